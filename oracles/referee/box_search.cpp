// SPDX-License-Identifier: MIT
#include "oracles/referee/box_search.hpp"

#include <algorithm>

#include "corpus/pairs/pair_numbers.hpp"

namespace cyl {

TermsPair<double> double_terms(const Pair& pair, int& exponent) {
  const auto most_of = [](const Solid& c) {
    return std::max({c.radius, c.height, c.rounding, c.edges[0], c.edges[1], c.edges[2]});
  };
  // Half the difference of the centres does not overflow. Subnormal pairs are scaled up before it is rounded.
  double most = std::max(most_of(pair.a), most_of(pair.b));
  most = std::max({most, pair.a.center.lpNorm<Eigen::Infinity>(), pair.b.center.lpNorm<Eigen::Infinity>()});
  const int lift = most < 0x1p-900 ? 200 : 0;
  Vec3<double> half;
  double* const to[3] = {&half.x, &half.y, &half.z};
  for (int i = 0; i < 3; ++i)
    *to[i] = std::ldexp(pair.b.center[i], lift - 1) - std::ldexp(pair.a.center[i], lift - 1);
  const double longest = std::max({std::ldexp(std::max(most_of(pair.a), most_of(pair.b)), lift - 1),
                                   std::fabs(half.x), std::fabs(half.y), std::fabs(half.z)});
  const int above = longest > 0 ? std::ilogb(longest) : 0;
  exponent = above - lift + 1;
  const Pair unit = scaled(pair, -exponent);
  return {terms_of<double>(unit.a),
          terms_of<double>(unit.b),
          {std::ldexp(half.x, -above), std::ldexp(half.y, -above), std::ldexp(half.z, -above)}};
}

}  // namespace cyl
