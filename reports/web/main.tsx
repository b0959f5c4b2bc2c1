// SPDX-License-Identifier: MIT
// The page: it shows the run that its data describe.
import * as forNode from "./chart.ts";
import { render } from "preact";
import { safe } from "./parts/words.ts";
import { expand } from "./run/report.ts";
import { RunPage } from "./run/run_page.tsx";

/** Undoes reports/run/page_template.cpp, which compresses with zlib and encodes in base64. */
function inflated(text: string): Response {
  const bytes = Uint8Array.from(atob(text), (character) => character.charCodeAt(0));
  return new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate")));
}

/** Draws the data in the element that reports/run/page_template.cpp fills, or states why it cannot. */
async function draw() {
  const page = document.getElementById("page")!,
    text = document.getElementById("report-data")!.textContent;
  if (text.startsWith("@")) {
    page.textContent = "This is the page without its data. daylight campaign writes it with the data of a run.";
    return;
  }
  try {
    const report = expand(await inflated(text).json());
    document.title = `daylight ${safe(report.run.id)}`;
    render(<RunPage report={report} />, page);
  } catch (error) {
    page.textContent = `The data of this page cannot be read: ${error}`;
    console.error(error);
  }
}

// In Node there is no page to draw. chart.mjs takes the functions that draw the plots as files from here.
if (typeof document === "undefined") Object.assign(globalThis, { daylight: forNode });
else void draw();
