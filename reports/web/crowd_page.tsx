// SPDX-License-Identifier: MIT
// The page of many cylinders that stand still: how many pairs are close, what the referee says of the answers, the
// cylinders in 3D with the nearest pairs, how the time grows. What is picked stands in the address after '#'.
import { useCallback, useEffect, useMemo, useState } from "preact/hooks";
import {
  command_of,
  csv_of_pairs,
  name_of,
  near_pair,
  partners_of,
  power_law,
  rows_of,
  source_of,
  total_ms,
  type Column,
  type Crowd,
  type GrowthRow,
  type NearPair,
  type Order,
} from "./crowd.ts";
import { height, pairs_plot, time_plot } from "./crowd_plot.ts";
import { CrowdView, type Picked, type Showing } from "./crowd_view.tsx";
import { Copy, Fact, Figure, Section, Select } from "./parts.tsx";
import { screen } from "./plots.ts";
import { save } from "./save.ts";
import { VirtualTable, type ColumnOf } from "./table.tsx";
import { full, grouped, percent, plural, short, time } from "./words.ts";

const ms = (x: number) => time(1e6 * x);
const said_within = (crowd: Crowd) => (crowd.clearance > 0 ? `within ${short(crowd.clearance)}` : "intersecting");

function verdict_of(crowd: Crowd): string {
  const count = crowd.within.length,
    who = count === 0 ? "No pair" : plural(count, "pair"),
    many = count > 1;
  if (crowd.clearance > 0) return `${who} ${many ? "are" : "is"} within ${short(crowd.clearance)}`;
  return `${who} ${many ? "intersect" : "intersects"}`;
}

function Header({ crowd }: { crowd: Crowd }) {
  const sections = [
    ["answer", "Answer"],
    ["cylinders", "Cylinders and pairs"],
    ...(crowd.growth ? [["growth", "Growth"]] : []),
  ];
  return (
    <header>
      <h1>
        <a href="#answer">daylight</a> <span class="soft">close pairs of many cylinders</span>
      </h1>
      <nav aria-label="Sections">
        {sections.map(([key, title]) => (
          <a href={`#${key}`} key={key}>
            {title}
          </a>
        ))}
      </nav>
      <p class="run">
        <b>{source_of(crowd)}</b> · {plural(crowd.cylinders, "cylinder")}
        {crowd.seed !== undefined && <> · seed {crowd.seed}</>} · clearance {short(crowd.clearance)}
      </p>
    </header>
  );
}

/** What the referee said of the answers and of their certificates; without --verify, how to ask. */
function Checked({ crowd }: { crowd: Crowd }) {
  const { verification: v, certificates: c } = crowd;
  if (!v || !c)
    return (
      <li class="warn">
        No answer was put before the referee: <code>{command_of(crowd)} --verify</code> does that
      </li>
    );
  return (
    <>
      <li class={v.wrong > 0 ? "bad" : "ok"}>
        Referee: {plural(v.asked, "answer")} asked, {grouped(v.wrong)} wrong, {grouped(v.undecided)} not proved
        <span class="soft"> · {ms(v.cpu_ms)}</span>
      </li>
      <li class={c.failed > 0 ? "bad" : "ok"}>
        Certificates: {grouped(c.checked)} checked, {grouped(c.failed)} failed, {plural(c.undecided, "pair")} without
        one
        <span class="soft"> · {ms(c.cpu_ms)}</span>
      </li>
    </>
  );
}

function Answer({ crowd }: { crowd: Crowd }) {
  const pairs = (crowd.cylinders * (crowd.cylinders - 1)) / 2,
    count = crowd.within.length;
  const levels = Object.entries(crowd.decided).filter(([, n]) => n > 0);
  return (
    <section id="answer" aria-labelledby="answer-title">
      <h2 id="answer-title" class="verdict">
        {verdict_of(crowd)}, found in {ms(total_ms(crowd.cpu_ms))}
      </h2>
      <ul class="said">
        <Checked crowd={crowd} />
        {crowd.undecided > 0 && (
          <li class="warn">
            {plural(crowd.undecided, "pair")} left undecided, and taken for {said_within(crowd)}
          </li>
        )}
      </ul>
      <dl class="facts">
        <Fact label="cylinders">{grouped(crowd.cylinders)}</Fact>
        <Fact label="pairs in all">{grouped(pairs)}</Fact>
        <Fact label="boxes meet">{grouped(crowd.candidates)}</Fact>
        {levels.map(([level, n]) => (
          <Fact label={`decided by ${level}`} key={level}>
            {grouped(n)}
          </Fact>
        ))}
        <Fact label={said_within(crowd)}>{grouped(count)}</Fact>
        <Fact label="models, tree, answers">
          {ms(crowd.cpu_ms.prepare)}, {ms(crowd.cpu_ms.tree)}, {ms(crowd.cpu_ms.ladder)}
        </Fact>
      </dl>
    </section>
  );
}

