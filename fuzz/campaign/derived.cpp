// SPDX-License-Identifier: MIT
#include "fuzz/campaign/derived.hpp"

#include <cmath>

#include "corpus/pairs/close_contact.hpp"
#include "corpus/pairs/pair_numbers.hpp"
#include "corpus/pairs/random_stream.hpp"
#include "solver/distance.hpp"

namespace cyl {
namespace {

Pair derived(std::uint64_t seed, std::uint64_t index) {
  RandomStream s("derived", seed, index);
  const auto kind = enum_values<CloseKind>[s.below(enum_values<CloseKind>.size())];
  const std::uint64_t number = s.bits() >> 32;
  Pair pair = draw_close_contact(kind, s, number).pair;
  for (std::size_t times = 1 + s.below(3); times > 0; --times) {
    const Feedback what = enum_values<Feedback>[s.below(enum_values<Feedback>.size())];
    if (const auto next = fed_back(what, pair)) pair = *next;
  }
  return pair;
}

}  // namespace

std::optional<Pair> fed_back(Feedback what, const Pair& pair) {
  const Distance d = distance(pair.a, pair.b);
  if (d.verdict == Verdict::invalid) return {};
  Pair next = pair;
  switch (what) {
    case Feedback::into_contact:
      next.b.center -= d.value * d.direction;
      break;
    case Feedback::to_the_other_side:
      next.b.center -= 2 * d.value * d.direction;
      break;
    case Feedback::onto_the_point:
      next.b.center = pair.a.center + d.on_a;
      break;
    case Feedback::points_together:
      next.b.center = pair.a.center + d.on_a - d.on_b;
      break;
    case Feedback::axis_along_normal:
      next.b.axis = d.direction;
      break;
    case Feedback::length_of_distance:
      (d.value > 0 ? next.a.radius : next.b.height) = std::abs(d.value);
      break;
  }
  return is_legal(next) ? std::optional(next) : std::nullopt;
}

const Family& derived_family() {
  static constexpr Family family{"derived", "made of distance()'s own points, normals and depths", derived};
  return family;
}

}  // namespace cyl
