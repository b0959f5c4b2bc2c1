// SPDX-License-Identifier: MIT
// The glossary at the end of the page, for paper and touch screens. A pointer sees the same texts as tooltips.
import { Section } from "./elements.tsx";

export function Words({ entries }: { entries: [string, string][] }) {
  return (
    <Section id="words" title="Glossary" lead="The terms of this page.">
      <dl class="words">
        {entries.map(([word, meaning]) => (
          <div key={word}>
            <dt>{word}</dt>
            <dd>{meaning}</dd>
          </div>
        ))}
      </dl>
    </Section>
  );
}
