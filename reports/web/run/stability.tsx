// SPDX-License-Identifier: MIT
// The answers of a method along a path of pairs.
import * as Plot from "@observablehq/plot";
import { sort } from "d3-array";
import { useCallback, useMemo, useState } from "preact/hooks";
import { Figure, Section } from "../parts/elements.tsx";
import { colours, common, decades, tips, type Options } from "../parts/plot.ts";
import { grouped, safe, short } from "../parts/words.ts";
import type { PathStability, Report } from "./data.ts";
import { Table } from "./elements.tsx";

/** The quantity that changes along a path, and its unit. */
const alongOf = (path: string) =>
  path.startsWith("touching")
    ? "gap (overlap below 0), part of the size"
    : path.startsWith("coaxial")
      ? "offset of the axes, part of the size"
      : "angle from the special position, radians";

const shapes: Record<string, string> = { disjoint: "circle", touching: "diamond2", intersecting: "square" };

function tracePlot({ path, trace = [] }: PathStability, o: Options): Element {
  type Step = (typeof trace)[number];
  const known = trace.some((t) => t.distance !== null);
  // Steps go by decades towards 0, and the axis with them.
  const sizes = trace.map((t) => Math.abs(t.at)),
    nearest = Math.min(1, ...sizes.filter((v) => v > 0)),
    farthest = Math.max(nearest, ...sizes);
  const reached = (v: number) => v >= 0.99 * nearest && v <= 1.01 * farthest,
    powers = decades([nearest, farthest]),
    within = (powers.filter(reached).length > 2 ? powers : powers.flatMap((v) => [v, 3 * v])).filter(reached),
    skip = Math.max(1, Math.ceil((2 * within.length * 60) / o.width)),
    sides = within.filter((_, i) => (within.length - 1 - i) % skip === 0);
  const at = { x: "at", y: known ? "distance" : "verdict" };
  const words = (t: Step) =>
    `at ${short(t.at, 6)}: ${t.verdict}${t.distance === null ? "" : `, distance ${short(t.distance, 6)}`}`;
  const flips = trace
    .slice(1)
    .flatMap((t, i) => (t.verdict === trace[i]!.verdict ? [] : [{ at: (t.at + trace[i]!.at) / 2 }]));
  return Plot.plot(
    common(o, height, {
      x: {
        type: "symlog",
        constant: nearest,
        label: `${alongOf(path)}, logarithmic on both sides of 0 \u2192`,
        grid: true,
        ticks: [...sides.map((v) => -v), 0, ...sides],
        tickFormat: (v: number) => short(v, 1),
      },
      y: known
        ? { label: "\u2191 distance it returns, a length", grid: true, tickFormat: (v: number) => short(v) }
        : { label: null, domain: Object.keys(shapes) },
      marks: [
        Plot.ruleX(flips, { x: "at", stroke: colours.soft, strokeDasharray: "3 3" }),
        ...(known
          ? [
              Plot.ruleY([0], { stroke: colours.soft }),
              Plot.line(
                trace.filter((t) => t.distance !== null),
                { ...at, stroke: colours.soft, strokeWidth: 0.8 },
              ),
            ]
          : []),
        Plot.dot(trace, {
          ...at,
          fill: (t: Step) => (t.verdict === "touching" ? colours.own : colours.fg),
          symbol: (t: Step) => shapes[t.verdict] ?? "times",
          r: 2.6,
          ariaLabel: words,
        }),
        ...tips(trace, o, words, at),
      ],
    }),
  );
}
const height = 220;

/** The number of wrong flips of the verdict. One is right if the path goes through touching. */
const noiseOf = (p: PathStability) => p.flips - (p.path.startsWith("touching") ? 1 : 0);

export function Stability({ report }: { report: Report }) {
  const paths = useMemo(
    () => sort(report.paths, (x, y) => noiseOf(y) - noiseOf(x) || x.path.localeCompare(y.path)),
    [report],
  );
  const [path, choose] = useState(() => paths.find((p) => p.trace) ?? paths[0]);
  const draw = useCallback((width: number) => tracePlot(path!, { width }), [path]);
  if (!path) return null;
  return (
    <Section
      id="stability"
      title="Stability"
      lead={
        "Answers along a path of pairs, step by step. If the path goes through touching, one flip of the verdict is " +
        "right. If the gap or overlap stays the same, no flip is right. Each further flip is noise. A distance " +
        "jump is the excess over the jump of the true distance, divided by the size. Jumps of the direction count " +
        "only if the direction is unique."
      }>
      <div class="case">
        <div class="tall">
          <Table kind="choose" of={["path", "method", "n:steps", "n:flips", "n:distance jumps by", "n:direction by"]}>
            {paths.map((p) => (
              <tr key={`${p.path} ${p.method}`} class={p === path ? "at" : ""} onClick={() => choose(p)}>
                <td>{safe(p.path)}</td>
                <td>
                  <button type="button" class="link" aria-pressed={p === path}>
                    {safe(p.method)}
                  </button>
                </td>
                <td class="n">{grouped(p.steps)}</td>
                <td class={`n ${noiseOf(p) > 0 ? "bad" : ""}`}>{grouped(p.flips)}</td>
                <td class="n">{short(p.distance_jump)}</td>
                <td class="n">{short(p.direction_jump_degrees)}</td>
              </tr>
            ))}
          </Table>
        </div>
        <div>
          <h3>
            {safe(path.method)}, {safe(path.path)}
          </h3>
          {path.trace && path.trace.length > 0 ? (
            <Figure
              draw={draw}
              height={height}
              label="The answers along the path"
              caption="Circles are disjoint, squares intersecting, diamonds touching. The verdict flips at dashes."
            />
          ) : (
            <p class="soft">No trace is stored for this path.</p>
          )}
        </div>
      </div>
    </Section>
  );
}
