// SPDX-License-Identifier: MIT
// The run at a glance: what was found, methods against families, how it stands against earlier runs.
import { useMemo, useState } from "preact/hooks";
import type { Report, Standing, Tally } from "./data.ts";
import { Section } from "./parts.tsx";
import { heat_step, type Heat } from "./plots.ts";
import type { FullReport } from "./report.ts";
import {
  claim_words,
  group_by,
  grouped,
  kind_words,
  library,
  percent,
  plural,
  safe,
  severity_words,
  time,
} from "./words.ts";

type Sum = Omit<Tally, "method" | "family">;
const none: Sum = { asked: 0, declined: 0, failed: 0, contract: 0, resolution: 0, undecided: 0, nanoseconds: 0 };
const counts = ["asked", "declined", "failed", "contract", "resolution", "undecided"] as const;
const count_words: Record<string, string> = { contract: "beyond claim", resolution: "within claim" };
const plus = (x: Sum, y: Sum): Sum => ({
  asked: x.asked + y.asked,
  declined: x.declined + y.declined,
  failed: x.failed + y.failed,
  contract: x.contract + y.contract,
  resolution: x.resolution + y.resolution,
  undecided: x.undecided + y.undecided,
  nanoseconds: x.nanoseconds + y.nanoseconds,
});

interface Row {
  name: string;
  total: Sum;
  families: Map<string, Sum>;
}

function add_up(name: string, tallies: Tally[]): Row {
  const row: Row = { name, total: none, families: new Map() };
  for (const t of tallies) {
    row.total = plus(row.total, t);
    row.families.set(t.family, plus(row.families.get(t.family) ?? none, t));
  }
  return row;
}

/** The methods by library, in the order of the run. */
function rows_of(report: Report) {
  const by_method = group_by(report.tallies, (t) => t.method);
  const names = report.methods.map((m) => m.name).filter((name) => by_method.has(name));
  return [...group_by(names, library)].map(([name, members]) => ({
    ...add_up(
      name,
      members.flatMap((m) => by_method.get(m)!),
    ),
    members: members.map((m) => add_up(m, by_method.get(m)!)),
  }));
}

/** What of a cell is shown, the worst of it: beyond a claim or failed, else within a claim, else undecided. */
function heat_of(c: Sum | undefined): { heat: Heat; step: number; failed: boolean } {
  if (!c || c.asked === 0) return { heat: "empty", step: 0, failed: false };
  const bad = c.contract + c.failed;
  if (bad > 0) return { heat: "bad", step: heat_step(bad / c.asked), failed: c.failed > 0 };
  if (c.resolution > 0) return { heat: "within", step: heat_step(c.resolution / c.asked), failed: false };
  if (c.undecided > 0) return { heat: "undecided", step: heat_step(c.undecided / c.asked), failed: false };
  return { heat: "clean", step: 0, failed: false };
}

const cell_words = (name: string, family: string, c: Sum | undefined) =>
  !c || c.asked === 0
    ? `${name}, ${family}: not asked`
    : [
        `${name}, ${family}`,
        `asked ${grouped(c.asked)}`,
        ...counts
          .slice(1)
          .filter((k) => c[k] > 0)
          .map((k) => `${count_words[k] ?? k} ${grouped(c[k])} (${percent(c[k], c.asked)})`),
        `${time(c.nanoseconds / c.asked)} a pair`,
      ].join("\n");

function HeatRow({
  row,
  families,
  level,
  open,
  toggle,
}: {
  row: Row;
  families: string[];
  level: 0 | 1;
  open?: boolean;
  toggle?: () => void;
}) {
  const t = row.total,
    members = toggle !== undefined;
  return (
    <tr class={level === 0 ? "group" : "member"}>
      <th scope="row">
        {members ? (
          <button type="button" class="unfold" aria-expanded={open} onClick={toggle}>
            {safe(row.name)}
          </button>
        ) : (
          <span>{safe(row.name)}</span>
        )}
      </th>
      {counts.map((k) => (
        <td class={`n ${t[k] === 0 ? "zero" : k === "contract" || k === "failed" ? "bad" : ""}`} key={k}>
          {t[k] === 0 ? "\u00b7" : grouped(t[k])}
        </td>
      ))}
      <td class="n">{t.asked === 0 ? "" : grouped(t.nanoseconds / t.asked)}</td>
      {families.map((family) => {
        const c = row.families.get(family),
          { heat, step, failed } = heat_of(c);
        const known = heat === "bad" || heat === "within";
        const where = `#/findings?${new URLSearchParams({ [members ? "library" : "method"]: row.name, family })}`;
        return (
          <td class={`heat ${heat} s${step}`} title={cell_words(row.name, family, c)} key={family}>
            {known ? (
              <a href={where} aria-label={cell_words(row.name, family, c)}>
                {failed ? "\u00d7" : ""}
              </a>
            ) : null}
          </td>
        );
      })}
    </tr>
  );
}

