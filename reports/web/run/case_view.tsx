// SPDX-License-Identifier: MIT
// A pair with its picture, its truth, the certificate and the answers.
import type { ComponentChildren } from "preact";
import { Copy } from "../parts/elements.tsx";
import { full, range, safe } from "../parts/words.ts";
import { Answers } from "./answers.tsx";
import { Prover } from "./certificate.tsx";
import type { Case } from "./data.ts";
import { Fact } from "./elements.tsx";
import { about } from "./glossary.ts";
import { PairView } from "./pair_view.tsx";

/** A vector in brackets, or a number; breaks between numbers, not in them. */
const Numbers = ({ of }: { of: readonly number[] }) => (
  <>
    {of.map((x, i) => (
      <>
        {i > 0 && " "}
        <span class="whole">
          {of.length > 1 && i === 0 && "("}
          {full(x)}
          {of.length > 1 && (i < of.length - 1 ? "," : ")")}
        </span>
      </>
    ))}
  </>
);

type Solid = Case["pair"]["a"];

function Solids({ pair: { a, b } }: { pair: Case["pair"] }) {
  const rows: [string, (s: Solid) => readonly number[]][] = [
    ["centre", (s) => s.center],
    ["axis", (s) => s.axis],
    ["radius", (s) => [s.radius]],
    ["height", (s) => [s.height]],
    ["rounding", (s) => [s.rounding ?? 0]],
  ];
  if (!a.rounding && !b.rounding) rows.pop();
  return (
    <table class="plain solids">
      <thead>
        <tr>
          <td />
          {["a", "b"].map((name) => (
            <th scope="col" title={`Solid ${name} of the pair`} key={name}>
              <i class={`swatch ${name}`} />
              {name}
            </th>
          ))}
        </tr>
      </thead>
      <tbody>
        {rows.map(([name, of]) => (
          <tr key={name}>
            <th scope="row" title={about(name)}>
              {name}
            </th>
            {[a, b].map((solid, i) => (
              <td key={i}>
                <Numbers of={of(solid)} />
              </td>
            ))}
          </tr>
        ))}
      </tbody>
    </table>
  );
}

const stageLabels: Record<string, string> = {
  filter: "double intervals",
  wide: "multiple precision",
  exact: "rationals",
};

/** `method`: the one that is wrong; `story`: what is known of its cause, beside the picture. */
export function CaseView({ shown, method, story }: { shown: Case; method: string; story?: ComponentChildren }) {
  const { truth } = shown,
    stage = truth.stage && (stageLabels[truth.stage] ?? safe(truth.stage));
  const isProved = Boolean(truth.direction || truth.point || truth.points || truth.near);
  const proof = isProved ? <Prover shown={shown} /> : <p class="warn">No truth is proved for this pair.</p>;
  const facts = (
    <dl class="facts">
      <Fact label="truth">
        <span title={about(truth.verdict)}>{truth.verdict}</span>
        {isProved && <span class="soft"> proved</span>}
      </Fact>
      <Fact label="signed distance">{range(truth.distance)}</Fact>
      <Fact label="margin">{range(shown.margin)}</Fact>
      {stage && (
        <Fact label="settled in">
          <span title={about(stage)}>{stage}</span>
        </Fact>
      )}
    </dl>
  );
  const answers = <Answers shown={shown} method={method} />;
  return (
    <>
      <div class="case">
        <div>
          <PairView shown={shown} />
          {story && facts}
          <Solids pair={shown.pair} />
          {story && proof}
          <Copy label="Ask again" text={shown.replay} />
          <Copy label="The pair, a line for daylight check" text={JSON.stringify(shown.pair)} />
          {shown.note && <p class="soft">From: {safe(shown.note)}</p>}
        </div>
        <div class="right">
          {story ?? (
            <>
              {facts}
              {proof}
              {answers}
            </>
          )}
        </div>
      </div>
      {story && answers}
    </>
  );
}
