// SPDX-License-Identifier: MIT
// The run at a glance: what is new, what was found, methods against families.
import { useMemo, useState } from "preact/hooks";
import { Section } from "../parts/elements.tsx";
import { groupBy, grouped, percent, plural, safe } from "../parts/words.ts";
import type { Tally } from "./data.ts";
import { Fact, Heads, ShareLegend } from "./elements.tsx";
import { about } from "./glossary.ts";
import { heatStep, type Heat } from "./heat.ts";
import { New } from "./new.tsx";
import type { FullReport } from "./report.ts";
import { claimOrigin, formatClaim, kindLabel, library } from "./words.ts";

const counts = ["asked", "declined", "failed", "contract", "resolution", "undecided"] as const;
const countLabels: Record<string, string> = { contract: "beyond claim", resolution: "within claim" };
type Sum = Pick<Tally, (typeof counts)[number]>;
const sumOf = (tallies: Tally[]) =>
  Object.fromEntries(counts.map((k) => [k, tallies.reduce((n, t) => n + t[k], 0)])) as Sum;
const failures = (c: Sum) => c.contract + c.failed;

interface Row {
  name: string;
  methods: string[]; // of a library; of a method itself
  total: Sum;
  families: Map<string, Sum>;
}

function rowOf(report: FullReport, name: string, methods: string[]): Row {
  const tallies = report.tallies.filter((t) => methods.includes(t.method)),
    families = groupBy(tallies, (t) => t.family);
  return {
    name,
    methods,
    total: sumOf(tallies),
    families: new Map([...families].map(([family, of]) => [family, sumOf(of)])),
  };
}

/** The methods that were asked, in the order of the run. */
const askedOf = (report: FullReport) =>
  report.methods.map((m) => m.name).filter((name) => report.tallies.some((t) => t.method === name));

/** What of a cell is shown, the worst of it: beyond a claim or failed, else within a claim, else undecided. */
function heatOf(c: Sum | undefined): [heat: Heat, step: number] {
  if (!c || c.asked === 0) return ["empty", 0];
  if (failures(c) > 0) return ["bad", heatStep(failures(c) / c.asked)];
  if (c.resolution > 0) return ["within", heatStep(c.resolution / c.asked)];
  if (c.undecided > 0) return ["undecided", heatStep(c.undecided / c.asked)];
  return ["clean", 0];
}

const describeCell = (name: string, family: string, c: Sum | undefined) =>
  !c || c.asked === 0
    ? `${name}, ${family}: not asked`
    : [
        `${name}, ${family}`,
        `asked ${grouped(c.asked)}`,
        ...counts
          .slice(1)
          .filter((k) => c[k] > 0)
          .map((k) => `${countLabels[k] ?? k} ${grouped(c[k])} (${percent(c[k], c.asked)})`),
      ].join("\n");

function HeatRow({ row, report, of }: { row: Row; report: FullReport; of: "library" | "text" }) {
  return (
    <tr class={of === "library" ? "group" : "member"}>
      <th scope="row">{safe(row.name)}</th>
      {counts.map((k) => (
        <td class={`n ${row.total[k] === 0 ? "zero" : k === "contract" || k === "failed" ? "bad" : ""}`} key={k}>
          {row.total[k] === 0 ? "\u00b7" : grouped(row.total[k])}
        </td>
      ))}
      {report.families.map(({ name: family }) => {
        const c = row.families.get(family),
          [heat, step] = heatOf(c),
          words = describeCell(row.name, family, c);
        return (
          <td class={`heat ${heat} s${step}`} title={words} key={family}>
            {(heat === "bad" || heat === "within") && (
              <a
                href={`#/findings?${new URLSearchParams({ [of]: row.name, family })}`}
                aria-label={words}
                tabIndex={-1}>
                {c!.failed > 0 ? "\u00d7" : ""}
              </a>
            )}
          </td>
        );
      })}
    </tr>
  );
}

