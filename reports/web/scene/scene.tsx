// SPDX-License-Identifier: MIT
// The robot, its joints and its pairs. The address after '#' has the view, so that a link shows the same.
import { useCallback, useEffect, useLayoutEffect, useMemo, useState } from "preact/hooks";
import type { Cylinder } from "../parts/data.ts";
import { Copy, Section, Select } from "../parts/elements.tsx";
import { getStage } from "../parts/stage.ts";
import { plural, safe, shellQuoted } from "../parts/words.ts";
import { gap } from "./gap.ts";
import { Joints } from "./joints.tsx";
import { freeJoints, jointValues } from "./kinematics.ts";
import { noFilter, passes } from "./order.ts";
import { Legend, Pairs, Picked } from "./pairs.tsx";
import { posed, type Posed } from "./pose.ts";
import {
  frameOf,
  formatGap,
  hasStandIn,
  formatLength,
  models,
  formatReason,
  unitOf,
  type Model,
  type Proof,
  type Study,
} from "./study.ts";
import { floorCell, StudyView } from "./view.tsx";

/** "#at=3&pair=12&ghosts=sphere&joints=0.5,-1" */
interface Looked {
  at: number;
  picked: number | null;
  ghosts: ReadonlySet<Model>;
  close: boolean;
  joints: number[] | null; // as the reader has set them
}
function readAddress(study: Study): Looked {
  const told = new URLSearchParams(location.hash.slice(1));
  const index = (name: string, of: unknown[]) => {
    const i = Number(told.get(name) ?? NaN);
    return Number.isInteger(i) && i >= 0 && i < of.length ? i : null;
  };
  const free = freeJoints(study.links),
    joints = (told.get("joints") ?? "").split(",").map(Number);
  return {
    joints: told.has("joints") && joints.length === free.length && joints.every(Number.isFinite) ? joints : null,
    at: index("at", study.kept) ?? 0,
    picked: index("pair", study.pairs),
    ghosts: new Set(models.filter((m) => hasStandIn(m) && told.get("ghosts")?.split(",").includes(m))),
    close: told.get("close") === "1",
  };
}
function addressOf({ at, picked, ghosts, close, joints }: Looked) {
  if (at === 0 && picked === null && !joints) return "#";
  const told = new URLSearchParams({
    at: String(at),
    ...(picked === null ? {} : { pair: String(picked) }),
    ...(ghosts.size > 0 ? { ghosts: [...ghosts].join(",") } : {}),
    ...(close ? { close: "1" } : {}),
    ...(joints ? { joints: joints.join(",") } : {}),
  });
  return `#${told}`;
}

