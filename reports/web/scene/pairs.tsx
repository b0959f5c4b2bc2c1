// SPDX-License-Identifier: MIT
// The pairs: a legend of the models that they need, which filters; a table; and what is known of the one that is
// picked.
import { useMemo, useState } from "preact/hooks";
import { save } from "../parts/save.ts";
import { VirtualTable, type ColumnOf } from "../parts/table.tsx";
import { grouped, percent, plural, short } from "../parts/words.ts";
import { csvName, csvOfStudy } from "./csv.ts";
import { aboutScene } from "./glossary.ts";
import { columns, passes, rowsOf, worstOf, wrongOf, type Column, type Filter, type Order } from "./order.ts";
import type { Posed } from "./pose.ts";
import { formatProof, formatProofShort, ShowProof, verdictClass } from "./proofs.tsx";
import { leastOf, proofOf, riskOf, type Risk } from "./risk.ts";
import {
  aModel,
  formatGap,
  hasStandIn,
  modelColour,
  models,
  asSentence,
  standsIn,
  unitOf,
  type Model,
  type Proof,
  type Study,
} from "./study.ts";

export const Swatch = ({ model }: { model: Model }) => (
  <i class="swatch" style={{ background: `var(${modelColour[model]})` }} />
);

/** Chips, one a model that some pair needs: pressed, only pairs of pressed ones are shown. */
export function Legend({ study, filter, set }: { study: Study; filter: Filter; set: (filter: Filter) => void }) {
  const counts = useMemo(
    () =>
      models.map(
        (model) =>
          [
            model,
            study.pairs.filter((pair) => pair.needs === model && passes(pair, { ...filter, models: new Set() })).length,
          ] as const,
      ),
    [study, filter.text],
  );
  const used = counts.filter(([model]) => study.pairs.some((pair) => pair.needs === model));
  const press = (model: Model) => {
    const chosen = new Set(filter.models);
    if (!chosen.delete(model)) chosen.add(model);
    set({ ...filter, models: chosen });
  };
  return (
    <span class="chips plain-chips" role="group" aria-label="Model needed">
      <span class="soft">Simplest model needed:</span>
      {used.map(([model, count]) => (
        <button
          type="button"
          class="chip"
          aria-pressed={filter.models.has(model)}
          onClick={() => press(model)}
          title={`show only pairs whose simplest sufficient model is ${aModel(model)}`}
          key={model}>
          <Swatch model={model} />
          {model} <span class="count">{grouped(count)}</span>
        </button>
      ))}
    </span>
  );
}

const rowHeight = 36,
  rowsShown = 15;
const titles: Record<Column, string> = {
  pair: "pair",
  risk: "state",
  least: "least gap",
  here: "gap here",
  within: "within",
  needs: "needs",
  sphere: "sphere",
  outer: "outer capsule",
  inner: "inner capsule",
};
/** What the columns of models hold, as the heads stand for them. */
const ofModels: Partial<Record<Column, string>> = {
  sphere: "False alarms of the spheres around both solids: the farthest beyond the clearance, and their number.",
  outer: "False alarms of the capsules around both solids: the farthest beyond the clearance, and their number.",
  inner: "Misses of the capsules inside both solids: the farthest below the clearance, and their number.",
};
const lengths: ReadonlySet<Column> = new Set(["least", "here", "sphere", "outer", "inner"]);
const riskClass: Record<Risk, string> = {
  "comes within": "bad",
  open: "warn",
  "not known": "warn",
  "not seen within": "",
  "never within": "ok",
};

