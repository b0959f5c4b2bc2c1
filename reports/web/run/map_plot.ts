// SPDX-License-Identifier: MIT
// The failure map of a method: a cell for each place in the space of pairs.
import * as Plot from "@observablehq/plot";
import { common, tips, type Options, type Theme } from "../parts/plot.ts";
import { grouped, percent } from "../parts/words.ts";
import type { FailureMap } from "./data.ts";
import { heatStep } from "./heat.ts";
import { library } from "./words.ts";

export type Wrongness = "all" | "wrong_disjoint" | "wrong_intersecting" | "failed" | "undecided" | "declined";
type Cell = FailureMap["cells"][number];
export const wrongOf = (c: Cell, what: Wrongness) =>
  what === "all" ? c.wrong_disjoint + c.wrong_intersecting + c.failed : (c[what] ?? 0);
/** Of those, how many the claim allows. */
export function withinOf(c: Cell, what: Wrongness) {
  const disjoint = c.within_disjoint ?? 0,
    intersecting = c.within_intersecting ?? 0;
  return what === "all"
    ? disjoint + intersecting
    : what === "wrong_disjoint"
      ? disjoint
      : what === "wrong_intersecting"
        ? intersecting
        : 0;
}
/** The map of a method with those cells alone in which no other library is wrong beyond its claim. */
export function onlyHere(map: FailureMap, all: FailureMap[]): FailureMap {
  const beyond = (c: Cell) => wrongOf(c, "all") > withinOf(c, "all"),
    key = (c: Cell) => `${c.x} ${c.y}`;
  const others = all.filter((m) => m.plane === map.plane && library(m.method) !== library(map.method));
  const shared = new Set(others.flatMap((m) => m.cells.filter(beyond).map(key)));
  return { ...map, cells: map.cells.filter((c) => !beyond(c) || !shared.has(key(c))) };
}
/** As the table of methods against families has it: what is beyond a claim before what is within. The fill is the
 *  share, the edge what it is of; a cell without such answers has no edge. */
export function mapColours(c: Cell, what: Wrongness, theme: Theme): { fill: string; edge: string | null } {
  const wrong = wrongOf(c, what),
    within = withinOf(c, what);
  const [shades, count] =
    what === "undecided" || what === "declined"
      ? [theme.unanswered, wrong]
      : wrong > within
        ? [theme.heat, wrong - within]
        : [theme.within, within];
  return count === 0
    ? { fill: theme.clean, edge: null }
    : { fill: shades[heatStep(count / c.asked) - 1]!, edge: shades.at(-1)! };
}
const describeCell = (map: FailureMap, c: Cell) =>
  [
    `${map.x.title}: ${map.x.labels[c.x] ?? c.x}`,
    `${map.y.title}: ${map.y.labels[c.y] ?? c.y}`,
    `asked ${grouped(c.asked)}`,
    ...(
      [
        ["wrong_disjoint", "wrongly reported disjoint"],
        ["wrong_intersecting", "wrongly reported intersecting"],
        ["failed", "failed"],
        ["undecided", "undecided"],
        ["declined", "declined"],
      ] as const
    )
      .map(([k, words]) => [words, wrongOf(c, k), withinOf(c, k)] as const)
      .filter(([, count]) => count > 0)
      .map(
        ([words, count, within]) =>
          `${words} ${grouped(count)} (${percent(count, c.asked)})` +
          (within > 0 ? `, ${grouped(within)} of them within its claim` : ""),
      ),
    ...(c.finding !== undefined ? ["click for a case of this cell"] : []),
  ].join("\n");

export function mapPlot(
  map: FailureMap,
  what: Wrongness,
  o: Options & { linkFinding?: (id: number) => string },
): Element {
  const coloursOf = (c: Cell) => mapColours(c, what, o.theme);
  const visited = map.cells.filter((c) => c.asked > 0);
  const seen = new Set(visited.map((c) => `${c.x} ${c.y}`));
  const blank = map.x.labels
    .flatMap((_, x) => map.y.labels.map((_, y) => ({ x, y }) as Cell))
    .filter((c) => !seen.has(`${c.x} ${c.y}`));
  const n = { x: map.x.labels.length, y: map.y.labels.length };
  const at = { x: (c: Cell) => c.x, y: (c: Cell) => c.y };
  const words = (c: Cell) => describeCell(map, c);
  const letters = Math.max(...map.x.labels.map((label) => label.length));
  const skip = Math.max(1, Math.ceil((n.x * (7 * letters + 6)) / (o.width - 104)));
  return Plot.plot(
    common(o, 40 + n.y * 17 + 46, {
      title: undefined,
      marginLeft: 74,
      marginBottom: 44,
      x: {
        type: "band",
        domain: Array.from({ length: n.x }, (_, i) => i),
        tickFormat: (i: number) => (i % skip === 0 ? (map.x.labels[i] ?? "") : ""),
        label: `${map.x.title} \u2192`,
        padding: 0.06,
        tickSize: 0,
      },
      y: {
        type: "band",
        domain: Array.from({ length: n.y }, (_, i) => n.y - 1 - i),
        tickFormat: (i: number) => map.y.labels[i] ?? "",
        label: `\u2191 ${map.y.title}`,
        padding: 0.06,
        tickSize: 0,
      },
      marks: [
        Plot.frame({ stroke: o.theme.line }),
        ...[true, false].map((isWrong) =>
          Plot.cell(
            visited.filter((c) => (coloursOf(c).edge !== null) === isWrong),
            {
              ...at,
              fill: (c: Cell) => coloursOf(c).fill,
              stroke: (c: Cell) => coloursOf(c).edge ?? o.theme.line,
              strokeWidth: isWrong ? 1 : 0.5,
              inset: 0.5,
              ...(isWrong ? {} : { className: "ground" }),
              ...(o.linkFinding
                ? { href: (c: Cell) => (c.finding !== undefined ? o.linkFinding!(c.finding) : null), target: "_self" }
                : {}),
              ariaLabel: words,
            },
          ),
        ),
        Plot.text(blank, { ...at, text: () => "\u2215", fill: o.theme.soft, fontSize: 8 }),
        Plot.dot(
          visited.filter((c) => wrongOf(c, what) > 0 && c.finding !== undefined),
          { ...at, r: 1.3, fill: o.theme.fg, pointerEvents: "none" },
        ),
        ...tips(visited, o, words, { ...at, maxRadius: 14 }),
      ],
    }),
  );
}
