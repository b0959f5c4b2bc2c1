// SPDX-License-Identifier: MIT
// Both solids as lines. A gap too narrow to see is drawn wider, and the caption states it.
import { useMemo } from "preact/hooks";
import { drawingOf } from "../parts/drawing.ts";
import { coreReach } from "../parts/geometry.ts";
import { Projection } from "../parts/projection.tsx";
import { short } from "../parts/words.ts";
import type { Case } from "./data.ts";

/** A solid this many times smaller than the other is not seen beside it. */
const uneven = 300;

/** Both solids, small. */
export function Thumbnail({ shown }: { shown: Case }) {
  const drawing = useMemo(() => drawingOf(shown), [shown]);
  return (
    <span class="thumb" aria-hidden="true">
      <Projection drawing={drawing} label="" />
    </span>
  );
}

export function PairView({ shown }: { shown: Case }) {
  const drawing = useMemo(() => drawingOf(shown), [shown]);
  const sizes = [drawing.a, drawing.b].map(coreReach),
    ratio = Math.max(...sizes) / Math.min(...sizes);
  const gap = drawing.gap ?? 0,
    words = `the ${gap < 0 ? "overlap" : "gap"} of ${short(Math.abs(gap) * drawing.unit)}`;
  const swatches = { a: true, b: true, "plane between": drawing.plane, "common point": drawing.point };
  return (
    <figure class="pair-view">
      <p class="swatches">
        {Object.entries(swatches).map(
          ([name, isShown]) =>
            isShown && (
              <span key={name}>
                <i class={name} /> {name}
              </span>
            ),
        )}
      </p>
      <div class="stage">
        <Projection
          drawing={drawing}
          label={`Solid a and solid b, ${shown.truth.verdict}${drawing.gap === null ? "" : `, ${words}`}`}
        />
      </div>
      <figcaption>
        {drawing.widened > 1 ? (
          <b class="warn">
            Not to scale: {words} is drawn {short(drawing.widened, 2)} times as wide, by moving the solids{" "}
            {gap > 0 ? "apart" : "into each other"} about their contact.
          </b>
        ) : (
          "To scale."
        )}
        {Number.isFinite(ratio) &&
          ratio > uneven &&
          ` One solid is ${short(ratio, 2)} times as large as the other. The smaller one may be too small to see.`}
        {drawing.near &&
          (gap < 0
            ? " The line joins two dots. Each dot marks roughly the deepest point of one solid in the other."
            : " The line joins two dots. They mark roughly the nearest points of the solids.")}
      </figcaption>
    </figure>
  );
}
