// SPDX-License-Identifier: MIT
// What the solver says of a pair, as doubles in a row: how the pages ask it in WebAssembly, and how a test
// compares that with the native solver. parts/solver.ts has the same lists.
#pragma once

#include <cstddef>

namespace cyl {

/// Of a, then of b: center, axis, radius, height, rounding.
inline constexpr std::size_t question_size = 18;
/// intersect(): verdict. decide(): verdict, proof, both hulls, iterations, direction, point_head, point_tail.
/// distance(): verdict, value, error, least, iterations, direction, on_a, on_b. Enums are their numbers.
inline constexpr std::size_t answers_size = 29;

void answer_all(const double* question, double* answers) noexcept;

}  // namespace cyl
