// SPDX-License-Identifier: MIT
// Methods against families, for files: the page has a table.
import * as Plot from "@observablehq/plot";
import { common, type Options } from "../parts/plot.ts";
import type { Tally } from "./data.ts";
import { heatStep } from "./heat.ts";

export function familiesPlot(tallies: Tally[], methods: string[], families: string[], o: Options): Element {
  const rows = tallies.filter((t) => t.asked > 0 && methods.includes(t.method));
  const fill = (t: Tally) => {
    const bad = t.contract + t.failed;
    if (bad > 0) return o.theme.heat[heatStep(bad / t.asked) - 1]!;
    if (t.resolution > 0) return o.theme.within[heatStep(t.resolution / t.asked) - 1]!;
    return t.undecided > 0 ? o.theme.unanswered[heatStep(t.undecided / t.asked) - 1]! : o.theme.clean;
  };
  return Plot.plot(
    common(o, 150 + methods.length * 13, {
      marginLeft: 190,
      marginTop: 130,
      marginBottom: 8,
      x: {
        type: "band",
        domain: families,
        axis: "top",
        tickRotate: -60,
        label: null,
        tickFormat: (f: string) => f.replaceAll("_", " "),
        tickSize: 0,
        padding: 0.06,
      },
      y: { type: "band", domain: methods, label: null, tickSize: 0, padding: 0.08 },
      marks: [Plot.cell(rows, { x: "family", y: "method", fill })],
    }),
  );
}
