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
  const [said, say] = useState("");
  const copy = async () => {
    try {
      await navigator.clipboard.writeText(text);
      say("copied");
    } catch {
      say("select and copy by hand"); // a page from disk may have no clipboard
    }
    setTimeout(() => say(""), 2000);
  };
  return (
    <div class="copy">
      <div class="copy-head">
        <span>{label}</span>
        <span>
          <span class="soft" role="status">
            {said}
          </span>{" "}
          <button type="button" onClick={copy}>
            Copy
          </button>
        </span>
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

/** The width of an element that is shown; 0 before it is. */
function useWidth<T extends HTMLElement>() {
  const ref = useRef<T>(null);
  const [width, set] = useState(0);
  useEffect(() => {
    const element = ref.current;
    if (!element) return;
    const measure = () => {
      if (element.clientWidth > 0) set(element.clientWidth);
    };
    measure();
    const observer = new ResizeObserver(measure);
    observer.observe(element);
    return () => observer.disconnect();
  }, []);
  return [ref, width] as const;
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
  const [ref, width] = useWidth<HTMLDivElement>();
  useEffect(() => {
    if (width > 0) ref.current!.replaceChildren(draw(Math.max(narrowest, width)));
  }, [width, draw]);
  return (
    <figure>
      <div ref={ref} class="plot" role="img" aria-label={label} style={{ minHeight: `${height}px` }} />
      {caption && <figcaption>{caption}</figcaption>}
    </figure>
  );
}
