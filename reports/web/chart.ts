// SPDX-License-Identifier: MIT
// The plots as files for a paper or a README, and the parts of the page that chart.mjs gives to Node.
import { colours, shade, type Options } from "./parts/plot.ts";
import { grouped } from "./parts/words.ts";
import { calibrationPlot, colourOf, firstOfEach } from "./run/calibration.tsx";
import type { Report } from "./run/data.ts";
import { mapPlot } from "./run/maps.tsx";
import { claimedDigits } from "./run/report.ts";
import { questions, speedPlot } from "./run/speed.tsx";

export { full, shellQuoted } from "./parts/words.ts";
export { prove } from "./parts/prove.ts";
export { exact, floorSqrt } from "./parts/rational.ts";
export { chosen, rowsOf } from "./run/findings.tsx";
export { glossary } from "./run/glossary.ts";
export { expand } from "./run/report.ts";
export { pareto } from "./run/speed.tsx";
export { sentenceOf } from "./run/words.ts";

const escaped = (text: string) =>
  text.replaceAll("&", "&amp;").replaceAll("<", "&lt;").replaceAll(">", "&gt;").replaceAll('"', "&quot;");

/** A document for plots if there is no browser. It has as much as Observable Plot asks for, and its text as SVG. */
class PlainNode {
  parentNode: PlainNode | null = null;
  childNodes: PlainNode[] = [];
  attributes = new Map<string, string>();
  style = {}; // of the whole plot alone, whose own element is not kept
  /** A name of null is that of a text. */
  constructor(
    readonly ownerDocument: object,
    readonly namespaceURI: string | null,
    readonly tagName: string | null,
    private text = "",
  ) {}

  get children() {
    return this.childNodes.filter((n) => n.tagName !== null);
  }
  set textContent(text: string) {
    this.childNodes = [];
    this.append(text);
  }
  get outerHTML(): string {
    if (this.tagName === null) return escaped(this.text);
    const attributes = [...this.attributes].map(([name, value]) => ` ${name}="${escaped(value)}"`);
    return `<${this.tagName}${attributes.join("")}>${this.innerHTML}</${this.tagName}>`;
  }
  get innerHTML(): string {
    return this.childNodes.map((n) => n.outerHTML).join("");
  }

  getAttribute(name: string) {
    return this.attributes.get(name) ?? null;
  }
  hasAttribute(name: string) {
    return this.attributes.has(name);
  }
  setAttribute(name: string, value: unknown) {
    this.attributes.set(name, String(value));
  }
  removeAttribute(name: string) {
    this.attributes.delete(name);
  }
  insertBefore(node: PlainNode, next: PlainNode | null) {
    node.remove();
    this.childNodes.splice(next === null ? this.childNodes.length : this.childNodes.indexOf(next), 0, node);
    node.parentNode = this;
    return node;
  }
  appendChild(node: PlainNode) {
    return this.insertBefore(node, null);
  }
  append(...nodes: (PlainNode | string)[]) {
    const textOf = (text: string) => new PlainNode(this.ownerDocument, null, null, text);
    for (const n of nodes) this.appendChild(typeof n === "string" ? textOf(n) : n);
  }
  remove() {
    const all = this.parentNode?.childNodes;
    all?.splice(all.indexOf(this), 1);
  }
}

function plainDocument(): Document {
  const document: Record<string, unknown> = {
    createElementNS: (namespace: string, name: string) => new PlainNode(document, namespace, name),
    createElement: (name: string) => new PlainNode(document, null, name),
    createTextNode: (text: string) => new PlainNode(document, null, null, text),
  };
  document.documentElement = new PlainNode(document, null, "html");
  return document as unknown as Document;
}

/** Points of a file's width; text is 11 of them high. */
const width = 600;

interface Key {
  name: string;
  colour: string;
}

/** A plot in a file of its own: a title, and the colours with their names below. It is white, or dark if the reader
 *  prefers that. A program that knows no media query shows it white. */
