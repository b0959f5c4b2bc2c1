// SPDX-License-Identifier: MIT
// The page of a scene: what is recommended, the robot with its pairs, cost against wrong answers. What is looked at
// stands in the address after '#', so that it can be passed on.
import { useCallback, useEffect, useMemo, useState } from "preact/hooks";
import { Copy, Figure, Section, Select } from "./parts.tsx";
import { screen } from "./plots.ts";
import { has_stand_in, models, no_filter, passes, reason_words, said, type Model, type Study } from "./study.ts";
import { Legend, Pairs, Picked, Swatch } from "./study_pairs.tsx";
import { cost_plot_of_study } from "./study_plot.ts";
import { StudyView } from "./study_view.tsx";
import { grouped, plural, safe, shell_quoted, short, time } from "./words.ts";

const sections = [
  ["recommendation", "Recommendation"],
  ["scene", "Scene and pairs"],
  ["cost", "Cost and wrong answers"],
] as const;

function Header({ study }: { study: Study }) {
  return (
    <header>
      <h1>
        <a href="#recommendation">daylight</a> <span class="soft">what a scene needs</span>
      </h1>
      <nav aria-label="Sections">
        {sections.map(([key, title]) => (
          <a href={`#${key}`} key={key}>
            {title}
          </a>
        ))}
      </nav>
      <p class="run">
        <b>{study.file}</b> · seed {study.seed} · {plural(study.configurations, "configuration")} · clearance{" "}
        {short(study.clearance)}
        {study.tolerated > 0 && <> · tolerated {short(study.tolerated)}</>}
      </p>
    </header>
  );
}

/** Some lines, the rest on demand. */
function Lines({ lines, shown = 3 }: { lines: string[]; shown?: number }) {
  const all = lines.map((text, i) => <li key={i}>{text}</li>);
  if (lines.length <= shown) return <>{all}</>;
  return (
    <>
      {all.slice(0, shown - 1)}
      <li>
        <details class="print">
          <summary>{lines.length - shown + 1} more</summary>
          <ul>{all.slice(shown - 1)}</ul>
        </details>
      </li>
    </>
  );
}

/** "17 box (base, ...)", where that is long with the names on demand. */
function LongList({ text }: { text: string }) {
  const names = text.indexOf(" (");
  return text.length < 90 || names < 0 ? (
    <>{text}</>
  ) : (
    <details class="print">
      <summary>{text.slice(0, names)}</summary>
      {text.slice(names + 2, -1)}
    </details>
  );
}

function Recommendation({ study }: { study: Study }) {
  const { words } = study,
    checked = study.pairs.length > 0;
  const against = words.cost.split("; ");
  return (
    <section id="recommendation" aria-labelledby="recommendation-title">
      <h2 id="recommendation-title" class="verdict">
        {checked ? said(`${words.recommended}: ${against[0]}`) : "Nothing to check"}
      </h2>
      <ul class="said">
        {against.slice(1).map((text) => (
          <li key={text}>{said(text)}</li>
        ))}
        {words.forgiven && <li>{said(words.forgiven)}</li>}
        {checked && <li>{said(words.enough)}</li>}
        {words.capsules && <li class={study.models[1]!.wrong > 0 ? "bad" : "ok"}>{said(words.capsules)}</li>}
        <Lines lines={words.rounding.map(said)} shown={2} />
        {words.closest && <li>{said(words.closest)}</li>}
        {words.verified && <li class={/ 0 wrong/.test(words.verified) ? "ok" : "bad"}>{said(words.verified)}</li>}
        {study.asked_referee > 0 && (
          <li>
            {plural(study.asked_referee, "sample")} left to the referee, {study.undecided} of them not proved and taken
            for within
          </li>
        )}
      </ul>
      <ul class="said soft">
        <li>
          {said(words.counts)}; {words.pairs}
        </li>
        {words.configurations && <li>{said(words.configurations)}</li>}
        {words.left_out.map((text) => (
          <li class="warn" key={text}>
            Not looked at: <LongList text={text} />
          </li>
        ))}
        <Lines lines={study.notes} />
      </ul>
    </section>
  );
}

