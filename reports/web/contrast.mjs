// SPDX-License-Identifier: MIT
// The contrast of what a page shows with what is behind it, from the computed colours: 4.5 for words, 3 for marks.
import assert from "node:assert/strict";

/** What is no mark, or need not stand out: grids and frames, what the pointer shows, faces of solids with an outline,
 *  the ground of a map, and controls without an effect. */
const exempt = [
  "[aria-label$=grid], [aria-label=frame], [aria-label=tip], .rule, .reach, .ground, defs *",
  ".projection .body, .projection .plane, button:disabled, .zero",
].join();

const measured = (exempt) => {
  const pen = Object.assign(document.createElement("canvas"), { width: 1, height: 1 }).getContext("2d", {
    willReadFrequently: true,
  });
  const known = new Map();
  const rgba = (colour) => {
    if (!known.has(colour)) {
      pen.clearRect(0, 0, 1, 1);
      pen.fillStyle = colour;
      pen.fillRect(0, 0, 1, 1);
      known.set(colour, [...pen.getImageData(0, 0, 1, 1).data]);
    }
    return known.get(colour);
  };
  const over = ([r, g, b, a], opacity, under) => [r, g, b].map((c, i) => under[i] + ((c - under[i]) * a * opacity) / 255);
  const light = (rgb) =>
    rgb
      .map((c) => (c / 255 <= 0.03928 ? c / 255 / 12.92 : ((c / 255 + 0.055) / 1.055) ** 2.4))
      .reduce((sum, c, i) => sum + c * [0.2126, 0.7152, 0.0722][i], 0);
  const ratio = (x, y) => {
    const [low, high] = [light(x), light(y)].sort((a, b) => a - b);
    return (high + 0.05) / (low + 0.05);
  };
  /** The colour behind an element: that of its nearest ancestor that has one. */
  const behind = (e) => {
    for (let at = e.parentElement; at; at = at.parentElement) {
      const colour = rgba(getComputedStyle(at).backgroundColor);
      if (colour[3] === 255) return colour.slice(0, 3);
    }
    return [255, 255, 255];
  };
  const opacityOf = (e) => {
    let opacity = 1;
    for (let at = e; at; at = at.parentElement) opacity *= Number(getComputedStyle(at).opacity);
    return opacity;
  };
  const shown = [...document.querySelectorAll("#page *")].filter(
    (e) => e.checkVisibility({ visibilityProperty: true }) && !e.closest(exempt),
  );
  const paints = (e, under) => {
    const style = getComputedStyle(e),
      opacity = opacityOf(e);
    const inks = [
      [style.fill, Number(style.fillOpacity)],
      [parseFloat(style.strokeWidth) > 0 ? style.stroke : "none", Number(style.strokeOpacity)],
    ];
    return inks.filter(([ink]) => ink !== "none").map(([ink, own]) => over(rgba(ink), own * opacity, under));
  };
  const found = [];
  const keep = (kind, e, contrast) =>
    found.push({ kind, contrast, name: `${e.tagName} ${e.closest("[aria-label]")?.getAttribute("aria-label") ?? ""} ` +
      `${e.getAttribute("class") ?? ""} ${e.textContent.slice(0, 30)}` });
  for (const e of shown)
    if ([...e.childNodes].some((n) => n.nodeType === Node.TEXT_NODE && n.textContent.trim().length > 1)) {
      const own = rgba(getComputedStyle(e).backgroundColor),
        under = own[3] === 255 ? own.slice(0, 3) : behind(e);
      const ink = e instanceof SVGElement ? paints(e, under)[0] : over(rgba(getComputedStyle(e).color), opacityOf(e), under);
      keep("word", e, ratio(ink, under));
    }
  // A mark inside a field of a plot that was painted before it has that field behind it.
  for (const svg of shown.filter((e) => e.tagName === "svg")) {
    const fields = [];
    for (const e of svg.querySelectorAll("path, circle, rect, line, polyline, polygon, ellipse")) {
      if (!e.checkVisibility({ visibilityProperty: true })) continue;
      const box = e.getBoundingClientRect();
      const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
      const field = fields.findLast((f) => f.box.left < x && x < f.box.right && f.box.top < y && y < f.box.bottom);
      const under = field?.colour ?? behind(svg),
        inks = paints(e, under);
      if (e.tagName === "rect" && inks.length > 0 && box.width > 6) fields.push({ box, colour: inks[0] });
      if (inks.length > 0 && !e.closest(exempt)) keep("mark", e, Math.max(...inks.map((ink) => ratio(ink, under))));
    }
  }
  // Swatches, and the fields of the table of methods with their edges.
  for (const e of shown.filter((e) => e.matches("i, td.heat.bad, td.heat.within, td.heat.undecided"))) {
    const style = getComputedStyle(e),
      under = behind(e);
    const edge = /^(rgb[^)]*\)|color[^)]*\)).*inset/.exec(style.boxShadow)?.[1];
    const inks = [style.backgroundColor, ...(edge ? [edge] : parseFloat(style.borderTopWidth) > 0 ? [style.borderTopColor] : [])];
    keep("mark", e, Math.max(...inks.map((ink) => ratio(over(rgba(ink), 1, under), under))));
  }
  return found;
};

/** Returns the least contrast of words and of marks, and how many there are. */
export async function assertContrast(page, what) {
  const found = await page.evaluate(measured, exempt);
  const least = {};
  for (const [kind, wanted] of [["word", 4.5], ["mark", 3]]) {
    const of = found.filter((f) => f.kind === kind);
    const pale = of.filter(({ contrast }) => contrast < wanted).map(({ name, contrast }) => `${name} ${contrast.toFixed(2)}`);
    assert.deepEqual([...new Set(pale)], [], `${what}: ${kind}s below ${wanted}`);
    least[kind] = of.length === 0 ? null : [Number(Math.min(...of.map(({ contrast }) => contrast)).toFixed(2)), of.length];
  }
  return least;
}
