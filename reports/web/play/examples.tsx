// SPDX-License-Identifier: MIT
// Pairs that somebody gets wrong, and what each library or engine says of them.
import type { Verdict } from "../parts/data.ts";
import { full, grouped, plural, short } from "../parts/words.ts";
import type { Example, Play, Said } from "./data.ts";

const groups: [Example["group"], string][] = [
  ["engines", "Worst pairs of engines"],
  ["reported", "Reported for a library"],
  ["rounded", "Spheres, capsules, rounded cylinders"],
  ["errata", "Faults of printed methods"],
];

const isFault = ({ wrong }: Said) => wrong?.severity === "contract";
const faultsOf = (example: Example) => example.answers.filter(isFault).length;

export function ChooseExample({
  examples,
  chosen,
  choose,
}: {
  examples: Play["examples"];
  chosen: Example | null;
  choose: (example: Example) => void;
}) {
  return (
    <label class="select">
      <span>Example</span>
      <select
        value={chosen?.id ?? ""}
        onChange={(event) => {
          const found = examples.find(({ id }) => id === event.currentTarget.value);
          if (found) choose(found);
        }}>
        <option value="" selected={!chosen}>
          your own pair
        </option>
        {groups.map(([group, title]) => (
          <optgroup label={title} key={group}>
            {examples
              .filter((e) => e.group === group)
              .map((e) => (
                <option value={e.id} key={e.id} selected={e === chosen}>
                  {e.id}
                  {faultsOf(e) > 0 ? ` \u2013 ${faultsOf(e)} wrong` : ""}
                </option>
              ))}
          </optgroup>
        ))}
      </select>
    </label>
  );
}

function saidText(a: Said): string {
  if (a.failed) return `failed: ${a.failed}${a.reason ? `, \u201c${a.reason}\u201d` : ""}`;
  if (a.declined !== undefined) return `declined${a.declined ? `: ${a.declined}` : ""}`;
  return [a.verdict ?? "no verdict", ...(a.distance === undefined ? [] : [`distance ${full(a.distance)}`])].join(", ");
}

const judged = ({ wrong }: Said) => {
  if (!wrong) return "";
  const how = { contract: "beyond its claim", resolution: "within its claim", unresolved: "not known" }[wrong.severity];
  return `${wrong.kind.replaceAll("_", " ")}, ${how}`;
};

function Answers({ answers }: { answers: Said[] }) {
  return (
    <table class="plain answers-of-engines">
      <thead>
        <tr>
          <th>method</th>
          <th>says</th>
          <th>wrong</th>
        </tr>
      </thead>
      <tbody>
        {answers.map((a) => (
          <tr key={a.method}>
            <td class="wrap">
              {a.method}{" "}
              <span class="soft">
                {a.version}
                {a.recorded && `, recorded on ${a.recorded}`}
              </span>
            </td>
            <td class="wrap">{saidText(a)}</td>
            <td class={`wrap ${isFault(a) ? "bad" : "soft"}`}>{judged(a)}</td>
          </tr>
        ))}
      </tbody>
    </table>
  );
}

/** The text with its first link as a link. */
function Linked({ text }: { text: string }) {
  const found = /https:\/\/\S+/.exec(text);
  if (!found) return <>{text}</>;
  const [address] = found;
  return (
    <>
      {text.slice(0, found.index)}
      <a href={address} rel="noreferrer">
        {address}
      </a>
      {text.slice(found.index + address.length)}
    </>
  );
}

const truthText = (verdict: Verdict, distance: [number, number] | undefined) => {
  if (verdict === "touching" || !distance) return verdict;
  return `${verdict}, ${verdict === "disjoint" ? "gap" : "depth"} ${short(Math.abs(distance[0]))}`;
};

export function AboutExample({
  example,
  isChanged,
  back,
}: {
  example: Example;
  isChanged: boolean;
  back: () => void;
}) {
  const faults = example.answers.filter(isFault),
    others = example.answers.filter((a) => !isFault(a)),
    right = others.filter((a) => a.verdict !== undefined && !a.wrong).length;
  return (
    <div class="example" data-example={example.id}>
      {isChanged && (
        <p class="alarm warn">
          You changed the pair. What follows is about the example.{" "}
          <button type="button" onClick={back}>
            Back to the example
          </button>
        </p>
      )}
      <p class="wrap">
        <Linked text={example.source} />
      </p>
      {example.note && <p class="wrap soft">{example.note}</p>}
      <p>
        Proved by the referee: <b>{truthText(example.truth.verdict, example.truth.distance)}</b>.{" "}
        {faults.length === 0
          ? "No answer is wrong beyond the claim of its method."
          : `${plural(faults.length, "answer is", "answers are")} wrong beyond the claim of the method.`}
      </p>
      {faults.length > 0 && <Answers answers={faults} />}
      {others.length > 0 && (
        <details>
          <summary>
            {grouped(others.length)} {faults.length > 0 && "other "}
            {others.length === 1 ? "answer" : "answers"}, {grouped(right)} of them right
          </summary>
          <Answers answers={others} />
        </details>
      )}
    </div>
  );
}
