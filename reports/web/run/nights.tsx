// SPDX-License-Identifier: MIT
// The rate of a cause run by run, and this run compared with an earlier one.
import { useState } from "preact/hooks";
import { Select } from "../parts/elements.tsx";
import { grouped, safe, short } from "../parts/words.ts";
import type { Night } from "./data.ts";
import { Heads } from "./elements.tsx";
import { about } from "./glossary.ts";
import { sameRateProbability } from "./rates.ts";

const high = 96,
  left = 46,
  floor = high + 8,
  narrowest = 14;

const formatRate = ({ per_million: [rate, low, up] }: Night) => `${short(rate)} (${short(low)} to ${short(up)})`;
const describeRun = (n: Night) =>
  `${safe(n.run)}\n${grouped(n.count)} of ${grouped(n.asked)} pairs wrong\n${formatRate(n)} per million`;

/** One mark a night: the rate, and a line from its lower to its upper bound. */
function Chart({ nights }: { nights: Night[] }) {
  const most = Math.max(...nights.map((n) => n.per_million[2])) || 1;
  const step = Math.min(80, Math.max(narrowest, 320 / nights.length));
  const y = (rate: number) => floor - (rate / most) * high,
    x = (i: number) => left + step * (i + 0.5),
    width = Math.max(200, left + step * nights.length + 6);
  return (
    <div class="scroll">
      <svg
        class="nights"
        width={width}
        height={floor + 18}
        viewBox={`0 0 ${width} ${floor + 18}`}
        role="img"
        aria-label="Wrong pairs per million, run by run">
        {[0, most].map((rate) => (
          <g key={rate}>
            <line class="rule" x1={left} x2={width} y1={y(rate)} y2={y(rate)} />
            <text x={left - 5} y={y(rate) + 4} text-anchor="end">
              {short(rate, 2)}
            </text>
          </g>
        ))}
        {nights.map((n, i) => {
          const [rate, low, up] = n.per_million;
          return (
            <g class={i === nights.length - 1 ? "night this" : "night"} key={`${n.run} ${i}`}>
              <title>{describeRun(n)}</title>
              <rect class="reach" x={x(i) - step / 2} y={0} width={step} height={floor + 18} />
              <line x1={x(i)} x2={x(i)} y1={y(low)} y2={y(up)} />
              <circle class={n.count === 0 ? "none" : ""} cx={x(i)} cy={y(rate)} r={4} />
            </g>
          );
        })}
        {nights.length > 1 && (
          <text x={left} y={floor + 15} text-anchor="start">
            {safe(nights[0]!.started.slice(0, 10))}
          </text>
        )}
        <text x={width} y={floor + 15} text-anchor="end">
          {safe(nights.at(-1)!.started.slice(0, 10))}
        </text>
      </svg>
    </div>
  );
}

/** The same in the height of a line: a bar a run, hollow if it has none. */
export function Sparkline({ nights }: { nights: Night[] }) {
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

function Against({ earlier, now }: { earlier: Night[]; now: Night }) {
  const [at, choose] = useState(earlier.length - 1);
  const then = earlier[at]!,
    p = sameRateProbability(then.count, then.asked, now.count, now.asked);
  return (
    <>
      <p class="tools">
        <Select
          label="Compared with"
          value={String(at)}
          onChange={(value) => choose(Number(value))}
          options={earlier.map((n, i) => [String(i), `${n.started.slice(0, 10)}, ${safe(n.run)}`] as const).reverse()}
        />
        <span title={about("probability of one rate")}>
          probability of such different counts at the same rate:{" "}
          <b class="same-rate">{p === null ? "\u2013" : short(p)}</b>
        </span>
      </p>
      <div class="scroll">
        <table class="plain against">
          <Heads of={["run", "begun", "n:wrong pairs", "n:asked", "n:per million"]} />
          <tbody>
            {[then, now].map((n, i) => (
              <tr key={i}>
                <td>
                  {safe(n.run)}
                  {i === 1 && <span class="soft"> this run</span>}
                </td>
                <td>{safe(n.started.slice(0, 16).replace("T", " "))}</td>
                <td class="n">{grouped(n.count)}</td>
                <td class="n">{grouped(n.asked)}</td>
                <td class="n">{formatRate(n)}</td>
              </tr>
            ))}
          </tbody>
        </table>
      </div>
    </>
  );
}

export function Nights({ nights }: { nights: Night[] }) {
  return (
    <section class="history">
      <h3>Run by run</h3>
      <p class="soft">
        Wrong pairs per million pairs asked. The line is the 95 % confidence interval. The last mark is this run.
      </p>
      <Chart nights={nights} />
      {nights.length > 1 && <Against earlier={nights.slice(0, -1)} now={nights.at(-1)!} />}
    </section>
  );
}