function HeatTable({ report }: { report: FullReport }) {
  const groups = useMemo(() => rows_of(report), [report]);
  const [open, set] = useState<ReadonlySet<string>>(new Set());
  const toggle = (name: string) =>
    set((was) => {
      const now = new Set(was);
      if (!now.delete(name)) now.add(name);
      return now;
    });
  const families = report.families.map((f) => f.name);
  const all_open = groups.every((g) => open.has(g.name) || g.members.length < 2);
  return (
    <>
      <p class="tools">
        <button type="button" onClick={() => set(all_open ? new Set() : new Set(groups.map((g) => g.name)))}>
          {all_open ? "Fold all" : "Unfold all methods"}
        </button>
        <span class="legend" aria-hidden="true">
          <i class="heat bad s5" /> wrong beyond the claim or failed (×) <i class="heat within s4" /> wrong within the
          claim <i class="heat undecided s4" /> undecided <i class="heat clean" /> neither <i class="heat empty" /> not
          asked; the stronger the colour, the larger the share
        </span>
      </p>
      <div class="scroll">
        <table class="heat-table">
          <thead>
            <tr>
              <th scope="col">method</th>
              {counts.map((k) => (
                <th scope="col" class="n" key={k}>
                  {count_words[k] ?? k}
                </th>
              ))}
              <th scope="col" class="n">
                ns/pair
              </th>
              {report.families.map((f) => (
                <th scope="col" class="turned" title={f.summary} key={f.name}>
                  <span>{f.name.replaceAll("_", " ")}</span>
                </th>
              ))}
            </tr>
          </thead>
          <tbody>
            {groups.flatMap((g) =>
              g.members.length < 2
                ? [<HeatRow row={g.members[0]!} families={families} level={0} key={g.name} />]
                : [
                    <HeatRow
                      row={g}
                      families={families}
                      level={0}
                      open={open.has(g.name)}
                      toggle={() => toggle(g.name)}
                      key={g.name}
                    />,
                    ...(open.has(g.name)
                      ? g.members.map((m) => (
                          <HeatRow row={m} families={families} level={1} key={`${g.name}/${m.name}`} />
                        ))
                      : []),
                  ],
            )}
          </tbody>
        </table>
      </div>
    </>
  );
}

function History({ report }: { report: FullReport }) {
  const { history } = report;
  if (!history) return <p class="soft">No earlier run stands beside this one: nothing to compare with.</p>;
  const order: Standing[] = ["new", "back", "gone", "known"];
  const by = group_by(history.groups, (g) => g.standing);
  return (
    <>
      <p>
        Against {plural(history.runs, "earlier run")}:{" "}
        {order.map((s, i) => (
          <>
            {i > 0 && ", "}
            <a href={s === "gone" ? "#/summary" : `#/findings?standing=${s}`}>
              <b>{grouped(by.get(s)?.length ?? 0)}</b> {s}
            </a>
          </>
        ))}{" "}
        (groups of method, kind and family).
      </p>
      {order.slice(0, 3).some((s) => by.has(s)) && (
        <details class="print">
          <summary>What is not as it was</summary>
          <table class="plain">
            <thead>
              <tr>
                <th>standing</th>
                <th>method</th>
                <th>kind</th>
                <th>severity</th>
                <th>family</th>
                <th class="n">count</th>
              </tr>
            </thead>
            <tbody>
              {order.slice(0, 3).flatMap((s) =>
                (by.get(s) ?? []).slice(0, 200).map((g) => (
                  <tr key={[g.method, g.kind, g.severity, g.family].join()}>
                    <td>{g.standing}</td>
                    <td>{safe(g.method)}</td>
                    <td>{safe(kind_words(g.kind))}</td>
                    <td>{safe(severity_words[g.severity] ?? g.severity)}</td>
                    <td>{safe(g.family)}</td>
                    <td class="n">{grouped(g.count)}</td>
                  </tr>
                )),
              )}
            </tbody>
          </table>
        </details>
      )}
    </>
  );
}

