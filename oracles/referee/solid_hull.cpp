// SPDX-License-Identifier: MIT
#include "oracles/referee/solid_hull.hpp"

#include <algorithm>
#include <array>

#include "corpus/pairs/pair_numbers.hpp"

namespace cyl {

Hull own_hull(const Solid& c) {
  if (is_half_space(c)) return Hull::space;
  if (is_box(c)) {
    constexpr std::array hulls{Hull::space, Hull::plane, Hull::line, Hull::center};
    return hulls[static_cast<std::size_t>(std::ranges::count(c.edges, 0.0))];
  }
  return both(c.height == 0 ? Hull::plane : Hull::space, c.radius == 0 ? Hull::line : Hull::space);
}

Hull hull_within(const Solid& c, Hull named) { return is_box(c) ? own_hull(c) : both(own_hull(c), named); }

std::size_t hull_edge(const Solid& box) {
  const bool plane = own_hull(box) == Hull::plane;
  for (std::size_t i = 0; i < 2; ++i)
    if ((box.edges[i] == 0) == plane) return i;
  return 2;
}

Rational3 hull_axis(const Solid& c) {
  return is_box(c) ? edge_directions<mpq_class>(c.quaternion)[hull_edge(c)] : exact(c.axis);
}

}  // namespace cyl
