// SPDX-License-Identifier: MIT
// The page of a run: an overview in sections, and a view of one cause or finding by the part of the address after '#'.
import { useEffect, useLayoutEffect, useRef, useState } from "preact/hooks";
import { grouped, safe, seconds, shellQuoted } from "../parts/words.ts";
import { Calibration } from "./calibration.tsx";
import { CauseView, FindingView } from "./cause.tsx";
import type { Report } from "./data.ts";
import { Findings } from "./findings.tsx";
import { glossary } from "./glossary.ts";
import { Maps } from "./maps.tsx";
import { Speed } from "./speed.tsx";
import { Stability } from "./stability.tsx";
import { Summary } from "./summary.tsx";

const sections = [
  ["new", "New in this run"],
  ["findings", "Causes and findings"],
  ["charts", "Charts"],
] as const;

const Header = ({ report: { run } }: { report: Report }) => (
  <header>
    <h1>
      <a href="#/new">daylight</a> <span class="soft">answers about two solids, checked against proofs</span>
    </h1>
    <nav aria-label="Sections">
      {sections.map(([key, title]) => (
        <a href={`#/${key}`} key={key}>
          {title}
        </a>
      ))}
    </nav>
    <p class="run">
      <b>{safe(run.id)}</b> · seed {safe(run.seed)} · {grouped(run.pairs)} pairs · {seconds(run.seconds)} · begun{" "}
      {safe(run.started)} ·{" "}
      <span class={run.status === "complete" ? "" : "warn"}>{safe(run.status) || "unfinished"}</span>
    </p>
  </header>
);

/** The commands that add the charts that a run has no data for. */
function NotInThisRun({ report: { run, maps, speed, paths } }: { report: Report }) {
  if ([maps, speed, paths].every((data) => data.length > 0)) return null;
  return (
    <p class="missing">
      This run has no data for some charts. These commands add them:{" "}
      <code>
        ./daylight bench --curves --json bench.json && ./daylight chart {shellQuoted(run.folder)} --bench bench.json
        --stability
      </code>
    </p>
  );
}

/** The glossary, folded. Its texts are also the tooltips of the page. */
const Words = () => (
  <details id="words">
    <summary>Glossary: {Object.keys(glossary).length} terms</summary>
    <dl class="words">
      {Object.entries(glossary).map(([word, meaning]) => (
        <div key={word}>
          <dt>{word}</dt>
          <dd>{meaning}</dd>
        </div>
      ))}
    </dl>
  </details>
);

const Footer = ({ report: { run } }: { report: Report }) => (
  <footer class="soft">
    <p>{safe(run.build)}</p>
    <p>One file. It uses no network.</p>
  </footer>
);

/** "#/cause/a%2Fb/c" names "a/b/c" in the view "cause". */
function readHash(hash: string) {
  const [path = "", query = ""] = hash.replace(/^#\/?/, "").split("?"),
    [view = "", ...rest] = path.split("/");
  let named = rest.join("/");
  try {
    named = decodeURIComponent(named);
  } catch {} // as it is
  return { view, named, query, isDetail: view === "cause" || view === "finding" };
}

export function RunPage({ report }: { report: Report }) {
  const [hash, set] = useState(location.hash);
  const left = useRef<HTMLElement | null>(null); // the link of the overview that led to a cause or finding
  useLayoutEffect(() => {
    const changed = ({ oldURL }: HashChangeEvent) => {
      if (!readHash(new URL(oldURL).hash).isDetail) left.current = document.activeElement as HTMLElement;
      set(location.hash);
    };
    addEventListener("hashchange", changed);
    return () => removeEventListener("hashchange", changed);
  }, []);
  const { view, named, query, isDetail } = readHash(hash),
    overview = useRef(""); // its query, while a cause or finding is shown
  if (!isDetail) overview.current = query;

  const wasDetail = useRef(false);
  useEffect(() => {
    const isIn = (place: string) => Boolean(document.activeElement?.closest(place));
    if (isDetail) {
      scrollTo(0, 0);
      document.querySelector<HTMLElement>("main.detail h2")?.focus({ preventScroll: true });
    } else if (wasDetail.current && !isIn("header")) left.current?.focus();
    else if (!isIn(".filters")) document.getElementById(view)?.scrollIntoView();
    wasDetail.current = isDetail;
  }, [hash]);

  return (
    <>
      <Header report={report} />
      {isDetail && (
        <main class="detail">
          {view === "cause" ? (
            <CauseView report={report} named={named} key={named} />
          ) : (
            <FindingView report={report} named={named} key={named} />
          )}
        </main>
      )}
      <main class="overview" hidden={isDetail}>
        <Summary report={report} />
        <Findings report={report} query={overview.current} />
        <div id="charts">
          <Speed report={report} />
          <Maps report={report} />
          <Calibration report={report} />
          <Stability report={report} />
          <NotInThisRun report={report} />
        </div>
        <Words />
        <Footer report={report} />
      </main>
    </>
  );
}
