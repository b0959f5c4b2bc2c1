// SPDX-License-Identifier: MIT
// The one WebGL renderer of a page and what stands on it. It draws when something changed, never by itself.
import {
  AmbientLight,
  BoxGeometry,
  BufferGeometry,
  CanvasTexture,
  CapsuleGeometry,
  CylinderGeometry,
  DirectionalLight,
  DoubleSide,
  EdgesGeometry,
  Float32BufferAttribute,
  Group,
  LatheGeometry,
  Line,
  LineBasicMaterial,
  LineSegments,
  Matrix4,
  Mesh,
  MeshBasicMaterial,
  MeshLambertMaterial,
  OrthographicCamera,
  PlaneGeometry,
  Quaternion,
  Raycaster,
  Scene,
  SphereGeometry,
  Sprite,
  SpriteMaterial,
  Vector2,
  Vector3,
  WebGLRenderer,
  type Object3D,
} from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import type { Vec } from "./data.ts";
import { add, scale, type Capsule, type Solid } from "./geometry.ts";

export interface View {
  eye: Vec;
  up: Vec;
  target: Vec;
  radius: number;
}

const three = (v: Vec) => new Vector3(v[0], v[1], v[2]);
const turned = (from: Vec, to: Vec) => new Quaternion().setFromUnitVectors(three(from), three(to));

/** Solids of no radius or height are drawn this thick, as part of the extent, to be seen. */
const thinnest = 2e-3;

/** A face a little behind the lines on it. */
const behindEdges = { polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1 };

/** A cylinder grown by a ball: its outline from pole to pole, turned about the axis. */
function rounded(radius: number, half: number, rounding: number) {
  const steps = 24,
    arc = (end: 1 | -1) =>
      Array.from({ length: steps + 1 }, (_, i) => {
        const t = ((end > 0 ? i : i - steps) * Math.PI) / (2 * steps);
        return new Vector2(radius + rounding * Math.cos(t), end * half + rounding * Math.sin(t));
      });
  const end = half + rounding;
  return new LatheGeometry([new Vector2(0, -end), ...arc(-1), ...arc(1), new Vector2(0, end)], 96);
}

/** See-through, so that what lies behind or inside is seen; of opacity 1 not. */
export function solid(s: Solid, colour: string, extent: number, opacity = 0.62): Group {
  const radius = Math.max(s.radius, s.rounding > 0 ? 0 : thinnest * extent),
    height = Math.max(2 * s.half, s.rounding > 0 ? 0 : thinnest * extent);
  const clear = opacity < 1,
    geometry =
      s.rounding > 0
        ? rounded(radius, height / 2, s.rounding)
        : new CylinderGeometry(radius, radius, height, 96, 1);
  const group = new Group();
  group.add(
    new Mesh(
      geometry,
      new MeshLambertMaterial({
        color: colour,
        transparent: clear,
        opacity,
        side: DoubleSide,
        depthWrite: !clear,
        ...(clear ? {} : behindEdges),
      }),
    ),
  );
  group.add(
    new LineSegments(
      new EdgesGeometry(geometry, 30),
      new LineBasicMaterial(
        clear
          ? { color: colour, transparent: true, opacity: Math.min(1, opacity * 2) }
          : { color: "#000000", transparent: true, opacity: 0.45 },
      ),
    ),
  );
  group.quaternion.copy(turned([0, 1, 0], s.axis));
  group.position.copy(three(s.center));
  return group;
}

