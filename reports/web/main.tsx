// SPDX-License-Identifier: MIT
// The page: it shows the run or the scene that its data describe.
import * as forNode from "./chart.ts";
import { render } from "preact";
import { inflated } from "./parts/inflate.ts";
import { bringSolver } from "./parts/solver.ts";
import { safe, safeTexts } from "./parts/words.ts";
import type { Report } from "./run/data.ts";
import { expand } from "./run/report.ts";
import { RunPage } from "./run/run_page.tsx";
import { StudyPage } from "./scene/scene_page.tsx";
import type { Study } from "./scene/study.ts";

const noData =
  "This is the page without its data. daylight campaign writes it with the data of a run, daylight scene --page with " +
  "the data of a scene.";

/** From the element that page_template.cpp fills; null if it holds the mark of the template. */
async function dataOf(): Promise<unknown> {
  const text = document.getElementById("report-data")?.textContent ?? "";
  if (text === "" || text.startsWith("@")) return null;
  return inflated(text).json();
}

/** From the element that page_template.cpp fills for pages that ask the solver. */
async function bringSolverOfPage() {
  await bringSolver(await inflated(document.getElementById("solver")!.textContent!).arrayBuffer());
}

/** The title of the page and what it shows; nothing in the template without data. */
async function shown() {
  const data = (await dataOf()) as Report | Study | null;
  if (data === null) return null;
  if ("kept" in data) {
    const study = safeTexts(data);
    await bringSolverOfPage();
    return { title: study.file, view: <StudyPage study={study} /> };
  }
  return { title: safe(data.run.id), view: <RunPage report={expand(data)} /> };
}

/** Draws the page, or says why it cannot. */
async function draw() {
  const page = document.getElementById("page")!;
  try {
    const it = await shown();
    if (it) {
      document.title = `daylight ${it.title}`;
      render(it.view, page);
    } else {
      page.textContent = noData;
    }
  } catch (error) {
    page.textContent = `The data of this page cannot be read: ${error}`;
    console.error(error);
  }
}

/** On paper nothing can be unfolded. */
function unfoldForPrint() {
  let opened: HTMLDetailsElement[] = [];
  addEventListener("beforeprint", () => {
    opened = [...document.querySelectorAll<HTMLDetailsElement>("details.print:not([open])")];
    for (const details of opened) details.open = true;
  });
  addEventListener("afterprint", () => {
    for (const details of opened) details.open = false;
  });
}

// In Node there is no page to draw: chart.mjs takes from here what draws the plots as files.
if (typeof document === "undefined") Object.assign(globalThis, { daylight: forNode });
else {
  unfoldForPrint(); // before the plots hear of it, which need their place
  void draw();
}
