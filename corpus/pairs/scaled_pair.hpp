// SPDX-License-Identifier: MIT
// A pair made larger or smaller by a power of two.
#pragma once

#include <cmath>
#include <optional>

#include "solver/cylinder.hpp"

namespace cyl {

/// Calls `change` with each length of the pair: the coordinates of the centres, the radii, the heights.
template <class Change>
void for_each_length(Pair& pair, Change change) {
  for (Cylinder* c : {&pair.a, &pair.b}) {
    for (double& x : c->center) change(x);
    change(c->radius);
    change(c->height);
  }
}

/// Returns the pair with all lengths times 2^exponent.
inline Pair scaled(Pair pair, int exponent) {
  for_each_length(pair, [&](double& x) { x = std::ldexp(x, exponent); });
  return pair;
}

/// Returns the same, or nothing where a length would be rounded.
inline std::optional<Pair> scaled_exactly(Pair pair, int exponent) {
  bool exact = true;
  for_each_length(pair, [&](double& x) {
    const double y = std::ldexp(x, exponent);
    exact = exact && std::isfinite(y) && std::ldexp(y, -exponent) == x;
    x = y;
  });
  if (!exact) return {};
  return pair;
}

}  // namespace cyl
