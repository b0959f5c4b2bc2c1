// SPDX-License-Identifier: MIT
// A wrong distance beside the proved one.
import { digits17, short } from "../parts/words.ts";
import type { Claim } from "./data.ts";
import type { Allowed, WrongDistance } from "./distance.ts";
import { ClaimWords, Fact } from "./elements.tsx";

const allowedLabels: Record<Allowed["by"], string> = {
  claim: "its claim",
  size: "1e\u221213 of the size, which is more than its claim: the coordinates of such solids are not finer",
  distance: "2^\u221250 of the distance or the size, which is more than its claim: doubles of that size are not finer",
};

export function WrongDistanceView({
  of: { said, proved, error, relative, allowed, claims, size },
  claim,
}: {
  of: WrongDistance;
  claim?: Claim;
}) {
  return (
    <section class="wrong-distance">
      <h3>The distance</h3>
      <dl class="facts long">
        <Fact label="proved distance">
          {digits17(proved[0])} to {digits17(proved[1])}
        </Fact>
        <Fact label="answer" kind="bad">
          {digits17(said)}
        </Fact>
      </dl>
      <dl class="facts">
        <Fact label="error">{Number.isFinite(error) ? short(error, 4) : "above 1.8e308"}</Fact>
        <Fact label="error over size">
          {short(relative, 4)} <span class="soft">of {short(size, 4)}</span>
        </Fact>
        <Fact label="error over claim" kind={claims !== null && claims > 1 ? "bad" : ""}>
          {claims === null ? "\u2013" : `${short(claims, 4)} times`}
        </Fact>
        {allowed && (
          <Fact label="allowed">
            {short(allowed.length, 4)} <span class="soft">{allowedLabels[allowed.by]}</span>
          </Fact>
        )}
      </dl>
      {claim && (
        <p class="soft">
          Its claim: <ClaimWords of={claim} />.
        </p>
      )}
    </section>
  );
}
