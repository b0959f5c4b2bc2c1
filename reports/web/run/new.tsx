// SPDX-License-Identifier: MIT
// The answer first: what is new and wrong, its picture and its command. Then the causes by how they stand against
// earlier runs: new, back, rare, known, gone.
import { Copy } from "../parts/elements.tsx";
import { grouped, plural, safe, shellQuoted } from "../parts/words.ts";
import { causeAddress } from "./causes.tsx";
import type { Case, Cause } from "./data.ts";
import { causesOf, isOrdinary, rowsOf } from "./filter.ts";
import { about } from "./glossary.ts";
import { Thumbnail } from "./pair_view.tsx";
import { changesOf, type FullReport } from "./report.ts";
import { sentenceOf } from "./sentence.ts";
import { isText, library } from "./words.ts";

/** What a band names: a sentence, where it leads and its pair. */
interface Named {
  words: string;
  address: string;
  shown: Case;
}
const namedFaults = 3;

/** The first with its picture and command, the next ones in a line each. */
function Band({
  kind,
  head,
  named,
  all,
  command,
}: {
  kind: "bad" | "warn";
  head: string;
  named: Named[];
  all: string; // the address of all of them
  command: [label: string, text: string];
}) {
  const [first, ...others] = named;
  return (
    <div class={`band picture ${kind}`}>
      <div>
        <p class="answer">
          <b class={kind}>{head} </b>
          <a href={first!.address}>{safe(first!.words)}</a>.
        </p>
        {others.slice(0, namedFaults - 1).map(({ address, words }) => (
          <p key={address}>
            <a href={address}>{safe(words)}</a>.
          </p>
        ))}
        {named.length > namedFaults && (
          <p>
            <a href={all}>All {named.length}</a>
          </p>
        )}
        <Copy label={command[0]} text={command[1]} />
      </div>
      <a class="band-picture" href={first!.address} tabIndex={-1} aria-hidden="true">
        <Thumbnail shown={first!.shown} />
      </a>
    </div>
  );
}

/** The answer of a run without causes: who is wrong, and the worst at ordinary sizes. */
function Untold({ report }: { report: FullReport }) {
  const rows = rowsOf(report).filter(({ f }) => f.severity === "contract"),
    wrong = [...rows.filter(({ f }) => !isText(f.method)), ...rows.filter(({ f }) => isText(f.method))],
    libraries = [...new Set(wrong.map(({ f }) => library(f.method)))];
  if (wrong.length === 0) return <p class="band ok answer">No method is wrong beyond its claim.</p>;
  const worst = wrong.filter(({ f }, i) => wrong.findIndex((w) => library(w.f.method) === library(f.method)) === i);
  const named = worst.map(({ f }) => ({
    words: sentenceOf({ ...f, methods_of_kind: [f.method], margin: f.margin && [f.margin[0], f.margin[0]], worst: f }),
    address: `#/finding/${f.id}`,
    shown: f,
  }));
  const where = isOrdinary(worst[0]!.f.pair) ? "Worst at ordinary sizes: " : "Worst, at an extreme size: ";
  return (
    <Band
      kind="bad"
      head={
        `${plural(libraries.length, "library is", "libraries are")} wrong beyond the claim: ` +
        `${safe(libraries.join(", "))}. ${where}`
      }
      named={named}
      all="#/findings?severity=contract"
      command={["Ask again", worst[0]!.f.replay]}
    />
  );
}

const namedCause = (b: Cause): Named => ({ words: sentenceOf(b), address: causeAddress(b.key), shown: b.worst });

function Answer({ report }: { report: FullReport }) {
  const compared = changesOf(report) !== null,
    wrong = causesOf(report)
      .map(({ b }) => b)
      .filter((b) => b.count > 0 && !b.suppressed && b.severity === "contract"),
    faults = wrong.filter((b) => !compared || b.standing === "new" || b.standing === "back"),
    rare = wrong.filter((b) => compared && b.standing === "rare");
  const explain = ({ key }: Cause): [string, string] => [
    "Explain it",
    `./daylight explain ${shellQuoted(report.run.folder)} ${shellQuoted(key)}`,
  ];
  if (faults.length > 0)
    return (
      <Band
        kind="bad"
        head={`${plural(faults.length, compared ? "new fault" : "fault")}:`}
        named={faults.map(namedCause)}
        all="#/findings?severity=contract"
        command={explain(faults[0]!)}
      />
    );
  if (rare.length > 0)
    return (
      <Band
        kind="warn"
        head={
          `${plural(rare.length, "cause was", "causes were")} not seen before; chance cannot be excluded, because ` +
          `each was found on so few pairs:`
        }
        named={rare.map(namedCause)}
        all="#/findings?severity=contract&standing=rare"
        command={explain(rare[0]!)}
      />
    );
  const text = compared ? "Nothing is new and wrong." : "No method is wrong beyond its claim.";
  return <p class="band ok answer">{text}</p>;
}

export function New({ report }: { report: FullReport }) {
  const changes = changesOf(report);
  if (report.buckets.length === 0 && report.findings_total > 0)
    return (
      <>
        <Untold report={report} />
        <p class="missing">
          <code>./daylight triage {shellQuoted(report.run.folder)}</code> groups the findings into causes, each with its
          simplest pair.
        </p>
      </>
    );
  return (
    <>
      <Answer report={report} />
      <ul class="changes">
        {changes?.counts.map(([standing, n]) =>
          n > 0 ? (
            <li key={standing}>
              <a href={`#/findings?standing=${standing}`} title={about(standing)}>
                <b>{grouped(n)}</b> {n === 1 ? "cause is" : "causes are"}{" "}
                {standing === "rare" ? "too rare to judge" : standing}
              </a>
            </li>
          ) : null,
        )}
        <li class="soft" title={safe(changes?.against.join(", ") ?? "")}>
          {changes
            ? `Compared with ${plural(changes.against.length, "earlier run")}`
            : "There are no causes of earlier runs to compare with"}
        </li>
      </ul>
    </>
  );
}
