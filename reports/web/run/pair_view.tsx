// SPDX-License-Identifier: MIT
// Both solids, whole or close up. A gap too narrow to see is drawn wider, and the caption states it.
import { useMemo, useState } from "preact/hooks";
import { drawingOf, exaggerated, exaggeration } from "../parts/drawing.ts";
import { coreReach } from "../parts/geometry.ts";
import { Projection } from "../parts/projection.tsx";
import { short } from "../parts/words.ts";
import type { Case } from "./data.ts";

/** Gaps narrower than this part of what can be seen are widened at first. */
const widenedAtOnce = 20;
/** A solid this many times smaller than the other is not seen beside it. */
const uneven = 300;

/** Both solids as lines, small. */
export function Thumbnail({ shown }: { shown: Case }) {
  const drawing = useMemo(() => {
    const drawn = drawingOf(shown);
    return exaggerated(drawn, exaggeration(drawn));
  }, [shown]);
  return (
    <span class="thumb" aria-hidden="true">
      <Projection drawing={drawing} label="" />
    </span>
  );
}

export function PairView({ shown }: { shown: Case }) {
  const trueDrawing = useMemo(() => drawingOf(shown), [shown]),
    factor = exaggeration(trueDrawing);
  const [close, zoom] = useState(false);
  const [wide, widen] = useState(factor > widenedAtOnce);
  const drawing = useMemo(() => exaggerated(trueDrawing, wide ? factor : 1), [trueDrawing, wide, factor]);
  const sizes = [trueDrawing.a, trueDrawing.b].map(coreReach),
    ratio = Math.max(...sizes) / Math.min(...sizes);

  const gap = trueDrawing.gap ?? 0,
    words = `the ${gap < 0 ? "overlap" : "gap"} of ${short(Math.abs(gap) * trueDrawing.unit)}`;
  const swatches = { a: true, b: true, "plane between": drawing.plane, "common point": drawing.point };
  return (
    <figure class="pair-view">
      <div class="stage-tools" role="group" aria-label="View">
        <button type="button" aria-pressed={!close} onClick={() => zoom(false)}>
          Whole pair
        </button>
        <button type="button" aria-pressed={close} onClick={() => zoom(true)}>
          Contact
        </button>
        {factor > 1 && (
          <button type="button" aria-pressed={wide} onClick={() => widen(!wide)}>
            Widen the {gap < 0 ? "overlap" : "gap"}
          </button>
        )}
        <span class="swatches">
          {Object.entries(swatches).map(
            ([name, isShown]) =>
              isShown && (
                <span key={name}>
                  <i class={name} /> {name}
                </span>
              ),
          )}
        </span>
      </div>
      <div class="stage">
        <Projection
          drawing={drawing}
          close={close}
          label={`Solid a and solid b, ${shown.truth.verdict}${trueDrawing.gap === null ? "" : `, ${words}`}`}
        />
      </div>
      <figcaption>
        {factor > 1 && wide ? (
          <b class="warn">
            Not to scale: {words} is drawn {short(factor, 2)} times as wide, by moving the solids{" "}
            {gap > 0 ? "apart" : "into each other"} about their contact.
          </b>
        ) : (
          `To scale${factor > 1 ? `: ${words} is drawn as it is` : ""}.`
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