export function Pairs({
  study,
  posed,
  filter,
  set,
  picked,
  pick,
}: {
  study: Study;
  posed: Posed;
  filter: Filter;
  set: (filter: Filter) => void;
  picked: number | null;
  pick: (pair: number) => void;
}) {
  const [order, setOrder] = useState<Order>({ column: "risk", down: false });
  const here = useMemo(() => posed.gaps.map((gap) => gap?.distance ?? null), [posed]);
  // A slider that moves leaves the rows where they are, unless they are sorted by the gap here.
  const rows = useMemo(
    () => rowsOf(study, filter, order, here),
    [study, filter, order, order.column === "here" ? here : null],
  );
  const unit = unitOf(study);
  const wrong = (model: Model): Partial<ColumnOf<number>> => ({
    numeric: true,
    cell: (i) =>
      wrongOf(study.pairs[i]!, model) === 0 ? (
        <span class="soft">{"\u2013"}</span>
      ) : (
        <>
          {short(worstOf(study.pairs[i]!, model), 2)}
          <br />
          <span class="soft">
            {grouped(wrongOf(study.pairs[i]!, model))}
            {"\u00d7"}
          </span>
        </>
      ),
    hint: (i) => `${plural(wrongOf(study.pairs[i]!, model), "wrong answer")} of ${grouped(study.pairs[i]!.samples)}`,
    bad: (i) => wrongOf(study.pairs[i]!, model) > 0,
  });
  const cells: Record<Column, Partial<ColumnOf<number>>> = {
    pair: {
      cell: (i) => (
        <>
          {study.pairs[i]!.a}
          <br />
          {study.pairs[i]!.b}
        </>
      ),
      hint: (i) => `${study.pairs[i]!.a} \u2013 ${study.pairs[i]!.b}`,
    },
    needs: {
      cell: (i) => {
        const pair = study.pairs[i]!;
        return (
          <>
            <Swatch model={pair.needs} />
            {pair.needs}
            {pair.recommended.join() !== pair.needs && (
              <>
                <br />
                <span class="soft">{pair.recommended.join(", ")}</span>
              </>
            )}
          </>
        );
      },
    },
    risk: {
      cell: (i) => {
        const risk = riskOf(study, i),
          proof = proofOf(study, i);
        return (
          <>
            <span class={riskClass[risk]}>{risk}</span>
            {proof && (
              <>
                <br />
                <span class="soft">{formatProofShort(study, proof)}</span>
              </>
            )}
          </>
        );
      },
      hint: (i) => {
        const proof = proofOf(study, i);
        return `${aboutScene(riskOf(study, i))}${proof ? ` ${asSentence(formatProof(study, proof))}.` : ""}`;
      },
    },
    least: { numeric: true, cell: (i) => short(leastOf(study, i)) },
    here: { numeric: true, cell: (i) => short(here[i]), bad: (i) => posed.within[i] === true },
    within: { numeric: true, cell: (i) => percent(study.pairs[i]!.within, study.pairs[i]!.samples) },
    sphere: wrong("sphere"),
    outer: wrong("outer capsule"),
    inner: wrong("inner capsule"),
  };
  const told = columns.map(
    (key) =>
      ({
        key,
        title: `${titles[key]}${unit && lengths.has(key) ? ` [${unit}]` : ""}`,
        about: ofModels[key] ?? aboutScene(titles[key]),
        ...cells[key],
      }) as ColumnOf<number>,
  );
  const turn = (column: string) =>
    setOrder({
      column: column as Column,
      down: order.column === column ? !order.down : !["pair", "risk", "least", "here"].includes(column),
    });
  return (
    <div class={`pairs ${study.motions ? "proved" : ""}`}>
      <div class="tools">
        <input
          type="search"
          value={filter.text}
          placeholder="names of bodies"
          aria-label="Search pairs by name"
          onInput={(event) => set({ ...filter, text: event.currentTarget.value })}
        />
        <span class="soft" role="status">
          {rows.length === study.pairs.length
            ? plural(rows.length, "pair")
            : `${grouped(rows.length)} of ${plural(study.pairs.length, "pair")}`}
        </span>
        <button
          type="button"
          class="saving"
          onClick={() => save(csvName(study), "text/csv", csvOfStudy(study, rows, here))}>
          Save as CSV
        </button>
      </div>
      <VirtualTable
        rows={rows}
        columns={told}
        keyOf={(i) => i}
        label="Pairs; arrow keys pick one"
        order={order}
        turn={turn}
        at={picked === null ? -1 : rows.indexOf(picked)}
        move={(at) => pick(rows[at]!)}
        open={pick}
        rowHeight={rowHeight}
        rowsShown={rowsShown}
      />
      <p class="only-print">Only the rows that were on the screen are printed. The CSV has all rows.</p>
    </div>
  );
}

