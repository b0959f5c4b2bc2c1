// SPDX-License-Identifier: MIT
// The causes, new ones first, and every finding that was kept. A text and three selections choose among both.
import { useMemo, useState } from "preact/hooks";
import { Section, Select } from "../parts/elements.tsx";
import { grouped, plural, safe, short } from "../parts/words.ts";
import type { Cause, Finding, Report } from "./data.ts";
import { Severity, Table } from "./elements.tsx";
import { about } from "./glossary.ts";
import { Thumbnail } from "./pair_view.tsx";
import { isOfNewFamilies, kindLabel, sentenceOf, severityLabels } from "./words.ts";

const selections = ["library", "kind", "family"] as const;
type Selection = (typeof selections)[number];
/** The choice; a part that is missing means all. It stands in the address behind "#/findings?". */
export type Filter = { [part in Selection | "text"]?: string };

export const toFindings = (filter: Filter) =>
  `#/findings?${new URLSearchParams(Object.entries(filter).filter(([, value]) => value !== ""))}`;
export const addressOf = (b: { key: string }) => `#/cause/${b.key.split("/").map(encodeURIComponent).join("/")}`;

/** A row, and its texts that a filter compares. */
type Choosable<T> = { row: T; text: string } & Record<Selection, string[]>;

const plain = (text: string) => text.toLowerCase().replaceAll("_", " ");
const causeOf = (b: Cause): Choosable<Cause> => ({
  row: b,
  library: b.libraries,
  kind: [b.kind],
  family: b.families,
  text: [b.key, sentenceOf(b), b.cause, b.status, severityLabels[b.severity], ...b.labels, ...b.methods].join(" "),
});
const findingOf = (f: Finding): Choosable<Finding> => ({
  row: f,
  library: [f.library],
  kind: [f.kind],
  family: [f.family],
  text: [`#${f.id}`, severityLabels[f.severity], f.kind, f.method, f.family, f.cause, f.reason, f.note].join(" "),
});
export const rowsOf = (report: Report) => ({
  causes: report.causes.map(causeOf),
  findings: report.findings.map(findingOf),
});

export const chosen = <T,>(all: Choosable<T>[], filter: Filter) =>
  all
    .filter((of) => selections.every((s) => !filter[s] || of[s].includes(filter[s])))
    .filter(({ text }) => plain(text).includes(plain(filter.text ?? "")))
    .map(({ row }) => row);

const CauseRow = ({ b }: { b: Cause }) => (
  <tr>
    <td title={about(b.status ?? "")}>
      <b class={b.status === "new" ? "bad" : ""}>{b.status ?? "\u2013"}</b>
    </td>
    <td class="wrap">
      <div class="cause">
        <Thumbnail shown={b.simplest} />
        <div>
          <a href={addressOf(b)}>{safe(b.key)}</a>
          <div>{safe(sentenceOf(b))}.</div>
          <div class="soft">
            {safe(b.cause)}
            {isOfNewFamilies(b) && "; no earlier run tested this method on these families"}
          </div>
        </div>
      </div>
    </td>
    <td>
      <Severity of={b.severity} />
    </td>
    <td class="n">{b.margin ? short(b.margin[1]) : "\u2013"}</td>
    <td class="n">{grouped(b.count)}</td>
    <td>{safe(b.first_seen)}</td>
  </tr>
);

const FindingRow = ({ f }: { f: Finding }) => (
  <tr>
    <td class="n">
      <a href={`#/finding/${f.id}`}>{f.id}</a>
    </td>
    <td>
      <Severity of={f.severity} />
    </td>
    <td>{safe(kindLabel(f.kind))}</td>
    <td>{safe(f.method)}</td>
    <td>{safe(kindLabel(f.family))}</td>
    <td class="n">{short(f.margin?.[0])}</td>
    <td>{f.cause && <a href={addressOf({ key: f.cause })}>{safe(f.cause)}</a>}</td>
  </tr>
);

const lead = (report: Report) =>
  `${grouped(report.findings_total)} in all. For each method, kind, severity and family, the run keeps the first ten ` +
  `findings, and each later one whose margin reaches a higher power of two. The margin of a wrong distance is its ` +
  `error over the size. The margin of any other finding is the signed distance between the solids over the size. ` +
  `Margins are lower bounds. The size is the sum of all radii, heights, edges and roundings. The worst finding comes ` +
  `first. The printed summary of the run names the same one.`;

const rowsAtFirst = 100;

export function Findings({ report, query }: { report: Report; query: string }) {
  const filter: Filter = Object.fromEntries(new URLSearchParams(query)),
    set = (part: Filter) => location.replace(toFindings({ ...filter, ...part }));
  const [whole, show] = useState(false);
  const all = useMemo(() => rowsOf(report), [report]);
  const causes = chosen(all.causes, filter),
    findings = chosen(all.findings, filter);
  const values = useMemo(() => {
    const of = (s: Selection) => [...new Set([...all.causes, ...all.findings].flatMap((row) => row[s]))].sort();
    return { library: of("library"), kind: of("kind"), family: of("family") };
  }, [all]);
  const ofAll = (shown: unknown[], rows: unknown[], one: string) =>
    shown.length === rows.length ? plural(rows.length, one) : `${grouped(shown.length)} of ${plural(rows.length, one)}`;
  if (all.findings.length + all.causes.length === 0)
    return (
      <Section id="findings" title="Causes and findings">
        <p class="ok">No method was wrong, and none failed.</p>
      </Section>
    );
  return (
    <Section id="findings" title="Causes and findings">
      <p class="tools filters">
        <input
          type="search"
          placeholder="Text to find"
          aria-label="Text of causes and findings"
          value={filter.text ?? ""}
          onInput={(event) => set({ text: event.currentTarget.value })}
        />
        {selections.map((s) => (
          <Select
            label={s}
            value={filter[s] ?? ""}
            onChange={(value) => set({ [s]: value })}
            options={["", ...values[s]].map((v) => [v, v ? kindLabel(safe(v)) : "all"])}
            key={s}
          />
        ))}
        <button type="button" disabled={query === ""} onClick={() => location.replace("#/findings")}>
          Clear
        </button>
        <span role="status">
          {ofAll(findings, all.findings, "finding")}, {ofAll(causes, all.causes, "cause")}
        </span>
      </p>
      {causes.length > 0 && (
        <Table
          kind="causes"
          of={["since earlier runs", "cause", "severity", "n:largest margin", "n:findings", "first seen"]}>
          {causes.map((b) => (
            <CauseRow b={b} key={b.key} />
          ))}
        </Table>
      )}
      <h3>Findings</h3>
      <p class="lead">{lead(report)}</p>
      <Table kind="findings" of={["n:#", "severity", "kind", "method", "family", "n:margin", "cause"]}>
        {findings.slice(0, whole ? findings.length : rowsAtFirst).map((f) => (
          <FindingRow f={f} key={f.id} />
        ))}
      </Table>
      {!whole && findings.length > rowsAtFirst && (
        <button type="button" onClick={() => show(true)}>
          Show all {plural(findings.length, "finding")}
        </button>
      )}
    </Section>
  );
}
