// SPDX-License-Identifier: MIT
// Nanoseconds a pair, by method, family and query, with the method's faults on the same pairs beside them.
// Every answer is held against the referee before anything is timed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/stopwatch.hpp"
#include "corpus/pairs/families.hpp"
#include "oracles/methods/method.hpp"

namespace cyl {

struct BenchOptions {
  std::uint64_t seed = 1;    ///< of the families
  std::size_t pairs = 2000;  ///< of each family; a method asked on a share of indices only gets its share
  double min_time = 0.2;     ///< seconds of timing a row, all rounds together
  int passes = 9;            ///< rounds of each row, the rows of a family taking turns
  bool curves = false;       ///< for bench/curves.hpp: its queries alone, costly methods on more pairs
  /// For format_shapes: verdict and certificate alone, without costly methods and p99. Each family is split
  /// by the shapes of its pairs, and its name becomes "sphere/box box_sphere".
  bool shapes = false;
};

/// For curves, a costly method with a smaller share is asked about at least this many pairs and timed on this
/// many. One answer of DIRECT at 6000 evaluations takes as long as ten thousand others.
inline constexpr std::size_t costly_asked = 100, costly_timed = 30;

/// One row for each method, family and query. The queries:
///   verdict      yes or no on prepared solids; the plain question if a method has no such call
///   raw          the plain question of a method that has that call; solids are prepared inside
///   certificate  verdict and certificate on prepared solids (method `decide`)
///   distance     the signed distance on prepared solids, for disjoint pairs
///   depth        the same, for pairs with a common point
///   batch        all verdicts in one call on prepared solids
struct BenchRow {
  std::string method;
  MethodName name;  ///< its parts
  std::string family;
  std::string query;
  bool foreign = false;
  std::size_t pairs = 0;                 ///< asked, those it failed on included
  double median_ns = not_measured;       ///< median over the rounds of the time of a pair; NaN if every pair
                                         ///< failed
  double spread_percent = not_measured;  ///< of the rounds
  /// Quantiles over pairs of the least time of each; NaN for a batch.
  double p50_ns = not_measured, p99_ns = not_measured, max_ns = not_measured;
  double instructions = not_measured;  ///< for a pair; NaN if the machine has no counter
  std::size_t wrong_disjoint = 0;      ///< a distance gives it by its sign
  std::size_t wrong_intersecting = 0;
  std::size_t wrong_below_claim = 0;  ///< those of the two above that the method's own claim allows
  std::size_t wrong_at_margin = 0;    ///< wrong verdicts whose margin may be at or above right_from(family)
  std::size_t undecided = 0;          ///< or declined, answered invalid, or returned no distance
  std::size_t failed = 0;             ///< crashed, threw or hung; left out of the times
  /// The largest error of a distance relative to the size: at least and at most, by the enclosures.
  double max_error = not_measured;
  double max_error_at_most = not_measured;
};

/// The margin from which on `intersect` is to be right.
constexpr double right_from(std::string_view family) { return family == "random" ? 1e-14 : 1e-13; }

using BenchProgress = std::function<void(std::string_view)>;

/// Returns a row for each family, method and query. Foreign methods run in a forked child. `progress` gets a
/// description of the current step.
std::vector<BenchRow> bench(std::span<const std::unique_ptr<Method>> methods,
                            std::span<const Family> families, const BenchOptions& options,
                            const BenchProgress& progress);

/// Returns the families that `spec` names by the rule of select_names; "all" is those of campaigns and the
/// margins.
std::vector<Family> select_families(std::string_view spec);

}  // namespace cyl