function Headline({ report }: { report: FullReport }) {
  const rows = rows_of(report).flatMap((g) => g.members);
  const bad = rows.filter((r) => r.total.contract + r.total.failed > 0);
  const own = new Set(report.methods.filter((m) => m.own).map((m) => m.name));
  const own_bad = bad.filter((r) => own.has(r.name));
  const referee = add_up(
    "referee",
    report.tallies.filter((t) => t.method === "referee"),
  ).total;
  const cases = add_up(
    "corpus",
    report.tallies.filter((t) => t.method === "corpus"),
  ).total;
  const unexplained = report.unreadable ?? 0;
  return (
    <>
      <dl class="facts">
        <div>
          <dt>pairs judged</dt>
          <dd>{grouped(report.run.pairs)}</dd>
        </div>
        <div>
          <dt>truth undecided</dt>
          <dd class={referee.undecided > 0 ? "warn" : ""}>{grouped(referee.undecided)}</dd>
        </div>
        <div>
          <dt>findings</dt>
          <dd>{grouped(report.findings_total)}</dd>
        </div>
        <div>
          <dt>kept with their pair</dt>
          <dd>{grouped(report.findings.length)}</dd>
        </div>
        <div>
          <dt>causes</dt>
          <dd>{report.buckets.length > 0 ? grouped(report.buckets.length) : "\u2013"}</dd>
        </div>
        <div>
          <dt>methods beyond their claim</dt>
          <dd class={bad.length > 0 ? "bad" : ""}>
            {bad.length} of {rows.length}
          </dd>
        </div>
        <div>
          <dt>of ours</dt>
          <dd class={own_bad.length > 0 ? "bad" : "ok"}>
            {own_bad.length} of {own.size}
          </dd>
        </div>
        <div>
          <dt>cases misstated</dt>
          <dd class={cases.contract > 0 ? "bad" : ""}>{grouped(cases.contract)}</dd>
        </div>
      </dl>
      {report.alarm && (
        <p class={`alarm ${report.alarm.green ? "ok" : "bad"}`} role={report.alarm.green ? undefined : "alert"}>
          <b>{report.alarm.green ? "The self-check passed." : "The self-check failed."}</b> {safe(report.alarm.text)}
        </p>
      )}
      {unexplained > 0 && (
        <p class="warn">
          {plural(unexplained, "finding")} of the store cannot be read and {unexplained === 1 ? "is" : "are"} not here.
        </p>
      )}
    </>
  );
}

export function Summary({ report }: { report: FullReport }) {
  return (
    <Section id="summary" title="Summary">
      <Headline report={report} />
      <History report={report} />
      {report.tallies.length > 0 ? (
        <HeatTable report={report} />
      ) : (
        <p class="missing">Nothing was asked in this run.</p>
      )}
    </Section>
  );
}

export function Methods({ report }: { report: FullReport }) {
  const referee = report.tallies.filter((t) => !report.methods.some((m) => m.name === t.method));
  const judges = [...group_by(referee, (t) => t.method)].map(([name, tallies]) => add_up(name, tallies));
  return (
    <Section
      id="methods"
      title="Methods and what they claim"
      lead={
        "A method is held to what its documentation says of its own tolerance: wrong beyond that is a finding " +
        "beyond its claim, wrong within it is counted apart."
      }>
      <details class="print">
        <summary>
          {plural(report.methods.length, "method")}, {plural(judges.length, "row")} of the referee and the cases
        </summary>
        <table class="plain">
          <thead>
            <tr>
              <th>method</th>
              <th>version</th>
              <th>claims to be</th>
              <th>because</th>
              <th class="n">asked on</th>
            </tr>
          </thead>
          <tbody>
            {report.methods.map((m) => (
              <tr key={m.name}>
                <td>{safe(m.name)}</td>
                <td>{safe(m.version)}</td>
                <td>{claim_words(m.claim)}</td>
                <td class="wrap soft">{safe(m.claim.source)}</td>
                <td class="n">{m.share === 1 ? "all" : `1 in ${m.share}`}</td>
              </tr>
            ))}
          </tbody>
        </table>
        <table class="plain">
          <thead>
            <tr>
              <th>judge</th>
              <th class="n">asked</th>
              <th class="n">undecided</th>
              <th class="n">wrong</th>
              <th class="n">a pair</th>
            </tr>
          </thead>
          <tbody>
            {judges.map((j) => (
              <tr key={j.name}>
                <td>{safe(j.name)}</td>
                <td class="n">{grouped(j.total.asked)}</td>
                <td class="n">{grouped(j.total.undecided)}</td>
                <td class="n">{grouped(j.total.contract)}</td>
                <td class="n">{j.total.asked ? time(j.total.nanoseconds / j.total.asked) : ""}</td>
              </tr>
            ))}
          </tbody>
        </table>
      </details>
    </Section>
  );
}
