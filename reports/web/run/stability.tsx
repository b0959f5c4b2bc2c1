// SPDX-License-Identifier: MIT
// How steady the answers of each method are along paths of pairs, the least steady first.
import { sort } from "d3-array";
import { Section } from "../parts/elements.tsx";
import { grouped, safe, short } from "../parts/words.ts";
import type { PathStability, Report } from "./data.ts";
import { Table } from "./elements.tsx";

/** The number of wrong flips of the verdict. One is right if the path goes through touching. */
const noiseOf = (p: PathStability) => p.flips - (p.path.startsWith("touching") ? 1 : 0);

export function Stability({ report }: { report: Report }) {
  if (report.paths.length === 0) return null;
  const jump = (p: PathStability) => p.distance_jump ?? 0,
    paths = sort(report.paths, (x, y) => noiseOf(y) - noiseOf(x) || jump(y) - jump(x));
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
      <div class="tall">
        <Table kind="paths" of={["path", "method", "n:steps", "n:flips", "n:distance jumps by", "n:direction by"]}>
          {paths.map((p) => (
            <tr key={`${p.path} ${p.method}`}>
              <td>{safe(p.path)}</td>
              <td>{safe(p.method)}</td>
              <td class="n">{grouped(p.steps)}</td>
              <td class={`n ${noiseOf(p) > 0 ? "bad" : ""}`}>{grouped(p.flips)}</td>
              <td class="n">{short(p.distance_jump)}</td>
              <td class="n">{short(p.direction_jump_degrees)}</td>
            </tr>
          ))}
        </Table>
      </div>
    </Section>
  );
}
