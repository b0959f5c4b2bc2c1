// SPDX-License-Identifier: MIT
#include "oracles/referee/box_search.hpp"

#include <algorithm>

#include "corpus/pairs/pair_numbers.hpp"
#include "oracles/referee/twin_interval.hpp"

namespace cyl {

template <class R>
TermsPair<R> terms_in_unit(const Pair& pair, int& exponent) {
  double most = 0;
  for (const Solid* c : {&pair.a, &pair.b})
    most = std::max({most, c->radius, c->height, c->rounding, c->edges[0], c->edges[1], c->edges[2]});
  exponent = std::max(-1080, std::ilogb(most));  // of 0, if all is in one point
  Twin way[3];
  int shift[3];
  for (int i = 0; i < 3; ++i) {
    const double from = pair.a.center[i], to = pair.b.center[i];
    shift[i] = std::max(std::fabs(from), std::fabs(to)) > 0x1p1000 ? 1 : 0;  // halves do not overflow
    way[i] = Twin::sum_of(std::ldexp(to, -shift[i]), -std::ldexp(from, -shift[i]));
    if (way[i].hi != 0) exponent = std::max(exponent, std::ilogb(way[i].hi) + shift[i]);
  }
  Pair unit = scaled(pair, -exponent);
  const auto even = [](auto& v) {
    const double longest = std::max(std::ranges::max(v), -std::ranges::min(v));
    for (const int power = -std::ilogb(longest); double& x : v) x = std::scalbn(x, power);
  };
  for (Solid* c : {&unit.a, &unit.b}) is_box(*c) ? even(c->quaternion) : even(c->axis);
  const auto part = [&](int i) {
    const int by = shift[i] - exponent;
    return R(std::ldexp(way[i].hi, by)) + R(std::ldexp(way[i].lo, by));
  };
  return {terms_of<R>(unit.a), terms_of<R>(unit.b), {part(0), part(1), part(2)}};
}

template TermsPair<double> terms_in_unit(const Pair&, int&);
template TermsPair<Twin> terms_in_unit(const Pair&, int&);

}  // namespace cyl
