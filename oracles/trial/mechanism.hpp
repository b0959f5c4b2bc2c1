// SPDX-License-Identifier: MIT
// Why a method is wrong on a pair, as far as a few more questions tell: the pair moved, made larger and
// smaller, put to the method's other settings.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/enum_words.hpp"
#include "oracles/methods/contained.hpp"
#include "oracles/trial/compare.hpp"

namespace cyl {

/// The first that applies, in this order.
enum class Mechanism : unsigned char {
  gone,             ///< not wrong today
  offset,           ///< right where both solids are moved to the origin together
  iteration_cap,    ///< its search ended by its own cap on steps
  underflow,        ///< right at an ordinary size; the size is below 2^-200
  overflow,         ///< the same above 2^200
  absolute_length,  ///< right where both solids are made larger or smaller, by up to 2^200
  rounding,         ///< wrong below rounding_margin, at any size
  setting,          ///< another setting of the same algorithm is right
  untold            ///< none of these
};
constexpr auto words_of(Mechanism) noexcept {
  return std::array{"gone",     "offset",  "iteration-cap", "underflow", "overflow", "absolute-length",
                    "rounding", "setting", "untold"};
}

/// In sizes: errors no larger are what double computations of some steps leave.
inline constexpr double rounding_margin = 1e-12;

/// The same for people: "a fixed length in it: ...".
std::string_view in_words(Mechanism m) noexcept;

/// A pair and the method that is wrong on it.
struct Failing {
  std::size_t method;
  FindingKind kind;
  Pair pair;
};

struct Told {
  Mechanism mechanism = Mechanism::untold;
  /// The method that is right with another setting, whatever the mechanism.
  std::optional<std::size_t> right_sibling;
  bool capped = false;         ///< its search ended by its own cap
  bool larger_cures = false;   ///< right where the pair is made larger,
  bool smaller_cures = false;  ///< smaller; the order of the mechanisms notwithstanding
  bool moving_cures = false;
};

/// An answer, and what is wrong with it, if anything is.
struct Examination {
  MethodAnswer answer;
  std::optional<Finding> wrong;
};

/// The mechanism of each. `kin`: as kin_of() gives it. A pure function of each, hangs excepted. Cost: four
/// rounds of questions for all together.
std::vector<Told> tell_mechanisms(std::span<const std::unique_ptr<Method>> methods,
                                  std::span<const std::size_t> kin, std::span<const Failing> failing,
                                  const Caps& caps);

/// The key of the cause: the same for every finding that has it, whatever the pair, the run or the night.
///   "fcl-libccd/absolute-length"   what was told; the first of the method's kin stands for all of them
///   "fcl-libccd/wrong_disjoint"    nothing was told but the kind, or that another setting is right
///   "overflow", "underflow"        whose products of lengths leave the doubles: wrong on the same pairs
///   "fcl-libccd/hang"              it does not come to an end
///   "ode/crash/..."                a failure of a library, by its own words without numbers
///   "fcl/within-claim"             a library's answers that its claims allow; "own" of those not foreign
///   "fcl-libccd/not-again"         not wrong when asked again
/// `reason`: the method's own words on a failure.
std::string cause_key(std::span<const std::unique_ptr<Method>> methods, std::span<const std::size_t> kin,
                      std::size_t method, FindingKind kind, Severity severity, const Told& told,
                      std::string_view reason);

}  // namespace cyl
