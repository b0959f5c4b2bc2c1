// SPDX-License-Identifier: MIT
// The run at a glance: what was found, methods against families, how it stands against earlier runs.
import { useMemo, useRef, useState } from "preact/hooks";
import { Section } from "../parts/elements.tsx";
import { groupBy, grouped, inOrder, percent, plural, safe, time } from "../parts/words.ts";
import type { Standing, Tally } from "./data.ts";
import { Fact, Heads } from "./elements.tsx";
import { about } from "./glossary.ts";
import { heatStep, type Heat } from "./heat.ts";
import { New } from "./new.tsx";
import { changesOf, type FullReport } from "./report.ts";
import { useRoving } from "./roving.ts";
import { formatClaim, kindLabel, library, claimOrigin, severityLabels } from "./words.ts";

type Sum = Omit<Tally, "method" | "family">;
const none: Sum = { asked: 0, declined: 0, failed: 0, contract: 0, resolution: 0, undecided: 0, nanoseconds: 0 };
const counts = ["asked", "declined", "failed", "contract", "resolution", "undecided"] as const;
const countLabels: Record<string, string> = { contract: "beyond claim", resolution: "within claim" };
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

function addUp(name: string, tallies: Tally[]): Row {
  const row: Row = { name, total: none, families: new Map() };
  for (const t of tallies) {
    row.total = plus(row.total, t);
    row.families.set(t.family, plus(row.families.get(t.family) ?? none, t));
  }
  return row;
}

/** The methods by library, in the order of the run. */
function rowsOf(report: FullReport) {
  const byMethod = groupBy(report.tallies, (t) => t.method);
  const names = report.methods.map((m) => m.name).filter((name) => byMethod.has(name));
  return [...groupBy(names, library)].map(([name, members]) => ({
    ...addUp(
      name,
      members.flatMap((m) => byMethod.get(m)!),
    ),
    members: members.map((m) => addUp(m, byMethod.get(m)!)),
  }));
}

/** What of a cell is shown, the worst of it: beyond a claim or failed, else within a claim, else undecided. */
function heatOf(c: Sum | undefined): { heat: Heat; step: number; failed: boolean } {
  if (!c || c.asked === 0) return { heat: "empty", step: 0, failed: false };
  if (failures(c) > 0) return { heat: "bad", step: heatStep(failures(c) / c.asked), failed: c.failed > 0 };
  if (c.resolution > 0) return { heat: "within", step: heatStep(c.resolution / c.asked), failed: false };
  if (c.undecided > 0) return { heat: "undecided", step: heatStep(c.undecided / c.asked), failed: false };
  return { heat: "clean", step: 0, failed: false };
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
        `${time(c.nanoseconds / c.asked)} a pair`,
      ].join("\n");

const failures = (c: Sum) => c.contract + c.failed;
const shareOf = (count: number, c: Sum) => (c.asked === 0 ? -1 : count / c.asked);
const worstFirst = <R extends Row>(rows: R[], family: string): R[] => {
  const of = (row: Row) => row.families.get(family) ?? none;
  return inOrder(
    rows,
    (x, y) =>
      shareOf(failures(of(y)), of(y)) - shareOf(failures(of(x)), of(x)) ||
      shareOf(of(y).resolution, of(y)) - shareOf(of(x).resolution, of(x)),
  );
};

/** Which library fails most on the pairs of a family. */
function WorstOf({ groups, family, all }: { groups: Row[]; family: string; all: () => void }) {
  const [worst] = worstFirst(groups, family),
    c = worst?.families.get(family) ?? none;
  return (
    <p role="status">
      On {kindLabel(family)}
      {failures(c) === 0 ? (
        " no library is wrong beyond its claim, and none failed."
      ) : (
        <>
          , <b>{safe(worst!.name)}</b> fails most: {percent(failures(c), c.asked)} ({grouped(failures(c))} of{" "}
          {grouped(c.asked)} answers) beyond its claim or failed.
        </>
      )}{" "}
      The numbers below are of these pairs.{" "}
      <button type="button" class="link" onClick={all}>
        All families
      </button>
    </p>
  );
}

