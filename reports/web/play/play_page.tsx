// SPDX-License-Identifier: MIT
// The page to play with: two solids, the verdict, the distance and the certificate, which the page checks in exact
// arithmetic at each change.
import { useEffect, useMemo, useState } from "preact/hooks";
import type { Pair, Truth } from "../parts/data.ts";
import { Copy, Section } from "../parts/elements.tsx";
import { prove, type Proof } from "../parts/prove.ts";
import { solve, type Solved } from "../parts/solver.ts";
import { full, short } from "../parts/words.ts";
import type { Example, Play } from "./data.ts";
import { AboutExample, ChooseExample } from "./examples.tsx";
import { SolidFields } from "./fields.tsx";
import { PlayView } from "./handles.tsx";
import { addressOf, pairOf } from "./solids.ts";

const firstPair: Pair = {
  a: { center: [0, 0, 0], axis: [0, 0, 1], radius: 1, height: 3 },
  b: { center: [2.5, 0.5, 0.4], axis: [0, 0.8, 0.6], radius: 0.8, height: 2.5 },
};

function Distance({ distance: { value, error, least } }: Solved) {
  const about = `the error is at most ${short(error)}`;
  if (value > 0)
    return (
      <p class="distance">
        Gap <b>{full(value)}</b>, {about}.
      </p>
    );
  return (
    <p class="distance">
      Depth <b>{full(value === 0 ? 0 : -value)}</b>.{" "}
      {least ? `No direction is shallower, ${about}.` : `A shallower direction may exist. Along this one ${about}.`}
    </p>
  );
}

const bandOf: Record<string, string> = { disjoint: "own", intersecting: "bad" };

/** What the solver says, and what is proved of it here. `undecided` carries no certificate to prove. */
function Verdict({ solved, proof }: { solved: Solved; proof: Proof }) {
  const { verdict } = solved.truth,
    isOpen = verdict === "undecided" || verdict === "invalid";
  return (
    <div class={`verdict ${bandOf[verdict] ?? "warn"}`} role="status" data-holds={String(proof.holds)}>
      <p class="answer">
        <b>{verdict}</b>
      </p>
      {verdict === "undecided" && (
        <p>The solids touch, or so nearly that doubles do not prove either. The command below decides it exactly.</p>
      )}
      {verdict === "invalid" && <p>This is not a pair of solids: an axis must not be zero.</p>}
      {!isOpen && <p class="proved">{proof.text}</p>}
      {verdict !== "invalid" && <Distance {...solved} />}
    </div>
  );
}

const certificateOf = ({ direction, point, points, hulls }: Truth) =>
  JSON.stringify({
    ...(direction && { direction }),
    ...(point && { point }),
    ...(points && { points }),
    ...(hulls && { hulls }),
  });

function Certificate({ truth, proof }: { truth: Truth; proof: Proof }) {
  if (proof.steps.length === 0) return null;
  return (
    <details class="certificate" open>
      <summary>The certificate, and its check in exact whole numbers</summary>
      <code>{certificateOf(truth)}</code>
      <div class={`proof ${proof.holds === true ? "ok" : proof.holds === false ? "bad" : "warn"}`}>
        <ul>
          {proof.steps.map((step, i) => (
            <li key={i}>{step}</li>
          ))}
        </ul>
      </div>
    </details>
  );
}

const isSame = (p: Pair, q: Pair) => addressOf(p) === addressOf(q);

/** The pair, kept in the address; `version` counts the pairs that were chosen as a whole. */
function usePair(examples: Example[]) {
  const exampleOf = (pair: Pair) => examples.find((e) => isSame(e.pair, pair)) ?? null;
  const start = () => {
    const pair = pairOf(location.hash) ?? firstPair;
    return { pair, version: 0, example: exampleOf(pair) };
  };
  const [state, set] = useState(start);
  const remember = (pair: Pair) => {
    try {
      history.replaceState(null, "", addressOf(pair));
    } catch {
      // Some browsers refuse after a hundred in half a minute: then the address is a little old.
    }
  };
  useEffect(() => {
    const follow = () => {
      const pair = pairOf(location.hash);
      if (pair) set((old) => ({ pair, version: old.version + 1, example: exampleOf(pair) }));
    };
    addEventListener("hashchange", follow);
    return () => removeEventListener("hashchange", follow);
  }, []);
  return {
    ...state,
    change: (pair: Pair) => {
      set((old) => ({ ...old, pair }));
      remember(pair);
    },
    choose: (pair: Pair, example: Example | null) => {
      set((old) => ({ pair, version: old.version + 1, example }));
      remember(pair);
    },
  };
}

export function PlayPage({ play }: { play: Play }) {
  const { pair, version, example, change, choose } = usePair(play.examples);
  const solved = useMemo(() => solve(pair), [pair]);
  const proof = useMemo(() => prove(pair, solved.truth), [pair, solved]);
  const line = JSON.stringify(pair);
  return (
    <>
      <header>
        <h1>daylight</h1> <span class="soft">two solids, and a proof whether they meet</span>
      </header>
      <main class="play">
        <div class="choose-pair">
          <ChooseExample examples={play.examples} chosen={example} choose={(e) => choose(e.pair, e)} />
          <button type="button" onClick={() => choose(firstPair, null)}>
            Start again
          </button>
        </div>
        <div class="play-grid">
          <div>
            <PlayView pair={pair} solved={solved} version={version} change={change} />
          </div>
          <div>
            <Verdict solved={solved} proof={proof} />
            <div class="two-solids">
              {(["a", "b"] as const).map((name) => (
                <SolidFields
                  key={`${name}${version}`}
                  name={name}
                  solid={pair[name]}
                  set={(solid) => change({ ...pair, [name]: solid })}
                />
              ))}
            </div>
            <Certificate truth={solved.truth} proof={proof} />
          </div>
        </div>
        {example && (
          <Section id="example" title={example.id}>
            <AboutExample
              example={example}
              isChanged={!isSame(example.pair, pair)}
              back={() => choose(example.pair, example)}
            />
          </Section>
        )}
        <Section id="share" title="Share the pair">
          <p>The address of this page holds the pair.</p>
          <Copy label="Address" text={location.href.split("#")[0] + addressOf(pair)} />
          <Copy label="The same question to the program" text={`echo '${line}' | daylight check --distance`} />
        </Section>
      </main>
      <footer class="soft">
        The solver runs in this page, compiled to WebAssembly. It answers bit for bit as the program does. The check of
        the certificate is separate code in exact whole numbers. Nothing leaves this page.
      </footer>
    </>
  );
}