function formatHere(within: boolean, wrong: boolean) {
  if (!wrong) return within ? "within" : "apart";
  return within ? "apart: missed" : "within: a false alarm";
}

/** What every model says of the picked pair, here and in all samples; the ghosts are switched here. */
export function Picked({
  study,
  at,
  posed,
  picked,
  ghosts,
  switchGhost,
  showProof,
}: {
  study: Study;
  at: number;
  posed: Posed;
  picked: number;
  ghosts: ReadonlySet<Model>;
  switchGhost: (model: Model) => void;
  showProof: (proof: Proof) => void;
}) {
  const pair = study.pairs[picked]!,
    proof = proofOf(study, picked),
    unit = unitOf(study),
    seen = posed.set ? null : study.kept[at]!.pairs[picked]!; // what models say is known of kept ones
  const wrongModels = seen?.wrong.filter(hasStandIn) ?? [];
  const heads = ["show", "model", ...(seen ? ["says here"] : []), "n:wrong overall"];
  const inUnit = (head: string) => (unit ? `${head} [${unit}]` : head);
  const told = [...heads, inUnit("n:false alarm up to"), inUnit("n:missed up to")];
  return (
    <div class="picked">
      <h3>
        <i class="swatch a" /> {pair.a} {"\u2013"} <i class="swatch b" /> {pair.b}{" "}
        <span class="soft">
          needs {aModel(pair.needs)}; cheapest: {pair.recommended.join(", then ")}
        </span>
      </h3>
      <p>
        <span class={posed.within[picked] ? "bad" : ""}>
          Here they {formatGap(posed.gaps[picked]!.distance, study.clearance, unit)}.
        </span>
        {standsIn(study, picked) && (
          <span class="soft"> The gap is that of the solid around a box or mesh, which may be farther away.</span>
        )}
        {seen && wrongModels.length > 0 && (
          <span class="bad">
            {" "}
            {seen.within
              ? `Alone, the ${wrongModels.join(" and the ")} would miss that.`
              : `Alone, the ${wrongModels.join(" and the ")} would raise a false alarm.`}
          </span>
        )}
      </p>
      {proof && (
        <p class={verdictClass[proof.verdict]}>
          Proof over all motions: {formatProof(study, proof)}. <ShowProof proof={proof} show={showProof} />
        </p>
      )}
      <div class="scroll">
      <table class="plain">
        <thead>
          <tr>
            {told.map((head) => (
              <th
                scope="col"
                class={head.startsWith("n:") ? "n" : ""}
                title={aboutScene(head.replace("n:", ""))}
                key={head}>
                {head.replace("n:", "")}
              </th>
            ))}
          </tr>
        </thead>
        <tbody>
          {pair.models.map((m) => {
            const wrong = seen?.wrong.includes(m.model) ?? false;
            return (
              <tr key={m.model}>
                <td>
                  {hasStandIn(m.model) && (
                    <input
                      type="checkbox"
                      aria-label={`Show the ${m.model} of both`}
                      checked={ghosts.has(m.model)}
                      onChange={() => switchGhost(m.model)}
                    />
                  )}
                </td>
                <td>
                  <Swatch model={m.model} />
                  {m.model}
                </td>
                {seen && <td class={wrong ? "bad" : ""}>{formatHere(seen.within, wrong)}</td>}
                <td class={`n ${m.wrong > 0 ? "bad" : ""}`}>
                  {m.wrong === 0 ? "\u2013" : `${grouped(m.wrong)} of ${grouped(pair.samples)}`}
                </td>
                <td class="n">{m.false_alarm > 0 ? short(m.false_alarm) : "\u2013"}</td>
                <td class="n">{m.missed > 0 ? short(m.missed) : "\u2013"}</td>
              </tr>
            );
          })}
        </tbody>
      </table>
      </div>
    </div>
  );
}
