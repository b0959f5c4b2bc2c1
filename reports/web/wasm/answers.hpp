// SPDX-License-Identifier: MIT
// The solver's answers to a pair, as doubles in a row. The pages get them from WebAssembly in this form. A
// test compares them with those of the native solver. parts/solver.ts has the same lists.
#pragma once

#include <cstddef>

namespace cyl {

/// The numbers of a, then of b: center, axis, radius, height, rounding.
inline constexpr std::size_t question_size = 18;
/// * intersect(): verdict.
/// * decide(): verdict, proof, both hulls, iterations, direction, point_head, point_tail.
/// * distance(): verdict, value, error, least, iterations, direction, on_a, on_b.
/// Enums are their numbers.
inline constexpr std::size_t answers_size = 29;

void answer_all(const double* question, double* answers) noexcept;

}  // namespace cyl
