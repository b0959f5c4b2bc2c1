// SPDX-License-Identifier: MIT
// The causes, and every finding that was kept: filtered by a search, sorted by columns, kept in the address.
import { useLayoutEffect, useMemo, useState } from "preact/hooks";
import { Section } from "../parts/elements.tsx";
import { grouped, plural } from "../parts/words.ts";
import { remember, type Address } from "./address.ts";
import { Causes } from "./causes.tsx";
import { csvOf, jsonOf, save } from "./files.ts";
import {
  causesOf,
  chipCounts,
  filtered,
  filteredCauses,
  loneCounts,
  queryOf,
  rowsOf,
  sorted,
  sortedCauses,
  viewOf,
  worstFirst,
  type View,
} from "./filter.ts";
import { FindingsTable } from "./findings_table.tsx";
import type { FullReport } from "./report.ts";
import { Search } from "./search.tsx";

/** The view that the address asks for; what is changed of it here is written there, so that it can be passed on. */
function useView(address: Address): [View, (view: View) => void] {
  const [view, set] = useState(() => viewOf(address.query));
  useLayoutEffect(() => {
    if (address.detail) return;
    const asked = viewOf(address.query);
    if ([...address.query].length === 0 && !address.again) remember(queryOf(view));
    else set((was) => (queryOf(was) === queryOf(asked) ? was : asked));
  }, [address]);
  useLayoutEffect(() => {
    if (!address.detail) remember(queryOf(view));
  }, [view]);
  return [view, set];
}

const ofAll = (shown: number, all: number, one: string) =>
  shown === all ? plural(all, one) : `${grouped(shown)} of ${plural(all, one)}`;

const lead = (report: FullReport) =>
  `${grouped(report.findings_total)} in all. For each method, kind and family the first ten are kept as examples, ` +
  `and each later one that is worse. The margin of a wrong distance is its error over the size (r + h + r + h). The ` +
  `margin of any other finding is the signed distance between the solids over the size. Margins are lower bounds.`;

export function Findings({ report, address }: { report: FullReport; address: Address }) {
  const all = useMemo(() => rowsOf(report), [report]);
  const allCauses = useMemo(() => causesOf(report), [report]);
  const [view, set] = useView(address);
  const { filter, order } = view;
  const passing = useMemo(() => filtered(all, filter), [all, filter]);
  const shown = useMemo(() => {
    const own = order.column === "margin" || order.column === "id";
    return sorted(own ? passing : worstFirst(passing), order);
  }, [passing, order]);
  const causes = useMemo(
    () => sortedCauses(filteredCauses(allCauses, passing, filter), view.causes),
    [allCauses, passing, filter, view.causes],
  );
  const counts = useMemo(() => chipCounts(all, filter), [all, filter]);
  const lone = useMemo(() => loneCounts(allCauses, filter), [allCauses, filter]);
  const said = [
    ofAll(shown.length, all.length, "finding"),
    ...(allCauses.length > 0 ? [ofAll(causes.length, allCauses.length, "cause")] : []),
  ].join(", ");
  const any = all.length > 0 || allCauses.length > 0;
  return (
    <Section id="findings" title="All findings" lead={all.length === 0 ? undefined : lead(report)}>
      {all.length === 0 && <p class="ok">No method was wrong, and none failed.</p>}
      {any && (
        <Search
          filter={filter}
          set={(filter) => set({ ...view, filter })}
          counts={counts}
          lone={lone}
          said={said}
        />
      )}
      {allCauses.length > 0 && (
        <Causes causes={causes} order={view.causes} setOrder={(order) => set({ ...view, causes: order })} />
      )}
      {all.length > 0 && (
        <>
          <p class="tools saving">
            <span class="soft">Save the findings shown</span>
            <button
              type="button"
              onClick={() => save(`${report.run.id}-findings.csv`, "text/csv", csvOf(shown, report))}>
              CSV
            </button>
            <button
              type="button"
              onClick={() => save(`${report.run.id}-findings.json`, "application/json", jsonOf(shown, report))}>
              JSON
            </button>
          </p>
          <FindingsTable rows={shown} order={order} setOrder={(o) => set({ ...view, order: o })} />
          <p class="only-print soft">Of {said}, only the rows that were on the screen are printed.</p>
        </>
      )}
    </Section>
  );
}
