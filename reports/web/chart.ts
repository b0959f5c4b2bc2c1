// SPDX-License-Identifier: MIT
// The plots as files for a paper or a README; and what else of the page chart.mjs gives to Node.
import { paper, type Options } from "./parts/plot.ts";
import { grouped } from "./parts/words.ts";
import { familiesPlot } from "./run/families_plot.ts";
import { mapPlot, onlyHere } from "./run/map_plot.ts";
import { calibrationPlot } from "./run/margin_plots.ts";
import { plainDocument } from "./run/plain_document.ts";
import { claimedDigits, expand, inRunOrder, type FullReport } from "./run/report.ts";
import { firstOfEach, seriesOf } from "./run/series.ts";
import { pareto, speedPlot } from "./run/speed_plot.ts";
import { tracePlot } from "./run/stability_plots.ts";

export { exact, floorSqrt, prove } from "./parts/prove.ts";
export { causesOf, filterOf, filtered, isOrdinary, queryOf, rowsOf } from "./run/filter.ts";
export { glossary } from "./run/glossary.ts";
export { sentenceOf } from "./run/sentence.ts";
export { full, shellQuoted } from "./parts/words.ts";
export { expand, onlyHere, pareto, plainDocument };

/** Points of a file's width; text is 11 of them high. */
const width = 760;

interface Key {
  name: string;
  colour: string;
}

const escaped = (text: string) =>
  text.replaceAll("&", "&amp;").replaceAll("<", "&lt;").replaceAll(">", "&gt;").replaceAll('"', "&quot;");

/** A plot in a file of its own: white behind it, a title, and who has which colour below it. */
function framed(plot: Element, title: string, keys: Key[], notes: string[] = []): string {
  const [w, h] = ["width", "height"].map((name) => Number(plot.getAttribute(name)));
  const columns = Math.max(1, Math.floor(w! / 150)),
    rows = Math.ceil(keys.length / columns);
  const head = 26,
    height = h! + head + (rows + notes.length) * 15 + (rows + notes.length > 0 ? 8 : 0);
  const inner = plot.innerHTML.replace(/<style>[^]*?<\/style>/, "");
  const legend = keys
    .map(({ name, colour }, i) => {
      const x = 12 + (i % columns) * 150,
        y = h! + head + 6 + Math.floor(i / columns) * 15;
      const square = `<rect x="${x}" y="${y}" width="10" height="10" fill="${colour}"/>`;
      return `${square}<text x="${x + 15}" y="${y + 9}">${escaped(name)}</text>`;
    })
    .join("");
  const told = notes.map(
    (note, i) => `<text x="12" y="${h! + head + 12 + 15 * i}" fill="${paper.soft}">${escaped(note)}</text>`,
  );
  return (
    `<?xml version="1.0" encoding="UTF-8"?>\n<svg xmlns="http://www.w3.org/2000/svg" ` +
    `xmlns:xlink="http://www.w3.org/1999/xlink" width="${w}" height="${height}" viewBox="0 0 ${w} ${height}" ` +
    `font-family="sans-serif" font-size="11" fill="${paper.fg}">` +
    `<rect width="100%" height="100%" fill="${paper.bg}"/><text x="12" y="17" font-size="13" ` +
    `font-weight="bold">${escaped(title)}</text><g transform="translate(0,${head})" text-anchor="middle" ` +
    `color="${paper.fg}" fill="currentColor">${inner}</g>${legend}${told.join("")}</svg>\n`
  );
}

const sure = (name: string) => name.replace(/[^A-Za-z0-9_.-]+/g, "_");

/** The plots that the report has data for, speed of all families and the random ones, maps of a method a library:
 * file name (without ending) and SVG. */
export function charts(report: FullReport, document: Document): Map<string, string> {
  const files = new Map<string, string>();
  const o: Options = { width, theme: paper, document };
  const series = (methods: string[]): Key[] =>
    methods.map((method) => ({ name: method, colour: seriesOf(methods, paper).colour({ method }) }));
  const shares = ["<1e-4", "1e-4 on", "1e-3 on", "1e-2 on", "0.1 on"];
  const heat: Key[] = [
    ...shares.map((name, i) => ({ name, colour: paper.heat[i]! })),
    { name: "within the claim", colour: paper.within[2]! },
  ];

  const methods = report.methods.map((m) => m.name).filter((name) => report.tallies.some((t) => t.method === name));
  if (methods.length > 0)
    files.set(
      "families",
      framed(
        familiesPlot(
          report.tallies,
          methods,
          report.families.map((f) => f.name),
          o,
        ),
        `Wrong beyond the claim or failed, ${grouped(report.run.pairs)} pairs`,
        [
          ...heat,
          { name: "undecided", colour: paper.unanswered[2]! },
          { name: "neither", colour: paper.clean },
        ],
      ),
    );
  for (const query of new Set(report.speed.map((p) => p.query)))
    for (const family of ["all", "random"]) {
      const points = report.speed.filter((p) => p.query === query && p.family === family);
      if (points.length === 0) continue;
      const name = sure(`${query}-${family}`);
      if (points.some((p) => p.digits !== null))
        files.set(
          `speed-${name}`,
          framed(
            speedPlot(points, o, claimedDigits(report)),
            `Speed against accuracy: ${query}, ${family === "all" ? "all families" : family}`,
            [],
            [
              "Filled: the accuracy shown with 95 % confidence. Hollow: the accuracy observed. Thin line: settings.",
              `${grouped(Math.max(...points.map((p) => p.asked)))} pairs at most for each method` +
                `${report.speed_on ? ` on ${report.speed_on}` : ""}.`,
            ],
          ),
        );
    }
  const mapped = firstOfEach(inRunOrder(report, report.maps));
  for (const map of report.maps.filter((m) => mapped.includes(m.method)))
    files.set(
      sure(`map-${map.plane}-${map.method}`),
      framed(
        mapPlot(map, "all", { ...o, width: width * 0.7 }),
        `${map.method}: share wrong beyond the claim or failed, else within it`,
        [...heat, { name: "none wrong", colour: paper.clean }],
      ),
    );
  const honest = firstOfEach(inRunOrder(report, report.honesty));
  const curves = honest.flatMap((m) => report.honesty.filter((h) => h.method === m && h.family === null));
  if (curves.length > 0)
    files.set(
      "honesty",
      framed(calibrationPlot(curves, o), "Share of wrong answers against margin", series(curves.map((h) => h.method))),
    );
  for (const path of report.paths)
    if (path.trace && path.trace.length > 0)
      files.set(
        sure(`path-${path.path}-${path.method}`),
        framed(tracePlot(path, o), `${path.method}, ${path.path}`, []),
      );
  return files;
}
