// SPDX-License-Identifier: MIT
// The causes as rows: picture, sentence, runs.
import { grouped, safe, short } from "../parts/words.ts";
import type { Cause, Night } from "./data.ts";
import { Heads } from "./elements.tsx";
import type { CauseRow } from "./filter.ts";
import { about } from "./glossary.ts";
import { Thumbnail } from "./pair_view.tsx";
import { sentenceOf } from "./sentence.ts";
import { severityLabels, standingLabel } from "./words.ts";

export const causeAddress = (key: string) => `#/bucket/${key.split("/").map(encodeURIComponent).join("/")}`;

/** A run of its nights with the day on which it began. */
export const formatRun = ({ nights }: Cause, run: string) => {
  const night = nights.find((n) => n.run === run);
  return night ? `${safe(night.started.slice(0, 10))} (${safe(run)})` : safe(run);
};

/** Wrong pairs run by run: a bar a run, hollow if it has none. */
function Sparkline({ nights }: { nights: Night[] }) {
  const [bar, tall] = [5, 18],
    shown = nights.slice(-16),
    most = Math.max(...shown.map((n) => n.per_million[0])) || 1;
  return (
    <svg class="spark" width={bar * shown.length} height={tall} role="img" aria-label="Wrong pairs, run by run">
      <title>{shown.map((n) => `${safe(n.run)}: ${grouped(n.count)}`).join("\n")}</title>
      {shown.map((n, i) => {
        const high = Math.max(2, (n.per_million[0] / most) * tall);
        const kind = n.count === 0 ? "none" : i === shown.length - 1 ? "this" : "";
        return <rect class={kind} x={i * bar} y={tall - high} width={bar - 1.5} height={high} key={i} />;
      })}
    </svg>
  );
}

function Row({ b }: { b: Cause }) {
  const severity = severityLabels[b.severity] ?? safe(b.severity);
  return (
    <tr class={b.suppressed ? "suppressed" : ""}>
      <td class="wrap">
        <div class="cause">
          <Thumbnail shown={b.simplest} />
          <div>
            <a href={causeAddress(b.key)}>{safe(b.key)}</a>{" "}
            <span class={`tag ${b.severity === "contract" ? "bad" : "soft"}`} title={about(severity)}>
              {severity}
            </span>
            {b.suppressed && (
              <span class="tag" title={safe(b.suppressed.reason)}>
                suppressed until {safe(b.suppressed.expires)}
              </span>
            )}
            <div>{safe(sentenceOf(b))}.</div>
            <div class="soft">{safe(b.cause)}</div>
          </div>
        </div>
      </td>
      <td class="n">{b.margin ? short(b.margin[1]) : "\u2013"}</td>
      <td class="n">{grouped(b.count)}</td>
      <td title={about(b.standing ?? "")}>
        {standingLabel(b.standing)}
        {b.nights.length > 1 && <Sparkline nights={b.nights} />}
      </td>
      <td>{formatRun(b, b.first_seen)}</td>
    </tr>
  );
}

export const Causes = ({ causes }: { causes: CauseRow[] }) => (
  <div class="scroll">
    <table class="plain causes">
      <Heads of={["cause", "n:largest margin", "n:findings", "since earlier runs", "first seen"]} />
      <tbody>
        {causes.map(({ b }) => (
          <Row b={b} key={b.key} />
        ))}
      </tbody>
    </table>
  </div>
);
