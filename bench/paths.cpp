// SPDX-License-Identifier: MIT
#include "bench/paths.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

#include "base/json.hpp"
#include "corpus/pairs/near_touching.hpp"
#include "corpus/pairs/pair_numbers.hpp"
#include "corpus/pairs/random_stream.hpp"
#include "corpus/pairs/stratum.hpp"
#include "oracles/methods/contained.hpp"
#include "oracles/trial/trial.hpp"

namespace cyl {
namespace {

using nlohmann::json;

/// The decades of the quantity that a path changes. Up to 1e-3, overlaps are known for all features.
constexpr std::span touching_decades = std::span(tenths).subspan<3, 13>();  // 1e-3 .. 1e-15
constexpr std::span turning_decades = std::span(tenths).subspan<2, 15>();   // 1e-2 .. 1e-16
constexpr double in_a_decade[] = {1, 0.6, 0.4, 0.25, 0.16};

/// A step relative to the size. Rounding moves a pair's distance by up to 5e-16, so the true verdict flips
/// once.
constexpr double fine_step_margin = 2e-15;
constexpr int fine_steps = 128;

/// Returns -decades.front(), .. -decades.back(), (0,) decades.back(), .. decades.front().
std::vector<double> by_decades(std::span<const double> decades, bool with_zero) {
  std::vector<double> at;
  for (std::size_t d = 0; d < decades.size(); ++d)
    for (const double part : in_a_decade)
      if (d + 1 < decades.size() || part == 1) at.push_back(-decades[d] * part);
  const std::size_t half = at.size();
  if (with_zero) at.push_back(0);
  for (std::size_t i = half; i-- > 0;) at.push_back(-at[i]);
  return at;
}

/// Leaves out 0, at which rounding alone would decide.
std::vector<double> finely() {
  std::vector<double> at;
  for (int i = 0; i < fine_steps; ++i) at.push_back((i - (fine_steps - 1) / 2.0) * fine_step_margin);
  return at;
}

struct Configuration {
  ContactKind kind;
  std::string_view name;
};
constexpr Configuration configurations[] = {{ContactKind::side_side, "side-side"},
                                            {ContactKind::side_rim, "side-rim"},
                                            {ContactKind::rim_rim, "rim-rim"},
                                            {ContactKind::cap_rim, "cap-rim"},
                                            {ContactKind::cap_side, "cap-side"},
                                            {ContactKind::cap_cap, "cap-cap"},
                                            {ContactKind::parallel_sides, "parallel-sides"}};

/// The margin does not influence the numbers drawn. So the same solids move along the same normal.
Path touching_path(std::string name, const Configuration& configuration, std::span<const double> margins,
                   std::uint64_t seed) {
  Path path{std::move(name), 1, {}};
  for (const double margin : margins) {
    RandomStream stream(configuration.name, seed, 0);
    const Contact c = draw_contact_at(configuration.kind, stream, margin);
    path.steps.push_back({margin, c.pair, c.distance});
  }
  return path;
}

/// How b lies next to a. The side of a faces +n about the middle of its height, or else its cap does.
enum class Turn : unsigned char {
  parallel_cross,
  parallel_tilt,
  perpendicular_cross,
  perpendicular_tilt,
  coaxial
};

constexpr std::string_view turn_names[] = {"parallel-cross", "parallel-tilt", "perpendicular-cross",
                                           "perpendicular-tilt", "coaxial"};

// Positions are relative to the centre of a. Its axis is u, n is the normal, and v = n x u. The lowest point
// of b against n lies at a distance g along n over a point p of a's side (coaxial: cap). p is 0.3 and more
// from the border. So the signed distance is g for every turn. For a gap, that point shows it, and the slab
// between the solids is free. For an overlap, the argument of corpus/pairs/near_touching.cpp shows it. A
// ball of radius 0.1 and more fits into a and touches at p.
//
// Crossed, the axis of b stays perpendicular to n, and its generator goes through p. Tilted, its lowest
// point is on its rim, at most h/2 or r away from the middle of its side or cap. So a is the longer one.
Path turning_path(Turn turn, bool gap, std::uint64_t seed) {
  Path path{fmt::format("{} {}", turn_names[static_cast<std::size_t>(turn)], gap ? "gap" : "overlap"), 0, {}};
  RandomStream s(turn_names[static_cast<std::size_t>(turn)], seed, 0);
  const Vector3 n = s.unit_vector();
  const Vector3 u = s.perpendicular(n);
  const Vector3 v = n.cross(u);
  Solid a, b;
  a.radius = s.between(1, 2);
  a.height = s.between(3, 4);
  b.radius = s.between(0.5, 0.9);
  b.height = s.between(0.5, 0.9);
  for (int i = 0; i < 3; ++i) a.center[i] = s.between(-1, 1);
  const double shift = s.between(-0.1, 0.1);  // of the middle of b along a's axis
  const double size = a.radius + a.height + b.radius + b.height;
  const double distance = (gap ? path_margin : -path_margin) * size;
  const bool on_cap = turn == Turn::coaxial;
  a.axis = on_cap ? n : u;
  const Vector3 facing = (on_cap ? a.height / 2 : a.radius) * n;
  for (const double t : by_decades(turning_decades, true)) {
    Vector3 middle = shift * u;  // of b, in the plane square to n
    if (turn == Turn::parallel_cross) b.axis = u + t * v;
    if (turn == Turn::parallel_tilt) b.axis = u + t * n;
    if (turn == Turn::perpendicular_cross) b.axis = v + t * u;
    if (turn == Turn::perpendicular_tilt) b.axis = n + t * u;
    if (on_cap) {
      b.axis = n;
      middle = t * size * v;
    }
    // How far b reaches against n. Its axis and n span the plane of the tilt, which has tangent t.
    const double cosine = 1 / std::sqrt(1 + t * t), sine = std::abs(t) * cosine;
    double reach = b.radius;
    if (turn == Turn::parallel_tilt) reach = b.radius * cosine + b.height / 2 * sine;
    if (turn == Turn::perpendicular_tilt) reach = b.height / 2 * cosine + b.radius * sine;
    if (on_cap) reach = b.height / 2;
    b.center = a.center + (facing + (reach + distance) * n + middle);
    path.steps.push_back({t, {a, b}, distance});
  }
  return path;
}

bool says(const MethodAnswer& a) {
  return a.status == Status::answered &&
         (a.verdict == Verdict::disjoint || a.verdict == Verdict::intersecting ||
          a.verdict == Verdict::touching);
}

bool says_distance(const MethodAnswer& a) {
  return a.status == Status::answered && a.has_distance && std::isfinite(a.distance);
}

std::optional<Vector3> direction_of(const MethodAnswer& a) {
  if (a.status != Status::answered || a.witness != CertificateKind::direction) return {};
  const Vector3 d(a.head[0] + a.tail[0], a.head[1] + a.tail[1], a.head[2] + a.tail[2]);
  const double length = d.stableNorm();
  if (!(length > 0) || !std::isfinite(length)) return {};
  return d / length;
}

double degrees_between(const Vector3& x, const Vector3& y) {
  return 2 * std::atan2((x - y).norm(), (x + y).norm()) * 180 / std::numbers::pi;
}

void at_least(std::optional<double>& most, double x) { most = std::max(most.value_or(0), x); }

void add_worst(PathStability& all, const PathStability& one) {
  all.said += one.said;
  all.flips = std::max(all.flips, one.flips);
  if (one.distance_jump) at_least(all.distance_jump, *one.distance_jump);
  if (one.direction_jump_degrees) at_least(all.direction_jump_degrees, *one.direction_jump_degrees);
}

}  // namespace

std::vector<Path> make_paths(std::uint64_t seed) {
  std::vector<Path> paths;
  for (const Configuration& c : configurations) {
    paths.push_back(
        touching_path(fmt::format("touching {}", c.name), c, by_decades(touching_decades, false), seed));
    paths.push_back(touching_path(fmt::format("touching-fine {}", c.name), c, finely(), seed));
  }
  for (const Turn turn : {Turn::parallel_cross, Turn::parallel_tilt, Turn::perpendicular_cross,
                          Turn::perpendicular_tilt, Turn::coaxial})
    for (const bool gap : {true, false}) paths.push_back(turning_path(turn, gap, seed));
  return paths;
}

PathStability stability_along(const Path& path, std::string_view method,
                              std::span<const MethodAnswer> answers) {
  PathStability s;
  s.method = method;
  s.path = path.name;
  s.steps = path.steps.size();
  std::optional<std::size_t> last;
  for (std::size_t i = 0; i < answers.size(); ++i) {
    if (says(answers[i])) {
      ++s.said;
      s.flips +=
          last && (answers[*last].verdict == Verdict::disjoint) != (answers[i].verdict == Verdict::disjoint);
      last = i;
    }
    if (i == 0) continue;
    const MethodAnswer &x = answers[i - 1], &y = answers[i];
    if (says_distance(x) && says_distance(y)) {
      const double reported = std::abs(y.distance - x.distance);
      const double true_change = std::abs(path.steps[i].distance - path.steps[i - 1].distance);
      at_least(s.distance_jump, std::max(0.0, reported - true_change) / size_of(path.steps[i].pair));
    }
    const auto before = direction_of(x), after = direction_of(y);
    if (before && after) at_least(s.direction_jump_degrees, degrees_between(*before, *after));
  }
  return s;
}

std::vector<PathStability> path_stability(std::span<const std::unique_ptr<Method>> methods,
                                          std::uint64_t seeds) {
  std::vector<std::vector<Path>> by_seed;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) by_seed.push_back(make_paths(seed));
  std::vector<PathStability> all;
  for (std::size_t m = 0; m < methods.size(); ++m) {
    std::vector<PathStability> of_method;
    for (std::uint64_t k = 0; k < (methods[m]->share() > 1 ? 1 : seeds); ++k) {
      std::vector<Pair> pairs;
      for (const Path& path : by_seed[k])
        for (const PathStep& step : path.steps) pairs.push_back(step.pair);
      std::vector<Question> questions;
      for (std::size_t i = 0; i < pairs.size(); ++i) questions.push_back({m, i});
      std::vector<MethodAnswer> answers;
      for (const ContainedAnswer& said : ask_contained(methods, pairs, questions, probe_caps))
        answers.push_back(said.answer);
      std::size_t first = 0;
      for (std::size_t p = 0; p < by_seed[k].size(); ++p) {
        const Path& path = by_seed[k][p];
        const auto along = std::span<const MethodAnswer>(answers).subspan(first, path.steps.size());
        first += path.steps.size();
        PathStability one = stability_along(path, methods[m]->name(), along);
        if (k == 0)
          of_method.push_back(std::move(one));
        else
          add_worst(of_method[p], one);
      }
    }
    std::ranges::copy_if(of_method, std::back_inserter(all),
                         [](const PathStability& s) { return s.said > 0; });
  }
  return all;
}

json paths_json(std::span<const PathStability> paths) {
  json all = json::array();
  for (const PathStability& p : paths) {
    all.push_back({{"method", p.method},
                   {"path", p.path},
                   {"steps", p.steps},
                   {"flips", p.flips},
                   {"distance_jump", number_or_null(p.distance_jump)},
                   {"direction_jump_degrees", number_or_null(p.direction_jump_degrees)}});
  }
  return all;
}

}  // namespace cyl
