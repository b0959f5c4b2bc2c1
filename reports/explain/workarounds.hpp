// SPDX-License-Identifier: MIT
// What cures a failure: the method's own other settings, and the same pair put to it in other words.
#pragma once

#include <array>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/enum_words.hpp"
#include "oracles/trial/probe.hpp"

namespace cyl {

enum class Remedy : unsigned char {
  setting,    ///< another setting of the same library and way
  rescaled,   ///< all lengths times the power of two that brings the size to [1, 2)
  at_origin,  ///< both solids moved so that a's centre is the origin; rounded
  exchanged,  ///< a and b exchanged
  unit_axes   ///< axes divided by their lengths; rounded
};
constexpr auto words_of(Remedy) noexcept {
  return std::array{"another setting", "rescaled to size 1", "moved to the origin", "solids exchanged",
                    "axes of unit length"};
}

enum class Effect : unsigned char {
  cured,
  not_cured,
  other_failure,  ///< fails in another way
  no_answer,      ///< declined or undecided
  truth_turned,   ///< the rounding of the remedy turned the verdict that is true: nothing is learnt
  no_change       ///< the pair is like that already, or cannot be brought there
};
constexpr auto words_of(Effect) noexcept {
  return std::array{"cured",     "not cured",    "fails otherwise",
                    "no answer", "truth turned", "nothing to change"};
}

struct Cure {
  Remedy remedy;
  std::string method;  ///< who was asked: for `setting` the sibling, else the method itself
  Effect effect;
  Probe after;  ///< meaningless for no_change
};

/// The settings, in the order of `methods`, then each of the others once.
std::vector<Cure> try_cures(std::span<const std::unique_ptr<Method>> methods,
                            const std::unique_ptr<Method>& method, const Probe& failing);

}  // namespace cyl
