// SPDX-License-Identifier: MIT
// What is done about a cause: who owns it, and the commands that explain, export, suppress or annotate it.
import { useState } from "preact/hooks";
import { Copy } from "../parts/elements.tsx";
import { json_line, safe, shell_quoted } from "../parts/words.ts";
import { note_words } from "./causes.tsx";
import type { Bucket } from "./data.ts";
import type { FullReport } from "./report.ts";

const day = 86_400_000,
  suppressed_days = 90;

/** One line for suppressions.jsonl; what only a person knows is left empty. */
function suppression_line(key: string, started: string): string {
  const begun = Date.parse(started);
  const end = new Date((Number.isNaN(begun) ? Date.now() : begun) + suppressed_days * day);
  const expires = end.toISOString().slice(0, 10);
  return json_line({ bucket: key, reason: "", link: "", owner: "", expires });
}

function Annotate({ report, b, triage }: { report: FullReport; b: Bucket; triage: string }) {
  const [owner, set_owner] = useState(b.note?.owner ?? "");
  const [note, set_note] = useState(b.note?.note ?? "");
  const key = shell_quoted(b.key);
  return (
    <>
      <h3>Owner and note</h3>
      {b.note && <p class="note">{safe(note_words(b))}</p>}
      <p class="tools">
        <label>
          Owner <input value={owner} size={14} onInput={(event) => set_owner(event.currentTarget.value)} />
        </label>
        <label class="wide">
          Note <input value={note} onInput={(event) => set_note(event.currentTarget.value)} />
        </label>
      </p>
      {owner !== "" || note !== "" ? (
        <Copy
          label={`Note it in ${safe(report.notes_file)}`}
          text={`${triage} --annotate ${key} --owner ${shell_quoted(owner)} --note ${shell_quoted(note)}`}
        />
      ) : (
        <p class="soft">Fill in either for the command that notes it.</p>
      )}
    </>
  );
}

export function Handling({ report, b }: { report: FullReport; b: Bucket }) {
  const triage = `./daylight triage ${shell_quoted(report.run.folder)}`,
    key = shell_quoted(b.key);
  return (
    <section class="handling">
      <h3>To do</h3>
      <Copy label="Explain it" text={`${triage} --explain ${key}`} />
      <Copy label="A program, a proof and the text of an issue" text={`${triage} --export ${key} --out upstream`} />
      <Copy label="A line of suppressions.jsonl" text={suppression_line(b.key, report.run.started)} />
      <p class="soft">
        Its pair is in <code>{safe(b.file)}</code>.
      </p>
      <Annotate report={report} b={b} triage={triage} />
    </section>
  );
}