function HeatTable({ report }: { report: FullReport }) {
  const [isOpen, open] = useState(false);
  const rows = useMemo(() => {
    const libraries = [...groupBy(askedOf(report), library)];
    return libraries.map(([name, methods]) => ({
      row: rowOf(report, name, methods),
      members: methods.map((m) => rowOf(report, m, [m])),
    }));
  }, [report]);
  return (
    <>
      <p class="tools">
        <button type="button" aria-expanded={isOpen} onClick={() => open(!isOpen)}>
          {isOpen ? "Libraries only" : "All methods"}
        </button>
        <span class="legend" aria-hidden="true">
          <i class="heat bad s4" /> wrong beyond the claim or failed (×) <i class="heat within s4" /> wrong within the
          claim <i class="heat undecided s4" /> undecided <i class="heat clean" /> none of these{" "}
          <i class="heat empty" /> not asked
        </span>
        <ShareLegend />
      </p>
      <div class="scroll">
        <table class="heat-table" aria-label="Methods against families">
          <thead>
            <tr>
              <th scope="col" title={about("method")}>
                method
              </th>
              {counts.map((k) => (
                <th scope="col" class="n" title={about(countLabels[k] ?? k)} key={k}>
                  {countLabels[k] ?? k}
                </th>
              ))}
              {report.families.map((f) => (
                <th scope="col" class="turned" title={f.summary} key={f.name}>
                  <a href={`#/findings?${new URLSearchParams({ family: f.name })}`}>{kindLabel(f.name)}</a>
                </th>
              ))}
            </tr>
          </thead>
          <tbody>
            {rows.flatMap(({ row, members }) => [
              <HeatRow row={row} report={report} of="library" key={row.name} />,
              ...(isOpen && members.length > 1
                ? members.map((m) => <HeatRow row={m} report={report} of="text" key={`${row.name}/${m.name}`} />)
                : []),
            ])}
          </tbody>
        </table>
      </div>
    </>
  );
}

function Headline({ report }: { report: FullReport }) {
  const rows = askedOf(report).map((m) => rowOf(report, m, [m])),
    bad = rows.filter((r) => failures(r.total) > 0),
    own = new Set(report.methods.filter((m) => m.own).map((m) => m.name)),
    ownBad = bad.filter((r) => own.has(r.name));
  const { undecided } = rowOf(report, "referee", ["referee"]).total,
    failing = rowOf(report, "corpus", ["corpus"]).total.contract,
    unreadable = report.unreadable ?? 0;
  return (
    <>
      <dl class="facts">
        <Fact label="pairs judged">{grouped(report.run.pairs)}</Fact>
        <Fact label="truth undecided" kind={undecided > 0 ? "warn" : ""}>
          {grouped(undecided)}
        </Fact>
        <Fact label="findings">{grouped(report.findings_total)}</Fact>
        <Fact label="causes">
          {report.buckets.length > 0 ? grouped(report.buckets.filter((b) => b.count > 0).length) : "\u2013"}
        </Fact>
        <Fact label="methods beyond their claim" kind={bad.length > 0 ? "bad" : ""}>
          {bad.length} of {rows.length}
        </Fact>
        <Fact label="of ours" kind={ownBad.length > 0 ? "bad" : "ok"}>
          {ownBad.length} of {own.size}
        </Fact>
        <Fact label="known cases now failing" kind={failing > 0 ? "bad" : ""}>
          {grouped(failing)}
        </Fact>
      </dl>
      {unreadable > 0 && (
        <p class="warn">
          {plural(unreadable, "finding")} of the store cannot be read and {unreadable === 1 ? "is" : "are"} not on this
          page.
        </p>
      )}
    </>
  );
}

export const Summary = ({ report }: { report: FullReport }) => (
  <Section id="new" title="What is new">
    <New report={report} />
    <Headline report={report} />
    {report.tallies.length > 0 ? (
      <HeatTable report={report} />
    ) : (
      <p class="missing">This run asked no method.</p>
    )}
  </Section>
);

export const Methods = ({ report }: { report: FullReport }) => (
  <Section
    id="methods"
    title="Methods and what they claim"
    lead={
      "The claim of a method is the tolerance that its documentation states. An error beyond the claim is a fault. " +
      "Errors within the claim are counted separately."
    }>
    <details>
      <summary>{plural(report.methods.length, "method")}</summary>
      <div class="scroll">
        <table class="plain">
          <Heads of={["method", "version", "claims to be", "claim", "because", "n:asked on"]} />
          <tbody>
            {report.methods.map((m) => (
              <tr key={m.name}>
                <td>{safe(m.name)}</td>
                <td>{safe(m.version)}</td>
                <td>{formatClaim(m.claim)}</td>
                <td title={about(claimOrigin(m.claim))}>{claimOrigin(m.claim)}</td>
                <td class="wrap soft">{safe(m.claim.source)}</td>
                <td class="n">{m.share === 1 ? "all" : `1 in ${m.share}`}</td>
              </tr>
            ))}
          </tbody>
        </table>
      </div>
    </details>
  </Section>
);
