// SPDX-License-Identifier: MIT
// The words of the page at its end, for paper and for fingers; a pointer is told the same where it rests.
import { Section } from "./parts.tsx";
import { glossary_entries } from "./words.ts";

export function Words() {
  return (
    <Section id="words" title="Words" lead="What the words of this page mean.">
      <dl class="words">
        {glossary_entries().map(([word, meaning]) => (
          <div key={word}>
            <dt>{word}</dt>
            <dd>{meaning}</dd>
          </div>
        ))}
      </dl>
    </Section>
  );
}