/** All points within a radius of a segment, as a breath of colour with outlines. */
export function ghost(c: Capsule, colour: string): Group {
  const group = new Group();
  group.add(
    new Mesh(
      new CapsuleGeometry(c.radius, 2 * c.half, 24, 64),
      new MeshLambertMaterial({ color: colour, transparent: true, opacity: 0.2, depthWrite: false, ...behindEdges }),
    ),
  );
  const arc = (at: (t: number) => Vec, from: number, to: number) =>
    Array.from({ length: 33 }, (_, i) => at(from + ((to - from) * i) / 32));
  const side = (u: Vec): Vec[] => {
    // a stadium in the plane of the axis and u
    const around =
      (middle: number) =>
      (t: number): Vec =>
        add(scale(u, c.radius * Math.cos(t)), [0, middle + c.radius * Math.sin(t), 0]);
    return [
      ...arc(around(c.half), 0, Math.PI),
      ...arc(around(-c.half), Math.PI, 2 * Math.PI),
      [u[0] * c.radius, c.half, u[2] * c.radius],
    ];
  };
  const ring = (y: number) => arc((t) => [c.radius * Math.cos(t), y, c.radius * Math.sin(t)], 0, 2 * Math.PI);
  for (const points of [side([1, 0, 0]), side([0, 0, 1]), ring(c.half), ring(-c.half)])
    group.add(line(points, colour, { opacity: 0.7 }));
  group.quaternion.copy(turned([0, 1, 0], c.axis));
  group.position.copy(three(c.center));
  return group;
}

export function line(points: Vec[], colour: string, { opacity = 1, onTop = false } = {}): Line {
  const geometry = new BufferGeometry().setAttribute("position", new Float32BufferAttribute(points.flat(), 3));
  const drawn = new Line(
    geometry,
    new LineBasicMaterial({ color: colour, transparent: true, opacity, depthTest: !onTop }),
  );
  if (onTop) drawn.renderOrder = 1;
  return drawn;
}

/** A dot of the same size at any zoom. */
export function pointMark(at: Vec, colour: string): Mesh {
  const ball = new Mesh(
    new SphereGeometry(1, 16, 12),
    new MeshBasicMaterial({ color: colour, depthTest: false, transparent: true }),
  );
  ball.position.copy(three(at));
  ball.renderOrder = 2;
  ball.userData.pointMark = true;
  return ball;
}

export function plane(at: Vec, normal: Vec, side: number, colour: string): Group {
  const sheet = new Mesh(
    new PlaneGeometry(side, side),
    new MeshBasicMaterial({ color: colour, transparent: true, opacity: 0.16, side: DoubleSide, depthWrite: false }),
  );
  const frame = new LineSegments(
    new EdgesGeometry(sheet.geometry),
    new LineBasicMaterial({ color: colour, transparent: true, opacity: 0.6 }),
  );
  const group = new Group();
  group.add(sheet, frame);
  group.quaternion.copy(turned([0, 0, 1], normal));
  group.position.copy(three(at));
  return group;
}

/** A box around a point, its three sides as vectors. */
export function box(center: Vec, sides: [Vec, Vec, Vec], colour: string, opacity: number): Group {
  const geometry = new BoxGeometry(1, 1, 1).applyMatrix4(
    new Matrix4().makeBasis(three(sides[0]), three(sides[1]), three(sides[2])).setPosition(three(center)),
  );
  const group = new Group();
  group.add(
    new Mesh(
      geometry,
      new MeshLambertMaterial({ color: colour, transparent: true, opacity, side: DoubleSide, depthWrite: false }),
    ),
    new LineSegments(
      new EdgesGeometry(geometry, 30),
      new LineBasicMaterial({ color: colour, transparent: true, opacity: Math.min(1, 2 * opacity) }),
    ),
  );
  return group;
}

/** Squares of a floor around a point, so many to each side. */
export function grid(at: Vec, cell: number, count: number, colour: string): LineSegments {
  const ends = Array.from({ length: 2 * count + 1 }, (_, i) => (i - count) * cell),
    reach = count * cell;
  const points = ends.flatMap((t) => [
    ...[at[0] + t, at[1] - reach, at[2], at[0] + t, at[1] + reach, at[2]],
    ...[at[0] - reach, at[1] + t, at[2], at[0] + reach, at[1] + t, at[2]],
  ]);
  return new LineSegments(
    new BufferGeometry().setAttribute("position", new Float32BufferAttribute(points, 3)),
    new LineBasicMaterial({ color: colour, transparent: true, opacity: 0.28 }),
  );
}

