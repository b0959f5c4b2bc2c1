// SPDX-License-Identifier: MIT
// The answers of a method along a path.
import * as Plot from "@observablehq/plot";
import { common, decades, tips, type Options } from "../parts/plot.ts";
import { short } from "../parts/words.ts";
import type { PathStability } from "./data.ts";

/** What changes along a path, and its unit. */
const alongOf = (path: string) =>
  path.startsWith("touching")
    ? "gap (overlap below 0), part of the size"
    : path.startsWith("coaxial")
      ? "offset of the axes, part of the size"
      : "angle from the special position, radians";

export function tracePlot(path: PathStability, o: Options): Element {
  const trace = path.trace ?? [];
  const colour = (t: { verdict: string }) =>
    ({ disjoint: o.theme.intersecting, intersecting: o.theme.disjoint, touching: o.theme.failed })[t.verdict] ??
    o.theme.undecided;
  const shape = (t: { verdict: string }) =>
    ({ disjoint: "circle", intersecting: "square", touching: "diamond2" })[t.verdict] ?? "times";
  const known = trace.some((t) => t.distance !== null);
  // Steps go by decades towards 0, and the axis with them.
  const nearest = Math.min(1, ...trace.map((t) => Math.abs(t.at)).filter((v) => v > 0));
  const farthest = Math.max(nearest, ...trace.map((t) => Math.abs(t.at)));
  const reached = (v: number) => v >= 0.99 * nearest && v <= 1.01 * farthest,
    powers = decades([nearest, farthest]),
    within = (powers.filter(reached).length > 2 ? powers : powers.flatMap((v) => [v, 3 * v])).filter(reached),
    skip = Math.max(1, Math.ceil((2 * within.length * 60) / o.width)),
    sides = within.filter((_, i) => (within.length - 1 - i) % skip === 0);
  const y = (t: (typeof trace)[number]) =>
    known ? t.distance : t.verdict === "disjoint" ? 1 : t.verdict === "intersecting" ? -1 : 0;
  const words = (t: (typeof trace)[number]) =>
    `at ${short(t.at, 6)}: ${t.verdict}${t.distance === null ? "" : `, distance ${short(t.distance, 6)}`}`;
  const flips = trace
    .slice(1)
    .flatMap((t, i) => (t.verdict === trace[i]!.verdict ? [] : [{ at: (t.at + trace[i]!.at) / 2 }]));
  return Plot.plot(
    common(o, 220, {
      x: {
        type: "symlog",
        constant: nearest,
        label: `${alongOf(path.path)}, logarithmic on both sides of 0 \u2192`,
        grid: true,
        ticks: [...sides.map((v) => -v), 0, ...sides],
        tickFormat: (v: number) => short(v, 1),
      },
      y: known
        ? { label: "\u2191 distance it returns, a length", grid: true, tickFormat: (v: number) => short(v) }
        : {
            label: null,
            domain: [-1.6, 1.6],
            ticks: [-1, 1],
            tickFormat: (v: number) => (v > 0 ? "disjoint" : "intersecting"),
          },
      marginLeft: 68,
      marks: [
        ...(known ? [Plot.ruleY([0], { stroke: o.theme.soft })] : []),
        Plot.ruleX(flips, { x: "at", stroke: o.theme.soft, strokeDasharray: "3 3" }),
        ...(known
          ? [
              Plot.line(
                trace.filter((t) => t.distance !== null),
                { x: "at", y: "distance", stroke: o.theme.soft, strokeWidth: 0.8 },
              ),
            ]
          : []),
        Plot.dot(trace, { x: "at", y, fill: colour, symbol: shape, r: 2.6, ariaLabel: words }),
        ...tips(trace, o, words, { x: "at", y }),
      ],
    }),
  );
}
