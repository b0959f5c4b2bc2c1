// SPDX-License-Identifier: MIT
// Finds out why a method is wrong on a pair, as far as a few more questions show. The method is asked about
// the pair moved, enlarged and reduced. Its other settings are asked about the pair.
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

/// The reason of a finding. If several apply, find_mechanism() and probe() of mechanism.cpp choose.
enum class Mechanism : unsigned char {
  gone,             ///< not wrong today
  offset,           ///< right if both solids are moved to the origin together
  iteration_cap,    ///< its search ended by its own cap on steps
  underflow,        ///< right at a larger size that is still below 2^-128
  overflow,         ///< right at a smaller size that is still above 2^128
  absolute_length,  ///< right if both solids are made larger or smaller
  rounding,         ///< wrong below rounding_margin, at any size that was tried
  setting,          ///< another setting of the same algorithm is right
  unclassified,     ///< none of these; "unclassified" in files
  model             ///< right about the solids that it models, whose edges it rounds on purpose
};
constexpr auto words_of(Mechanism) noexcept {
  return std::array{"gone",     "offset",  "iteration-cap", "underflow", "overflow", "absolute-length",
                    "rounding", "setting", "unclassified",  "model"};
}

/// Relative to the size. Double computations of some steps leave errors up to this.
inline constexpr double rounding_margin = 1e-12;

/// Returns the same in words: "a fixed length in it: ...".
std::string_view in_words(Mechanism m) noexcept;

/// A pair and the method that is wrong on it.
struct Failing {
  std::size_t method;
  FindingKind kind;
  Pair pair;
};

/// The result of further questions about a failure.
struct Classification {
  Mechanism mechanism = Mechanism::unclassified;
  /// The method that is right with another setting, for any mechanism.
  std::optional<std::size_t> right_sibling;
  bool capped = false;  ///< its search ended by its own cap
  bool right_at_origin = false;
  std::optional<int> smaller, larger;  ///< the method is right with all lengths times 2^this
};

/// Returns whether the other trial fails as the first does: with the same kind, and beyond the claim if that
/// one is. If the library broke, its words must also be the same, except for numbers other than codes.
bool fails_alike(const Trial& failing, const Trial& other);

/// Methods, with the first method of each one's shared-algorithm group (algorithm_groups()).
struct GroupedMethods {
  std::span<const std::unique_ptr<Method>> methods;
  std::span<const std::size_t> groups;
};

/// Returns the classification of a failure. It is a pure function of the failure, except for hangs. Cost: two
/// rounds of some 25 questions. A caller with many failures keeps the asker, because the start of a worker
/// takes longer than the questions.
Classification classify(std::span<const std::unique_ptr<Method>> methods, const Failing& failing,
                        Asker& asker);
/// Finds out whether a failure is the library's own, or depends on the last bit of our adapter's sums. Asks
/// once more, contained, with the sums of our support function in another order. Returns whether this failure
/// is then absent. Returns nothing if the library does not call our support function.
std::optional<bool> depends_on_last_bit(std::string_view method, FindingKind kind, const Pair& pair);

/// Returns the methods of other libraries that share the method's algorithm, as far as their errors show.
std::vector<std::size_t> methods_sharing_algorithm(const GroupedMethods& of, std::size_t method);

/// Returns the key of the cause. Every finding with this cause has the same key, for any pair and any run.
/// `reason` is the method's own words on a failure. Examples:
///   "fcl-libccd/absolute-length"   The mechanism. The first method of the library that shares the algorithm
///                                  stands for all of them.
///   "fcl-libccd/overflow"          Products of lengths leave the doubles.
///   "fcl-libccd/wrong_disjoint"    Only the kind is known, or another setting is right.
///   "fcl-libccd/wrong_disjoint/extreme"   The same for pairs that are not ordinary: is_ordinary().
///   "fcl-libccd/hang"              The call does not end.
///   "ode/crash/..."                A failure of a library, by its own words without numbers.
///   "fcl/within-claim"             Answers of a library that its claims cover. Our own methods: "own".
///   "fcl-libccd/not-again"         The answer was not wrong when the method was asked again.
std::string cause_key(const GroupedMethods& of, const Failing& failing, Severity severity,
                      Mechanism mechanism, std::string_view reason);

/// Returns the key of the cause of one failure, which it classifies first.
std::string find_cause(const GroupedMethods& of, const Failing& failing, Severity severity,
                       std::string_view reason, Asker& asker);

}  // namespace cyl
