// SPDX-License-Identifier: MIT
// Whether two counts can come from one rate.

/** ln of the gamma function: Stirling's series, from 12 on; below by x * gamma(x) = gamma(x + 1). */
export function logGamma(x: number): number {
  let shift = 0;
  for (; x < 12; ++x) shift += Math.log(x);
  const r = 1 / (x * x);
  const series = (1 / 12 - r * (1 / 360 - r * (1 / 1260 - r * (1 / 1680 - r / 1188)))) / x;
  return (x - 0.5) * Math.log(x) - x + 0.5 * Math.log(2 * Math.PI) + series - shift;
}

/** The probability of counts at least as unlikely as k0 of n0 and k1 of n1 if both have one rate: given k0 + k1 in
 *  all, the first is binomial with the share n0 / (n0 + n1). null where nothing was asked. */
export function sameRateProbability(k0: number, n0: number, k1: number, n1: number): number | null {
  if (n0 <= 0 || n1 <= 0) return null;
  const k = k0 + k1,
    [p, q] = [Math.log(n0 / (n0 + n1)), Math.log(n1 / (n0 + n1))],
    all = logGamma(k + 1);
  const logOf = (i: number) => all - logGamma(i + 1) - logGamma(k - i + 1) + i * p + (k - i) * q;
  const seen = logOf(k0) + 1e-9; // ties are as unlikely
  let sum = 0;
  for (let i = 0; i <= k; ++i) {
    const log = logOf(i);
    if (log <= seen) sum += Math.exp(log);
  }
  return Math.min(1, sum);
}
