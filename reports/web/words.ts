// SPDX-License-Identifier: MIT
// Numbers and names as people read them.
import type { Claim, Coordinate } from "./data.ts";

export const grouped = (n: number) => Math.round(n).toLocaleString("en-US");

/** "1.2e-7", "0.013", "42": `digits` significant ones. */
export function short(x: number | null | undefined, digits = 3): string {
  if (x === null || x === undefined || Number.isNaN(x)) return "\u2013";
  if (!Number.isFinite(x)) return x > 0 ? "\u221e" : "\u2212\u221e";
  if (x === 0) return "0";
  const size = Math.abs(x);
  const text =
    size >= 1e-3 && size < 1e5
      ? Number(x.toPrecision(digits)).toString()
      : x
          .toExponential(digits - 1)
          .replace(/\.?0+e/, "e")
          .replace("e+", "e");
  return text.replace(/^-/, "\u2212");
}

export function percent(part: number, whole: number): string {
  if (whole === 0) return "\u2013";
  if (part === 0) return "0";
  const share = (100 * part) / whole;
  if (share < 0.001) return "<0.001 %";
  return share >= 99.95 && part < whole ? ">99.9 %" : `${Number(share.toPrecision(share < 10 ? 2 : 3))} %`;
}

export const plural = (n: number, one: string, many = one + "s") => `${grouped(n)} ${n === 1 ? one : many}`;

export function range(of: [number, number] | null | undefined): string {
  if (!of) return "\u2013";
  const [low, high] = [short(of[0]), short(of[1])];
  return low === high ? low : `${low} to ${high}`;
}

/** Of least margins: each is proved, and may be larger. */
export const least_range = (of: [number, number] | null | undefined) =>
  !of ? "\u2013" : short(of[0]) === short(of[1]) ? `at least ${short(of[0])}` : `${short(of[0])} to at least ${short(of[1])}`;

export function seconds(s: number): string {
  if (s < 120) return `${short(s)} s`;
  if (s < 7200) return `${Math.floor(s / 60)} min ${Math.round(s % 60)} s`;
  return `${Math.floor(s / 3600)} h ${Math.round((s % 3600) / 60)} min`;
}

export function time(ns: number): string {
  if (ns < 1e3) return `${short(ns)} ns`;
  if (ns < 1e6) return `${short(ns / 1e3)} \u00b5s`;
  return ns < 1e9 ? `${short(ns / 1e6)} ms` : `${short(ns / 1e9)} s`;
}

/** Text from anywhere: what reorders or hides the text around it is shown as an escape. */
export function safe(text: string): string {
  return text.replace(
    /[\u0000-\u0008\u000b-\u001f\u007f-\u009f\u200b-\u200f\u2028-\u202e\u2060-\u2069\ufeff]/g,
    (c) => "\\u" + c.charCodeAt(0).toString(16).padStart(4, "0"),
  );
}

/** One line of JSON that hides nothing: the escapes of safe() are those of JSON. */
export const json_line = (data: unknown) => safe(JSON.stringify(data));

/** The same data with every text in them made safe. */
export function safe_texts<T>(data: T): T {
  const made_safe = (x: unknown): unknown => {
    if (typeof x === "string") return safe(x);
    if (Array.isArray(x)) return x.map(made_safe);
    if (x === null || typeof x !== "object") return x;
    return Object.fromEntries(Object.entries(x).map(([key, value]) => [key, made_safe(value)]));
  };
  return made_safe(data) as T;
}

const own_names = new Set(["intersect", "decide", "distance", "exact"]);
/** Ours are one library; any other is what stands before the first '-'. */
export const library = (method: string) => (own_names.has(method) ? "ours" : method.split("-", 1)[0]!);

export const kind_words = (kind: string) => kind.replaceAll("_", " ");
export const severity_words: Record<string, string> = {
  contract: "beyond its claim",
  resolution: "within its claim",
  unresolved: "truth undecided",
};

export const standing_words = (standing: string | null) => standing ?? "\u2013";

export const origin_words = ({ stated }: Claim) => (stated === undefined ? "" : stated ? "stated" : "assumed by us");

export function claim_words(claim: Claim): string {
  const parts = [];
  if (claim.relative !== 0) parts.push(`${short(claim.relative)} of the size`);
  if (claim.absolute !== 0) parts.push(`a length of ${short(claim.absolute)}`);
  return parts.length === 0 ? "always right" : `right from ${parts.join(" plus ")} on`;
}

const exponent = (text: string) => text.replace("e+0", "").replace("e+", "e");
/** The shortest decimal that is this double, in exponent form where it has more than 12 digits and is no size that
 *  people read as it is. */
export function full(x: number): string {
  if (Object.is(x, -0)) return "-0";
  const text = String(x);
  const readable = Math.abs(x) >= 1e-3 && Math.abs(x) < 1e5;
  const long = text.replace(/[^0-9]/g, "").length > 12 && !text.includes("e");
  return long && !readable ? exponent(x.toExponential()) : text;
}
/** All 17 digits. */
export const digits17 = (x: number) => (x === 0 || !Number.isFinite(x) ? short(x) : exponent(x.toExponential(16)));

