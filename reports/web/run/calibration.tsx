// SPDX-License-Identifier: MIT
// The share of wrong answers as margins shrink, compared with the claim.
import * as Plot from "@observablehq/plot";
import { sort } from "d3-array";
import { useCallback, useMemo, useState } from "preact/hooks";
import { Figure, Section, Select } from "../parts/elements.tsx";
import { colours, common, decades, power, tips, type Options } from "../parts/plot.ts";
import { grouped, percent, safe, shareBounds, short } from "../parts/words.ts";
import type { Calibration as Curve, Report } from "./data.ts";
import { ClaimWords } from "./elements.tsx";
import { isText } from "./words.ts";

const symbols = ["circle", "triangle", "square", "diamond", "star", "wye", "cross", "hexagon"] as const;
/** Curves in one plot: as many as have a distinct colour and symbol. */
const shownCap = symbols.length;
export const colourOf = (of: Curve[], method: string) => colours.series[of.findIndex((h) => h.method === method)]!;

/** The first method of each library: ours first, and the methods of the literature last. */
export function firstOfEach(all: Curve[]): Curve[] {
  const rank = ({ library }: Curve) => (library === "ours" ? 0 : isText(library) ? 2 : 1);
  const firsts = all.filter((h, i) => all.findIndex(({ library }) => library === h.library) === i);
  return sort(firsts, (x, y) => rank(x) - rank(y)).slice(0, shownCap);
}

const sides = [
  ["wrong_disjoint", "wrongly disjoint"],
  ["wrong_intersecting", "wrongly intersecting"],
] as const;

/** The share of wrong answers of a method on a side at a decade of the margin. */
const sharesOf = ({ method, bins }: Curve) =>
  sides.flatMap(([key, side]) =>
    bins
      .map((b) => ({ method, side, decade: b.decade, wrong: b[key], answered: b.asked - b.declined }))
      .filter((b) => b.answered > 0)
      .map((b) => ({ ...b, share: b.wrong / b.answered, bounds: shareBounds(b.wrong, b.answered) })),
  );
type Share = ReturnType<typeof sharesOf>[number];

export function calibrationPlot(all: Curve[], o: Options): Element {
  const rows = all.flatMap(sharesOf);
  /** A power of ten below all, which stands for 0. */
  const floor = 10 ** (Math.ceil(Math.log10(Math.min(0.01, ...rows.map((r) => r.bounds[1])))) - 1);
  const words = (r: Share) =>
    `${r.method}, margin (1e\u2212${r.decade + 1}, 1e\u2212${r.decade}]\nwrong ${grouped(r.wrong)} of ` +
    `${grouped(r.answered)}: ${percent(r.wrong, r.answered)}\n` +
    `95 %: ${short(r.bounds[0], 2)} to ${short(r.bounds[1], 2)}`;
  const last = Math.max(0, ...rows.map((r) => r.decade)),
    skip = Math.max(1, Math.ceil((last * 46) / ((o.width - 90) / sides.length)));
  const place = (method: string) => all.findIndex((h) => h.method === method),
    colour = (r: Share) => colourOf(all, r.method);
  const at = {
    x: (r: Share) => r.decade + (place(r.method) - (all.length - 1) / 2) * 0.09,
    y: (r: Share) => Math.max(floor, r.share),
    fx: "side",
  };
  return Plot.plot(
    common(o, 350, {
      marginTop: 44,
      x: {
        label: "margin, smaller \u2192",
        domain: [-0.5, last + 0.5],
        ticks: Array.from({ length: last + 1 }, (_, d) => d).filter((d) => d % skip === 0),
        tickFormat: (d: number) => power(-d),
      },
      y: {
        type: "log",
        label: "\u2191 share wrong (bar: 95 %)",
        domain: [floor, 1],
        ticks: decades([floor, 1]),
        tickFormat: (v: number) => (v < floor * 1.01 ? "0" : power(Math.round(Math.log10(v)))),
        grid: true,
      },
      fx: { label: null, padding: 0.08 },
      marks: [
        Plot.frame({ stroke: colours.line }),
        Plot.ruleX(rows, {
          x: at.x,
          y1: (r: Share) => Math.max(floor, r.bounds[0]),
          y2: (r: Share) => r.bounds[1],
          fx: "side",
          stroke: colour,
          strokeWidth: (r: Share) => (r.wrong === 0 ? 0.3 : 0.8),
        }),
        Plot.line(rows, { ...at, z: "method", stroke: colour, strokeWidth: 1.3 }),
        Plot.dot(rows, {
          ...at,
          stroke: colour,
          fill: (r: Share) => (r.wrong === 0 ? colours.bg : colour(r)),
          symbol: (r: Share) => symbols[place(r.method)]!,
          r: 3,
          ariaLabel: words,
        }),
        ...tips(rows, o, words, at),
      ],
    }),
  );
}

export function Calibration({ report }: { report: Report }) {
  const [library, choose] = useState("");
  const curves = useMemo(() => {
    const of = report.calibration.filter((h) => h.library === library).slice(0, shownCap);
    return library === "" ? firstOfEach(report.calibration) : of;
  }, [report, library]);
  const draw = useCallback((width: number) => calibrationPlot(curves, { width }), [curves]);
  if (curves.length === 0) return null;
  return (
    <Section
      id="calibration"
      title="Calibration"
      lead={
        "The share of wrong answers as the margin shrinks. A method must have no wrong answer to the " +
        "left of the margin that it claims. An open mark means no wrong answer. Bars are 95 % confidence."
      }>
      <p class="tools">
        <Select
          label="Methods"
          value={library}
          onChange={choose}
          options={[
            ["", "one of each library"],
            ...[...new Set(report.calibration.map((h) => h.library))].map((name) => [name, safe(name)] as const),
          ]}
        />
      </p>
      <Figure draw={draw} height={330} label="Share of wrong answers against margin" />
      <ul class="keys">
        {curves.map(({ method }) => {
          const claim = report.methods.find((m) => m.name === method)?.claim;
          return (
            <li key={method}>
              <b style={{ color: colourOf(curves, method) }}>{safe(method)}</b> {claim && <ClaimWords of={claim} />}
            </li>
          );
        })}
      </ul>
    </Section>
  );
}
