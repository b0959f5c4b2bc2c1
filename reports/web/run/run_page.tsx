// SPDX-License-Identifier: MIT
// The page of a run: an overview in sections, and a view of one cause or finding by the part of the address after '#'.
import { useEffect, useMemo, useRef } from "preact/hooks";
import { grouped, safe, seconds } from "../parts/words.ts";
import { useAddress } from "./address.ts";
import { Calibration } from "./calibration.tsx";
import { CauseView } from "./cause.tsx";
import { NotInThisRun } from "./elements.tsx";
import { FindingView } from "./finding.tsx";
import { Findings } from "./findings.tsx";
import { glossary } from "./glossary.ts";
import { Maps } from "./maps.tsx";
import type { FullReport } from "./report.ts";
import { Speed } from "./speed.tsx";
import { Stability } from "./stability.tsx";
import { Methods, Summary } from "./summary.tsx";

const sections = [
  ["new", "What is new"],
  ["findings", "All findings"],
  ["charts", "Charts"],
] as const;

function Header({ report: { run } }: { report: FullReport }) {
  return (
    <header>
      <h1>
        <a href="#/new">daylight</a> <span class="soft">answers about two cylinders, checked against proofs</span>
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

function Footer({ report: { run } }: { report: FullReport }) {
  return (
    <footer class="soft">
      <p>{safe(run.build)}</p>
      {run.command && (
        <p>
          The same run again: <code>{safe(run.command)}</code>
        </p>
      )}
      <p>One file. It uses no network.</p>
    </footer>
  );
}

const isDetail = (hash: string) => /^#\/(bucket|finding)\//.test(hash);

export function RunPage({ report }: { report: FullReport }) {
  const [{ parts, query, from }, remember] = useAddress();
  const [view = "", ...rest] = parts,
    named = rest.join("/"),
    detail = view === "bucket" || view === "finding";
  const scrolled = useRef(0); // where the overview was left
  const finding = useMemo(() => new Map(report.findings.map((f) => [f.id, f])), [report]);
  const cause = useMemo(() => new Map(report.buckets.map((b) => [b.key, b])), [report]);

  useEffect(() => {
    const note = () => {
      if (!isDetail(location.hash)) scrolled.current = scrollY;
    };
    addEventListener("scroll", note, { passive: true });
    return () => removeEventListener("scroll", note);
  }, []);
  useEffect(() => {
    if (from === null) return;
    if (detail) {
      scrollTo(0, 0);
      document.querySelector<HTMLElement>("main.detail h2")?.focus({ preventScroll: true });
    } else if (isDetail(from) && view !== "charts") {
      const left = [...document.querySelectorAll<HTMLElement>("main.overview a")];
      left.find((a) => a.getAttribute("href") === from)?.focus({ preventScroll: true });
      scrollTo(0, scrolled.current);
    } else document.getElementById(view)?.scrollIntoView();
  }, [parts, from]);

  return (
    <>
      <Header report={report} />
      {detail && (
        <main class="detail">
          {view === "bucket" ? (
            <CauseView report={report} cause={cause.get(named)} finding={finding} named={named} key={named} />
          ) : (
            <FindingView report={report} finding={finding.get(Number(named))} named={named} key={named} />
          )}
        </main>
      )}
      <main class="overview" hidden={detail}>
        <Summary report={report} />
        <Findings report={report} query={query} remember={remember} />
        <div id="charts">
          <Speed report={report} />
          <Maps report={report} />
          <Calibration report={report} />
          <Stability report={report} />
          <Methods report={report} />
          <NotInThisRun report={report} />
        </div>
        <Words />
        <Footer report={report} />
      </main>
    </>
  );
}
