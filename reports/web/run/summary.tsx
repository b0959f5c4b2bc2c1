// SPDX-License-Identifier: MIT
// The run at a glance: new faults, counts, libraries against families.
import { group } from "d3-array";
import { Section } from "../parts/elements.tsx";
import { cellColours, outcomes, type Outcomes } from "../parts/plot.ts";
import { grouped, percent, plural, safe, shellQuoted } from "../parts/words.ts";
import type { Report, Tally } from "./data.ts";
import { Fact, Legend } from "./elements.tsx";
import { addressOf, toFindings } from "./findings.tsx";
import { about } from "./glossary.ts";
import { isOfNewFamilies, isText, kindLabel, sentenceOf, sentenceOfFinding } from "./words.ts";

const labels = { bad: "beyond claim or failed", within: "within claim", undecided: "undecided or declined" };

function sumOf(tallies: Tally[]): Outcomes {
  const total = (count: (t: Tally) => number) => tallies.reduce((n, t) => n + count(t), 0);
  return {
    asked: total((t) => t.asked),
    bad: total((t) => t.contract + t.failed),
    within: total((t) => t.resolution),
    undecided: total((t) => t.undecided + t.declined),
  };
}

function Cell({ library, family, tallies }: { library: string; family: string; tallies: Tally[] }) {
  const c = sumOf(tallies.filter((t) => t.family === family));
  if (c.asked === 0) return <td title={`${safe(library)}, ${family}: not asked`} />;
  const { fill } = cellColours(c);
  const words = [
    `${safe(library)}, ${family}`,
    `asked ${grouped(c.asked)}`,
    ...outcomes.filter((k) => c[k] > 0).map((k) => `${labels[k]} ${grouped(c[k])} (${percent(c[k], c.asked)})`),
  ].join("\n");
  return (
    <td title={words} style={{ background: fill }}>
      {c.bad + c.within > 0 && <a href={toFindings({ library, family })} aria-label={words} tabIndex={-1} />}
    </td>
  );
}

/** The tallies without those of the referee and of the stored cases. */
const methodTallies = ({ tallies, methods }: Report) => tallies.filter((t) => methods.some((m) => m.name === t.method));

const Heat = ({ report }: { report: Report }) => (
  <>
    <Legend empty="not asked" />
    <div class="scroll">
      <table class="heat-table" aria-label="Libraries against families">
        <thead>
          <tr>
            <th scope="col" title={about("library")}>
              library
            </th>
            {report.families.map((f) => (
              <th scope="col" class="turned" title={f.summary} key={f.name}>
                <a href={toFindings({ family: f.name })}>{kindLabel(f.name)}</a>
              </th>
            ))}
          </tr>
        </thead>
        <tbody>
          {[...group(methodTallies(report), (t) => t.library)].map(([library, tallies]) => (
            <tr key={library}>
              <th scope="row">{safe(library)}</th>
              {report.families.map(({ name }) => (
                <Cell library={library} family={name} tallies={tallies} key={name} />
              ))}
            </tr>
          ))}
        </tbody>
      </table>
    </div>
  </>
);

const namedFaults = 3;

/** The answer of the run: red if something is new and wrong, else green. */
function Answer({ report }: { report: Report }) {
  const compared = report.causes.some((b) => b.status !== null),
    wrong = report.causes.filter((b) => b.count > 0 && b.severity === "contract"),
    faults = wrong.filter((b) => !compared || b.status === "new"),
    undrawn = faults.filter(isOfNewFamilies).length;
  const beyond = report.findings.filter((f) => f.severity === "contract" && f.cause === null),
    libraries = [...new Set(beyond.map((f) => f.library))].sort((x, y) => Number(isText(x)) - Number(isText(y)));
  const [kind, head] =
    faults.length > 0
      ? ["bad", `${plural(faults.length, compared ? "new fault" : "fault")}:`]
      : libraries.length > 0 && report.causes.length === 0
        ? ["bad", `${plural(libraries.length, "library is", "libraries are")} wrong beyond the claim: `]
        : ["ok", compared ? "Nothing is new and wrong." : "No method is wrong beyond its claim."];
  return (
    <div class={`band ${kind}`}>
      <p class="answer">
        <b class={kind}>{head}</b> {kind === "bad" && faults.length === 0 && safe(libraries.join(", "))}
      </p>
      {faults.slice(0, namedFaults).map((b) => (
        <p key={b.key}>
          <a href={addressOf(b)}>{safe(sentenceOf(b))}</a>.
        </p>
      ))}
      {report.causes.length === 0 && beyond[0] && (
        <p>
          The worst finding: <a href={`#/finding/${beyond[0].id}`}>{safe(sentenceOfFinding(beyond[0]))}</a>.
        </p>
      )}
      <p class="soft">
        {compared
          ? "Compared with earlier runs."
          : report.causes.length > 0 && "There are no causes of earlier runs to compare with."}
        {undrawn > 0 &&
          ` For ${plural(undrawn, "new fault")}, no earlier run tested the method on these families. So it is ` +
            `unknown whether ${undrawn === 1 ? "it is" : "they are"} really new.`}
      </p>
    </div>
  );
}

function Facts({ report }: { report: Report }) {
  const methods = group(report.tallies, (t) => t.method),
    asked = report.methods.filter((m) => methods.has(m.name)),
    bad = asked.filter((m) => sumOf(methods.get(m.name)!).bad > 0),
    own = asked.filter((m) => m.own),
    ownBad = bad.filter((m) => m.own).length;
  const { undecided } = sumOf(methods.get("referee") ?? []),
    failing = sumOf(methods.get("corpus") ?? []).bad;
  const facts: [label: string, value: string, kind: string][] = [
    ["pairs judged", grouped(report.run.pairs), ""],
    ["truth undecided", grouped(undecided), undecided > 0 ? "warn" : ""],
    ["findings", grouped(report.findings_total), ""],
    ["causes", grouped(report.causes.filter((b) => b.count > 0).length), ""],
    ["methods beyond their claim", `${bad.length} of ${asked.length}`, bad.length > 0 ? "bad" : ""],
    ["of ours", `${ownBad} of ${own.length}`, ownBad > 0 ? "bad" : "ok"],
    ["known cases now failing", grouped(failing), failing > 0 ? "bad" : ""],
  ];
  return (
    <dl class="facts">
      {facts.map(([label, value, kind]) => (
        <Fact label={label} kind={kind} key={label}>
          {value}
        </Fact>
      ))}
    </dl>
  );
}

export const Summary = ({ report }: { report: Report }) => (
  <Section id="new" title="New in this run">
    <Answer report={report} />
    {report.causes.length === 0 && report.findings_total > 0 && (
      <p class="missing">
        <code>./daylight triage {shellQuoted(report.run.folder)}</code> groups the findings into causes, each with a
        simple pair.
      </p>
    )}
    <Facts report={report} />
    {report.unreadable > 0 && (
      <p class="warn">The page leaves out {plural(report.unreadable, "finding")} of the store that cannot be read.</p>
    )}
    {report.tallies.length > 0 ? <Heat report={report} /> : <p class="missing">This run asked no method.</p>}
  </Section>
);
