// SPDX-License-Identifier: MIT
// The robot, its joints and its pairs. What is looked at stands in the address after '#', so that it can be passed on.
import { useCallback, useEffect, useMemo, useState } from "preact/hooks";
import type { Cylinder } from "../parts/data.ts";
import { Copy, Section, Select } from "../parts/elements.tsx";
import { the_stage } from "../parts/stage.ts";
import { plural, safe, shell_quoted } from "../parts/words.ts";
import { gap } from "./gap.ts";
import { Joints } from "./joints.tsx";
import { free_joints, joint_values } from "./kinematics.ts";
import { no_filter, passes } from "./order.ts";
import { Legend, Pairs, Picked } from "./pairs.tsx";
import { posed, type Posed } from "./pose.ts";
import {
  frame_of,
  gap_words,
  has_stand_in,
  long,
  models,
  reason_words,
  unit_of,
  type Model,
  type Proof,
  type Study,
} from "./study.ts";
import { floor_cell, StudyView } from "./view.tsx";

/** "#at=3&pair=12&ghosts=sphere&joints=0.5,-1" */
interface Looked {
  at: number;
  picked: number | null;
  ghosts: ReadonlySet<Model>;
  close: boolean;
  joints: number[] | null; // as the reader has set them
}
function read_address(study: Study): Looked {
  const told = new URLSearchParams(location.hash.slice(1));
  const index = (name: string, of: unknown[]) => {
    const i = Number(told.get(name) ?? NaN);
    return Number.isInteger(i) && i >= 0 && i < of.length ? i : null;
  };
  const free = free_joints(study.links),
    joints = (told.get("joints") ?? "").split(",").map(Number);
  return {
    joints: told.has("joints") && joints.length === free.length && joints.every(Number.isFinite) ? joints : null,
    at: index("at", study.kept) ?? 0,
    picked: index("pair", study.pairs),
    ghosts: new Set(models.filter((m) => has_stand_in(m) && told.get("ghosts")?.split(",").includes(m))),
    close: told.get("close") === "1",
  };
}
function address_of({ at, picked, ghosts, close, joints }: Looked) {
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

/** A pair that the SRDF exempts, where the sliders stand: it is no row of the table. */
function Exempt({ study, posed, proof }: { study: Study; posed: Posed; proof: Proof }) {
  const [a, b] = proof.bodies.map((body) => posed.cylinders[body]!) as [Cylinder, Cylinder],
    { distance } = gap(a, b);
  return (
    <p class="exempt" role="status">
      <i class="swatch a" /> {proof.a} {"\u2013"} <i class="swatch b" /> {proof.b}, not among the{" "}
      {plural(study.pairs.length, "checked pair")}:{" "}
      <b class={distance <= study.clearance ? "bad" : "ok"}>
        here they {gap_words(distance, study.clearance, unit_of(study))}
      </b>
    </p>
  );
}

export function SceneSection({
  study,
  asked,
  show_proof,
}: {
  study: Study;
  asked: Proof | null;
  show_proof: (proof: Proof) => void;
}) {
  const [looked, look] = useState(() => read_address(study));
  const [filter, set_filter] = useState(no_filter);
  const [touched, touch] = useState<number | null>(null); // the body clicked last
  const [exempt, set_exempt] = useState<Proof | null>(null); // asked for, and not among the checked pairs
  const { at, picked, ghosts, close, joints } = looked;
  const pose = useMemo(() => posed(study, at, joints, picked), [study, at, joints, joints ? picked : null]);
  const unit = unit_of(study),
    frame = useMemo(() => frame_of(study), [study]);
  const passing = useMemo(
    () => new Set(study.pairs.flatMap((pair, i) => (passes(pair, filter) ? [i] : []))),
    [study, filter],
  );
  const options = useMemo(
    () =>
      study.kept.flatMap((k, i) =>
        k.reasons.map((reason, j) => ({ key: `${i} ${j}`, at: i, reason, words: reason_words(study, k, reason) })),
      ),
    [study],
  );
  const [chosen, choose] = useState(() => options.find((o) => o.at === at)?.key ?? "0 0");

  useEffect(() => {
    const now = address_of(looked);
    if (now === "#" ? /^#at=/.test(location.hash) : now !== location.hash) history.replaceState(null, "", now);
  }, [looked]);
  useEffect(() => {
    const changed = () => {
      if (/^#at=/.test(location.hash)) look(read_address(study));
    };
    addEventListener("hashchange", changed);
    return () => removeEventListener("hashchange", changed);
  }, [study]);
  const pick_pair = useCallback((pair: number | null) => {
    set_exempt(null);
    look((was) => ({ ...was, picked: pair, close: pair === null ? false : was.close }));
    touch(null);
  }, []);
  // The pair of the two bodies clicked last; of one that has none with the other, its nearest pair.
  const pick_body = useCallback(
    (body: number) => {
      const of_both =
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
      const pair = of_both >= 0 ? of_both : nearest;
      look((was) => ({ ...was, picked: pair >= 0 ? pair : null }));
      touch(body);
    },
    [study, touched, passing, pose],
  );
  const switch_ghost = (model: Model) =>
    look((was) => {
      const now = new Set(was.ghosts);
      if (!now.delete(model)) now.add(model);
      return { ...was, ghosts: now };
    });
  const choose_option = (key: string) => {
    const option = options.find((o) => o.key === key)!;
    choose(key);
    look((was) => ({
      ...was,
      at: option.at,
      joints: null,
      ...(option.reason.pair === undefined ? {} : { picked: option.reason.pair }),
      ...(option.reason.model ? { ghosts: new Set([option.reason.model].filter(has_stand_in)) } : {}),
    }));
  };
  // A proof tells of the joints between its bodies; the others stand at 0, or at the limit nearest to it.
  useEffect(() => {
    if (!asked) return;
    const values = joint_values(study.links, asked.joints);
    const pair = study.pairs.findIndex(({ bodies }) => bodies.join() === asked.bodies.join());
    set_exempt(pair >= 0 ? null : asked);
    look((was) => ({
      ...was,
      joints: free_joints(study.links).map((link) => values[link]!),
      picked: pair >= 0 ? pair : null,
    }));
  }, [asked]);
  const clearance = study.clearance > 0 ? ` --clearance ${study.clearance}` : "";
  const told = Object.entries(pose.joints).map(([name, value]) => `${shell_quoted(safe(name))}=${value}`);
  const command = `./daylight scene ${shell_quoted(study.file)}${clearance} --at ${told.join(" ")}`;
  return (
    <Section id="scene" title="Scene and pairs">
      <div class="study">
        <div class="seen">
          <div class="stage-tools" role="group" aria-label="View">
            <Select
              label="Look at"
              value={chosen}
              onChange={choose_option}
              options={options.map((o) => [o.key, o.words] as const)}
            />
            <button
              type="button"
              aria-pressed={close}
              disabled={picked === null}
              onClick={() => look({ ...looked, close: !close })}>
              Close up
            </button>
            <button type="button" disabled={picked === null} onClick={() => pick_pair(null)}>
              Show all
            </button>
          </div>
          <StudyView
            shown={{ study, at, posed: pose, picked, exempt, ghosts, close, passing }}
            pick_pair={pick_pair}
            pick_body={pick_body}
          />
          {study.pairs.length > 0 && <Legend study={study} filter={filter} set={set_filter} />}
          <p class="soft">
            {pose.set
              ? "Red are the bodies and lines of pairs within the clearance where the sliders stand. "
              : "Bodies have the colour of the most exact model that one of their pairs needs; lines join the " +
                "nearest points of a pair. "}
            {study.bodies.some(({ holds }) => holds) &&
              "Grey are boxes and the boxes of meshes, clear grey the solids that stand in for them. "}
            The squares of the floor are {long(floor_cell(frame), unit)} wide; x is red, y green, z blue.{" "}
            {the_stage()
              ? "Drag to turn, wheel to zoom; click a body, then another one, a line, or a row to pick a pair."
              : "This browser has no WebGL: what is drawn are outlines that cannot be turned."}
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
            set={(values) => look({ ...looked, joints: values })}
            reset={() => look({ ...looked, joints: null })}
            pick={pick_pair}
          />
          {exempt && <Exempt study={study} posed={pose} proof={exempt} />}
          {picked !== null && (
            <Picked
              study={study}
              at={at}
              posed={pose}
              picked={picked}
              ghosts={ghosts}
              switch_ghost={switch_ghost}
              show_proof={show_proof}
            />
          )}
        </div>
      </div>
      {study.pairs.length > 0 && (
        <Pairs study={study} posed={pose} filter={filter} set={set_filter} picked={picked} pick={pick_pair} />
      )}
    </Section>
  );
}
