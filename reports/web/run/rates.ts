// SPDX-License-Identifier: MIT
// Whether two counts can come from one rate.

/** ln of the gamma function: Stirling's series, from 12 on; below by x * gamma(x) = gamma(x + 1). */
export function log_gamma(x: number): number {
  let shift = 0;
  for (; x < 12; ++x) shift += Math.log(x);
  const r = 1 / (x * x);
  const series = (1 / 12 - r * (1 / 360 - r * (1 / 1260 - r * (1 / 1680 - r / 1188)))) / x;
  return (x - 0.5) * Math.log(x) - x + 0.5 * Math.log(2 * Math.PI) + series - shift;
}

/** The probability of counts at least as unlikely as k0 of n0 and k1 of n1 if both have one rate: given k0 + k1 in
 *  all, the first is binomial with the share n0 / (n0 + n1). null where nothing was asked. */
export function same_rate_probability(k0: number, n0: number, k1: number, n1: number): number | null {
  if (n0 <= 0 || n1 <= 0) return null;
  const k = k0 + k1,
    [p, q] = [Math.log(n0 / (n0 + n1)), Math.log(n1 / (n0 + n1))],
    all = log_gamma(k + 1);
  const log_of = (i: number) => all - log_gamma(i + 1) - log_gamma(k - i + 1) + i * p + (k - i) * q;
  const seen = log_of(k0) + 1e-9; // ties are as unlikely
  let sum = 0;
  for (let i = 0; i <= k; ++i) {
    const log = log_of(i);
    if (log <= seen) sum += Math.exp(log);
  }
  return Math.min(1, sum);
}
