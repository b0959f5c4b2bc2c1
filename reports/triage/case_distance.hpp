// SPDX-License-Identifier: MIT
// The distance of a pair for the page: enclosed by the referee, with the direction and the points at which it
// is attained.
#pragma once

#include <array>
#include <optional>
#include <utility>

#include "base/json.hpp"
#include "corpus/pairs/pair_json.hpp"
#include "corpus/store/run_store.hpp"
#include "oracles/referee/referee.hpp"
#include "solver/solid.hpp"

namespace cyl {

struct CaseDistance {
  Enclosure distance;
  std::optional<Enclosure> margin;                     ///< none of two points
  std::optional<std::array<double, 3>> direction;      ///< unit, from a to b
  std::optional<std::pair<Vector3, Vector3>> nearest;  ///< on a, on b; the solver's, approximate
};

/// Encloses the distance of a pair with that truth, which is decided. `margin`: the known one, or to be
/// enclosed. An overlap is enclosed only as narrowly as it needs. Cost: some 0.1 ms.
CaseDistance case_distance(const Pair& pair, Verdict truth, std::optional<Enclosure> margin);

/// Adds truth.distance, margin, direction and nearest to a Case of reports/web/run/data.ts, as far as known.
template <class Json>
void add_distance(Json& reported, const CaseDistance& d) {
  const auto vector = [](const Vector3& v) { return Json::array({v[0], v[1], v[2]}); };
  reported["truth"]["distance"] = {number_json(d.distance.lo), number_json(d.distance.hi)};
  if (d.margin) reported["margin"] = {number_json(d.margin->lo), number_json(d.margin->hi)};
  if (d.direction) reported["direction"] = *d.direction;
  if (d.nearest) reported["nearest"] = {{"a", vector(d.nearest->first)}, {"b", vector(d.nearest->second)}};
}

}  // namespace cyl