function framed(plot: Element, title: string, keys: Key[], notes: string[] = []): string {
  const [w, h] = ["width", "height"].map((name) => Number(plot.getAttribute(name)));
  const columns = Math.max(1, Math.floor(w! / 150)),
    rows = Math.ceil(keys.length / columns);
  const head = 26,
    height = h! + head + (rows + notes.length) * 15 + (rows + notes.length > 0 ? 8 : 0);
  const inner = plot.innerHTML.replace(/<style>[^]*?<\/style>/, "");
  const legend = keys.map(({ name, colour }, i) => {
    const x = 12 + (i % columns) * 150,
      y = h! + head + 6 + Math.floor(i / columns) * 15;
    const square = `<rect x="${x}" y="${y}" width="10" height="10" fill="${colour}"/>`;
    return `${square}<text x="${x + 15}" y="${y + 9}">${escaped(name)}</text>`;
  });
  const lines = notes.map(
    (note, i) => `<text x="12" y="${h! + head + 12 + 15 * i}" fill="${colours.soft}">${escaped(note)}</text>`,
  );
  return (
    `<?xml version="1.0" encoding="UTF-8"?>\n<svg xmlns="http://www.w3.org/2000/svg" ` +
    `xmlns:xlink="http://www.w3.org/1999/xlink" width="${w}" height="${height}" viewBox="0 0 ${w} ${height}" ` +
    `font-family="sans-serif" font-size="11" fill="${colours.fg}">` +
    `<style>@media (prefers-color-scheme:dark){svg{filter:invert(.9) hue-rotate(180deg)}}</style>` +
    `<rect width="100%" height="100%" fill="${colours.bg}"/><text x="12" y="17" font-size="13" ` +
    `font-weight="bold">${escaped(title)}</text><g transform="translate(0,${head})" text-anchor="middle" ` +
    `color="${colours.fg}" fill="currentColor">${inner}</g>${legend.join("")}${lines.join("")}</svg>\n`
  );
}

const sure = (name: string) => name.replace(/[^A-Za-z0-9_.-]+/g, "_");

/** The plots that the report has data for: file name (without ending) and SVG. Maps and curves show one method of each
 *  library. Colours have the names of style.css. */
export function charts(report: Report): Map<string, string> {
  const files = new Map<string, string>();
  const o: Options = { width, document: plainDocument() };
  const shares = ["<1e-4", "1e-4 on", "1e-3 on", "1e-2 on", "0.1 on"];
  const heat: Key[] = [
    ...shares.map((name, i) => ({ name, colour: shade("bad", i + 1) })),
    { name: "within the claim", colour: shade("within", 3) },
    { name: "undecided or declined", colour: shade("undecided", 3) },
    { name: "none of these", colour: "var(--clean)" },
  ];
  for (const query of Object.keys(questions)) {
    const points = report.speed.filter((p) => p.query === query);
    if (points.some((p) => p.digits !== null))
      files.set(
        `speed-${query}`,
        framed(
          speedPlot(points, o, claimedDigits(report)),
          `Speed against accuracy: ${questions[query]}`,
          [],
          [
            "Filled: the accuracy shown with 95 % confidence. Hollow: the accuracy observed. Thin line: settings.",
            `${grouped(Math.max(...points.map((p) => p.asked)))} pairs at most for each method` +
              `${report.speed_on ? ` on ${report.speed_on}` : ""}.`,
          ],
        ),
      );
  }
  const curves = firstOfEach(report.calibration);
  for (const map of report.maps.filter((m) => curves.some((h) => h.method === m.method)))
    files.set(
      sure(`map-${map.plane}-${map.method}`),
      framed(
        mapPlot(map, o),
        `${map.method}: share wrong beyond the claim or failed, else within it`,
        heat,
      ),
    );
  if (curves.length > 0)
    files.set(
      "calibration",
      framed(
        calibrationPlot(curves, o),
        "Share of wrong answers against margin",
        curves.map(({ method }) => ({ name: method, colour: colourOf(curves, method) })),
      ),
    );
  return files;
}
