// SPDX-License-Identifier: MIT
// Searches for the worst pair of one method: the largest proved error beyond its claim. From given pairs it
// walks through shapes (fuzz/worst/shapes.hpp). For each shape it asks about pairs on its ray. A walk goes on
// from a shape on which the method is worse. Only proved errors count.
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/enum_words.hpp"
#include "corpus/pairs/finding.hpp"
#include "corpus/pairs/stratum.hpp"
#include "oracles/methods/method.hpp"

namespace cyl {

/// The quantity that a search maximises.
enum class Objective : unsigned char {
  margin,  ///< the margin by which a verdict is wrong
  error    ///< the error of the distance, divided by the bound that is returned with it, or by the claim
};
constexpr auto words_of(Objective) noexcept { return std::array{"margin", "error"}; }

struct WorstOptions {
  Objective objective = Objective::margin;
  std::optional<ContactFeature> feature = {};  ///< only pairs on which these features meet count
  std::uint64_t seed = 1;
  /// Shapes looked at, about a hundred questions each: the limit that gives the same result again.
  std::size_t evaluation_cap = std::numeric_limits<std::size_t>::max();
  std::chrono::milliseconds budget = std::chrono::hours(24);  ///< wall time
};

struct WorstPair {
  Pair pair;
  FindingKind kind;
  Severity severity;
  /// The proved margin of a wrong verdict. The error of a distance over its bound: a proved one beyond the
  /// bound, else an upper limit of it that is 1 at most. 0 of a failure.
  double score = 0;
  std::string reason = {};  ///< of a failure
};

struct Worst {
  /// The pair with the largest score beyond the claim. If there is none, the pair nearest to the claim.
  std::optional<WorstPair> worst;
  std::optional<WorstPair> failed;  ///< the first of the worst kind: crash, hang, others
  std::size_t evaluations = 0, questions = 0;

  /// Returns whether something beyond the method's claim was found: all failures are.
  bool beyond_claim() const { return failed || (worst && worst->severity == Severity::contract); }
};

/// Called now and then, with what was found so far.
using OnWorst = std::function<void(const Worst& so_far)>;

/// A foreign `method` is asked in a contained process. Starts are examined in their order, those with the
/// wanted feature first. The walks begin at the worst of them. While the method is right on all, mutations
/// of them are examined. Cost: a millisecond a shape for a fast method. With a limit on evaluations the
/// result is a pure function of the arguments, except for hangs.
Worst worst_of(const std::unique_ptr<Method>& method, std::span<const Pair> starts,
               const WorstOptions& options, const OnWorst& on_worst = {});

/// Pairs to start from without earlier findings: nearly touching pairs of that feature, or of every feature.
/// For Objective::error they are close contacts of all positions and angles (corpus/pairs/close_contact.hpp),
/// at which solvers like ours are worst. Some pairs of every family that the method supports follow.
std::vector<Pair> drawn_starts(const Method& method, const WorstOptions& options);

}  // namespace cyl
