// SPDX-License-Identifier: MIT
// The pairs: a legend of the models that they need, which filters; a table; and what is known of the one that is
// picked.
import { useMemo, useState } from "preact/hooks";
import { save } from "../parts/save.ts";
import { VirtualTable, type ColumnOf } from "../parts/table.tsx";
import { grouped, percent, plural, short } from "../parts/words.ts";
import { csv_name, csv_of_study } from "./csv.ts";
import { about_study } from "./glossary.ts";
import { columns, passes, rows_of, worst_of, wrong_of, type Column, type Filter, type Order } from "./order.ts";
import type { Posed } from "./pose.ts";
import { proof_words, short_proof_words, ShowProof, verdict_class } from "./proofs.tsx";
import { least_of, proof_of, risk_of, type Risk } from "./risk.ts";
import {
  a_model,
  gap_words,
  has_stand_in,
  model_colour,
  models,
  said,
  stands_in,
  unit_of,
  type Model,
  type Proof,
  type Study,
} from "./study.ts";

export const Swatch = ({ model }: { model: Model }) => (
  <i class="swatch" style={{ background: `var(${model_colour[model]})` }} />
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
      <span class="soft">Pairs that need a</span>
      {used.map(([model, count]) => (
        <button
          type="button"
          class="chip"
          aria-pressed={filter.models.has(model)}
          onClick={() => press(model)}
          title={`only pairs for which ${a_model(model)} is enough, and nothing simpler`}
          key={model}>
          <Swatch model={model} />
          {model} <span class="count">{grouped(count)}</span>
        </button>
      ))}
    </span>
  );
}

const row_height = 36,
  rows_shown = 15;
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
const of_models: Partial<Record<Column, string>> = {
  sphere: "False alarms of the spheres around both, by themselves: up to how far beyond the clearance, and how often.",
  outer: "False alarms of the capsules around both, by themselves: up to how far beyond the clearance, and how often.",
  inner: "What the capsules inside both miss, by themselves: down to how far below the clearance, and how often.",
};
const lengths: ReadonlySet<Column> = new Set(["least", "here", "sphere", "outer", "inner"]);
const risk_class: Record<Risk, string> = {
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
  const [order, set_order] = useState<Order>({ column: "risk", down: false });
  const here = useMemo(() => posed.gaps.map((gap) => gap?.distance ?? null), [posed]);
  // A slider that moves leaves the rows where they are, unless they are sorted by the gap here.
  const rows = useMemo(
    () => rows_of(study, filter, order, here),
    [study, filter, order, order.column === "here" ? here : null],
  );
  const unit = unit_of(study);
  const wrong = (model: Model): Partial<ColumnOf<number>> => ({
    numeric: true,
    cell: (i) =>
      wrong_of(study.pairs[i]!, model) === 0 ? (
        <span class="soft">{"\u2013"}</span>
      ) : (
        <>
          {short(worst_of(study.pairs[i]!, model), 2)}
          <br />
          <span class="soft">
            {grouped(wrong_of(study.pairs[i]!, model))}
            {"\u00d7"}
          </span>
        </>
      ),
    hint: (i) => `${plural(wrong_of(study.pairs[i]!, model), "wrong answer")} of ${grouped(study.pairs[i]!.samples)}`,
    bad: (i) => wrong_of(study.pairs[i]!, model) > 0,
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
        const risk = risk_of(study, i),
          proof = proof_of(study, i);
        return (
          <>
            <span class={risk_class[risk]}>{risk}</span>
            {proof && (
              <>
                <br />
                <span class="soft">{short_proof_words(study, proof)}</span>
              </>
            )}
          </>
        );
      },
      hint: (i) => {
        const proof = proof_of(study, i);
        return `${about_study(risk_of(study, i))}${proof ? ` ${said(proof_words(study, proof))}.` : ""}`;
      },
    },
    least: { numeric: true, cell: (i) => short(least_of(study, i)) },
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
        about: of_models[key] ?? about_study(titles[key]),
        ...cells[key],
      }) as ColumnOf<number>,
  );
  const turn = (column: string) =>
    set_order({
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
          onClick={() => save(csv_name(study), "text/csv", csv_of_study(study, rows, here))}>
          Save as CSV
        </button>
      </div>
      <VirtualTable
        rows={rows}
        columns={told}
        key_of={(i) => i}
        label="Pairs; arrow keys pick one"
        order={order}
        turn={turn}
        at={picked === null ? -1 : rows.indexOf(picked)}
        move={(at) => pick(rows[at]!)}
        open={pick}
        row_height={row_height}
        rows_shown={rows_shown}
      />
      <p class="only-print">Only the rows that were on the screen are printed; all of them are in the CSV.</p>
    </div>
  );
}

function here_words(within: boolean, wrong: boolean) {
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
  switch_ghost,
  show_proof,
}: {
  study: Study;
  at: number;
  posed: Posed;
  picked: number;
  ghosts: ReadonlySet<Model>;
  switch_ghost: (model: Model) => void;
  show_proof: (proof: Proof) => void;
}) {
  const pair = study.pairs[picked]!,
    proof = proof_of(study, picked),
    unit = unit_of(study),
    seen = posed.set ? null : study.kept[at]!.pairs[picked]!; // what models say is known of kept ones
  const wrong_models = seen?.wrong.filter(has_stand_in) ?? [];
  const heads = ["show", "model", ...(seen ? ["says here"] : []), "n:wrong in all"];
  const in_unit = (head: string) => (unit ? `${head} [${unit}]` : head);
  const told = [...heads, in_unit("n:false alarm up to"), in_unit("n:missed up to")];
  return (
    <div class="picked">
      <h3>
        <i class="swatch a" /> {pair.a} {"\u2013"} <i class="swatch b" /> {pair.b}{" "}
        <span class="soft">
          needs {a_model(pair.needs)}; cheapest: {pair.recommended.join(", then ")}
        </span>
      </h3>
      <p>
        <span class={posed.within[picked] ? "bad" : ""}>
          Here they {gap_words(posed.gaps[picked]!.distance, study.clearance, unit)}.
        </span>
        {stands_in(study, picked) && (
          <span class="soft"> Measured from the solid around a box or mesh, which itself may be farther away.</span>
        )}
        {seen && wrong_models.length > 0 && (
          <span class="bad">
            {" "}
            {seen.within
              ? `Alone, the ${wrong_models.join(" and the ")} would miss that.`
              : `Alone, the ${wrong_models.join(" and the ")} would raise a false alarm.`}
          </span>
        )}
      </p>
      {proof && (
        <p class={verdict_class[proof.verdict]}>
          Over all motions {proof_words(study, proof)}. <ShowProof proof={proof} show={show_proof} />
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
                title={about_study(head.replace("n:", ""))}
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
                  {has_stand_in(m.model) && (
                    <input
                      type="checkbox"
                      aria-label={`Show the ${m.model} of both`}
                      checked={ghosts.has(m.model)}
                      onChange={() => switch_ghost(m.model)}
                    />
                  )}
                </td>
                <td>
                  <Swatch model={m.model} />
                  {m.model}
                </td>
                {seen && <td class={wrong ? "bad" : ""}>{here_words(seen.within, wrong)}</td>}
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
