// SPDX-License-Identifier: MIT
// Tries workarounds of a failure: other settings of the method, and equivalent forms of the pair.
#pragma once

#include <array>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/enum_words.hpp"
#include "oracles/trial/trial.hpp"

namespace cyl {

enum class Transformation : unsigned char {
  setting,    ///< another setting of the same library and way
  rescaled,   ///< all lengths times the power of two that brings the size to [1, 2)
  at_origin,  ///< both solids moved so that a's centre is the origin; rounded
  exchanged,  ///< a and b exchanged
  unit_axes   ///< axes divided by their lengths; rounded
};
constexpr auto words_of(Transformation) noexcept {
  return std::array{"another setting", "rescaled to size 1", "moved to the origin", "solids exchanged",
                    "axes of unit length"};
}

enum class WorkaroundOutcome : unsigned char {
  right,
  still_fails,
  other_failure,  ///< fails in another way
  no_answer,      ///< declined or undecided
  truth_changed,  ///< its rounding changed the verdict that is true: nothing is learnt
  no_change       ///< the pair is like that already, or cannot be brought there
};
constexpr auto words_of(WorkaroundOutcome) noexcept {
  return std::array{"cured",     "not cured",    "fails otherwise",
                    "no answer", "truth turned", "nothing to change"};
}

struct Workaround {
  Transformation transformation;
  std::string method;  ///< who was asked: for `setting` the sibling, else the method itself
  WorkaroundOutcome outcome;
  Trial after;  ///< meaningless for no_change
};

/// Tries the settings, in the order of `methods`, then each of the others once.
std::vector<Workaround> try_workarounds(std::span<const std::unique_ptr<Method>> methods,
                                        const std::unique_ptr<Method>& method, const Trial& failing);

}  // namespace cyl
