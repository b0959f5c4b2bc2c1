// SPDX-License-Identifier: MIT
// Searches for the worst pair of one method: the largest proved error beyond its claim. From given pairs it
// walks through shapes (fuzz/worst/pair_chart.hpp). For each shape it asks about pairs on its ray. The
// optimiser gets how far the method stays wrong. Only proved errors count.
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
#include "fuzz/worst/pair_chart.hpp"
#include "oracles/methods/contained.hpp"
#include "oracles/methods/method.hpp"
#include "oracles/trial/compare.hpp"

namespace cyl {

/// The quantity that a search maximises.
enum class Objective : unsigned char {
  margin,  ///< the margin by which a verdict is wrong
  error    ///< the error of the distance, divided by the bound that is returned with it, or by the claim
};
constexpr auto words_of(Objective) noexcept { return std::array{"margin", "error"}; }

/// The pairs that count: these features meet, the verdict is wrong in this way, and `also` is true, as far as
/// they are given. `also` is called only for the few pairs that would be the worst so far. It may cost some
/// milliseconds.
struct Sought {
  std::optional<ContactFeature> feature = {};
  std::function<bool(const Pair&)> also = {};
  std::optional<FindingKind> kind = {};
};

struct WorstOptions {
  Objective objective = Objective::margin;
  std::uint64_t seed = 1;
  /// Shapes looked at, about a hundred questions each: the limit that gives the same result again.
  std::size_t evaluation_cap = std::numeric_limits<std::size_t>::max();
  std::chrono::milliseconds budget = std::chrono::hours(24);  ///< wall time
  Domain domain;
};

/// A verdict that is refuted.
struct WrongPair {
  Pair pair;
  Verdict truth;
  Finding finding;  ///< wrong_disjoint, wrong_intersecting or wrong_touching, with its margin
};

/// A crash, a hang, an exception or no number: not asked about again.
struct FailedPair {
  Pair pair;
  Failure failure;
  std::string reason;
};

/// The score is the error over its bound, at most.
struct ScoredPair {
  Pair pair;
  double score;
  bool beyond;  ///< the error is proved to be beyond its bound
};

struct Worst {
  /// For Objective::margin: the pair with the largest margin beyond the claim. If there is none, the pair
  /// nearest to the claim.
  std::optional<WrongPair> wrong;
  std::optional<FailedPair> failed;  ///< the first of the worst kind: crash, hang, others
  std::optional<ScoredPair> scored;  ///< of Objective::error
  std::size_t evaluations = 0, questions = 0;

  /// Returns whether something beyond the method's claim was found: all failures are.
  bool beyond_claim() const;
};

/// Called now and then, with what was found so far.
using OnWorst = std::function<void(const Worst& so_far, std::chrono::milliseconds elapsed)>;

/// A foreign `method` is asked in a contained process. Starts are examined in their order, those with the
/// wanted features first. The walks begin at the worst of them. While the method is right on all, mutations
/// of them are examined. Cost: a millisecond a shape for a fast method. With a limit on evaluations the
/// result is a pure function of the arguments, except for hangs.
Worst worst_of(const std::unique_ptr<Method>& method, std::span<const Pair> starts, const Sought& sought,
               const WorstOptions& options, const OnWorst& on_worst = {});

/// Pairs to start from without earlier findings: nearly touching pairs of that stratum, or of every stratum.
/// For Objective::error they are close contacts of all positions and angles (corpus/pairs/close_contact.hpp),
/// at which solvers like ours are worst. Some pairs of every family follow.
std::vector<Pair> drawn_starts(std::optional<ContactFeature> feature, std::uint64_t seed,
                               Objective objective = Objective::margin);

/// Pairs with a box that the method supports, of every family.
std::vector<Pair> drawn_box_starts(const Method& method, std::uint64_t seed);

}  // namespace cyl
