// SPDX-License-Identifier: MIT
// Stability under small changes: the cost near touching, and the answers along a path.
import { useCallback, useMemo, useState } from "preact/hooks";
import { Figure, Section } from "../parts/elements.tsx";
import { screen } from "../parts/plot.ts";
import { grouped, inOrder, safe, short } from "../parts/words.ts";
import { Heads } from "./elements.tsx";
import type { FullReport } from "./report.ts";
import { tracePlot } from "./stability_plots.ts";

/** How often the verdict should turn: once where the path goes through touching. */
const rightFlips = (p: { path: string }) => (p.path.startsWith("touching") ? 1 : 0);

function Paths({ report }: { report: FullReport }) {
  const paths = useMemo(
    () =>
      inOrder(
        report.paths,
        (x, y) =>
          y.flips - rightFlips(y) - (x.flips - rightFlips(x)) || (x.path < y.path ? -1 : x.path > y.path ? 1 : 0),
      ),
    [report],
  );
  const [at, choose] = useState(() =>
    Math.max(
      0,
      paths.findIndex((p) => p.flips > rightFlips(p) && p.trace),
    ),
  );
  const path = paths[at];
  const draw = useCallback((width: number) => tracePlot(path!, { width, theme: screen }), [path]);
  if (!path) return null;
  return (
    <>
      <h3>Answers along a path</h3>
      <p class="lead">
        Pairs along a path, step by step. If the path goes through touching, one flip of the verdict is right. If the
        gap or overlap stays the same, no flip is right. Each further flip is noise. Jumps of the distance are in sizes,
        beyond the jump of the true distance. Jumps of the direction count only if the direction is unique.
      </p>
      <div class="case">
        <div class="scroll tall">
          <table class="plain choose">
            <Heads of={["path", "method", "n:steps", "n:flips", "n:distance jumps by", "n:direction by"]} />
            <tbody>
              {paths.map((p, i) => (
                <tr key={`${p.path} ${p.method}`} class={i === at ? "at" : ""} onClick={() => choose(i)}>
                  <td>{safe(p.path)}</td>
                  <td>
                    <button type="button" class="link" aria-pressed={i === at}>
                      {safe(p.method)}
                    </button>
                  </td>
                  <td class="n">{grouped(p.steps)}</td>
                  <td class={`n ${p.flips > rightFlips(p) ? "bad" : ""}`}>{grouped(p.flips)}</td>
                  <td class="n">{short(p.distance_jump)}</td>
                  <td class="n">
                    {p.direction_jump_degrees === null ? "\u2013" : `${short(p.direction_jump_degrees)}\u00b0`}
                  </td>
                </tr>
              ))}
            </tbody>
          </table>
        </div>
        <div>
          <h3>
            {safe(path.method)}, {safe(path.path)}
          </h3>
          {path.trace && path.trace.length > 0 ? (
            <Figure
              draw={draw}
              height={220}
              label="The answers along the path"
              caption="Round: disjoint; square: intersecting; diamond: touching. Dashed: the verdict flips."
            />
          ) : (
            <p class="soft">No trace is stored for this path.</p>
          )}
        </div>
      </div>
    </>
  );
}

export function Stability({ report }: { report: FullReport }) {
  if (report.paths.length === 0) return null;
  return (
    <Section id="stability" title="Stability">
      <Paths report={report} />
    </Section>
  );
}