const row_height = 36,
  rows_shown = 13;

function Nearest({ crowd, picked, pick }: { crowd: Crowd; picked: Picked; pick: (picked: Picked) => void }) {
  const [order, set_order] = useState<Order>({ column: "rank", down: false });
  const [text, search] = useState("");
  const rows = useMemo(() => rows_of(crowd, text, order), [crowd, text, order]);
  const at = (i: number) => crowd.nearest[i]!;
  const told: ColumnOf<number>[] = [
    { key: "rank", title: "rank", numeric: true, cell: (i) => grouped(i + 1) },
    {
      key: "pair",
      title: "pair",
      cell: (i) => (
        <>
          {name_of(crowd, at(i).a)}
          <br />
          {name_of(crowd, at(i).b)}
        </>
      ),
      hint: (i) => `${name_of(crowd, at(i).a)} \u2013 ${name_of(crowd, at(i).b)}`,
    },
    {
      key: "distance",
      title: "distance",
      numeric: true,
      about: "negative: minus the depth of the overlap",
      cell: (i) => short(at(i).distance, 4),
      hint: (i) => `${full(at(i).distance)}, within ${short(at(i).error, 2)}`,
    },
    { key: "answer", title: "answer", cell: (i) => (at(i).within ? said_within(crowd) : "apart") },
    {
      key: "certificate",
      title: "certificate",
      about: "what proves the answer: a direction that separates both, a point of both, or a point of each",
      cell: (i) => (at(i).certificate === "none" ? "\u2013" : at(i).certificate),
    },
  ];
  const shown = picked !== null && "pair" in picked ? near_pair(crowd, picked.pair) : undefined;
  const pick_row = (i: number) => pick({ pair: [at(i).a, at(i).b] });
  const turn = (column: string) =>
    set_order({ column: column as Column, down: order.column === column ? !order.down : false });
  return (
    <div class="pairs crowd-pairs">
      <div class="tools">
        <input
          type="search"
          value={text}
          placeholder="names of cylinders"
          aria-label="Search the nearest pairs by name"
          onInput={(event) => search(event.currentTarget.value)}
        />
        <span class="soft" role="status">
          {rows.length === crowd.nearest.length
            ? `the nearest ${plural(rows.length, "pair")}`
            : `${grouped(rows.length)} of the nearest ${plural(crowd.nearest.length, "pair")}`}
        </span>
        <button
          type="button"
          class="saving"
          onClick={() => save("nearest-pairs.csv", "text/csv", csv_of_pairs(crowd, rows))}>
          CSV
        </button>
      </div>
      <VirtualTable
        rows={rows}
        columns={told}
        key_of={(i) => i}
        label="Nearest pairs; arrow keys pick one"
        order={order}
        turn={turn}
        at={shown ? rows.indexOf(crowd.nearest.indexOf(shown)) : -1}
        move={(row) => pick_row(rows[row]!)}
        open={pick_row}
        row_height={row_height}
        rows_shown={rows_shown}
      />
      {crowd.nearest.length > crowd.within.length && (
        <p class="soft">
          Of pairs whose boxes meet. Beyond the clearance others, whose boxes do not meet, may be nearer.
        </p>
      )}
    </div>
  );
}

/** So many partners of a solid are named; one that has more is in the JSON. */
const partner_cap = 30;

interface SolidOf {
  crowd: Crowd;
  solid: number;
  partners: number[];
  pick: (picked: Picked) => void;
}

