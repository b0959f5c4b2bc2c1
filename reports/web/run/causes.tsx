// SPDX-License-Identifier: MIT
// The causes as rows: picture, sentence, runs. Sorted by the heads; on a narrow screen a card for each.
import { useRef } from "preact/hooks";
import { grouped, safe, short } from "../parts/words.ts";
import type { Cause } from "./data.ts";
import { causeColumns, type CauseEntry, type CauseColumn, type CauseOrder } from "./filter.ts";
import { about } from "./glossary.ts";
import { Sparkline } from "./nights.tsx";
import { Thumbnail } from "./pair_view.tsx";
import { useRoving } from "./roving.ts";
import { sentenceOf } from "./sentence.ts";
import { severityLabels, standingLabel } from "./words.ts";

const titles: Record<CauseColumn, string> = {
  key: "cause",
  margin: "largest margin",
  count: "findings",
  standing: "since earlier runs",
  seen: "first seen",
};
const numeric = new Set<CauseColumn>(["count", "margin"]);

export const causeAddress = (key: string) => `#/bucket/${key.split("/").map(encodeURIComponent).join("/")}`;


/** A run of its nights with the day on which it began. */
export const formatRun = ({ nights }: Cause, run: string) => {
  const night = nights.find((n) => n.run === run);
  return night ? `${safe(night.started.slice(0, 10))} (${safe(run)})` : safe(run);
};

const standingHint = ({ standing, chance }: Cause) =>
  [standing ? about(standing) : "", chance !== null ? `By chance: ${short(chance)}` : ""].join("\n").trim();

function CauseRow({ b }: { b: Cause }) {
  const severity = severityLabels[b.severity] ?? safe(b.severity);
  return (
    <tr class={b.suppressed ? "suppressed" : ""}>
      <td class="wrap" data-label={titles.key}>
        <div class="cause">
          <Thumbnail shown={b.simplest} />
          <div>
            <a href={causeAddress(b.key)}>{safe(b.key)}</a>{" "}
            <span class={`tag ${b.severity === "contract" ? "bad" : "soft"}`} title={about(severity)}>
              {severity}
            </span>
            {b.suppressed && (
              <span class="tag" title={safe(b.suppressed.reason)}>
                suppressed until {safe(b.suppressed.expires)}
              </span>
            )}
            <div>{safe(sentenceOf(b))}.</div>
            <div class="soft">{safe(b.cause)}</div>
          </div>
        </div>
      </td>
      <td class="n" data-label={titles.margin}>
        {b.margin ? short(b.margin[1]) : "\u2013"}
      </td>
      <td class="n" data-label={titles.count}>
        {grouped(b.count)}
      </td>
      <td data-label={titles.standing} title={standingHint(b)}>
        {standingLabel(b.standing)}
        {b.nights.length > 1 && <Sparkline nights={b.nights} />}
      </td>
      <td data-label={titles.seen}>{formatRun(b, b.first_seen)}</td>
    </tr>
  );
}

export function Causes({
  causes,
  order,
  setOrder,
}: {
  causes: CauseEntry[];
  order: CauseOrder;
  setOrder: (order: CauseOrder) => void;
}) {
  const table = useRef<HTMLTableElement>(null);
  const roving = useRoving(table);
  const turn = (column: CauseColumn) =>
    setOrder({ column, down: order.column === column ? !order.down : numeric.has(column) });
  return (
    <div class="scroll">
      <table class="plain sortable causes" ref={table} aria-label="Causes; arrow keys move, Enter opens" {...roving}>
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
