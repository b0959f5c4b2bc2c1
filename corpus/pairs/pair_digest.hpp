// SPDX-License-Identifier: MIT
// A short name for the numbers of a pair.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "base/fnv.hpp"
#include "corpus/pairs/pair_numbers.hpp"

namespace cyl {

/// Returns a digest of the pair's numbers to the bit, after what went before. Roundings and shapes
/// count if one is not 0 or not a cylinder, edges and quaternions count for boxes.
inline std::uint64_t digest_of(const Pair& p, std::uint64_t so_far) noexcept {
  const auto add = [&](const auto& numbers) {
    so_far = fnv1a({reinterpret_cast<const char*>(numbers.data()), sizeof numbers}, so_far);
  };
  for (const Solid* s : {&p.a, &p.b}) {
    std::array<double, core_number_count> core;
    std::ranges::copy_n(numbers_of(*s).begin(), core.size(), core.begin());
    add(core);
  }
  if (is_rounded(p)) add(std::array{p.a.rounding, p.b.rounding});
  if (p.a.shape != Shape::cylinder || p.b.shape != Shape::cylinder) add(std::array{p.a.shape, p.b.shape});
  for (const Solid* s : {&p.a, &p.b}) {
    if (!is_box(*s)) continue;
    add(s->edges);
    add(s->quaternion);
  }
  return so_far;
}

}  // namespace cyl
