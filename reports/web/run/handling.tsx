// SPDX-License-Identifier: MIT
// The next steps for a cause: what explains, exports or suppresses it.
import { Copy } from "../parts/elements.tsx";
import { jsonLine, safe, shellQuoted } from "../parts/words.ts";
import type { Cause } from "./data.ts";
import type { FullReport } from "./report.ts";

const day = 86_400_000,
  suppressedDays = 90;

/** One line for suppressions.jsonl; a person fills in the empty fields. */
function suppressionLine(key: string, started: string): string {
  const begun = Date.parse(started);
  const end = new Date((Number.isNaN(begun) ? Date.now() : begun) + suppressedDays * day);
  const expires = end.toISOString().slice(0, 10);
  return jsonLine({ bucket: key, reason: "", link: "", owner: "", expires });
}

export function Handling({ report, b }: { report: FullReport; b: Cause }) {
  const run = shellQuoted(report.run.folder),
    key = shellQuoted(b.key);
  return (
    <section class="handling">
      <h3>Next steps</h3>
      <Copy label="Explain it" text={`./daylight explain ${run} ${key}`} />
      <Copy
        label="For the maintainers: a proof, the text of an issue, and a program or case"
        text={`./daylight export ${run} ${key} --out upstream`}
      />
      <Copy label="A line for suppressions.jsonl" text={suppressionLine(b.key, report.run.started)} />
      <p class="soft">
        Its pair is in <code>{safe(b.file)}</code>.
      </p>
    </section>
  );
}
