// SPDX-License-Identifier: MIT
// The pairs: a legend of the models that they need, which filters; a table; and what is known of the one that is
// picked.
import { useMemo, useState } from "preact/hooks";
import { VirtualTable, type ColumnOf } from "./table.tsx";
import {
  a_model,
  columns,
  gap_words,
  has_stand_in,
  model_colour,
  models,
  passes,
  rows_of,
  worst_of,
  wrong_of,
  type Column,
  type Filter,
  type Model,
  type Order,
  type Study,
} from "./study.ts";
import { grouped, percent, plural, short } from "./words.ts";

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
const titles: Record<Column, [string, string]> = {
  pair: ["pair", ""],
  needs: [
    "needs",
    "the simplest model that alone answers every sample right; below it what is cheapest, where that is something " +
      "else: asked one after the other, the last is accepted",
  ],
  least: ["least distance", "over all configurations; negative: the depth of an overlap"],
  within: ["within", "share of the configurations in which the two are within the clearance"],
  sphere: ["sphere", "false alarms of the spheres around both, alone: up to how far beyond the clearance"],
  outer: ["capsule", "false alarms of the capsules around both, alone: up to how far beyond the clearance"],
  inner: ["inner", "what the capsules inside both, alone, miss: down to how far below the clearance"],
};

export function Pairs({
  study,
  filter,
  set,
  picked,
  pick,
}: {
  study: Study;
  filter: Filter;
  set: (filter: Filter) => void;
  picked: number | null;
  pick: (pair: number) => void;
}) {
  const [order, set_order] = useState<Order>({ column: "needs", down: true });
  const rows = useMemo(() => rows_of(study, filter, order), [study, filter, order]);
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
    least: { numeric: true, cell: (i) => short(study.pairs[i]!.least_distance) },
    within: { numeric: true, cell: (i) => percent(study.pairs[i]!.within, study.pairs[i]!.samples) },
    sphere: wrong("sphere"),
    outer: wrong("outer capsule"),
    inner: wrong("inner capsule"),
  };
  const told = columns.map(
    (key) =>
      ({
        key,
        title: titles[key][0],
        ...(titles[key][1] ? { about: titles[key][1] } : {}),
        ...cells[key],
      }) as ColumnOf<number>,
  );
  const turn = (column: string) =>
    set_order({
      column: column as Column,
      down: order.column === column ? !order.down : column !== "pair" && column !== "least",
    });
  return (
    <div class="pairs">
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
  picked,
  ghosts,
  switch_ghost,
}: {
  study: Study;
  at: number;
  picked: number;
  ghosts: ReadonlySet<Model>;
  switch_ghost: (model: Model) => void;
}) {
  const pair = study.pairs[picked]!,
    seen = study.kept[at]!.pairs[picked]!;
  const wrong_models = seen.wrong.filter(has_stand_in);
  return (
    <div class="picked">
      <h3>
        <i class="swatch a" /> {pair.a} {"\u2013"} <i class="swatch b" /> {pair.b}{" "}
        <span class="soft">
          needs {a_model(pair.needs)}; cheapest: {pair.recommended.join(", then ")}
        </span>
      </h3>
      <p>
        Here they {gap_words(seen.distance, study.clearance)}.
        {wrong_models.length > 0 && (
          <span class="bad">
            {" "}
            {seen.within
              ? `Alone, the ${wrong_models.join(" and the ")} would miss that.`
              : `Alone, the ${wrong_models.join(" and the ")} would raise a false alarm.`}
          </span>
        )}
      </p>
      <table class="plain">
        <thead>
          <tr>
            <th>show</th>
            <th>model</th>
            <th>says here</th>
            <th class="n">wrong in all</th>
            <th class="n">false alarm up to</th>
            <th class="n">missed up to</th>
          </tr>
        </thead>
        <tbody>
          {pair.models.map((m) => {
            const wrong = seen.wrong.includes(m.model);
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
                <td class={wrong ? "bad" : ""}>{here_words(seen.within, wrong)}</td>
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
  );
}