export function coordinate_words(x: Coordinate): string {
  if (typeof x === "number") return full(x);
  if (typeof x === "string") return x;
  return x.map((term, i) => (i === 0 ? full(term) : term < 0 ? `\u2212 ${full(-term)}` : `+ ${full(term)}`)).join(" ");
}

/** The double nearest to an exact coordinate, for drawing. */
export function coordinate_value(x: Coordinate): number {
  if (typeof x === "number") return x;
  if (typeof x !== "string") return x.reduce((sum, term) => sum + term, 0);
  const [n, d = "1"] = x.split("/");
  const digits = Math.max(n!.length, d.length) - 300; // beyond the range of doubles: the leading ones
  const value = (text: string) =>
    digits > 0 ? Number(text.slice(0, Math.max(1, text.length - digits))) : Number(text);
  return value(n!) / value(d);
}

/** One word of a POSIX shell; what cannot be seen in it is written as bytes. */
export function shell_quoted(text: string): string {
  if (/^[A-Za-z0-9_./:-]+$/.test(text)) return text;
  if (safe(text) === text) return `'${text.replaceAll("'", "'\\''")}'`;
  const octal = (byte: number) => `\\${byte.toString(8).padStart(3, "0")}`;
  const seen = (byte: number) => byte > 31 && byte < 127 && byte !== 39 && byte !== 92;
  const bytes = [...new TextEncoder().encode(text)];
  return `$'${bytes.map((byte) => (seen(byte) ? String.fromCharCode(byte) : octal(byte))).join("")}'`;
}

