// SPDX-License-Identifier: MIT
// Why a method is wrong on a pair, as far as a few more questions tell: it is asked about the pair moved,
// made larger and smaller, and its other settings are asked about the pair.
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

struct Trial;

/// The first that applies, in this order.
enum class Mechanism : unsigned char {
  gone,             ///< not wrong today
  offset,           ///< right where both solids are moved to the origin together
  iteration_cap,    ///< its search ended by its own cap on steps
  underflow,        ///< right at a larger size, which is below 2^-128 all the same
  overflow,         ///< right at a smaller size, which is above 2^128 all the same
  absolute_length,  ///< right where both solids are made larger or smaller
  rounding,         ///< wrong below rounding_margin, at any size that was tried
  setting,          ///< another setting of the same algorithm is right
  unclassified,     ///< none of these
  model  ///< right about the solids that it models, whose edges it rounds on purpose; before all others
};
constexpr auto words_of(Mechanism) noexcept {
  return std::array{"gone",     "offset",  "iteration-cap", "underflow", "overflow", "absolute-length",
                    "rounding", "setting", "untold",        "model"};
}

/// Relative to the size: errors no larger are what double computations of some steps leave.
inline constexpr double rounding_margin = 1e-12;

/// The same for people: "a fixed length in it: ...".
std::string_view in_words(Mechanism m) noexcept;

/// A pair and the method that is wrong on it.
struct Failing {
  std::size_t method;
  FindingKind kind;
  Pair pair;
};

/// All lengths times 2^wrong: not right; times 2^right: right. `right` is the nearest that was seen.
struct ScaleCure {
  int wrong, right;
};

/// What further questions told of a failure.
struct Classification {
  Mechanism mechanism = Mechanism::unclassified;
  /// The method that is right with another setting, whatever the mechanism.
  std::optional<std::size_t> right_sibling;
  bool capped = false;  ///< its search ended by its own cap
  bool right_at_origin = false;
  Pair base;                                 ///< the pair, at the origin where it fails there too
  std::optional<ScaleCure> smaller, larger;  ///< of that
};

/// Returns whether the method is right on the pair of `after`, which is the failing one changed so that its
/// truth stays: that it fails otherwise, or does not answer, cures nothing. A distance must be right by the
/// claim, and off by half as much at most, relative to the size. Both are trials of one method.
bool cures(const Trial& failing, Trial& after);

/// Returns whether the other fails as the first does: in the same kind, and where it broke, by the same words
/// but for numbers that are no codes.
bool fails_alike(const Trial& failing, const Trial& other);

/// "right once scaled down to a size of 12 (..), wrong at a size of 24 (..)"; empty where no scale cures it.
std::string scale_in_words(const Classification& found, const Trial& failing);

/// Methods, and for each the first of those that share its algorithm (algorithm_groups()).
struct GroupedMethods {
  std::span<const std::unique_ptr<Method>> methods;
  std::span<const std::size_t> groups;
};

/// Returns the classification of each failure, a pure function of it, hangs excepted. Cost: two rounds of
/// some 25 questions a failure for all together, in one worker, or in those of an asker of all methods.
std::vector<Classification> classify(std::span<const std::unique_ptr<Method>> methods,
                                     std::span<const Failing> failing, const Caps& caps);
std::vector<Classification> classify(std::span<const std::unique_ptr<Method>> methods,
                                     std::span<const Failing> failing, Asker& asker);
/// Returns the same of one, with the two ends of each cure by scale neighbours: some 40 questions more.
Classification classify_closely(std::span<const std::unique_ptr<Method>> methods, const Failing& failing,
                                const Caps& caps);

/// Returns the methods of other libraries that share the method's algorithm, as far as their errors tell.
std::vector<std::size_t> methods_sharing_algorithm(const GroupedMethods& of, std::size_t method);

/// Returns the key of the cause: the same for every finding that has it, whatever the pair or the run.
///   "fcl-libccd/absolute-length"   the mechanism; the first of the library's that share the algorithm
///                                  stands for all of them
///   "fcl-libccd/overflow"          products of lengths leave the doubles
///   "fcl-libccd/wrong_disjoint"    no more is known than the kind, or that another setting is right
///   "fcl-libccd/hang"              it does not come to an end
///   "ode/crash/..."                a failure of a library, by its own words without numbers
///   "fcl/within-claim"             a library's answers that its claims allow; "own" of those not foreign
///   "fcl-libccd/not-again"         not wrong when asked again
/// `reason`: the method's own words on a failure.
std::string cause_key(const GroupedMethods& of, std::size_t method, FindingKind kind, Severity severity,
                      Mechanism mechanism, std::string_view reason);

/// Returns the key of the cause of one failure, classified beforehand. Whoever has many to find keeps the
/// asker: to start a worker takes longer than the questions.
std::string find_cause(const GroupedMethods& of, const Failing& failing, Severity severity,
                       std::string_view reason, Asker& asker);

}  // namespace cyl