function Solid({ crowd, solid, partners, pick }: SolidOf) {
  const [x, y, z, u, v, w, radius, length, rounding = 0] = crowd.solids[solid]!;
  const vector = (...of: (number | undefined)[]) => of.map((c) => full(c!)).join(", ");
  return (
    <div class="picked">
      <h3>
        <i class="swatch a" /> {name_of(crowd, solid)}
      </h3>
      <dl class="facts long">
        <Fact label="radius">{full(radius!)}</Fact>
        <Fact label="height">{full(length!)}</Fact>
        {rounding > 0 && <Fact label="rounding">{full(rounding)}</Fact>}
        <Fact label="centre">{vector(x, y, z)}</Fact>
        <Fact label="axis">{vector(u, v, w)}</Fact>
      </dl>
      <p>
        {partners.length === 0
          ? `It is in no pair ${said_within(crowd)}.`
          : `${plural(partners.length, "pair")} ${said_within(crowd)}, with `}
        {partners.slice(0, partner_cap).map((other, i) => (
          <span key={other}>
            {i > 0 && ", "}
            <button type="button" class="link" onClick={() => pick({ pair: [solid, other] })}>
              {name_of(crowd, other)}
            </button>
          </span>
        ))}
        {partners.length > partner_cap && ` and ${grouped(partners.length - partner_cap)} more`}
      </p>
    </div>
  );
}

const certificate_words: Record<NearPair["certificate"], string> = {
  direction: "a direction that separates both",
  point: "a point of both",
  points: "a point of each, no farther apart than both roundings and the clearance",
  none: "none",
};

interface PairOf {
  crowd: Crowd;
  pair: readonly [number, number];
  close: boolean;
  pick: (picked: Picked) => void;
}

function Pair({ crowd, pair, close, pick }: PairOf) {
  const near = near_pair(crowd, pair);
  const name = (solid: number, side: string) => (
    <>
      <i class={`swatch ${side}`} />{" "}
      <button type="button" class="link" onClick={() => pick({ solid })}>
        {name_of(crowd, solid)}
      </button>
    </>
  );
  return (
    <div class="picked">
      <h3>
        {name(pair[0], "a")} {"\u2013"} {name(pair[1], "b")}
      </h3>
      {near ? (
        <p>
          {near.distance < 0
            ? `They overlap by ${full(-near.distance)}, by no more than ${short(near.error, 2)} deeper.`
            : `They are ${full(near.distance)} apart, give or take ${short(near.error, 2)}.`}{" "}
          Certificate of the answer: {certificate_words[near.certificate]}.
        </p>
      ) : (
        <p>
          They are {close ? said_within(crowd) : `not ${said_within(crowd)}`}; the distance is known of the{" "}
          {grouped(crowd.nearest.length)} nearest pairs.
        </p>
      )}
    </div>
  );
}

/** "#solid=12", "#pair=12,40", "&show=close" */
interface Looked {
  picked: Picked;
  showing: Showing;
}
const showings: readonly (readonly [Showing, string])[] = [
  ["all", "all cylinders"],
  ["close", "those in a close pair"],
  ["nearest", "those of the nearest pairs"],
];
function read_address(crowd: Crowd): Looked {
  const told = new URLSearchParams(location.hash.slice(1));
  const indices = (name: string) =>
    (told.get(name) ?? "")
      .split(",")
      .map((text) => (/^\d+$/.test(text) ? Number(text) : NaN))
      .filter((i) => i < crowd.solids.length);
  const [solid] = indices("solid"),
    [a, b] = indices("pair");
  const picked =
    a !== undefined && b !== undefined && a !== b ? { pair: [a, b] as const } : solid !== undefined ? { solid } : null;
  return { picked, showing: showings.find(([key]) => key === told.get("show"))?.[0] ?? "all" };
}
function address_of({ picked, showing }: Looked) {
  const told = [
    ...(picked === null ? [] : "pair" in picked ? [`pair=${picked.pair.join(",")}`] : [`solid=${picked.solid}`]),
    ...(showing === "all" ? [] : [`show=${showing}`]),
  ];
  return `#${told.join("&")}`;
}
const is_view = (hash: string) => /^#(solid|pair|show)=/.test(hash);