/** What each word of the page means, one sentence each. */
export const glossary: Record<string, string> = {
  "#": "The number of a finding in its run, or of a fault.",
  "a pair": "The mean time that one pair took.",
  against: "The build that the answers are held against.",
  answer: "What a method said of the pair.",
  asked: "How many pairs were put to it.",
  "asked on": "Which part of the pairs a method is asked; a slow one gets a random share.",
  "assumed by us": "The library says nothing of its tolerance, so the project has set this one.",
  axis: "The direction of a cylinder's axis; its length does not matter.",
  back: "A cause that was gone in the run before and is seen again.",
  because: "The line of the library that makes the claim, or why we assume it.",
  "beyond claim": "Answers that are wrong by more than the method's own tolerance.",
  "beyond its claim": "Wrong by more than the method's own tolerance: a fault.",
  "beyond the claim": "Of the changed verdicts, those wrong by more than the method's own tolerance.",
  begun: "When the run was started.",
  build: "The compiler and options of the second build.",
  caught: "Faults that at least one test found.",
  cause: "Findings that have one reason, under one name: library, kind, parts that are nearest, what matters.",
  allowed: "How wrong the method may be on this pair: its claim, but never less than what rounding costs.",
  causes: "How many different reasons the findings of this run were put down to; others were seen in earlier runs.",
  centre: "The middle of a cylinder.",
  chance: "How likely so large a change is by luck alone, with allowance for the number of causes.",
  "changes nothing": "Faults of which it is argued that no pair can show them.",
  claim: "How wrong a method may be by its own account.",
  "claims to be": "From which distance on, or with what error, a method says that it is right.",
  "common point": "A certificate: a point that lies in both solids proves that they meet.",
  count: "How many findings the group has.",
  declined: "Pairs that a method would not answer.",
  "direction by": "The largest jump of the direction from one step to the next.",
  disjoint: "The solids have no point in common.",
  "distance jumps by": "The largest jump of the distance from one step to the next, in sizes, beyond the true one.",
  "distances changed": "Pairs of which the two builds give different distances.",
  "double intervals": "The truth was proved in ordinary numbers, rounded outwards.",
  error: "How far the answer is from the proved interval of the distance, at least.",
  core: "A solid without its rounding.",
  "error over claim": "The error as a multiple of what the method claims; above 1 it is beyond its claim.",
  "error over size": "The error divided by the size; the margin of such a finding.",
  failed: "Crashes, hangs and answers that are no answer.",
  family: "The kind of pairs that were drawn, such as nearly parallel axes.",
  fault: "What was changed in our own code.",
  faults: "How many faults we put into our own code.",
  feature: "Which parts of the two solids are nearest to each other: side, rim or cap.",
  file: "Where the fault was put.",
  findings: "Wrong answers, crashes and hangs, one for each method and pair.",
  "first seen": "The first run that has the cause.",
  flips: "How often the verdict changes along the path.",
  from: "The methods that gave this answer; those in red are wrong by their own claim.",
  gone: "A cause that earlier runs have and this one has not.",
  height: "The length of a cylinder along its axis.",
  "held against": "An earlier run, to be compared with this one.",
  intersecting: "The solids have common points, and more than touch.",
  invalid: "The numbers describe no two cylinders.",
  judge: "The part of the referee, or the stored cases, that says what is true.",
  "kept as examples": "Findings that are on this page with their pair and all answers.",
  kind: "What is wrong: the verdict, the distance, the proof offered, or a crash.",
  known: "A cause that earlier runs have too.",
  "known cases now failing": "Pairs stored with their truth of which the referee now says something else.",
  "largest change": "The largest difference of a distance between the two builds.",
  library: "The program that a method belongs to; ours is one.",
  margin:
    "For a wrong distance its error over the size, for other findings the distance between the solids over the size.",
  margins: "From the least to the largest margin of the findings of the cause, as far as it is proved.",
  method: "One way to answer, of some library, with its settings.",
  methods: "The methods that are wrong for this reason.",
  "methods beyond their claim": "Methods that failed or were wrong by more than they allow themselves.",
  missed: "Faults that no test found and that nobody has argued away.",
  "multiple precision": "The truth needed numbers of many digits.",
  new: "A cause that no earlier run has.",
  "ns/pair": "The mean time of one pair, in nanoseconds.",
  "of ours": "How many of our own methods are among them.",
  "pairs judged": "How many pairs of cylinders were put to the methods.",
  pairs: "How many pairs were compared.",
  path: "A row of pairs, each a little different from the last.",
  "per million": "Wrong pairs in a million asked, and where the rate lies with 95 % confidence.",
  "point near both": "A certificate for touching: a point as good as in both, and no gap wider than nothing.",
  "probability of one rate": "How likely counts so different are if the rate were the same in both runs.",
  "proved distance": "The signed distance lies between these two numbers; this is proved.",
  "put into": "The part of our own code that the faults were put into.",
  radius: "Half the width of a cylinder.",
  rounding: "The radius of the ball by which a solid is grown: all points within it of the cylinder, its core.",
  rare: "A cause seen in one of the runs only, which may well be chance.",
  rationals: "The truth needed exact fractions.",
  run: "One night of pairs, methods and answers.",
  seen: "The first and the last run that have the cause.",
  "separating direction": "A certificate: a plane square to it with one solid on each side proves that they are apart.",
  "settled in": "The arithmetic that was needed to prove the truth.",
  severity: "Whether the answer is wrong by more than the method's own claim allows.",
  "share of pairs like it": "How often the methods are wrong on pairs with the same nearest parts and margin.",
  "signed distance": "The gap between the solids, or minus the depth of their overlap.",
  "since earlier runs": "Whether the cause is new, known, back, gone or rare, held against earlier runs.",
  size: "The sum of both radii and both heights.",
  stated: "The claim is the library's own; the line that says so is named.",
  steps: "The number of pairs on the path.",
  text: "Words to look for in all that is shown of a finding or cause; every one must occur.",
  "times its claim": "The error as a multiple of what that method claims.",
  touching: "The solids have common points, but no common inside.",
  truth: "What is proved of the pair.",
  "truth undecided": "Pairs of which nobody could prove what is true.",
  undecided: "Neither yes nor no could be said.",
  "verdicts changed": "Pairs of which the two builds give different verdicts.",
  version: "The version of the method's library.",
  versions: "The versions of the library at the first and the last sight of the cause.",
  "what still matters": "The number of the simplest pair that cannot be changed without losing the fault.",
  "within claim": "Wrong answers that the method's own tolerance allows.",
  "within its claim": "Wrong, but by no more than the method's own tolerance allows.",
  wrong: "Answers of the judge that others have refuted.",
  "wrong pairs": "Pairs on which a method of the cause is wrong.",
  "wrong by": "How far the distance said is from the proved one, at least.",
};
export const about = (label: string): string | undefined => glossary[label.toLowerCase()];
/** Terms by the alphabet. */
export const glossary_entries = () => Object.entries(glossary).sort(([x], [y]) => (x < y ? -1 : 1));

/** Where the share lies with 95 % confidence after k hits in n trials (Wilson); the upper end is 3/n for none. */
export function share_bounds(k: number, n: number): [number, number] {
  if (n === 0) return [0, 1];
  if (k === 0) return [0, Math.min(1, 3 / n)];
  const z = 1.96,
    p = k / n,
    spread = (z * z) / n;
  const middle = (p + spread / 2) / (1 + spread),
    half = (z / (1 + spread)) * Math.sqrt((p * (1 - p)) / n + (z * z) / (4 * n * n));
  return [Math.max(0, middle - half), Math.min(1, middle + half)];
}

export function group_by<T, K>(all: Iterable<T>, key_of: (x: T) => K): Map<K, T[]> {
  const groups = new Map<K, T[]>();
  for (const x of all) {
    const key = key_of(x),
      group = groups.get(key);
    if (group) group.push(x);
    else groups.set(key, [x]);
  }
  return groups;
}

/** A sorted copy; equal ones keep their order. */
export const in_order = <T>(all: readonly T[], by: (x: T, y: T) => number): T[] => [...all].sort(by);
