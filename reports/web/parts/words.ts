// SPDX-License-Identifier: MIT
// Numbers and names as people read them.

/** Made once: toLocaleString() would make one for each number. */
const inGroups = new Intl.NumberFormat("en-US");
export const grouped = (n: number) => inGroups.format(Math.round(n));

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

/** Text from anywhere. Characters that reorder or hide the text around them are shown as escapes. */
export function safe(text: string): string {
  return text.replace(
    /[\u0000-\u0008\u000b-\u001f\u007f-\u009f\u200b-\u200f\u2028-\u202e\u2060-\u2069\ufeff]/g,
    (c) => "\\u" + c.charCodeAt(0).toString(16).padStart(4, "0"),
  );
}

const exponent = (text: string) => text.replace("e+0", "").replace("e+", "e");
/** The shortest decimal that is this double. It is in exponent form if it has more than 12 digits, and people do not
 *  read such a size as it is. */
export function full(x: number): string {
  if (Object.is(x, -0)) return "-0";
  const text = String(x);
  const readable = Math.abs(x) >= 1e-3 && Math.abs(x) < 1e5;
  const long = text.replace(/[^0-9]/g, "").length > 12 && !text.includes("e");
  return long && !readable ? exponent(x.toExponential()) : text;
}
/** One word of a POSIX shell. Characters that cannot be seen are written as bytes. */
export function shellQuoted(text: string): string {
  if (/^[A-Za-z0-9_./:-]+$/.test(text)) return text;
  if (safe(text) === text) return `'${text.replaceAll("'", "'\\''")}'`;
  const octal = (byte: number) => `\\${byte.toString(8).padStart(3, "0")}`;
  const seen = (byte: number) => byte > 31 && byte < 127 && byte !== 39 && byte !== 92;
  const bytes = [...new TextEncoder().encode(text)];
  return `$'${bytes.map((byte) => (seen(byte) ? String.fromCharCode(byte) : octal(byte))).join("")}'`;
}

/** The bounds of the share with 95 % confidence after k hits in n trials (Wilson); the upper end is 3/n for none. */
export function shareBounds(k: number, n: number): [number, number] {
  if (n === 0) return [0, 1];
  if (k === 0) return [0, Math.min(1, 3 / n)];
  const z = 1.96,
    p = k / n,
    spread = (z * z) / n;
  const middle = (p + spread / 2) / (1 + spread),
    half = (z / (1 + spread)) * Math.sqrt((p * (1 - p)) / n + (z * z) / (4 * n * n));
  return [Math.max(0, middle - half), Math.min(1, middle + half)];
}
