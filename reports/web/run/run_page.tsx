// SPDX-License-Identifier: MIT
// The page of a run: an overview in sections, and a view of one cause or finding by the part of the address after '#'.
import { useEffect, useMemo, useRef, useState } from "preact/hooks";
import { grouped, safe, seconds } from "../parts/words.ts";
import { useAddress, type Address } from "./address.ts";
import { Calibration } from "./calibration.tsx";
import { CauseView } from "./cause.tsx";
import { NotInThisRun } from "./elements.tsx";
import { FindingView } from "./finding.tsx";
import { Findings } from "./findings.tsx";
import { arrive, skip } from "./focus.ts";
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

function Header({ report }: { report: FullReport }) {
  const { run } = report;
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
function Words() {
  const entries = Object.entries(glossary).sort(([x], [y]) => (x < y ? -1 : 1));
  return (
    <details id="words">
      <summary>Glossary: {entries.length} terms</summary>
      <dl class="words">
        {entries.map(([word, meaning]) => (
          <div key={word}>
            <dt>{word}</dt>
            <dd>{meaning}</dd>
          </div>
        ))}
      </dl>
    </details>
  );
}

/** Everything below the summary. */
function Rest({ report, address }: { report: FullReport; address: Address }) {
  return (
    <>
      <Findings report={report} address={address} />
      <div id="charts">
        <Speed report={report} />
        <Maps report={report} />
        <Calibration report={report} />
        <Stability report={report} />
        <Methods report={report} />
        <NotInThisRun report={report} />
      </div>
      <Words />
      <footer class="soft">
        <p>{safe(report.run.build)}</p>
        {report.run.command && (
          <p>
            The same run again: <code>{safe(report.run.command)}</code>
          </p>
        )}
        <p>
          One file. It uses no network.{" "}
          <button type="button" class="link" onClick={() => print()}>
            Print
          </button>
        </p>
      </footer>
    </>
  );
}

/** Whether the rest of the page is drawn too: once the summary is seen, or at once if the address asks for more. */
function useWhole(asksForMore: boolean): boolean {
  const [isWhole, draw] = useState(asksForMore);
  useEffect(() => {
    if (!isWhole) requestAnimationFrame(() => setTimeout(() => draw(true)));
  }, []);
  useEffect(() => {
    document.getElementById("page")!.dataset.whole = String(isWhole);
  }, [isWhole]);
  return isWhole;
}

export function RunPage({ report }: { report: FullReport }) {
  const address = useAddress(),
    isWhole = useWhole(address.parts.some((part) => part !== ""));
  const [view = ""] = address.parts;
  const { detail } = address;
  const scrolled = useRef(0);
  const wasDetail = useRef(detail);
  const finding = useMemo(() => new Map((isWhole ? report.findings : []).map((f) => [f.id, f])), [report, isWhole]);
  const cause = useMemo(() => new Map(report.buckets.map((b) => [b.key, b])), [report]);

  useEffect(() => {
    const remember = () => {
      if (!wasDetail.current) scrolled.current = scrollY;
    };
    addEventListener("scroll", remember, { passive: true });
    return () => removeEventListener("scroll", remember);
  }, []);
  useEffect(() => {
    if (detail && !address.again) history.replaceState({ known: true }, "");
    arrive(address, wasDetail.current, scrolled.current);
    wasDetail.current = detail;
  }, [address]);

  const named = address.parts.slice(1).join("/");
  return (
    <>
      <a class="skip" href="#/findings" onClick={skip}>
        Skip to {detail ? "the case" : "the findings"}
      </a>
      <Header report={report} />
      {detail && (
        <main class="detail">
          {view === "bucket" && (
            <CauseView report={report} cause={cause.get(named)} finding={finding} named={named} key={named} />
          )}
          {view === "finding" && (
            <FindingView report={report} finding={finding.get(Number(named))} named={named} key={named} />
          )}
        </main>
      )}
      <main class="overview" hidden={detail}>
        <Summary report={report} />
        {isWhole && <Rest report={report} address={address} />}
      </main>
    </>
  );
}