/** A letter that faces the reader, of one height in the scene. */
function letter(at: Vec, text: string, colour: string, height: number): Sprite {
  const side = 64,
    canvas = Object.assign(document.createElement("canvas"), { width: side, height: side }),
    pen = canvas.getContext("2d")!;
  Object.assign(pen, { font: `bold ${side * 0.8}px sans-serif`, textAlign: "center", textBaseline: "middle" });
  pen.fillStyle = colour;
  pen.fillText(text, side / 2, side / 2);
  const sprite = new Sprite(new SpriteMaterial({ map: new CanvasTexture(canvas), depthTest: false }));
  sprite.position.copy(three(at));
  sprite.scale.setScalar(height);
  sprite.renderOrder = 1;
  return sprite;
}

/** A thin rod with its name beyond its end, in front of all else. */
export function arrow(from: Vec, to: Vec, colour: string, name: string): Group {
  const way = three(to).sub(three(from)),
    rod = new Mesh(
      new CylinderGeometry(0.0035, 0.0035, way.length(), 8),
      new MeshBasicMaterial({ color: colour, depthTest: false, transparent: true }),
    );
  rod.position.copy(three(from)).addScaledVector(way, 0.5);
  rod.quaternion.setFromUnitVectors(new Vector3(0, 1, 0), way.clone().normalize());
  rod.renderOrder = 1;
  const group = new Group();
  group.add(rod, letter(add(from, scale(add(to, scale(from, -1)), 1.15)), name, colour, 0.07));
  return group;
}

/** How near to a line a click must be, in pixels. */
const lineReach = 4;

/** The distance of the eye from its target. With parallel rays it changes nothing in the picture. */
const eyeWay = 4;
class Stage {
  readonly canvas: HTMLCanvasElement;
  private readonly renderer: WebGLRenderer;
  private readonly camera = new OrthographicCamera(-1, 1, 1, -1, -100, 100);
  private readonly controls: OrbitControls;
  private scene = new Scene();
  private radius = 1; // of what has to be seen
  private waiting = false;
  private marks: Object3D[] = [];
  /** Called after each drawing: what lies over the canvas moves along. */
  drawn: () => void = () => {};

  constructor() {
    this.renderer = new WebGLRenderer({ antialias: true, alpha: true, preserveDrawingBuffer: true });
    this.renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
    this.canvas = this.renderer.domElement;
    this.controls = new OrbitControls(this.camera, this.canvas);
    this.controls.enableDamping = false;
    const light = new DirectionalLight("#ffffff", 2.2); // beside the eye
    light.position.set(0.3, 0.6, 1);
    this.camera.add(light);
    this.controls.addEventListener("change", () => this.draw());
    this.canvas.tabIndex = 0;
    this.controls.listenToKeyEvents(this.canvas);
  }

  /** For those who do not see it. */
  setAriaLabel(what: string) {
    this.canvas.setAttribute("role", "img");
    this.canvas.setAttribute("aria-label", what);
  }

  /** These and nothing else, from the next draw() on. */
  show(objects: Object3D[]) {
    this.scene.traverse((o) => {
      if (o instanceof Mesh || o instanceof LineSegments || o instanceof Line) {
        o.geometry.dispose();
        (o.material as { dispose(): void }).dispose();
      } else if (o instanceof Sprite) {
        o.material.map?.dispose();
        o.material.dispose();
      }
    });
    this.scene = new Scene();
    this.scene.add(this.camera, new AmbientLight("#ffffff", 1.5), ...objects);
    this.marks = objects.filter((o) => o.userData.pointMark);
  }

  look(view: View) {
    this.radius = view.radius;
    this.camera.zoom = 1;
    this.camera.up.copy(three(view.up));
    this.camera.position.copy(three(add(view.target, scale(view.eye, eyeWay))));
    this.controls.target.copy(three(view.target));
    this.controls.update();
    this.draw();
  }

  /** With the next frame of the screen, once for all that asked for it. */
  draw() {
    if (this.waiting) return;
    this.waiting = true;
    requestAnimationFrame(() => {
      this.waiting = false;
      this.drawNow();
    });
  }

