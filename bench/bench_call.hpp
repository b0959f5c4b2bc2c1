// SPDX-License-Identifier: MIT
// One way of asking one method, in a forked worker: for its answers, and for its time.
#pragma once

#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "base/stopwatch.hpp"
#include "oracles/methods/method.hpp"

namespace cyl {

/// `query` is one of BenchRow's.
struct Candidate {
  Method* method;
  std::string_view query;
};

/// Returns every way of asking each of these methods.
std::vector<Candidate> candidates_of(std::span<const std::unique_ptr<Method>> methods);

/// Returns whether the query is about distances: `distance` is asked about disjoint pairs, `depth` about
/// others.
inline bool asks_distance(const Candidate& c) { return c.query == "distance" || c.query == "depth"; }

/// Returns one answer for each pair. The sign of a distance gives a verdict. An answer without a distance is
/// declined.
std::vector<MethodAnswer> ask_all(const Candidate& candidate, std::span<const Pair> pairs);

/// Returns the cost of a pair in a round that fills `seconds`, as series_cost, or NaN if the worker died.
Cost time_round(const Candidate& candidate, std::span<const Pair> pairs, double seconds);
/// Returns the same for a call that does nothing.
Cost time_nothing(std::size_t count, double seconds);
/// Returns the costs of the single pairs, as time_calls; NaN for a batch or if the worker died.
CallTimes time_each(const Candidate& candidate, std::span<const Pair> pairs, int passes);

}  // namespace cyl
