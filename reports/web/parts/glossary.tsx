// SPDX-License-Identifier: MIT
// The glossary at the end of the page, folded. Its texts are also the tooltips of the page.

export function Words({ entries }: { entries: [string, string][] }) {
  return (
    <details id="words">
      <summary>Glossary: {entries.length} terms</summary>
      <dl class="words">
        {entries.map(([word, meaning]) => (
          <div key={word}>
            <dt>{word}</dt>
            <dd>{meaning}</dd>
          </div>
        ))}
      </dl>
    </details>
  );
}
