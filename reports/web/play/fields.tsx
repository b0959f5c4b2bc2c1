// SPDX-License-Identifier: MIT
// The numbers of a solid as fields.
import { useLayoutEffect, useRef, useState } from "preact/hooks";
import type { Cylinder, Vec } from "../parts/data.ts";
import { asKind, kindOf, kinds, lengthsOf, type Kind } from "./solids.ts";

/** What is being typed stays as it is typed. */
function NumberField({
  label,
  value,
  step,
  least,
  set,
}: {
  label: string;
  value: number;
  step: number;
  least?: number;
  set: (value: number) => void;
}) {
  const field = useRef<HTMLInputElement>(null);
  const [wrong, tell] = useState(false);
  useLayoutEffect(() => {
    const input = field.current!;
    if (document.activeElement === input && (wrong || Number(input.value) === value)) return;
    input.value = String(value);
    tell(false);
  }, [value]);
  const read = (input: HTMLInputElement) => {
    const x = input.value.trim() === "" ? NaN : input.valueAsNumber,
      isGood = Number.isFinite(x) && x >= (least ?? -Infinity);
    tell(!isGood);
    if (isGood) set(x);
  };
  return (
    <label class="number">
      <span>{label}</span>
      <input
        ref={field}
        type="number"
        step={step}
        min={least}
        aria-invalid={wrong}
        onInput={(event) => read(event.currentTarget)}
        onBlur={(event) => {
          event.currentTarget.value = String(value);
          tell(false);
        }}
      />
    </label>
  );
}

/** A fiftieth of the largest length, as a power of ten or half of one. */
function stepOf(c: Cylinder): number {
  const size = Math.max(c.radius, c.height, c.rounding ?? 0) / 50;
  const power = 10 ** Math.floor(Math.log10(size));
  return Number.isFinite(power) && power > 0 ? Number((size >= 5 * power ? 5 * power : power).toPrecision(1)) : 0.05;
}

const coordinates = ["x", "y", "z"] as const;

export function SolidFields({ name, solid, set }: { name: string; solid: Cylinder; set: (solid: Cylinder) => void }) {
  // A capsule of length 0 is still typed as a capsule.
  const [chosen, choose] = useState<Kind>(kindOf(solid));
  const kind = chosen === "sphere" ? (solid.height > 0 || solid.radius > 0 ? kindOf(solid) : chosen) : chosen;
  const isAlike = (kind === "cylinder") === !solid.rounding && !(kind === "capsule" && solid.radius > 0),
    shown = isAlike || solid.rounding === 0 ? kind : kindOf(solid);
  const step = stepOf(solid);
  const vector = (key: "center" | "axis", title: string) => (
    <div class="vector" role="group" aria-label={`${title} of ${name}`}>
      <span class="title">{title}</span>
      {coordinates.map((coordinate, i) => (
        <NumberField
          key={coordinate}
          label={coordinate}
          value={solid[key][i]!}
          step={key === "axis" ? 0.05 : step}
          set={(x) => set({ ...solid, [key]: solid[key].map((old, k) => (k === i ? x : old)) as Vec })}
        />
      ))}
    </div>
  );
  return (
    <fieldset class={`solid-fields ${name}`}>
      <legend>
        <i class={name} /> Solid {name}
      </legend>
      <label class="select">
        <span class="sr">Kind of {name}</span>
        <select
          value={shown}
          onChange={(event) => {
            const next = event.currentTarget.value as Kind;
            choose(next);
            set(asKind(solid, next));
          }}>
          {kinds.map((k) => (
            <option value={k} key={k} selected={k === shown}>
              {k}
            </option>
          ))}
        </select>
      </label>
      {vector("center", "centre")}
      {shown !== "sphere" && vector("axis", "axis")}
      <div class="vector" role="group" aria-label={`Lengths of ${name}`}>
        {lengthsOf[shown].map(([key, label]) => (
          <NumberField
            key={key}
            label={label}
            value={solid[key] ?? 0}
            step={step}
            least={0}
            set={(x) => set({ ...solid, [key]: x })}
          />
        ))}
      </div>
    </fieldset>
  );
}
