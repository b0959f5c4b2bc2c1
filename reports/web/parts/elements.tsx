// SPDX-License-Identifier: MIT
// Sections, plots, choices, and fields with a button that copies their text (Copy).
import type { ComponentChildren } from "preact";
import { useEffect, useRef, useState } from "preact/hooks";

export function Section({
  id,
  title,
  lead,
  children,
}: {
  id: string;
  title: string;
  lead?: ComponentChildren;
  children: ComponentChildren;
}) {
  return (
    <section id={id} aria-labelledby={`${id}-title`}>
      <h2 id={`${id}-title`} tabIndex={-1}>
        {title}
      </h2>
      {lead && <p class="lead">{lead}</p>}
      {children}
    </section>
  );
}

export function Copy({ text, label }: { text: string; label: string }) {
  const [said, say] = useState("Copy");
  const copy = async () => {
    try {
      await navigator.clipboard.writeText(text);
      say("Copied");
    } catch {
      say("Select and copy by hand"); // a page from disk may have no clipboard
    }
  };
  return (
    <div class="copy">
      <div class="copy-head">
        <span>{label}</span>
        <button type="button" onClick={copy} aria-live="polite">
          {said}
        </button>
      </div>
      <code>{text}</code>
    </div>
  );
}

export function Select({
  label,
  value,
  options,
  onChange,
}: {
  label: string;
  value: string;
  options: readonly (readonly [string, string])[];
  onChange: (value: string) => void;
}) {
  return (
    <label class="select">
      {label}{" "}
      <select value={value} onChange={(event) => onChange(event.currentTarget.value)}>
        {options.map(([key, words]) => (
          <option value={key} key={key} selected={key === value}>
            {words}
          </option>
        ))}
      </select>
    </label>
  );
}

/** The margins of a plot leave nothing of less than this. */
const narrowest = 260;

/** A plot as wide as its place. */
export function Figure({
  draw,
  height,
  caption,
  label,
}: {
  draw: (width: number) => Element;
  height: number;
  caption?: ComponentChildren;
  label: string;
}) {
  const ref = useRef<HTMLDivElement>(null);
  useEffect(() => {
    const place = ref.current!;
    const observer = new ResizeObserver(() => {
      if (place.clientWidth > 0) place.replaceChildren(draw(Math.max(narrowest, place.clientWidth)));
    });
    observer.observe(place);
    return () => observer.disconnect();
  }, [draw]);
  return (
    <figure>
      <div ref={ref} class="plot" role="img" aria-label={label} style={{ minHeight: `${height}px` }} />
      {caption && <figcaption>{caption}</figcaption>}
    </figure>
  );
}
