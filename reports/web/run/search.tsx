// SPDX-License-Identifier: MIT
// One field that searches and suggests filters; those chosen stand beside it, each to be removed.
import { useState } from "preact/hooks";
import { grouped, plural, safe } from "../parts/words.ts";
import { facets, noFilter, type chipCounts, type Facet, type Filter } from "./filter.ts";
import { about } from "./glossary.ts";
import { kindLabel, severityLabels } from "./words.ts";

const facetTitles: Record<Facet, string> = {
  severity: "severity",
  kind: "kind",
  library: "library",
  family: "family",
  standing: "since earlier runs",
};
type Counts = ReturnType<typeof chipCounts>;

const wordsOf = (facet: Facet, value: string) =>
  facet === "severity" ? (severityLabels[value] ?? value) : kindLabel(value);

interface Suggestion {
  facet: Facet;
  value: string;
  told: string;
}
/** So many of a facet if nothing is typed, and in all if something is. */
const shownOfEach = 5,
  shownInAll = 12;

/** Filters whose words begin as what is typed does, those with the most findings first. */
function suggestionsOf(filter: Filter, counts: Counts, lone: Counts): Suggestion[] {
  const typed = filter.text.trim().toLowerCase().replaceAll("_", " ");
  const all = facets.flatMap((facet) => {
    const values = new Map([...[...lone[facet].keys()].map((value) => [value, 0] as const), ...counts[facet]]);
    const passing = [...values]
      .map(([value, count]) => ({ value, count, causes: count > 0 ? 0 : (lone[facet].get(value) ?? 0) }))
      .filter(({ value, count, causes }) => count + causes > 0 && !filter.chosen[facet].has(value))
      .filter(({ value }) => ` ${wordsOf(facet, value).toLowerCase()}`.includes(` ${typed}`))
      .sort((x, y) => y.count - x.count || (x.value < y.value ? -1 : 1));
    return passing.slice(0, typed === "" ? shownOfEach : shownInAll).map(({ value, count, causes }) => ({
      facet,
      value,
      told: causes > 0 ? plural(causes, "cause") : grouped(count),
    }));
  });
  return typed === "" ? all : all.slice(0, shownInAll);
}

function changed(filter: Filter, facet: Facet, value: string, chosen: boolean): Filter {
  const now = new Set(filter.chosen[facet]);
  if (chosen) now.add(value);
  else now.delete(value);
  return { ...filter, chosen: { ...filter.chosen, [facet]: now } };
}

function Field({
  filter,
  set,
  counts,
  lone,
}: {
  filter: Filter;
  set: (filter: Filter) => void;
  counts: Counts;
  lone: Counts;
}) {
  const [open, unfold] = useState(false);
  const [at, move] = useState(-1);
  const all = open ? suggestionsOf(filter, counts, lone) : [];
  const choose = ({ facet, value }: Suggestion) => {
    set({ ...changed(filter, facet, value, true), text: "" });
    move(-1);
  };
  const press = (event: KeyboardEvent) => {
    if (event.key === "ArrowDown" || event.key === "ArrowUp") {
      event.preventDefault();
      unfold(true);
      move(Math.max(-1, Math.min(all.length - 1, at + (event.key === "ArrowDown" ? 1 : -1))));
    } else if (event.key === "Enter" && all[at]) choose(all[at]);
    else if (event.key === "Enter" || event.key === "Escape") {
      if (open) event.preventDefault(); // Escape else empties the field
      unfold(false);
    }
  };
  return (
    <div class="search">
      <input
        type="search"
        role="combobox"
        list={undefined}
        aria-expanded={all.length > 0}
        aria-controls="suggestions"
        aria-autocomplete="list"
        aria-activedescendant={all[at] ? `suggestion-${at}` : undefined}
        value={filter.text}
        placeholder="Search: method, family, kind, cause, reason or number"
        aria-label="Search causes and findings"
        title={about("text")}
        onFocus={() => unfold(true)}
        onClick={() => unfold(true)}
        onBlur={() => unfold(false)}
        onKeyDown={press}
        onInput={(event) => {
          unfold(true);
          move(-1);
          set({ ...filter, text: event.currentTarget.value });
        }}
      />
      <ul id="suggestions" role="listbox" aria-label="Filters" hidden={all.length === 0}>
        {all.map((s, i) => (
          <li
            role="option"
            id={`suggestion-${i}`}
            aria-selected={i === at}
            title={about(wordsOf(s.facet, s.value))}
            onMouseDown={(event) => {
              event.preventDefault(); // the field keeps the focus
              choose(s);
            }}
            key={`${s.facet} ${s.value}`}>
            <span class="soft">{facetTitles[s.facet]}</span> {safe(wordsOf(s.facet, s.value))}{" "}
            <span class="soft">{s.told}</span>
          </li>
        ))}
      </ul>
    </div>
  );
}

export function Search({
  filter,
  set,
  counts,
  lone,
  said,
}: {
  filter: Filter;
  set: (filter: Filter) => void;
  counts: Counts;
  lone: Counts;
  said: string;
}) {
  const chosen = [
    ...facets.flatMap((facet) =>
      [...filter.chosen[facet]].map((value) => ({
        title: facetTitles[facet],
        words: wordsOf(facet, value),
        without: changed(filter, facet, value, false),
      })),
    ),
    ...(filter.method === null
      ? []
      : [{ title: "method", words: filter.method, without: { ...filter, method: null } }]),
  ];
  return (
    <div class="filters">
      <Field filter={filter} set={set} counts={counts} lone={lone} />
      {chosen.map(({ title, words, without }) => (
        <button type="button" class="chip" onClick={() => set(without)} title="Remove this filter" key={title + words}>
          <span class="soft">{title}</span> {safe(words)} <span aria-hidden="true">×</span>
        </button>
      ))}
      {(chosen.length > 0 || filter.text !== "") && (
        <button type="button" class="link" onClick={() => set(noFilter)}>
          Clear
        </button>
      )}
      <span class="soft" role="status">
        {said}
      </span>
    </div>
  );
}
