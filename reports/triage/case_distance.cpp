// SPDX-License-Identifier: MIT
#include "reports/triage/case_distance.hpp"

#include <algorithm>

#include "corpus/pairs/pair_json.hpp"
#include "corpus/pairs/pair_numbers.hpp"
#include "oracles/referee/referee.hpp"

namespace cyl {
namespace {

/// The width of an enclosed overlap: this part of the pair's size, or this part of its margin if that is
/// less. That suffices for readers, and a narrower width costs a longer search.
constexpr double shown_depth_width_tol = 1e-6, shown_depth_width_share = 0.01;

}  // namespace

std::optional<Enclosure> add_distance(nlohmann::ordered_json& reported, const Pair& pair, Verdict verdict,
                                      std::optional<Enclosure> margin) {
  double width = gap_width_tol;
  if (verdict == Verdict::intersecting) {
    width = shown_depth_width_tol;
    if (margin) width = std::clamp(shown_depth_width_share * margin->lo, depth_width_tol, width);
  }
  Truth truth;
  truth.verdict = verdict;
  const AttainedDistance attained = attain_distance(pair, truth, width);
  Enclosure d = attained.distance;
  if (verdict == Verdict::disjoint || verdict == Verdict::touching) d.lo = std::max(d.lo, 0.0);
  const double size = size_of(pair), near = std::max({d.lo, -d.hi, 0.0}), far = std::max(d.hi, -d.lo);
  if (!margin && size > 0) margin = Enclosure{near / size, far / size};
  reported["truth"]["distance"] = {number_json(d.lo), number_json(d.hi)};
  if (margin) reported["margin"] = {number_json(margin->lo), number_json(margin->hi)};
  if (std::any_of(attained.direction.begin(), attained.direction.end(), [](double x) { return x != 0; }))
    reported["direction"] = attained.direction;
  const MeasuredDistance nearest = measure_with_points(pair);
  const Vector3 a = pair.a.center + nearest.on_a, b = pair.b.center + nearest.on_b;
  if (!nearest.direction.isZero(0) && a.allFinite() && b.allFinite())
    reported["nearest"] = {{"a", vector_json(a)}, {"b", vector_json(b)}};
  return margin;
}

}  // namespace cyl
