// SPDX-License-Identifier: MIT
// What each method answers on a pair.
import type { Answer, Truth } from "../parts/data.ts";
import { full, groupBy, plural, safe, short } from "../parts/words.ts";
import type { Case, Claim } from "./data.ts";
import { wrongDistance, type WrongDistance } from "./distance.ts";
import { Heads } from "./elements.tsx";
import type { FullReport } from "./report.ts";
import { formatCoordinate, library } from "./words.ts";

function formatAnswer(a: Answer): string {
  if (a.failed) return `failed: ${a.failed}${a.reason ? `, \u201c${a.reason}\u201d` : ""}`;
  if (a.declined !== undefined) return `declined${a.declined ? `: ${a.declined}` : ""}`;
  return [
    a.verdict ?? "no verdict",
    ...(a.distance === undefined ? [] : [`distance ${full(a.distance)}`]),
    ...(a.direction ? [`direction (${a.direction.map(full).join(", ")})`] : []),
    ...(a.point ? [`point (${a.point.map(formatCoordinate).join(", ")})`] : []),
  ].join(", ");
}

function wrongVerdict(a: Answer, truth: Truth) {
  if (a.failed) return true;
  const meets = truth.verdict === "intersecting" || truth.verdict === "touching";
  return (
    (a.verdict === "disjoint" && meets) ||
    ((a.verdict === "intersecting" || a.verdict === "touching") && truth.verdict === "disjoint")
  );
}

interface AnswerGroup {
  answer: Answer;
  who: { name: string; off: WrongDistance | null; wrong: boolean }[];
  isSelected: boolean; // of the method that is looked at
  wrong: boolean;
}

/** The answers, each once: that of `method` first, then the wrong ones, then what most say. `distances`: those outside
 *  their claim are wrong too. */
function groupAnswers(shown: Case, method: string, claims: Map<string, Claim>, distances: boolean): AnswerGroup[] {
  const same = groupBy(Object.entries(shown.answers), ([name, a]) => `${name === method} ${formatAnswer(a)}`);
  const all = [...same.values()].map((given): AnswerGroup => {
    const answer = given[0]![1];
    const who = given.map(([name]) => {
      const off = distances ? wrongDistance(shown, answer, claims.get(name)) : null;
      const outside = off !== null && (off.claims === null ? off.error > 0 : off.claims > 1);
      return { name, off, wrong: outside || wrongVerdict(answer, shown.truth) };
    });
    return { answer, who, isSelected: given.some(([name]) => name === method), wrong: who.some((w) => w.wrong) };
  });
  return all.sort(
    (x, y) =>
      Number(y.isSelected) - Number(x.isSelected) ||
      Number(y.wrong) - Number(x.wrong) ||
      y.who.length - x.who.length,
  );
}

/** Names of methods; more than fit into two lines are folded, unless one is wrong. */
function Who({ who, method }: { who: AnswerGroup["who"]; method: string }) {
  const names = who.map(({ name, off, wrong }, i) => (
    <>
      {i > 0 && ", "}
      <span
        class={`${wrong ? "bad" : ""} ${name === method ? "strong" : ""}`}
        title={off?.claims ? `${short(off.claims)} times its claim` : undefined}>
        {safe(name)}
      </span>
    </>
  ));
  if (who.length <= 8 || who.some(({ wrong }) => wrong)) return <>{names}</>;
  const libraries = new Set(who.map(({ name }) => library(name))).size;
  return (
    <details>
      <summary>
        {plural(who.length, "method")} of {plural(libraries, "library", "libraries")}
      </summary>
      {names}
    </details>
  );
}

export function Answers({
  shown,
  method,
  report,
  distances,
}: {
  shown: Case;
  method: string;
  report: FullReport;
  distances: boolean;
}) {
  const claims = new Map(report.methods.map((m) => [m.name, m.claim]));
  const said = groupAnswers(shown, method, claims, distances);
  if (said.length === 0) return null;
  return (
    <section>
      <h3>The answer of each method</h3>
      <div class="scroll">
        <table class="plain answers">
          <Heads of={distances ? ["answer", "n:wrong by", "from"] : ["answer", "from"]} />
          <tbody>
            {said.map(({ answer, who, isSelected, wrong }, row) => (
              <tr key={row} class={isSelected ? "its" : ""}>
                <td class={`wrap ${wrong ? "bad" : ""}`}>{safe(formatAnswer(answer))}</td>
                {distances && <td class="n">{who[0]!.off ? short(who[0]!.off.error) : "\u2013"}</td>}
                <td class="wrap">
                  <Who who={who} method={method} />
                </td>
              </tr>
            ))}
          </tbody>
        </table>
      </div>
    </section>
  );
}
