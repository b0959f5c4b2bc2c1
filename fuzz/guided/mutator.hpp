// SPDX-License-Identifier: MIT
// Geometric changes of a pair, towards places at which solvers fail. These are plain functions of a pair and
// a stream. From a valid pair they make a valid pair, or return it unchanged.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "corpus/pairs/random_stream.hpp"
#include "solver/solid.hpp"

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
