// SPDX-License-Identifier: MIT
// The distance of a pair for the page: enclosed by the referee, with the direction and the points at which it
// is attained.
#pragma once

#include <optional>

#include "base/json.hpp"
#include "corpus/store/run_store.hpp"
#include "solver/solid.hpp"

namespace cyl {

/// Adds truth.distance, margin, direction and nearest to a Case of reports/web/run/data.ts, as far as known,
/// and returns the margin. `truth` is decided. A margin that is not given is enclosed, but two points have
/// none. An overlap is enclosed only as narrowly as it needs. The nearest points are the solver's,
/// approximate. Cost: some 0.1 ms.
std::optional<Enclosure> add_distance(nlohmann::ordered_json& reported, const Pair& pair, Verdict truth,
                                      std::optional<Enclosure> margin);

}  // namespace cyl
