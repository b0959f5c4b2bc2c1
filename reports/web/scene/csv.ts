// SPDX-License-Identifier: MIT
// The table of pairs as a file for spreadsheets (RFC 4180): all that is known of each pair, with units in the head.
import { csvCell } from "../parts/save.ts";
import { leastOf, proofOf, riskOf } from "./risk.ts";
import { models, unitOf, type Study } from "./study.ts";

/** After the scene's own file. */
export const csvName = ({ file }: Study) => `${file.replace(/^.*\//, "")}-pairs.csv`;

/** `rows`: of study.pairs, in this order; `here`: their gaps in the configuration shown. */
export function csvOfStudy(study: Study, rows: readonly number[], here: readonly (number | null)[]): string {
  const unit = unitOf(study) || "scene unit";
  const inUnit = (name: string) => `${name} [${unit}]`;
  const head = [
    ...["a", "b", "link_a", "link_b", "state", inUnit("least_gap"), inUnit("gap_here"), inUnit("clearance")],
    ...["samples [1]", "within [1]", "within_rate_low [1]", "within_rate_high [1]", "known"],
    ...["proved", inUnit("proved_apart"), "open_share [1]", "needs", "recommended"],
    ...models.flatMap((model) => {
      const name = model.replace(" ", "_");
      return [`${name}_wrong [1]`, inUnit(`${name}_false_alarm`), inUnit(`${name}_missed`)];
    }),
  ];
  const lines = rows.map((i) => {
    const pair = study.pairs[i]!,
      proof = proofOf(study, i),
      link = (side: 0 | 1) => study.bodies[pair.bodies[side]]!.link;
    return [
      ...[pair.a, pair.b, link(0), link(1), riskOf(study, i), leastOf(study, i), here[i], study.clearance],
      ...[pair.samples, pair.within, ...pair.within_rate, pair.known ? "yes" : "no"],
      ...[proof?.verdict, proof?.verdict === "never" ? proof.bound : null, proof?.open_share],
      ...[pair.needs, pair.recommended.join(" then ")],
      ...pair.models.flatMap((m) => [m.wrong, m.false_alarm, m.missed]),
    ];
  });
  return [head, ...lines].map((cells) => `${cells.map(csvCell).join(",")}\r\n`).join("");
}
