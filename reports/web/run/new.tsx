// SPDX-License-Identifier: MIT
// The answer first: what is new and wrong, its picture and its command; then what is known, rare or gone.
import { Copy } from "../parts/elements.tsx";
import { grouped, plural, safe, shellQuoted } from "../parts/words.ts";
import { causeAddress } from "./causes.tsx";
import type { Cause, Standing } from "./data.ts";
import { Missing } from "./elements.tsx";
import { causesOf, sortedCauses } from "./filter.ts";
import { about } from "./glossary.ts";
import { Thumbnail } from "./pair_view.tsx";
import { changesOf, type FullReport } from "./report.ts";
import { sentenceOf } from "./sentence.ts";

const namedFaults = 3;

/** The first of the faults with its picture and command, the next ones in a line each. */
function Faults({ report, faults, word }: { report: FullReport; faults: Cause[]; word: string }) {
  const [first, ...others] = faults;
  const command = `./daylight explain ${shellQuoted(report.run.folder)} ${shellQuoted(first!.key)}`;
  return (
    <div class="band bad">
      <div>
        <p class="answer">
          <b>
            {plural(faults.length, `${word}fault`)}:{" "}
          </b>
          <a href={causeAddress(first!.key)}>{safe(sentenceOf(first!))}</a>.
        </p>
        {others.slice(0, namedFaults - 1).map((b) => (
          <p key={b.key}>
            <a href={causeAddress(b.key)}>{safe(sentenceOf(b))}</a>.
          </p>
        ))}
        {others.length >= namedFaults && (
          <p>
            <a href={`#/findings?severity=contract${word === "" ? "" : "&standing=new&standing=back"}`}>
              All {faults.length}
            </a>
          </p>
        )}
        <Copy label="Explain it" text={command} />
      </div>
      <a class="band-picture" href={causeAddress(first!.key)} tabIndex={-1} aria-hidden="true">
        <Thumbnail shown={first!.worst} />
      </a>
    </div>
  );
}

const lineOf: Partial<Record<Standing, (n: number) => string>> = {
  back: (n) => (n === 1 ? "cause is back" : "causes are back"),
  known: (n) => (n === 1 ? "cause is known" : "causes are known"),
  rare: (n) => (n === 1 ? "cause is rare" : "causes are rare"),
  gone: (n) => (n === 1 ? "cause is gone" : "causes are gone"),
};

export function New({ report }: { report: FullReport }) {
  const changes = changesOf(report),
    causes = sortedCauses(causesOf(report), { column: "standing", down: false }).map(({ b }) => b),
    here = causes.filter((b) => b.count > 0 && !b.suppressed);
  const isNew = (b: Cause) => !changes || b.standing === "new" || b.standing === "back";
  const faults = here.filter((b) => isNew(b) && b.severity === "contract"),
    within = here.filter((b) => isNew(b) && b.severity !== "contract").length;
  const untold = report.buckets.length === 0 && report.findings_total > 0;
  return (
    <>
      {untold ? (
        <Missing of="buckets" report={report} />
      ) : faults.length > 0 ? (
        <Faults report={report} faults={faults} word={changes ? "new " : ""} />
      ) : (
        <p class="band ok answer">{changes ? "Nothing is new and wrong." : "No method is wrong beyond its claim."}</p>
      )}
      <ul class="changes">
        {within > 0 && (
          <li>
            <b>{grouped(within)}</b> {changes ? "new " : ""}
            {within === 1 ? "cause is" : "causes are"} within the claim
          </li>
        )}
        {changes?.counts.map(([standing, n]) =>
          n > 0 && lineOf[standing] ? (
            <li key={standing}>
              <a href={`#/findings?standing=${standing}`} title={about(standing)}>
                <b>{grouped(n)}</b> {lineOf[standing]!(n)}
              </a>
            </li>
          ) : null,
        )}
        <li class="soft" title={safe(changes?.against.join(", ") ?? "")}>
          {changes
            ? `Compared with ${plural(changes.against.length, "earlier run")}`
            : report.history
              ? "There are no causes of earlier runs to compare with"
              : "There is no earlier run to compare with"}
        </li>
      </ul>
    </>
  );
}
