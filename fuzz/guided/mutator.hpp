// SPDX-License-Identifier: MIT
// Changes to a pair that a geometer would make: towards the places where solvers break. Plain functions of a
// pair and a stream; what they make of a legal pair is legal, or the pair itself.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "corpus/pairs/random_stream.hpp"
#include "solver/cylinder.hpp"

namespace cyl {

struct Move {
  std::string_view name;  ///< "slide_to_touching"
  void (*apply)(Pair& pair, RandomStream& stream);
};

std::span<const Move> moves();

/// One to three moves, drawn by `seed`; a pair that is not legal is made legal first.
Pair mutate(const Pair& pair, std::uint64_t seed);

/// One solid of each parent; now and then the second is brought to touch the first.
Pair cross_over(const Pair& x, const Pair& y, std::uint64_t seed);

}  // namespace cyl
