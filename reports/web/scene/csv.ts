// SPDX-License-Identifier: MIT
// The table of pairs as a file for spreadsheets (RFC 4180): all that is known of each pair, with units in the head.
import { csv_cell } from "../parts/save.ts";
import { least_of, proof_of, risk_of } from "./risk.ts";
import { models, unit_of, type Study } from "./study.ts";

/** After the scene's own file. */
export const csv_name = ({ file }: Study) => `${file.replace(/^.*\//, "")}-pairs.csv`;

/** `rows`: of study.pairs, in this order; `here`: their gaps in the configuration shown. */
export function csv_of_study(study: Study, rows: readonly number[], here: readonly (number | null)[]): string {
  const unit = unit_of(study) || "scene unit";
  const in_unit = (name: string) => `${name} [${unit}]`;
  const head = [
    ...["a", "b", "link_a", "link_b", "state", in_unit("least_gap"), in_unit("gap_here"), in_unit("clearance")],
    ...["samples [1]", "within [1]", "within_rate_low [1]", "within_rate_high [1]", "known"],
    ...["proved", in_unit("proved_apart"), "open_share [1]", "needs", "recommended"],
    ...models.flatMap((model) => {
      const name = model.replace(" ", "_");
      return [`${name}_wrong [1]`, in_unit(`${name}_false_alarm`), in_unit(`${name}_missed`)];
    }),
  ];
  const lines = rows.map((i) => {
    const pair = study.pairs[i]!,
      proof = proof_of(study, i),
      link = (side: 0 | 1) => study.bodies[pair.bodies[side]]!.link;
    return [
      ...[pair.a, pair.b, link(0), link(1), risk_of(study, i), least_of(study, i), here[i], study.clearance],
      ...[pair.samples, pair.within, ...pair.within_rate, pair.known ? "yes" : "no"],
      ...[proof?.verdict, proof?.verdict === "never" ? proof.bound : null, proof?.open_share],
      ...[pair.needs, pair.recommended.join(" then ")],
      ...pair.models.flatMap((m) => [m.wrong, m.false_alarm, m.missed]),
    ];
  });
  return [head, ...lines].map((cells) => `${cells.map(csv_cell).join(",")}\r\n`).join("");
}
