// SPDX-License-Identifier: MIT
// Bounds of f on caps hold at directions drawn from the cap.
#include "oracles/referee/direction_bounds.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "corpus/pairs/families.hpp"
#include "corpus/pairs/pair_io.hpp"
#include "corpus/pairs/random_stream.hpp"

namespace cyl {
namespace {

constexpr std::uint64_t pairs_of_family = 60, directions_of_cap = 30;
constexpr double cap_sines[] = {0.8, 0.4, 0.1, 0.01};

Vec drawn_direction(RandomStream& stream) {
  const Vector3 d = stream.unit_vector();
  return {d.x(), d.y(), d.z()};
}

/// Returns a direction in the cap, more often near its edge.
Vec drawn_in(const Cap& cap, RandomStream& stream) {
  const Vec d = drawn_direction(stream), across = normalized(d - dot(d, cap.center) * cap.center);
  const double sine = 0.999 * cap.sine * std::sqrt(stream.unit());
  return std::sqrt((1 - sine) * (1 + sine)) * cap.center + sine * across;
}

TEST(DirectionBounds, HoldOnTheirCaps) {
  for (const Family& family : families())
    for (std::uint64_t i = 0; i < pairs_of_family; ++i) {
      const Pair pair = family.generate(20261125, i);
      int exponent = 0;
      const SearchPair<double> p = double_pair(pair, exponent);
      if (length(cross(p.axis0, p.axis1)) == 0) continue;
      const DirectionBounds f(p);
      const double error = 2 * bound_error * f.reach();
      RandomStream stream("caps", 1, i);
      for (const double sine : cap_sines) {
        const Cap cap{drawn_direction(stream), std::sqrt((1 - sine) * (1 + sine)), sine};
        const double by_planes = f.bounds(cap, std::numeric_limits<double>::infinity()).below,
                     by_any = f.bounds_by_minimum(cap, cap.center, 1e300, 0).below;
        for (std::uint64_t k = 0; k < directions_of_cap; ++k) {
          const Vec d = drawn_in(cap, stream);
          ASSERT_GE(f.value(d), by_planes - error) << family.name << ' ' << sine << format_pair(pair);
          ASSERT_GE(f.value(d), by_any - error) << family.name << ' ' << sine << format_pair(pair);
        }
      }
    }
}

}  // namespace
}  // namespace cyl
