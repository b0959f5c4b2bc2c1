// SPDX-License-Identifier: MIT
// What each method answers on a pair.
import type { Answer, Truth } from "../parts/data.ts";
import { full, groupBy, plural, safe } from "../parts/words.ts";
import type { Case } from "./data.ts";
import { Heads } from "./elements.tsx";
import { formatCoordinate } from "./words.ts";

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
  who: string[];
  isSelected: boolean; // of the method that is looked at
  wrong: boolean;
}

/** The answers, each once: that of `method` first, then the wrong ones, then what most say. */
function groupAnswers({ answers, truth }: Case, method: string): AnswerGroup[] {
  const same = groupBy(Object.entries(answers), ([name, a]) => `${name === method} ${formatAnswer(a)}`);
  const all = [...same.values()].map((given): AnswerGroup => {
    const answer = given[0]![1],
      who = given.map(([name]) => name);
    return { answer, who, isSelected: who.includes(method), wrong: wrongVerdict(answer, truth) };
  });
  return all.sort(
    (x, y) =>
      Number(y.isSelected) - Number(x.isSelected) ||
      Number(y.wrong) - Number(x.wrong) ||
      y.who.length - x.who.length,
  );
}

const namesShown = 8;

/** Names of methods; many that are right are folded. */
function Who({ who, wrong }: { who: string[]; wrong: boolean }) {
  const names = safe(who.join(", "));
  if (wrong || who.length <= namesShown) return <span class={wrong ? "bad" : ""}>{names}</span>;
  return (
    <details>
      <summary>{plural(who.length, "method")}</summary>
      {names}
    </details>
  );
}

export function Answers({ shown, method }: { shown: Case; method: string }) {
  const said = groupAnswers(shown, method);
  if (said.length === 0) return null;
  return (
    <section>
      <h3>The answer of each method</h3>
      <div class="scroll">
        <table class="plain answers">
          <Heads of={["answer", "from"]} />
          <tbody>
            {said.map(({ answer, who, isSelected, wrong }, row) => (
              <tr key={row} class={isSelected ? "its" : ""}>
                <td class={`wrap ${wrong ? "bad" : ""}`}>{safe(formatAnswer(answer))}</td>
                <td class="wrap">
                  <Who who={who} wrong={wrong} />
                </td>
              </tr>
            ))}
          </tbody>
        </table>
      </div>
    </section>
  );
}