  private drawNow() {
    const { clientWidth: width, clientHeight: height } = this.canvas.parentElement ?? this.canvas;
    if (width === 0 || height === 0) return;
    this.renderer.setSize(width, height, false);
    const aspect = width / height,
      half = this.radius * Math.max(1, 1 / aspect);
    Object.assign(this.camera, { left: -half * aspect, right: half * aspect, top: half, bottom: -half });
    this.camera.updateProjectionMatrix();
    for (const ball of this.marks) ball.scale.setScalar((0.012 * half * 2) / this.camera.zoom);
    this.renderer.render(this.scene, this.camera);
    this.drawn();
  }

  private get pixel() {
    return (this.camera.top - this.camera.bottom) / this.camera.zoom / this.canvas.clientHeight;
  }

  /** Where a point of the scene is on the canvas, in pixels. */
  at(point: Vec): [number, number] {
    const { x, y } = three(point).project(this.camera),
      { clientWidth: width, clientHeight: height } = this.canvas;
    return [((1 + x) / 2) * width, ((1 - y) / 2) * height];
  }

  /** The way in the scene, square to the line of sight, of a way on the canvas in pixels. */
  way(right: number, down: number): Vec {
    const e = this.camera.matrixWorld.elements,
      [x, y] = [right * this.pixel, -down * this.pixel];
    return [x * e[0]! + y * e[4]!, x * e[1]! + y * e[5]!, x * e[2]! + y * e[6]!];
  }

  /** What `userData.is` of the objects shown says of the nearest one under a point of the canvas. */
  hit(x: number, y: number): unknown {
    const { clientWidth: width, clientHeight: height } = this.canvas;
    const ray = new Raycaster();
    ray.params.Line.threshold = lineReach * this.pixel;
    ray.setFromCamera(new Vector2((2 * x) / width - 1, 1 - (2 * y) / height), this.camera);
    for (const { object } of ray.intersectObjects(this.scene.children, true))
      for (let o: Object3D | null = object; o; o = o.parent)
        if (o.userData.is !== undefined) return o.userData.is as unknown;
    return undefined;
  }
}

/** Shows the stage in a place, in whatever width and colour scheme it has; what it returns ends that. */
export function mountStage(stage: Stage, place: HTMLElement, show: () => void): () => void {
  place.append(stage.canvas);
  const paint = () => {
    show();
    stage.draw();
  };
  paint();
  const observer = new ResizeObserver(() => stage.draw());
  observer.observe(place);
  const scheme = matchMedia("(prefers-color-scheme: dark)");
  scheme.addEventListener("change", paint);
  return () => {
    observer.disconnect();
    scheme.removeEventListener("change", paint);
  };
}

/** How far, in pixels, a pointer may move and still click instead of turning the scene. */
const clickSlack = 4;

/** Tells what a pointer clicks, and what it rests on; `at` finds it. What is returned ends that. */
export function onPointer<Found>(
  { canvas }: Stage,
  at: (x: number, y: number) => Found | null,
  clicked: (found: Found | null) => void,
  rests: (found: Found | null) => void,
): () => void {
  let from: [number, number] | null = null;
  const down = ({ offsetX: x, offsetY: y }: PointerEvent) => {
    from = [x, y];
  };
  const up = ({ offsetX: x, offsetY: y }: PointerEvent) => {
    if (from && Math.hypot(x - from[0], y - from[1]) <= clickSlack) clicked(at(x, y));
  };
  const move = (event: PointerEvent) => {
    if (event.buttons !== 0) return;
    const found = at(event.offsetX, event.offsetY);
    rests(found);
    canvas.style.cursor = found === null ? "grab" : "pointer";
  };
  const leave = () => rests(null);
  canvas.addEventListener("pointerdown", down);
  canvas.addEventListener("pointerup", up);
  canvas.addEventListener("pointermove", move);
  canvas.addEventListener("pointerleave", leave);
  return () => {
    canvas.removeEventListener("pointerdown", down);
    canvas.removeEventListener("pointerup", up);
    canvas.removeEventListener("pointermove", move);
    canvas.removeEventListener("pointerleave", leave);
  };
}

let stage: Stage | null | undefined;
/** null where this browser has no WebGL. */
export function getStage(): Stage | null {
  if (stage === undefined) {
    try {
      stage = new Stage();
    } catch {
      stage = null;
    }
  }
  return stage;
}
