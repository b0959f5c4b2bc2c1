// SPDX-License-Identifier: MIT
// How bad an answer is: a number of one answer to one pair. `worst` makes the most of it for one method, the
// family `climbed` for our own calls, and the fuzzers are guided by it.
#pragma once

#include <array>
#include <memory>

#include "base/enum_words.hpp"
#include "oracles/methods/method.hpp"
#include "oracles/referee/referee.hpp"

namespace cyl {

/// What is sought: the most of it.
enum class Objective : unsigned char {
  margin,     ///< by which a verdict is wrong
  time,       ///< of a call, by the clock
  steps,      ///< that a call reports: the same on every machine; of the referee, bits
  error,      ///< of the distance, over the bound that is returned with it, or claimed
  bound,      ///< of the error of the distance of solids apart, over the claim
  undecided,  ///< the distance, or the radius of a ball in common, over the size, of a pair left undecided
};
constexpr auto words_of(Objective) noexcept {
  return std::array{"margin", "time", "steps", "error", "bound", "undecided"};
}

/// By which means a score is found: its cost, and what it is worth.
enum class Effort : unsigned char {
  quick,   ///< one call of the solver: what is undecided may count for more
  likely,  ///< the solver, or for `error` an enclosure of the distance: a few us, up to 0.1 ms for an
           ///< enclosure and more of overlapping rods
  proved   ///< the referee
};

struct Badness {
  double value = 0;  ///< 0 if the answer has none, and of `margin` and `time`, which no single answer shows
  bool beyond = false;  ///< more than the method promises: of `undecided` and `error` only if that is proved
};

/// Returns how bad an answer is. Beyond the promise are a bound of the error that is exceeded (the value is
/// what it is at most), or above the claim; undecided beyond rounding; steps beyond their cap.
Badness badness_of(Objective objective, const Claim& claim, const Pair& pair, const MethodAnswer& answer,
                   Effort effort);

/// Returns what the referee answers, `steps` being the bits it took; and the referee as a method, for
/// searches for its slowest call.
MethodAnswer answer_of(const Truth& truth);
std::unique_ptr<Method> judge_method();

}  // namespace cyl
