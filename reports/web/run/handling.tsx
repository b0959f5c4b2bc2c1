// SPDX-License-Identifier: MIT
// The next steps for a cause: its owner, and the commands that explain, export, suppress or annotate it.
import { useState } from "preact/hooks";
import { Copy } from "../parts/elements.tsx";
import { jsonLine, safe, shellQuoted } from "../parts/words.ts";
import { formatNote } from "./causes.tsx";
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

function Annotate({ report, b, triage }: { report: FullReport; b: Cause; triage: string }) {
  const [owner, setOwner] = useState(b.note?.owner ?? "");
  const [note, setNote] = useState(b.note?.note ?? "");
  const key = shellQuoted(b.key);
  return (
    <>
      <h3>Owner and note</h3>
      {b.note && <p class="note">{safe(formatNote(b))}</p>}
      <p class="tools">
        <label>
          Owner <input value={owner} size={14} onInput={(event) => setOwner(event.currentTarget.value)} />
        </label>
        <label class="wide">
          Note <input value={note} onInput={(event) => setNote(event.currentTarget.value)} />
        </label>
      </p>
      {owner !== "" || note !== "" ? (
        <Copy
          label={`Record it in ${safe(report.notes_file)}`}
          text={`${triage} --annotate ${key} --owner ${shellQuoted(owner)} --note ${shellQuoted(note)}`}
        />
      ) : (
        <p class="soft">Fill in an owner or a note to see the command that records it.</p>
      )}
    </>
  );
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
      <Annotate report={report} b={b} triage={`./daylight triage ${run}`} />
    </section>
  );
}
