// SPDX-License-Identifier: MIT
// The one WebGL renderer of the page. It draws when something changed, never by itself.
import {
  AmbientLight, BufferGeometry, CylinderGeometry, DirectionalLight, DoubleSide, EdgesGeometry, Float32BufferAttribute, Group, Line, LineBasicMaterial,
  LineSegments, Mesh, MeshBasicMaterial, MeshLambertMaterial, OrthographicCamera, PlaneGeometry, Quaternion, Scene, SphereGeometry, Vector3, WebGLRenderer,
} from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import type { Vec } from "./data.ts";
import { add, scale, square_to, type Drawing, type Solid } from "./geometry.ts";

export interface View { eye: Vec; up: Vec; target: Vec; radius: number }
export interface Colours { a: string; b: string; plane: string; point: string; line: string }

/** Looking across the direction of the gap, a little from above; a lies left of b. */
export function view_of(d: Drawing, close: boolean): View {
  const along = d.direction ?? ([1, 0, 0] as Vec);
  const [u, v] = square_to(along);
  const eye = add(add(scale(u, -0.85), scale(v, 0.4)), scale(along, 0.25));
  return { eye, up: v, target: close ? d.contact : [0, 0, 0], radius: close ? 0.25 * d.extent : 1.12 * d.extent };
}

const three = (v: Vec) => new Vector3(v[0], v[1], v[2]);

/** Solids of no radius or height are drawn this thick, as part of the extent, to be seen. */
const thinnest = 2e-3;

function solid_group(s: Solid, colour: string, extent: number): Group {
  const radius = Math.max(s.radius, thinnest * extent), height = Math.max(2 * s.half, thinnest * extent);
  const geometry = new CylinderGeometry(radius, radius, height, 96, 1);
  const group = new Group();
  group.add(new Mesh(geometry, new MeshLambertMaterial({ color: colour, transparent: true, opacity: 0.62, side: DoubleSide, depthWrite: false })));
  group.add(new LineSegments(new EdgesGeometry(geometry, 30), new LineBasicMaterial({ color: colour })));
  group.quaternion.copy(new Quaternion().setFromUnitVectors(new Vector3(0, 1, 0), three(s.axis)));
  group.position.copy(three(s.center));
  return group;
}

class Stage {
  readonly canvas: HTMLCanvasElement;
  private readonly renderer: WebGLRenderer;
  private readonly camera = new OrthographicCamera(-1, 1, 1, -1, -100, 100);
  private readonly controls: OrbitControls;
  private scene = new Scene();
  private radius = 1;
  private marks: Mesh[] = [];

  constructor() {
    this.renderer = new WebGLRenderer({ antialias: true, alpha: true, preserveDrawingBuffer: true });
    this.renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
    this.canvas = this.renderer.domElement;
    this.controls = new OrbitControls(this.camera, this.canvas);
    this.controls.enableDamping = false;
    const light = new DirectionalLight("#ffffff", 2.2);  // beside the eye
    light.position.set(0.3, 0.6, 1);
    this.camera.add(light);
    this.controls.addEventListener("change", () => this.draw());
    this.canvas.tabIndex = 0;
    this.controls.listenToKeyEvents(this.canvas);
  }

  show(d: Drawing, colours: Colours) {
    this.scene.traverse((o) => {
      if (o instanceof Mesh || o instanceof LineSegments || o instanceof Line) { o.geometry.dispose(); (o.material as { dispose(): void }).dispose(); }
    });
    this.scene = new Scene();
    this.marks = [];
    this.scene.add(this.camera, new AmbientLight("#ffffff", 1.5), solid_group(d.a, colours.a, d.extent), solid_group(d.b, colours.b, d.extent));
    const mark = (at: Vec, colour: string) => {
      const ball = new Mesh(new SphereGeometry(1, 16, 12), new MeshBasicMaterial({ color: colour, depthTest: false, transparent: true }));
      ball.position.copy(three(at));
      ball.renderOrder = 2;
      this.marks.push(ball);
      this.scene.add(ball);
    };
    if (d.plane && d.direction) {
      const side = 1.5 * d.extent;
      const plane = new Mesh(new PlaneGeometry(side, side), new MeshBasicMaterial({ color: colours.plane, transparent: true, opacity: 0.16, side: DoubleSide, depthWrite: false }));
      const frame = new LineSegments(new EdgesGeometry(plane.geometry), new LineBasicMaterial({ color: colours.plane, transparent: true, opacity: 0.6 }));
      for (const part of [plane, frame]) {
        part.quaternion.copy(new Quaternion().setFromUnitVectors(new Vector3(0, 0, 1), three(d.direction)));
        part.position.copy(three(d.plane));
        this.scene.add(part);
      }
    }
    if (d.near) {
      mark(d.near.a, colours.a);
      mark(d.near.b, colours.b);
      const geometry = new BufferGeometry().setAttribute("position", new Float32BufferAttribute([...d.near.a, ...d.near.b], 3));
      const line = new Line(geometry, new LineBasicMaterial({ color: colours.line, depthTest: false, transparent: true }));
      line.renderOrder = 1;
      this.scene.add(line);
    }
    if (d.point) mark(d.point, colours.point);
  }

  look(view: View) {
    this.radius = view.radius;
    this.camera.zoom = 1;
    this.camera.up.copy(three(view.up));
    this.camera.position.copy(three(add(view.target, scale(view.eye, 4))));
    this.controls.target.copy(three(view.target));
    this.controls.update();
    this.draw();
  }

  draw() {
    const { clientWidth: width, clientHeight: height } = this.canvas.parentElement ?? this.canvas;
    if (width === 0 || height === 0) return;
    this.renderer.setSize(width, height, false);
    const aspect = width / height, half = this.radius / Math.min(1, aspect);
    Object.assign(this.camera, { left: -half * aspect, right: half * aspect, top: half, bottom: -half });
    this.camera.updateProjectionMatrix();
    for (const ball of this.marks) ball.scale.setScalar((0.012 * half * 2) / this.camera.zoom);
    this.renderer.render(this.scene, this.camera);
  }
}

let stage: Stage | null | undefined;
/** null where this browser has no WebGL. */
export function the_stage(): Stage | null {
  if (stage === undefined) {
    try {
      stage = new Stage();
    } catch {
      stage = null;
    }
  }
  return stage;
}