/** "#at=3&pair=12&ghosts=sphere" */
interface Looked {
  at: number;
  picked: number | null;
  ghosts: ReadonlySet<Model>;
  close: boolean;
}
function read_address(study: Study): Looked {
  const told = new URLSearchParams(location.hash.slice(1));
  const index = (name: string, of: unknown[]) => {
    const i = Number(told.get(name) ?? NaN);
    return Number.isInteger(i) && i >= 0 && i < of.length ? i : null;
  };
  return {
    at: index("at", study.kept) ?? 0,
    picked: index("pair", study.pairs),
    ghosts: new Set(models.filter((m) => has_stand_in(m) && told.get("ghosts")?.split(",").includes(m))),
    close: told.get("close") === "1",
  };
}
function address_of({ at, picked, ghosts, close }: Looked) {
  if (at === 0 && picked === null) return "#";
  const told = new URLSearchParams({
    at: String(at),
    ...(picked === null ? {} : { pair: String(picked) }),
    ...(ghosts.size > 0 ? { ghosts: [...ghosts].join(",") } : {}),
    ...(close ? { close: "1" } : {}),
  });
  return `#${told}`;
}

function Scene({ study }: { study: Study }) {
  const [looked, look] = useState(() => read_address(study));
  const [filter, set_filter] = useState(no_filter);
  const [touched, touch] = useState<number | null>(null); // the body clicked last
  const { at, picked, ghosts, close } = looked,
    kept = study.kept[at]!;
  const passing = useMemo(
    () => new Set(study.pairs.flatMap((pair, i) => (passes(pair, filter) ? [i] : []))),
    [study, filter],
  );
  const options = useMemo(
    () =>
      study.kept.flatMap((k, i) =>
        k.reasons.map((reason, j) => ({ key: `${i} ${j}`, at: i, reason, words: reason_words(study, k, reason) })),
      ),
    [study],
  );
  const [chosen, choose] = useState(() => options.find((o) => o.at === at)?.key ?? "0 0");

  useEffect(() => {
    const now = address_of(looked);
    if (now === "#" ? /^#at=/.test(location.hash) : now !== location.hash) history.replaceState(null, "", now);
  }, [looked]);
  useEffect(() => {
    const changed = () => {
      if (/^#at=/.test(location.hash)) look(read_address(study));
    };
    addEventListener("hashchange", changed);
    return () => removeEventListener("hashchange", changed);
  }, [study]);
  const pick_pair = useCallback((pair: number | null) => {
    look((was) => ({ ...was, picked: pair, close: pair === null ? false : was.close }));
    touch(null);
  }, []);
  // The pair of the two bodies clicked last; of one that has none with the other, its nearest pair.
  const pick_body = useCallback(
    (body: number) => {
      const of_both =
        touched === null
          ? -1
          : study.pairs.findIndex(
              ({ bodies }) => bodies.includes(body) && bodies.includes(touched) && body !== touched,
            );
      const own = study.pairs.flatMap(({ bodies }, i) => (bodies.includes(body) && passing.has(i) ? [i] : []));
      const nearest = own.reduce(
        (best, i) => (best < 0 || kept.pairs[i]!.distance < kept.pairs[best]!.distance ? i : best),
        -1,
      );
      const pair = of_both >= 0 ? of_both : nearest;
      look((was) => ({ ...was, picked: pair >= 0 ? pair : null }));
      touch(body);
    },
    [study, touched, passing, kept],
  );
  const switch_ghost = (model: Model) =>
    look((was) => {
      const now = new Set(was.ghosts);
      if (!now.delete(model)) now.add(model);
      return { ...was, ghosts: now };
    });
  const choose_option = (key: string) => {
    const option = options.find((o) => o.key === key)!;
    choose(key);
    look((was) => ({
      ...was,
      at: option.at,
      ...(option.reason.pair === undefined ? {} : { picked: option.reason.pair }),
      ...(option.reason.model ? { ghosts: new Set([option.reason.model].filter(has_stand_in)) } : {}),
    }));
  };
  const clearance = study.clearance > 0 ? ` --clearance ${study.clearance}` : "";
  const joints = Object.entries(kept.joints).map(([name, value]) => `${shell_quoted(safe(name))}=${value}`);
  const command = `./daylight scene ${shell_quoted(study.file)}${clearance} --at ${joints.join(" ")}`;
  return (
    <Section id="scene" title="Scene and pairs">
      <div class="study">
        <div class="seen">
          <div class="stage-tools" role="group" aria-label="View">
            <Select
              label="Look at"
              value={chosen}
              onChange={choose_option}
              options={options.map((o) => [o.key, o.words] as const)}
            />
            <button
              type="button"
              aria-pressed={close}
              disabled={picked === null}
              onClick={() => look({ ...looked, close: !close })}>
              Close up
            </button>
            <button type="button" disabled={picked === null} onClick={() => pick_pair(null)}>
              Show all
            </button>
          </div>
          <StudyView
            shown={{ study, at, picked, ghosts, close, passing }}
            pick_pair={pick_pair}
            pick_body={pick_body}
          />
          {study.pairs.length > 0 && <Legend study={study} filter={filter} set={set_filter} />}
          {picked === null ? (
            <p class="soft">
              Bodies have the colour of the most exact model that one of their pairs needs; lines join the nearest
              points of a pair. Drag to turn, wheel to zoom; click a body, then another one, a line, or a row to pick a
              pair.
            </p>
          ) : (
            <Picked study={study} at={at} picked={picked} ghosts={ghosts} switch_ghost={switch_ghost} />
          )}
          {Object.keys(kept.joints).length > 0 && (
            <details>
              <summary>Joints of this configuration</summary>
              <Copy label="This configuration alone" text={command} />
            </details>
          )}
        </div>
        {study.pairs.length > 0 && (
          <Pairs study={study} filter={filter} set={set_filter} picked={picked} pick={pick_pair} />
        )}
      </div>
    </Section>
  );
}

function Cost({ study }: { study: Study }) {
  const draw = useCallback((width: number) => cost_plot_of_study(study, { width, theme: screen }), [study]);
  const ns = study.ns_per_configuration,
    wrong = study.pairs.reduce((n, pair) => n + pair.recommended_wrong, 0),
    length = (x: number) => (x > 0 ? short(x) : "\u2013"),
    count = (n: number) => (n > 0 ? grouped(n) : "\u2013");
  return (
    <Section
      id="cost"
      title="Cost and wrong answers"
      lead={
        "Each model alone for every pair, in every configuration drawn. To the left is cheaper, on the " +
        "lowest line nothing is wrong. A sphere or an outer capsule alone only raises false alarms, an inner capsule " +
        "alone only misses."
      }>
      <div class="cost">
        <Figure draw={draw} height={340} label="Wrong answers against time a configuration, a point a model" />
        <div class="scroll">
          <table class="plain">
            <thead>
              <tr>
                <th>model</th>
                <th class="n" title="samples of which it is the first that can tell">
                  decides
                </th>
                <th class="n">alone</th>
                <th class="n" title="pairs for which it is enough">
                  suffices
                </th>
                <th class="n">wrong</th>
                <th class="n">in pairs</th>
                <th class="n">false alarm</th>
                <th class="n">missed</th>
              </tr>
            </thead>
            <tbody>
              {study.models.map((m) => (
                <tr key={m.model}>
                  <td>
                    <Swatch model={m.model} />
                    {m.model}
                  </td>
                  <td class="n">{count(m.decides)}</td>
                  <td class="n">{time(ns.alone[m.model])}</td>
                  <td class="n">{m.suffices}</td>
                  <td class={`n ${m.wrong > 0 ? "bad" : ""}`}>{count(m.wrong)}</td>
                  <td class="n">{count(m.wrong_pairs)}</td>
                  <td class="n">{length(m.false_alarm)}</td>
                  <td class="n">{length(m.missed)}</td>
                </tr>
              ))}
              <tr>
                <td>
                  <b class="ok">{"\u2605"} recommended</b>
                </td>
                <td />
                <td class="n">{time(ns.recommended)}</td>
                <td class="n">{study.pairs.length}</td>
                <td class="n">{count(wrong)}</td>
                <td />
                <td />
                <td />
              </tr>
            </tbody>
          </table>
          <p class="soft">
            Times are of one configuration with all its pairs. To move the bodies takes {time(ns.kinematics)} more, to
            make their models {time(ns.models)}.
          </p>
        </div>
      </div>
    </Section>
  );
}

export function StudyPage({ study }: { study: Study }) {
  return (
    <>
      <Header study={study} />
      <main class="overview">
        <Recommendation study={study} />
        {study.kept.length > 0 && study.bodies.length > 0 && <Scene study={study} />}
        {study.pairs.length > 0 && <Cost study={study} />}
        <footer class="soft">
          <p>
            One file; it asks nothing from the network. All of its data:{" "}
            <code>./daylight scene {shell_quoted(study.file)} --json FILE</code>
          </p>
        </footer>
      </main>
    </>
  );
}