/** The view. The reader's changes go into the address, and changes of the address into the view. */
function useLooked(study: Study) {
  const [{ looked, byReader }, set] = useState({ looked: readAddress(study), byReader: false });
  useLayoutEffect(() => {
    const now = addressOf(looked);
    if (byReader && (now === "#" ? /^#at=/.test(location.hash) : now !== location.hash))
      history.replaceState(null, "", now);
  }, [looked]);
  useLayoutEffect(() => {
    const follow = () => {
      if (/^#at=/.test(location.hash)) set({ looked: readAddress(study), byReader: false });
    };
    follow(); // it may have changed since it was read
    addEventListener("hashchange", follow);
    return () => removeEventListener("hashchange", follow);
  }, [study]);
  const look = useCallback(
    (change: (was: Looked) => Partial<Looked>) =>
      set(({ looked: was }) => ({ looked: { ...was, ...change(was) }, byReader: true })),
    [],
  );
  return [looked, look] as const;
}

/** A pair that the SRDF exempts, where the sliders stand: it is no row of the table. */
function Exempt({ study, posed, proof }: { study: Study; posed: Posed; proof: Proof }) {
  const [a, b] = proof.bodies.map((body) => posed.cylinders[body]!) as [Cylinder, Cylinder],
    { distance } = gap(a, b);
  return (
    <p class="exempt" role="status">
      <i class="swatch a" /> {proof.a} {"\u2013"} <i class="swatch b" /> {proof.b}, not among the{" "}
      {plural(study.pairs.length, "checked pair")}:{" "}
      <b class={distance <= study.clearance ? "bad" : "ok"}>
        here they {formatGap(distance, study.clearance, unitOf(study))}
      </b>
    </p>
  );
}

export function SceneSection({
  study,
  asked,
  showProof,
}: {
  study: Study;
  asked: Proof | null;
  showProof: (proof: Proof) => void;
}) {
  const [looked, look] = useLooked(study);
  const [filter, setFilter] = useState(noFilter);
  const [touched, touch] = useState<number | null>(null); // the body clicked last
  const [exempt, setExempt] = useState<Proof | null>(null); // asked for, and not among the checked pairs
  const { at, picked, ghosts, close, joints } = looked;
  const pose = useMemo(() => posed(study, at, joints, picked), [study, at, joints, joints ? picked : null]);
  const unit = unitOf(study),
    frame = useMemo(() => frameOf(study), [study]);
  const passing = useMemo(
    () => new Set(study.pairs.flatMap((pair, i) => (passes(pair, filter) ? [i] : []))),
    [study, filter],
  );
  const options = useMemo(
    () =>
      study.kept.flatMap((k, i) =>
        k.reasons.map((reason, j) => ({ key: `${i} ${j}`, at: i, reason, words: formatReason(study, k, reason) })),
      ),
    [study],
  );
  const [chosen, choose] = useState(() => options.find((o) => o.at === at)?.key ?? "0 0");

  const pickPair = useCallback((pair: number | null) => {
    setExempt(null);
    look(({ close }) => ({ picked: pair, close: pair !== null && close }));
    touch(null);
  }, []);
  // The pair of the two bodies clicked last; of one that has none with the other, its nearest pair.
  const pickBody = useCallback(
    (body: number) => {
      const ofBoth =
        touched === null
          ? -1
          : study.pairs.findIndex(
              ({ bodies }) => bodies.includes(body) && bodies.includes(touched) && body !== touched,
            );
      const own = study.pairs.flatMap(({ bodies }, i) => (bodies.includes(body) && passing.has(i) ? [i] : []));
      const nearest = own.reduce(
        (best, i) => {
          const to = (pair: number) => pose.gaps[pair]?.distance ?? Infinity;
          return best < 0 || to(i) < to(best) ? i : best;
        },
        -1,
      );
      const pair = ofBoth >= 0 ? ofBoth : nearest;
      look(() => ({ picked: pair >= 0 ? pair : null }));
      touch(body);
    },
    [study, touched, passing, pose],
  );
  const switchGhost = (model: Model) =>
    look((was) => {
      const now = new Set(was.ghosts);
      if (!now.delete(model)) now.add(model);
      return { ghosts: now };
    });
  const chooseOption = (key: string) => {
    const option = options.find((o) => o.key === key)!;
    choose(key);
    look(() => ({
      at: option.at,
      joints: null,
      ...(option.reason.pair === undefined ? {} : { picked: option.reason.pair }),
      ...(option.reason.model ? { ghosts: new Set([option.reason.model].filter(hasStandIn)) } : {}),
    }));
  };
  // A proof has values of the joints between its bodies. The others are 0, or the limit nearest to 0.
  useEffect(() => {
    if (!asked) return;
    const values = jointValues(study.links, asked.joints);
    const pair = study.pairs.findIndex(({ bodies }) => bodies.join() === asked.bodies.join());
    setExempt(pair >= 0 ? null : asked);
    look(() => ({
      joints: freeJoints(study.links).map((link) => values[link]!),
      picked: pair >= 0 ? pair : null,
    }));
  }, [asked]);
  const clearance = study.clearance > 0 ? ` --clearance ${study.clearance}` : "";
  const told = Object.entries(pose.joints).map(([name, value]) => `${shellQuoted(safe(name))}=${value}`);
  const command = `./daylight scene ${shellQuoted(study.file)}${clearance} --at ${told.join(" ")}`;
  return (
    <Section id="scene" title="Scene and pairs">
      <div class="study">
        <div class="seen">
          <div class="stage-tools" role="group" aria-label="View">
            <Select
              label="Look at"
              value={chosen}
              onChange={chooseOption}
              options={options.map((o) => [o.key, o.words] as const)}
            />
            <button
              type="button"
              aria-pressed={close}
              disabled={picked === null}
              onClick={() => look(() => ({ close: !close }))}>
              Close up
            </button>
            <button type="button" disabled={picked === null} onClick={() => pickPair(null)}>
              Show all
            </button>
          </div>
          <StudyView
            shown={{ study, at, posed: pose, picked, exempt, ghosts, close, passing }}
            pickPair={pickPair}
            pickBody={pickBody}
          />
          {study.pairs.length > 0 && <Legend study={study} filter={filter} set={setFilter} />}
          <p class="soft">
            {pose.set
              ? "Bodies and lines of pairs within the clearance are red. "
              : "A body's colour shows the most exact model that any of its pairs needs. "}
            {study.bodies.some(({ holds }) => holds) &&
              "Boxes and the boxes of meshes are grey, and the solids around them are translucent grey. "}
            The squares of the floor are {formatLength(floorCell(frame), unit)} wide; x is red, y green, z blue.{" "}
            {getStage()
              ? "Drag to turn, use the wheel to zoom. To pick a pair, click two bodies, a line, or a row."
              : "This browser has no WebGL, so the drawing has outlines that cannot be turned."}
          </p>
          {Object.keys(pose.joints).length > 0 && (
            <details>
              <summary>Joints of this configuration</summary>
              <Copy label="This configuration alone" text={command} />
            </details>
          )}
        </div>
        <div>
          <Joints
            study={study}
            posed={pose}
            set={(joints) => look(() => ({ joints }))}
            reset={() => look(() => ({ joints: null }))}
            pick={pickPair}
          />
          {exempt && <Exempt study={study} posed={pose} proof={exempt} />}
          {picked !== null && (
            <Picked
              study={study}
              at={at}
              posed={pose}
              picked={picked}
              ghosts={ghosts}
              switchGhost={switchGhost}
              showProof={showProof}
            />
          )}
        </div>
      </div>
      {study.pairs.length > 0 && (
        <Pairs study={study} posed={pose} filter={filter} set={setFilter} picked={picked} pick={pickPair} />
      )}
    </Section>
  );
}
