// SPDX-License-Identifier: MIT
// How bad one answer to one pair is, as a number. `worst` maximises it for one method, and it guides
// the fuzzers.
#pragma once

#include <array>
#include <memory>

#include "base/enum_words.hpp"
#include "oracles/methods/method.hpp"
#include "oracles/referee/referee.hpp"

namespace cyl {

/// The quantity that a search maximises.
enum class Objective : unsigned char {
  margin,     ///< the margin by which a verdict is wrong
  time,       ///< the wall time of a call
  steps,      ///< the steps that a call reports, which are the same on every machine; for the referee, bits
  error,      ///< the error of the distance, divided by the bound that is returned with it, or by the claim
  bound,      ///< the bound of the error of the distance of solids apart, divided by the claim
  undecided,  ///< the distance of an undecided pair, or the radius of a ball in common, divided by the size
};
constexpr auto words_of(Objective) noexcept {
  return std::array{"margin", "time", "steps", "error", "bound", "undecided"};
}

/// How a score is found. A more costly one is worth more.
enum class Effort : unsigned char {
  likely,  ///< the solver, or for `error` an enclosure of the distance: a few us, up to 0.1 ms for an
           ///< enclosure and more of overlapping rods
  proved   ///< the referee
};

struct Badness {
  double value = 0;  ///< 0 if the answer has none, and for `margin` and `time`, which no single answer shows
  bool beyond = false;  ///< beyond the method's promise; for `undecided` and `error` only if that is proved
};

/// Returns how bad an answer is. It is beyond the promise if
/// 1. it exceeds its bound of the error (the value is then an upper bound), or that bound is above the claim,
/// 2. it is undecided beyond rounding,
/// 3. its steps exceed their cap.
Badness badness_of(Objective objective, const Claim& claim, const Pair& pair, const MethodAnswer& answer,
                   Effort effort);

/// Returns the referee's answer, with the bits that it took as `steps`. judge_method() is the referee as a
/// method, for searches for its slowest call.
MethodAnswer answer_of(const Truth& truth);
std::unique_ptr<Method> judge_method();

}  // namespace cyl
