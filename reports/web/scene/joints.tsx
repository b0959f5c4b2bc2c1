// SPDX-License-Identifier: MIT
// A slider for each joint that moves by itself, and the pairs that are near each other at these values.
import { useMemo } from "preact/hooks";
import { plural, short } from "../parts/words.ts";
import { freeJoints, type StudiedLink } from "./kinematics.ts";
import { nearestFirst, type Posed } from "./pose.ts";
import { formatGap, formatLength, standsIn, unitOf, type Study } from "./study.ts";

const degrees = 180 / Math.PI;
const formatValue = (link: StudiedLink, value: number, unit: string) =>
  link.motion === "turn" ? `${short(value * degrees, 4)}\u00b0` : formatLength(value, unit);

function Joint({
  link,
  value,
  unit,
  set,
}: {
  link: StudiedLink;
  value: number;
  unit: string;
  set: (value: number) => void;
}) {
  const [low, high] = link.limits!;
  const words = (x: number) => formatValue(link, x, unit);
  return (
    <label class="joint">
      <span class="name">{link.joint}</span>
      <span class="value">{words(value)}</span>
      <input
        type="range"
        min={Math.min(low, value)}
        max={Math.max(high, value)}
        step="any"
        value={value}
        aria-label={link.joint}
        aria-valuetext={words(value)}
        title={`${words(low)} to ${words(high)}`}
        onInput={(event) => set(Number(event.currentTarget.value))}
      />
      <span class="limits soft" aria-hidden="true">
        <span>{words(low)}</span>
        <span>{words(high)}</span>
      </span>
    </label>
  );
}

/** The pairs within the clearance, and the nearest one beyond; a click picks. */
function Near({ study, posed, pick }: { study: Study; posed: Posed; pick: (pair: number) => void }) {
  const order = useMemo(() => nearestFirst(posed), [posed]);
  const within = order.filter((i) => posed.within[i]),
    next = order.find((i) => !posed.within[i]),
    unit = unitOf(study);
  const line = (i: number) => (
    <li key={i} class={posed.within[i] ? "bad" : ""}>
      <button type="button" class="link" onClick={() => pick(i)}>
        {study.pairs[i]!.a} {"\u2013"} {study.pairs[i]!.b}
      </button>{" "}
      {formatGap(posed.gaps[i]!.distance, 0, unit)}
      {posed.within[i] && standsIn(study, i) && (
        <span class="soft"> (measured to the solid around a box or mesh, so the pair itself may be clear)</span>
      )}
    </li>
  );
  return (
    <div class="near">
      <p role="status">
        <b class={within.length > 0 ? "bad" : "ok"}>
          {within.length === 0
            ? `None of the ${plural(study.pairs.length, "checked pair")} is`
            : `${within.length} of ${plural(study.pairs.length, "checked pair")} ` +
              (within.length === 1 ? "is" : "are")}{" "}
          within the clearance here
        </b>
        {posed.set && <span class="soft"> (computed by this page, without proof)</span>}
      </p>
      <ul>
        {within.map(line)}
        {next !== undefined && line(next)}
      </ul>
    </div>
  );
}

export function Joints({
  study,
  posed,
  set,
  reset,
  pick,
}: {
  study: Study;
  posed: Posed;
  set: (joints: number[]) => void;
  reset: () => void;
  pick: (pair: number) => void;
}) {
  const free = useMemo(() => freeJoints(study.links), [study]);
  const unit = unitOf(study),
    values = free.map((link) => posed.values[link]!);
  const following = study.links.flatMap((link, i) => (link.follows ? [{ link, value: posed.values[i]! }] : [])),
    held = study.links.filter(({ motion }) => motion === "held");
  return (
    <div class="joints">
      {free.length > 0 && (
        <fieldset>
          <legend>Joints</legend>
          <button type="button" disabled={!posed.set} onClick={reset}>
            Back to the sampled configuration
          </button>
          <div class="sliders">
            {free.map((link, k) => (
              <Joint
                link={study.links[link]!}
                value={values[k]!}
                unit={unit}
                set={(value) => set(values.map((x, i) => (i === k ? value : x)))}
                key={link}
              />
            ))}
          </div>
          {following.map(({ link, value }) => (
            <p class="soft" key={link.joint}>
              {link.joint} follows {study.links[link.follows!.link]!.joint}: {formatValue(link, value, unit)}
            </p>
          ))}
          {held.length > 0 && (
            <p class="warn">Not moved on this page: {held.map(({ joint, name }) => joint ?? name).join(", ")}</p>
          )}
        </fieldset>
      )}
      {study.pairs.length > 0 && <Near study={study} posed={posed} pick={pick} />}
    </div>
  );
}
