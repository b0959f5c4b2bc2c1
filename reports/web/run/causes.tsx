// SPDX-License-Identifier: MIT
// The table of causes: sorted by its heads; on a narrow screen a card for each.
import { useRef } from "preact/hooks";
import { grouped, leastRange, percent, safe, short } from "../parts/words.ts";
import type { Bucket } from "./data.ts";
import { causeColumns, type Cause, type CauseColumn, type CauseOrder } from "./filter.ts";
import { about } from "./glossary.ts";
import { useRoving } from "./roving.ts";
import { severityLabels, standingLabel } from "./words.ts";

const titles: Record<CauseColumn, string> = {
  key: "cause",
  methods: "methods",
  severity: "severity",
  count: "findings",
  margin: "margins",
  share: "share of pairs like it",
  standing: "since earlier runs",
  seen: "first seen",
};
const numeric = new Set<CauseColumn>(["count", "margin", "share"]);

const few = (names: string[]) =>
  names.length < 4 ? safe(names.join(", ")) : `${safe(names.slice(0, 2).join(", "))} and ${names.length - 2} more`;

export const bucketAddress = (key: string) => `#/bucket/${key.split("/").map(encodeURIComponent).join("/")}`;

export const formatNote = ({ note }: Bucket) => (note ? `${note.owner}${note.note && `: ${note.note}`}` : "");

function Name({ b }: { b: Bucket }) {
  return (
    <>
      <a href={bucketAddress(b.key)}>{safe(b.key)}</a>
      {b.suppressed && (
        <>
          {" "}
          <span class="tag" title={safe(b.suppressed.reason)}>
            suppressed until {safe(b.suppressed.expires)}
          </span>
        </>
      )}
      <div class="soft">
        {safe(b.cause)}
      </div>
      {b.note && <div class="note">{safe(formatNote(b))}</div>}
    </>
  );
}

const standingHint = ({ standing, chance }: Bucket) =>
  [standing ? about(standing) : "", chance !== null ? `By chance: ${short(chance)}` : ""].join("\n").trim();

function CauseRow({ b }: { b: Bucket }) {
  const share = b.share && `${grouped(b.share.wrong)} of ${grouped(b.share.asked)}`;
  return (
    <tr class={b.suppressed ? "suppressed" : ""}>
      <td class="wrap" data-label={titles.key}>
        <Name b={b} />
      </td>
      <td class="wrap soft" data-label={titles.methods} title={safe((b.methods).join(", "))}>
        {few(b.methods)}
      </td>
      <td class={b.severity === "contract" ? "bad" : ""} data-label={titles.severity}>
        {severityLabels[b.severity] ?? safe(b.severity)}
      </td>
      <td class="n" data-label={titles.count}>
        {grouped(b.count)}
      </td>
      <td class="n" data-label={titles.margin}>
        {leastRange(b.margin)}
      </td>
      <td class="n" data-label={titles.share} title={share ?? ""}>
        {b.share ? percent(b.share.wrong, b.share.asked) : "\u2013"}
      </td>
      <td data-label={titles.standing} title={standingHint(b)}>
        {standingLabel(b.standing)}
      </td>
      <td data-label={titles.seen}>{safe(b.first_seen)}</td>
    </tr>
  );
}

export function Causes({
  causes,
  order,
  setOrder,
}: {
  causes: Cause[];
  order: CauseOrder;
  setOrder: (order: CauseOrder) => void;
}) {
  const table = useRef<HTMLTableElement>(null);
  const roving = useRoving(table);
  const turn = (column: CauseColumn) =>
    setOrder({ column, down: order.column === column ? !order.down : numeric.has(column) });
  return (
    <div class="scroll">
      <table class="plain sortable buckets" ref={table} aria-label="Causes; arrow keys move, Enter opens" {...roving}>
        <thead>
          <tr>
            {causeColumns.map((c) => (
              <th
                scope="col"
                class={numeric.has(c) ? "n" : ""}
                title={about(titles[c])}
                aria-sort={order.column === c ? (order.down ? "descending" : "ascending") : "none"}
                key={c}>
                <button type="button" onClick={() => turn(c)}>
                  {titles[c]}
                </button>
              </th>
            ))}
          </tr>
        </thead>
        <tbody>
          {causes.map(({ b }) => (
            <CauseRow b={b} key={b.key} />
          ))}
        </tbody>
      </table>
    </div>
  );
}
