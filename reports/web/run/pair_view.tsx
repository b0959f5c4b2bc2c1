// SPDX-License-Identifier: MIT
// Both solids, whole or close up. A gap too narrow to see is drawn wider, and the caption states it.
import { useMemo, useState } from "preact/hooks";
import { drawingOf, exaggerated, exaggeration } from "../parts/drawing.ts";
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
  const trueDrawing = useMemo(() => drawingOf(shown), [shown]);
  const factor = exaggeration(trueDrawing);
  const [close, zoom] = useState(false);
  const [wide, widen] = useState(factor > widenedAtOnce);
  const drawing = useMemo(() => exaggerated(trueDrawing, wide ? factor : 1), [trueDrawing, wide, factor]);
  const sizes = [trueDrawing.a, trueDrawing.b].map((s) => Math.hypot(s.radius, s.half));
  const ratio = Math.max(...sizes) / Math.min(...sizes);

  const gap = trueDrawing.gap,
    words = gap === null ? "" : gap < 0 ? "overlap" : "gap";
  const formatGap = gap === null ? "" : `, ${words} ${short(Math.abs(gap) * trueDrawing.unit)}`;
  const label = `Cylinder a and cylinder b, ${shown.truth.verdict}${formatGap}`;
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
            Widen the {words}
          </button>
        )}
        <span class="swatches">
          <i class="a" /> a <i class="b" /> b
          {drawing.plane && (
            <>
              <i class="plane" /> plane between
            </>
          )}
          {drawing.point && (
            <>
              <i class="point" /> common point
            </>
          )}
        </span>
      </div>
      <div class="stage">
        <Projection drawing={drawing} close={close} label={label} />
      </div>
      <figcaption>
        {factor > 1 && wide && (
          <b class="warn">
            Not to scale: the {words} of {short(Math.abs(gap!) * trueDrawing.unit)} is drawn {short(factor, 2)} times
            as wide, by moving the solids {gap! > 0 ? "apart" : "into each other"} about their contact.{" "}
          </b>
        )}
        {factor > 1 && !wide && (
          <>
            To scale: the {words} of {short(Math.abs(gap!) * trueDrawing.unit)} is drawn as it is.{" "}
          </>
        )}
        {factor === 1 && <>To scale. </>}
        {Number.isFinite(ratio) && ratio > uneven && (
          <>One solid is {short(ratio, 2)} times as large as the other. The smaller one may be too small to see. </>
        )}
        {drawing.near &&
          (gap !== null && gap < 0
            ? "The dots on a line are approximately the deepest points of each solid in the other."
            : "The dots on a line are approximately the nearest points.")}
      </figcaption>
    </figure>
  );
}
