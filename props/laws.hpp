// SPDX-License-Identifier: MIT
// The laws: relations between a method's answers that must hold, whoever is right. They need no oracle. Those
// here are exact: bit for bit, no tolerance.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "oracles/method.hpp"
#include "solver/cylinder.hpp"

namespace cyl {

/// How far two answers must agree.
enum class Agreement : unsigned char {
  verdict,   ///< the distance and the witness may be others
  every_bit  ///< but for the sign of zero, and for bits lost to underflow
};

/// every_bit of `intersect` and `decide`, the verdict of any other method: theirs may come out of a search.
Agreement promised(const Method& method);

struct Law {
  int number;                  ///< kept for good: a number is never given to another law
  std::string_view name;       ///< "swap"
  std::string_view statement;  ///< what must hold
  /// What broke, or empty where the law holds for this pair or says nothing of it. Says nothing where the
  /// method declines or fails. Throws only what `ask` throws.
  std::string (*broken)(Method& method, const Pair& pair, Agreement agreement);
};

/// Laws that hold exactly, by increasing number.
std::span<const Law> exact_laws();

}  // namespace cyl