function HeatRow({
  row,
  families,
  family,
  level,
  open,
  toggle,
}: {
  row: Row;
  families: string[];
  family: string | null; // of the numbers; of all if null
  level: 0 | 1;
  open?: boolean;
  toggle?: () => void;
}) {
  const t = family === null ? row.total : (row.families.get(family) ?? none),
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
          { heat, step, failed } = heatOf(c);
        const known = heat === "bad" || heat === "within";
        const filter = { [members ? "library" : "method"]: row.name, family },
          words = describeCell(row.name, family, c);
        return (
          <td class={`heat ${heat} s${step}`} title={words} key={family}>
            {known ? (
              <a href={`#/findings?${new URLSearchParams(filter)}`} aria-label={words}>
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
  const all = useMemo(() => rowsOf(report), [report]);
  const [family, choose] = useState<string | null>(null);
  const groups = useMemo(() => {
    if (family === null) return all;
    return worstFirst(all, family).map((g) => ({ ...g, members: worstFirst(g.members, family) }));
  }, [all, family]);
  const [open, set] = useState<ReadonlySet<string>>(new Set());
  const toggle = (name: string) =>
    set((was) => {
      const now = new Set(was);
      if (!now.delete(name)) now.add(name);
      return now;
    });
  const table = useRef<HTMLTableElement>(null);
  const roving = useRoving(table);
  const families = report.families.map((f) => f.name);
  const allOpen = groups.every((g) => open.has(g.name) || g.members.length < 2);
  return (
    <>
      <p class="tools">
        <button type="button" onClick={() => set(allOpen ? new Set() : new Set(groups.map((g) => g.name)))}>
          {allOpen ? "Fold all" : "Unfold all methods"}
        </button>
        <span class="legend" aria-hidden="true">
          <i class="heat bad s5" /> wrong beyond the claim or failed (×) <i class="heat within s4" /> wrong within the
          claim <i class="heat undecided s4" /> undecided <i class="heat clean" /> none of these{" "}
          <i class="heat empty" /> not asked;
          a stronger colour means a larger share. Click a family to see which library fails most on it.
        </span>
      </p>
      {family !== null && <WorstOf groups={all} family={family} all={() => choose(null)} />}
      <div class="scroll">
        <table
          class="heat-table"
          ref={table}
          aria-label="Methods against families; arrow keys move, Enter opens a cell or ranks a family"
          {...roving}>
          <thead>
            <tr>
              <th scope="col" title={about("method")}>
                method
              </th>
              {[...counts.map((k) => countLabels[k] ?? k), "ns/pair"].map((words) => (
                <th scope="col" class="n" title={about(words)} key={words}>
                  {words}
                </th>
              ))}
              {report.families.map((f) => (
                <th
                  scope="col"
                  class="turned"
                  title={f.summary}
                  aria-sort={f.name === family ? "descending" : "none"}
                  key={f.name}>
                  <button type="button" onClick={() => choose(f.name === family ? null : f.name)}>
                    {kindLabel(f.name)}
                  </button>
                </th>
              ))}
            </tr>
          </thead>
          <tbody>
            {groups.flatMap((g) =>
              g.members.length < 2
                ? [<HeatRow row={g.members[0]!} families={families} family={family} level={0} key={g.name} />]
                : [
                    <HeatRow
                      row={g}
                      families={families}
                      family={family}
                      level={0}
                      open={open.has(g.name)}
                      toggle={() => toggle(g.name)}
                      key={g.name}
                    />,
                    ...(open.has(g.name)
                      ? g.members.map((m) => (
                          <HeatRow row={m} families={families} family={family} level={1} key={`${g.name}/${m.name}`} />
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
  if (!history) return null;
  const order: Standing[] = ["new", "back", "gone"];
  const by = groupBy(history.groups, (g) => g.standing);
  const all: Standing[] = [...order, "known"];
  return (
    <>
      {!changesOf(report) && (
        <p>
          Compared with {plural(history.runs, "earlier run")}:{" "}
          {all.map((s, i) => (
            <>
              {i > 0 && ", "}
              <a href={s === "gone" ? "#/new" : `#/findings?standing=${s}`} title={about(s)}>
                <b>{grouped(by.get(s)?.length ?? 0)}</b> {s}
              </a>
            </>
          ))}{" "}
          (groups of method, kind and family).
        </p>
      )}
      {order.some((s) => by.has(s)) && (
        <details>
          <summary>Methods, kinds and families that changed</summary>
          <div class="scroll">
            <table class="plain">
              <Heads of={["since earlier runs", "method", "kind", "severity", "family", "n:count"]} />
              <tbody>
                {order.flatMap((s) =>
                  (by.get(s) ?? []).slice(0, 200).map((g) => (
                    <tr key={[g.method, g.kind, g.severity, g.family].join()}>
                      <td>{g.standing}</td>
                      <td>{safe(g.method)}</td>
                      <td>{safe(kindLabel(g.kind))}</td>
                      <td>{safe(severityLabels[g.severity] ?? g.severity)}</td>
                      <td>{safe(kindLabel(g.family))}</td>
                      <td class="n">{grouped(g.count)}</td>
                    </tr>
                  )),
                )}
              </tbody>
            </table>
          </div>
        </details>
      )}
    </>
  );
}

function Headline({ report }: { report: FullReport }) {
  const rows = rowsOf(report).flatMap((g) => g.members);
  const bad = rows.filter((r) => r.total.contract + r.total.failed > 0);
  const own = new Set(report.methods.filter((m) => m.own).map((m) => m.name));
  const ownBad = bad.filter((r) => own.has(r.name));
  const referee = addUp(
    "referee",
    report.tallies.filter((t) => t.method === "referee"),
  ).total;
  const cases = addUp(
    "corpus",
    report.tallies.filter((t) => t.method === "corpus"),
  ).total;
  const causes = report.buckets.filter((b) => b.count > 0),
    earlier = report.buckets.length - causes.length;
  const unexplained = report.unreadable ?? 0;
  return (
    <>
      <dl class="facts">
        <Fact label="pairs judged">{grouped(report.run.pairs)}</Fact>
        <Fact label="truth undecided" kind={referee.undecided > 0 ? "warn" : ""}>
          {grouped(referee.undecided)}
        </Fact>
        <Fact label="findings">{grouped(report.findings_total)}</Fact>
        <Fact label="kept as examples">{grouped(report.findings_kept)}</Fact>
        <Fact label="causes">
          {report.buckets.length > 0 ? grouped(causes.length) : "\u2013"}
          {earlier > 0 && <span class="soft"> and {grouped(earlier)} only in earlier runs</span>}
        </Fact>
        <Fact label="methods beyond their claim" kind={bad.length > 0 ? "bad" : ""}>
          {bad.length} of {rows.length}
        </Fact>
        <Fact label="of ours" kind={ownBad.length > 0 ? "bad" : "ok"}>
          {ownBad.length} of {own.size}
        </Fact>
        <Fact label="known cases now failing" kind={cases.contract > 0 ? "bad" : ""}>
          {grouped(cases.contract)}
        </Fact>
      </dl>
      {unexplained > 0 && (
        <p class="warn">
          {plural(unexplained, "finding")} of the store cannot be read and {unexplained === 1 ? "is" : "are"} not on
          this page.
        </p>
      )}
    </>
  );
}

export function Summary({ report }: { report: FullReport }) {
  return (
    <Section id="new" title="What is new">
      <New report={report} />
      <Headline report={report} />
      <History report={report} />
      {report.tallies.length > 0 ? (
        <HeatTable report={report} />
      ) : (
        <p class="missing">This run asked no method.</p>
      )}
    </Section>
  );
}

export function Methods({ report }: { report: FullReport }) {
  const referee = report.tallies.filter((t) => !report.methods.some((m) => m.name === t.method));
  const judges = [...groupBy(referee, (t) => t.method)].map(([name, tallies]) => addUp(name, tallies));
  return (
    <Section
      id="methods"
      title="Methods and what they claim"
      lead={
        "The claim of a method is the tolerance that its documentation states. An error beyond the claim is a fault. " +
        "Errors within the claim are counted separately."
      }>
      <details class="print">
        <summary>
          {plural(report.methods.length, "method")}, {plural(judges.length, "row")} of the referee and the cases
        </summary>
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
        <table class="plain">
          <Heads of={["judge", "n:asked", "n:undecided", "n:wrong", "n:a pair"]} />
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
