// SPDX-License-Identifier: MIT
// The search for the worst pair of one method: refuted as far beyond its claim, or answered as slowly, as the
// search can find. From pairs that are given it walks through shapes (fuzz/worst/pair_chart.hpp) by NLopt.
// For each shape the solids are brought to touch and then moved apart and into each other along the direction
// of their distance: how far the method stays wrong is what the optimiser is told. Only what the referee
// proves counts.
#pragma once

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

#include "fuzz/worst/pair_chart.hpp"
#include "oracles/methods/contained.hpp"
#include "oracles/methods/method.hpp"
#include "oracles/trial/compare.hpp"
#include "oracles/trial/objective.hpp"

namespace cyl {

/// Which pairs count: those where these features meet, on which the verdict is wrong in this way, and of
/// which `also` holds, where they are given. `also` is asked of a few pairs only, those that would be the
/// worst yet; it may cost some milliseconds.
struct Sought {
  std::optional<ContactFeature> feature = {};
  std::function<bool(const Pair&)> also = {};
  std::optional<FindingKind> kind = {};
};

/// In ns: CPU time of this process, and time in all, which counts what another process does for a guest.
double cpu_clock();
double wall_clock();

struct WorstOptions {
  Objective objective = Objective::margin;
  std::uint64_t seed = 1;
  /// Shapes looked at, about a hundred questions each: the limit that gives the same result again (times
  /// aside).
  std::size_t evaluation_cap = std::numeric_limits<std::size_t>::max();
  std::chrono::milliseconds budget = std::chrono::hours(24);  ///< wall time
  Domain domain;
  double (*clock)() = cpu_clock;  ///< of Objective::time; it is read in the worker that asks
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

struct SlowPair {
  Pair pair;
  double ns;  ///< of one call: the least of a few
};

/// Of the other searches.
struct ScoredPair {
  Pair pair;
  double score;
  bool beyond;  ///< proved to be more than the method promises; an error's score is what it is at most
};

struct Worst {
  /// Where Objective::margin: of those beyond the claim the one of the greatest margin; where none is, the
  /// one nearest to the claim.
  std::optional<WrongPair> wrong;
  std::optional<FailedPair> failed;  ///< the first of the worst kind: crash, hang, others
  std::optional<SlowPair> slow;      ///< of Objective::time
  std::optional<ScoredPair> scored;  ///< of steps, error, bound and undecided
  std::size_t evaluations = 0, questions = 0;

  /// Returns whether something beyond the method's claim was found: all failures are.
  bool beyond_claim() const;
};

/// Called now and then, with what was found so far.
using OnWorst = std::function<void(const Worst& so_far, std::chrono::milliseconds elapsed)>;

/// A foreign `method` is asked contained. Starts are looked at in their order, those with the features sought
/// first, then those on which the method is worst are walked from; while it is wrong on none, mutations of
/// them are looked at. Cost: a millisecond a shape of a quick method. With a cap on evaluations the result is
/// a pure function of the arguments but for times and hangs.
Worst worst_of(const std::unique_ptr<Method>& method, std::span<const Pair> starts, const Sought& sought,
               const WorstOptions& options, const OnWorst& on_worst = {});

/// Pairs to start from where nothing is known: near touching, of that stratum (of every one where none is
/// named), and some of every family.
std::vector<Pair> drawn_starts(std::optional<ContactFeature> feature, std::uint64_t seed);

/// Pairs to start from where solvers of our kind are at their worst: close contacts of all lies and angles
/// (corpus/pairs/close_contact.hpp), those of the feature where it is one that they are drawn by, and some of
/// every family.
std::vector<Pair> close_starts(std::optional<ContactFeature> feature, std::uint64_t seed);

/// The method's usual time of a call: the median over pairs of family `random`, each the least of a few.
/// Nothing where it answers none.
std::optional<double> usual_ns(const std::unique_ptr<Method>& method, double (*clock)() = cpu_clock);

}  // namespace cyl
