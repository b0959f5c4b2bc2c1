// SPDX-License-Identifier: MIT
// What the words of the page of a scene mean, a sentence each.

const meanings: Record<string, string> = {
  "box, mesh":
    "A shape that is not asked about itself: a ball, capsule or cylinder around it, drawn in clear grey, stands in.",
  capsule: "All points within a radius of a segment. As a column: the outer capsule.",
  certified: "The answer is given only with a proof that is checked; what has none goes to the referee.",
  clearance: "How near is too near: a pair that is no farther apart is within it. 0: only contact counts.",
  "comes within": "The pair is within the clearance in a configuration that was drawn or found by the proof.",
  configuration: "One value for every joint. Those of the study are drawn at random within the limits.",
  cylinder: "The exact test of two rounded cylinders, yes or no.",
  distance: "The computed distance of the two solids, held against the clearance.",
  "false alarm": "A model says that a pair is within the clearance and it is not; with how far it is beyond.",
  "gap here": "The gap of the pair in the configuration shown, where the sliders stand; a dash: far beyond.",
  "in pairs": "How many pairs the model is wrong about at least once.",
  "inner capsule": "A capsule that lies inside the solid: it raises no false alarm, but may miss a contact.",
  known: "Not, where a solid that only holds a box or mesh came within the clearance: the box itself may be clear.",
  "least gap": "The least distance of the pair that was seen; below 0 the depth of an overlap.",
  link: "A rigid part of the robot, carried by a joint.",
  missed: "A model says that a pair is clear and it is within the clearance; with how far below it is.",
  model: "A simpler solid, or a test, that answers for a pair whether it is within the clearance.",
  needs: "The simplest model that by itself answers every sample of the pair right; below it what costs least.",
  never: "Proved for all values of the joints within their limits, not only for those that were drawn.",
  "never within": "Proved: in no configuration is the pair within the clearance.",
  "not known": "A solid around a box or mesh came within the clearance: whether the box did is not known.",
  "not seen within": "In no configuration that was drawn; others may be, unless it is proved.",
  open: "Of a part of the joints' space nothing is proved, within the boxes that were looked at.",
  "other link": "The second link of the two.",
  "outer capsule": "The capsule around the solid: it misses nothing, but may raise a false alarm.",
  pair: "Two solids of different parts of the robot.",
  recommended: "The models that cost least and are right: asked one after the other, the last is trusted.",
  referee: "Slow exact arithmetic that settles what doubles cannot.",
  refuted: "A configuration is known, and confirmed, in which the two overlap or touch.",
  rounding: "The radius of a ball by which a solid is grown.",
  sample: "One pair in one configuration.",
  seed: "The number from which the configurations are drawn: the same one draws the same.",
  settles: "Samples for which this is the first model, from the simplest on, that can tell for sure.",
  show: "Draws the model around both solids, or puts the sliders where the proof saw the pair.",
  "says here": "What the model says of the pair in the configuration shown.",
  sphere: "The ball around the solid.",
  state: "What there is to fear of a pair, worst first: comes within, open, not known, not seen, never within.",
  suffices: "Pairs for which the model by itself is right in every sample.",
  "time alone": "The time of one configuration if this model by itself is asked about every pair.",
  tolerated: "So early a false alarm may come, beyond the clearance, without being counted as wrong.",
  verdict: "What is proved of the two: refuted, within the clearance, open or never.",
  "what is known": "The proved distance, the one that was seen, or how much is open.",
  within: "The share of configurations drawn in which the pair is within the clearance.",
  wrong: "Answers of the model by itself that are not true.",
  "wrong in all": "Wrong answers of the model in all samples of the pair.",
};
meanings["false alarm up to"] = meanings["false alarm"]!;
meanings["missed up to"] = meanings.missed!;

export const aboutScene = (word: string): string | undefined => meanings[word.toLowerCase().replace(/ \[.*\]$/, "")];

/** All of them, in the order of the alphabet. */
export const sceneGlossaryEntries = (): [string, string][] => Object.entries(meanings).sort(([x], [y]) => (x < y ? -1 : 1));