function Cylinders({ crowd }: { crowd: Crowd }) {
  const [looked, look] = useState(() => read_address(crowd));
  const [fitted, fit] = useState(0);
  const { picked, showing } = looked;
  const partners = useMemo(() => partners_of(crowd), [crowd]);
  const pick = useCallback((it: Picked) => look((was) => ({ ...was, picked: it })), []);
  const pick_solid = useCallback((solid: number | null) => pick(solid === null ? null : { solid }), []);
  useEffect(() => {
    const now = address_of(looked);
    if (now === "#" ? is_view(location.hash) : now !== location.hash) history.replaceState(null, "", now);
  }, [looked]);
  useEffect(() => {
    const changed = () => {
      if (is_view(location.hash)) look(read_address(crowd));
    };
    addEventListener("hashchange", changed);
    return () => removeEventListener("hashchange", changed);
  }, [crowd]);
  return (
    <Section id="cylinders" title="Cylinders and pairs">
      <div class="study">
        <div class="seen">
          <div class="stage-tools" role="group" aria-label="View">
            <Select
              label="Show"
              value={showing}
              onChange={(key) => look({ picked: null, showing: key as Showing })}
              options={showings}
            />
            <button type="button" onClick={() => fit(fitted + 1)}>
              Fit
            </button>
            <button type="button" disabled={picked === null} onClick={() => pick(null)}>
              Show all
            </button>
          </div>
          <CrowdView shown={{ crowd, partners, showing, picked, fitted }} pick={pick_solid} />
          {picked === null ? (
            <p class="soft">
              <i class="swatch close" /> {grouped(partners.size)} in a close pair (
              {percent(partners.size, crowd.cylinders)}), <i class="swatch apart" />{" "}
              {grouped(crowd.cylinders - partners.size)} in none. Drag to turn, wheel to zoom; click a cylinder or a row
              to see it close up.
            </p>
          ) : "pair" in picked ? (
            <Pair
              crowd={crowd}
              pair={picked.pair}
              close={partners.get(picked.pair[0])?.includes(picked.pair[1]) ?? false}
              pick={pick}
            />
          ) : (
            <Solid crowd={crowd} solid={picked.solid} partners={partners.get(picked.solid) ?? []} pick={pick} />
          )}
        </div>
        <Nearest crowd={crowd} picked={picked} pick={pick} />
      </div>
    </Section>
  );
}

function Growth({ growth }: { growth: GrowthRow[] }) {
  const draw_time = useCallback((width: number) => time_plot(growth, { width, theme: screen }), [growth]);
  const draw_pairs = useCallback((width: number) => pairs_plot(growth, { width, theme: screen }), [growth]);
  const exponent = (of: (row: GrowthRow) => number) =>
    power_law(growth.map((row) => [row.cylinders, of(row)]))?.exponent.toFixed(2);
  const first = growth[0]!,
    last = growth[growth.length - 1]!;
  return (
    <Section
      id="growth"
      title="Growth"
      lead={
        growth.length > 1
          ? `From ${grouped(first.cylinders)} to ${grouped(last.cylinders)} cylinders the time grows as their number ` +
            `to the power ${exponent((row) => total_ms(row.cpu_ms))}, the pairs whose boxes meet to the power ` +
            `${exponent((row) => row.candidates)}: least squares through the logarithms, dashed. CPU time of one ` +
            "thread."
          : "Of fewer than 2,000 cylinders no parts are timed. CPU time of one thread."
      }>
      {growth.length > 1 && (
        <div class="pairs-of">
          <Figure draw={draw_time} height={height} label="CPU time against the number of cylinders" />
          <Figure draw={draw_pairs} height={height} label="Pairs against the number of cylinders" />
        </div>
      )}
      <div class="scroll">
        <table class="plain">
          <thead>
            <tr>
              <th class="n">cylinders</th>
              <th class="n">boxes meet</th>
              <th class="n">within</th>
              <th class="n">models</th>
              <th class="n">tree of boxes</th>
              <th class="n">answers</th>
              <th class="n">in all</th>
              <th class="n">for each cylinder</th>
            </tr>
          </thead>
          <tbody>
            {growth.map((row) => (
              <tr key={row.cylinders}>
                <td class="n">{grouped(row.cylinders)}</td>
                <td class="n">{grouped(row.candidates)}</td>
                <td class="n">{grouped(row.within)}</td>
                <td class="n">{ms(row.cpu_ms.prepare)}</td>
                <td class="n">{ms(row.cpu_ms.tree)}</td>
                <td class="n">{ms(row.cpu_ms.ladder)}</td>
                <td class="n">
                  <b>{ms(total_ms(row.cpu_ms))}</b>
                </td>
                <td class="n">{ms(total_ms(row.cpu_ms) / row.cylinders)}</td>
              </tr>
            ))}
          </tbody>
        </table>
      </div>
    </Section>
  );
}

export function CrowdPage({ crowd }: { crowd: Crowd }) {
  return (
    <>
      <Header crowd={crowd} />
      <main class="overview">
        <Answer crowd={crowd} />
        {crowd.solids.length > 0 && <Cylinders crowd={crowd} />}
        {crowd.growth && <Growth growth={crowd.growth} />}
        <footer class="soft">
          <p>One file; it asks nothing from the network.</p>
          <Copy label="The same again, and all of it as JSON" text={`${command_of(crowd)} --verify --json FILE`} />
        </footer>
      </main>
    </>
  );
}
