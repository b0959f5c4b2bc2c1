// SPDX-License-Identifier: MIT
// The meaning of each term of the page of a scene.

const meanings: Record<string, string> = {
  "box, mesh":
    "A shape that is not tested itself. A ball, capsule or cylinder around it, drawn in translucent grey, replaces it.",
  capsule: "All points within a radius of a segment. In the table: the outer capsule.",
  certified: "An answer with a proof that is checked. Pairs without such a proof go to the referee.",
  clearance: "A pair is within the clearance if it is no farther apart than this. 0: only contact counts.",
  "comes within": "The pair is within the clearance in a sampled configuration, or in one that the proof found.",
  configuration: "One value for every joint. The study samples configurations at random within the limits.",
  cylinder: "The exact test of two rounded cylinders, yes or no.",
  distance: "The computed distance of the two solids, compared with the clearance.",
  "false alarm":
    "A model reports that a pair is within the clearance, but it is not. The number states how far beyond it is.",
  "gap here":
    "The gap of the pair in the configuration shown, as the sliders are set. A dash: far beyond the clearance.",
  "in pairs": "The number of pairs for which the model is wrong at least once.",
  "inner capsule": "A capsule that lies inside the solid: it raises no false alarm, but may miss a contact.",
  known:
    "A pair is not known if only a solid around a box or mesh came within the clearance. The box itself may be clear.",
  "least gap": "The least distance of the pair that was seen. A negative number is the depth of an overlap.",
  link: "A rigid part of the robot, carried by a joint.",
  missed:
    "A model reports that a pair is clear, but it is not. The number is the distance of the pair below the clearance.",
  model: "A simpler solid, or a test, that decides whether a pair is within the clearance.",
  needs:
    "The simplest model that is right in every sample of the pair. Below it is the cheapest sequence of models.",
  never: "Proved for all values of the joints within their limits, not only for the sampled ones.",
  "never within": "Proved: in no configuration is the pair within the clearance.",
  "not known": "A solid around a box or mesh came within the clearance. It is not known whether the box itself did.",
  "not seen within":
    "The pair was not within the clearance in any sampled configuration. Without a proof, it may be in others.",
  open: "The proof reached its limit of boxes, which are parts of the joint space, before it covered all of it.",
  "other link": "The second link of the two.",
  "outer capsule": "The capsule around the solid: it misses nothing, but may raise a false alarm.",
  pair: "Two solids of different parts of the robot.",
  recommended:
    "The cheapest sequence of models that is right. If one is not certain, the next is used. The last one decides.",
  referee: "Slow exact arithmetic that settles what doubles cannot.",
  refuted: "A configuration in which the two overlap or touch is known and confirmed.",
  rounding: "The radius of a ball by which a solid is grown.",
  sample: "One pair in one configuration.",
  seed: "The number that determines the sampled configurations. The same seed gives the same configurations.",
  settles: "Samples for which this is the simplest model whose answer is certain.",
  show: "Draws the model around both solids, or sets the sliders to the configuration of the proof.",
  "says here": "The answer of the model for the pair in the configuration shown.",
  sphere: "The ball around the solid.",
  state: "The state of the pair, worst first: comes within, open, not known, not seen within, never within.",
  suffices: "Pairs for which the model on its own is right in every sample.",
  "time alone": "The time for one configuration if only this model is asked for every pair.",
  tolerated: "A false alarm is not counted as wrong if the pair is within this length beyond the clearance.",
  verdict: "The result of the proof for the two: refuted, within the clearance, open or never.",
  "what is known": "The proved distance, the distance that was seen, or the share that is open.",
  within: "The share of sampled configurations in which the pair is within the clearance.",
  wrong: "Wrong answers of the model if it is used alone.",
  "wrong overall": "Wrong answers of the model in all samples of the pair.",
};
meanings["false alarm up to"] = meanings["false alarm"]!;
meanings["missed up to"] = meanings.missed!;

export const aboutScene = (word: string): string | undefined => meanings[word.toLowerCase().replace(/ \[.*\]$/, "")];

/** All of them, in the order of the alphabet. */
export const sceneGlossaryEntries = (): [string, string][] =>
  Object.entries(meanings).sort(([x], [y]) => (x < y ? -1 : 1));
