// SPDX-License-Identifier: MIT
// The page of a scene: what is recommended, the robot with its pairs, what is proved, cost against wrong answers.
import { useCallback, useState } from "preact/hooks";
import { Figure, Section } from "../parts/elements.tsx";
import { Words } from "../parts/glossary.tsx";
import { screen } from "../parts/plot.ts";
import { grouped, plural, shellQuoted, short, time } from "../parts/words.ts";
import { costPlotOfStudy } from "./cost_plot.ts";
import { aboutScene, sceneGlossaryEntries } from "./glossary.ts";
import { Swatch } from "./pairs.tsx";
import { Proofs } from "./proofs.tsx";
import { riskOf, type Risk } from "./risk.ts";
import { SceneSection } from "./scene.tsx";
import { formatLength, asSentence, unitOf, type Proof, type Study } from "./study.ts";

const sections = [
  ["recommendation", "Recommendation"],
  ["scene", "Scene and pairs"],
  ["proofs", "Over all motions"],
  ["cost", "Cost and wrong answers"],
  ["words", "Glossary"],
] as const;

function Header({ study }: { study: Study }) {
  return (
    <header>
      <h1>
        <a href="#recommendation">daylight</a> <span class="soft">the models that a scene needs</span>
      </h1>
      <nav aria-label="Sections">
        {sections.filter(([key]) => key !== "proofs" || study.motions).map(([key, title]) => (
          <a href={`#${key}`} key={key}>
            {title}
          </a>
        ))}
      </nav>
      <p class="run">
        <b>{study.file}</b> · seed {study.seed} · {plural(study.configurations, "configuration")} · clearance{" "}
        {formatLength(study.clearance, unitOf(study))}
        {study.tolerated > 0 && (
          <> · false alarms up to {formatLength(study.tolerated, unitOf(study))} beyond it are tolerated</>
        )}
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

/** What one wants to know first, in three numbers. */
function Numbers({ study }: { study: Study }) {
  const { pairs, left_out } = study;
  const of = (...which: Risk[]) => pairs.filter((_, i) => which.includes(riskOf(study, i))).length;
  const simple = pairs.filter(({ needs }) => needs === "sphere" || needs === "outer capsule").length,
    within = of("comes within"),
    unknown = of("not known", "open");
  return (
    <ul class="numbers">
      <li>
        <b>
          {grouped(simple)} <span class="soft">of {grouped(pairs.length)}</span>
        </b>
        pairs need only spheres or capsules: these were right in every configuration
      </li>
      <li>
        <b class={within > 0 ? "bad" : "ok"}>{grouped(within)}</b>
        {within === 1 ? "pair comes" : "pairs come"} within the clearance
      </li>
      <li>
        <b class={unknown + left_out.length > 0 ? "warn" : "ok"}>{grouped(unknown)}</b>
        pairs not known or open
        {left_out.length > 0 && <span class="soft">; some shapes were not tested</span>}
      </li>
    </ul>
  );
}

function Recommendation({ study }: { study: Study }) {
  const { words } = study,
    checked = study.pairs.length > 0;
  const against = words.cost.split("; ");
  return (
    <Section id="recommendation" title={checked ? "Recommendation" : "Nothing to check"}>
      {checked && <Numbers study={study} />}
      {checked && <p>{asSentence(`${words.recommended}: ${against[0]}`)}</p>}
      <ul class="said">
        {words.remarks.map((text) => (
          <li class={text.startsWith("NOT ") ? "bad" : ""} key={text}>
            {asSentence(text)}
          </li>
        ))}
        {against.slice(1).map((text) => (
          <li key={text}>{asSentence(text)}</li>
        ))}
        {words.forgiven && <li>{asSentence(words.forgiven)}</li>}
        {checked && <li>{asSentence(words.enough)}</li>}
        {words.capsules && <li class={study.models[1]!.wrong > 0 ? "bad" : "ok"}>{asSentence(words.capsules)}</li>}
        <Lines lines={words.rounding.map(asSentence)} shown={2} />
        {words.closest && <li>{asSentence(words.closest)}</li>}
        {words.verified && <li class={/ 0 wrong/.test(words.verified) ? "ok" : "bad"}>{asSentence(words.verified)}</li>}
        {study.asked_referee > 0 && (
          <li>
            {plural(study.asked_referee, "sample")} went to the referee. It could not prove {study.undecided} of them;
            these count as within the clearance.
          </li>
        )}
      </ul>
      <ul class="said soft">
        <li>
          {asSentence(words.counts)}; {words.pairs}
        </li>
        {words.configurations && <li>{asSentence(words.configurations)}</li>}
        {words.left_out.map((text) => (
          <li class="warn" key={text}>
            Not tested: <LongList text={text} />
          </li>
        ))}
        <Lines lines={study.notes} />
      </ul>
    </Section>
  );
}

function Cost({ study }: { study: Study }) {
  const draw = useCallback((width: number) => costPlotOfStudy(study, { width, theme: screen }), [study]);
  const unit = unitOf(study),
    heads = ["model", "settles", "time alone", "suffices", "wrong", "in pairs", "false alarm", "missed"];
  const ns = study.ns_per_configuration,
    wrong = study.pairs.reduce((n, pair) => n + pair.recommended_wrong, 0),
    length = (x: number) => (x > 0 ? short(x) : "\u2013"),
    count = (n: number) => (n > 0 ? grouped(n) : "\u2013");
  return (
    <Section
      id="cost"
      title="Cost and wrong answers"
      lead={
        "Each point is one model, tested alone on every pair in every sampled configuration. Points to the left are " +
        "cheaper. On the lowest line no answer is wrong. A sphere or an outer capsule alone can only raise false " +
        "alarms, and an inner capsule alone can only miss contacts."
      }>
      <div class="cost">
        <Figure draw={draw} height={340} label="Wrong answers against time per configuration, one point per model" />
        <div class="scroll">
          <table class="plain">
            <thead>
              <tr>
                {heads.map((head) => (
                  <th
                    scope="col"
                    class={head === "model" ? "" : "n"}
                    title={aboutScene(head)}
                    key={head}>
                    {unit && ["false alarm", "missed"].includes(head) ? `${head} [${unit}]` : head}
                  </th>
                ))}
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
            The times are for one configuration with all its pairs. In addition, moving the bodies takes{" "}
            {time(ns.kinematics)}, and making their models {time(ns.models)}.
          </p>
        </div>
      </div>
    </Section>
  );
}

export function StudyPage({ study }: { study: Study }) {
  const [asked, ask] = useState<Proof | null>(null); // whose configuration is to be shown
  const show = useCallback((proof: Proof) => {
    ask({ ...proof }); // another one each time, so that a second press counts
    document.getElementById("scene")?.scrollIntoView();
  }, []);
  return (
    <>
      <Header study={study} />
      <main class="overview">
        <Recommendation study={study} />
        {study.kept.length > 0 && study.bodies.length > 0 && (
          <SceneSection study={study} asked={asked} showProof={show} />
        )}
        <Proofs study={study} show={show} />
        {study.pairs.length > 0 && <Cost study={study} />}
        <Words entries={sceneGlossaryEntries()} />
        <footer class="soft">
          <p>
            One file. It uses no network. All of its data:{" "}
            <code>./daylight scene {shellQuoted(study.file)} --json FILE</code>
          </p>
        </footer>
      </main>
    </>
  );
}
