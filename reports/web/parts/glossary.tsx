// SPDX-License-Identifier: MIT
// The words of the page at its end, for paper and for fingers; a pointer is told the same where it rests.
import { Section } from "./elements.tsx";

export function Words({ entries }: { entries: [string, string][] }) {
  return (
    <Section id="words" title="Words" lead="What the words of this page mean.">
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
