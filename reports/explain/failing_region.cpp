// SPDX-License-Identifier: MIT
#include "reports/explain/failing_region.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "corpus/pairs/pair_numbers.hpp"
#include "corpus/pairs/touch_plane.hpp"
#include "oracles/methods/adapter.hpp"
#include "oracles/trial/mechanism.hpp"

namespace cyl {
namespace {

using enum Parameter;

std::vector<Parameter> parameters_of(const Pair& pair) {
  std::vector<Parameter> all{distance, angle};
  if (is_box(pair.a))
    all.insert(all.end(), {first_edge_a, second_edge_a, third_edge_a});
  else
    all.insert(all.end(), {radius_a, height_a});
  if (is_box(pair.b))
    all.insert(all.end(), {first_edge_b, second_edge_b, third_edge_b});
  else
    all.insert(all.end(), {radius_b, height_b});
  return all;
}

/// The most steps outwards. For the solids they reach a factor of 2^24 = 1.7e7. For distances and angles they
/// reach 2^52, which is more than a double resolves.
constexpr int short_steps_cap = 24, long_steps_cap = 52;
/// The first lengths of the steps that begin at 0, relative to the size.
constexpr double least_distance = 0x1p-50, least_length = 0x1p-20, least_angle = 0x1p-50;
/// The tolerance of a kept distance: relative to it, and for rounding relative to the largest coordinate.
constexpr double kept_tol = 0.01, rounding_tol = 0x1p-50;
constexpr int moves_cap = 4;
constexpr double square = std::numbers::pi / 2;

double middle(const Enclosure& e) { return e.lo / 2 + e.hi / 2; }

double largest_coordinate(const Pair& p) {
  return std::max(p.a.center.cwiseAbs().maxCoeff(), p.b.center.cwiseAbs().maxCoeff());
}

/// The signed distance, which is finite.
struct Located {
  double distance;
  Vector3 direction;
};

std::optional<Located> locate(const Pair& pair, double relative_width) {
  const Truth truth = judge(pair);
  if (truth.verdict == Verdict::undecided || truth.verdict == Verdict::invalid) return {};
  const AttainedDistance d = attain_distance(pair, truth, relative_width);
  const double distance = truth.verdict == Verdict::touching ? 0 : middle(d.distance);
  if (!std::isfinite(distance)) return {};
  return Located{distance, {d.direction[0], d.direction[1], d.direction[2]}};
}

/// Returns a width that resolves `distance`. For penetrating pairs, narrower widths cost more.
double width_for(double distance, double size) {
  const double wanted = kept_tol / 10 * std::abs(distance) / size;
  return std::clamp(wanted, distance > 0 ? 1e-16 : depth_width_tol, 1e-4);
}

/// Moves b along the direction of the distance until the distance is `wanted`. Nothing if that fails.
std::optional<Pair> at_distance(Pair pair, double wanted) {
  for (int i = 0; i < moves_cap; ++i) {
    const double size = size_of(pair);
    if (!(size > 0)) return {};
    const auto now = locate(pair, width_for(wanted, size));
    if (!now) return {};
    const double allowed =
        std::max(kept_tol * std::abs(wanted), rounding_tol * (size + largest_coordinate(pair)));
    if (std::abs(now->distance - wanted) <= allowed) return pair;
    pair.b.center += (wanted - now->distance) * now->direction;
  }
  return {};
}

/// The line of pairs that result if one parameter of the pair changes.
class SearchPath {
 public:
  /// If `located` is empty, the distance is not kept.
  SearchPath(const Pair& pair, const std::optional<Located>& located, Parameter parameter)
      : pair_(pair), parameter_(parameter), size_(size_of(pair)) {
    if (located) {
      distance_ = located->distance;
      direction_ = located->direction;
    }
    if (size_ == 0) size_ = std::abs(distance_);  // two points
    lay_axes();
  }

  Parameter parameter() const { return parameter_; }

  double here() const {
    if (parameter_ == distance) return distance_;
    if (parameter_ == angle) return angle_;
    Pair p = pair_;
    return length(p);
  }

  /// Returns values from the pair's own value outwards, to smaller or to greater values.
  std::vector<double> steps_outwards(bool up) const {
    switch (parameter_) {
      case distance:
        return distances(up);
      case angle:
        return angles(up);
      default:
        return up ? growing(here(), least_length * size_, short_steps_cap)
                  : shrinking(here(), short_steps_cap);
    }
  }

  /// Returns the pair at that value, if it can be built.
  std::optional<Pair> at(double value) const {
    auto moved = moved_to(value);
    if (!moved || !is_legal(*moved)) return {};
    return moved;
  }

 private:
  static std::vector<double> growing(double from, double least, int count, double end = 1e300) {
    std::vector<double> steps;
    double x = from > 0 ? from * region_step : least;
    for (int i = 0; i < count && x < end; ++i, x *= region_step) steps.push_back(x);
    return steps;
  }
  static std::vector<double> shrinking(double from, int count) {
    std::vector<double> steps;
    if (!(from > 0)) return steps;
    double x = from / region_step;
    for (int i = 0; i < count; ++i, x /= region_step) steps.push_back(x);
    steps.push_back(0);
    return steps;
  }

  /// Steps by factors away from parallel (down: from perpendicular), then by factors towards the other end.
  std::vector<double> angles(bool up) const {
    const double rest = square - angle_;
    std::vector<double> steps = growing(up ? angle_ : rest, least_angle, long_steps_cap, square / 2);
    const double far = !steps.empty() ? square - steps.back() : up ? rest : angle_;
    if (!up)
      for (double& x : steps) x = square - x;
    for (const double x : shrinking(far, long_steps_cap)) steps.push_back(up ? square - x : x);
    return steps;
  }

  /// Steps away from touching by factors. Steps towards it also by factors, and then beyond it.
  std::vector<double> distances(bool up) const {
    const double sign = distance_ < 0 ? -1 : 1;
    const double least = std::max(least_distance * size_, std::numeric_limits<double>::denorm_min());
    std::vector<double> steps;
    if (distance_ != 0 && up == (sign > 0)) {
      steps = growing(std::abs(distance_), 0, long_steps_cap, sign > 0 ? 1e3 * size_ : size_);
      for (double& x : steps) x *= sign;
      return steps;
    }
    if (distance_ != 0) {
      for (double x = std::abs(distance_) / region_step; x > least; x /= region_step)
        steps.push_back(sign * x);
    }
    const double beyond = distance_ != 0 ? -sign : up ? 1 : -1;
    for (double x = least; x < 0.01 * size_; x *= region_step * region_step) steps.push_back(beyond * x);
    return steps;
  }

  static std::vector<Vector3> lines_of(const Solid& c) {
    if (!is_box(c)) return {unit_axis(c.axis)};
    return {edge_direction(c, 0), edge_direction(c, 1), edge_direction(c, 2)};
  }

  /// Takes the axes, or the edges that are most nearly parallel.
  void lay_axes() {
    const std::vector<Vector3> of_a = lines_of(pair_.a), of_b = lines_of(pair_.b);
    along_ = of_a.front();
    other_ = of_b.front();
    for (const Vector3& u : of_a)
      for (const Vector3& v : of_b)
        if (std::abs(u.dot(v)) > std::abs(along_.dot(other_))) along_ = u, other_ = v;
    if (other_.dot(along_) < 0) other_ = -other_;
    const Vector3& other = other_;
    Vector3 across = other - other.dot(along_) * along_;
    angle_ = std::atan2(across.norm(), other.dot(along_));
    // If the axes are parallel, b turns in the direction of the distance, or in any direction.
    if (!(across.norm() > 0)) across = direction_ - direction_.dot(along_) * along_;
    if (!(across.norm() > 1e-3 * direction_.norm())) across = rotation_to(along_).col(0);
    across_ = across.normalized();
  }

  std::optional<Pair> moved_to(double value) const {
    Pair p = pair_;
    switch (parameter_) {
      case distance:
        if (direction_.isZero(0)) return {};
        // Outwards, the direction stays the shortest. Inwards, another one may become shorter.
        if (distance_ < 0 && value < distance_) return at_distance(p, value);
        p.b.center += (value - distance_) * direction_;
        return p;
      case angle: {
        const Vector3 line = value == 0       ? along_
                             : value < square ? Vector3(std::cos(value) * along_ + std::sin(value) * across_)
                                              : across_;
        if (is_box(p.b))
          turn(p.b, other_, line);
        else
          p.b.axis = value == 0 && !is_box(p.a) ? p.a.axis : line;
        return kept(p);
      }
      default:
        length(p) = value;
        return kept(p);
    }
  }

  std::optional<Pair> kept(const Pair& p) const {
    if (distance_ == 0) return p;
    return at_distance(p, distance_);
  }

  /// Turns a box so that the line of `from` becomes that of `to`.
  static void turn(Solid& box, const Vector3& from, const Vector3& to) {
    const auto& [w, x, y, z] = box.quaternion;
    const Eigen::Quaterniond q =
        Eigen::Quaterniond::FromTwoVectors(from, to) * Eigen::Quaterniond(w, x, y, z);
    box.quaternion = {q.w(), q.x(), q.y(), q.z()};
  }

  double& length(Pair& p) const {
    if (parameter_ >= first_edge_b) return p.b.edges[index_of(parameter_) - index_of(first_edge_b)];
    if (parameter_ >= first_edge_a) return p.a.edges[index_of(parameter_) - index_of(first_edge_a)];
    Solid& c = parameter_ == radius_a || parameter_ == height_a ? p.a : p.b;
    return parameter_ == radius_a || parameter_ == radius_b ? c.radius : c.height;
  }
  static std::size_t index_of(Parameter parameter) { return static_cast<std::size_t>(parameter); }

  Pair pair_;
  Parameter parameter_;
  double size_, distance_ = 0, angle_ = 0;
  Vector3 direction_{0, 0, 0}, along_, other_, across_;
};

double between(double x, double y) {
  const bool same_sign = (x > 0 && y > 0) || (x < 0 && y < 0);
  const double ratio = std::abs(x / y);
  if (!same_sign || (ratio < region_step && ratio > 1 / region_step)) return x / 2 + y / 2;
  return std::copysign(std::sqrt(std::abs(x)) * std::sqrt(std::abs(y)), x);
}

/// Finds the end of a region on one side, in rounds of questions.
class Search {
 public:
  Search(const SearchPath& path, bool up, const Trial& failing) : path_(&path), up_(up) {
    end_.fails_at = path.here();
    end_.failing = failing;
  }

  /// Returns the next values to ask about, from the last that fails outwards. Empty if the search is done.
  std::vector<double> proposals() const {
    if (done_) return {};
    if (!end_.ends_at) return path_->steps_outwards(up_);
    const double inner = end_.fails_at, outer = *end_.ends_at;
    const double half = between(inner, outer), first = between(inner, half), last = between(half, outer);
    std::vector<double> values{between(inner, first), first, between(first, half), half,
                               between(half, last),   last,  between(last, outer)};
    std::erase_if(values, [&](double x) { return x == inner || x == outer; });
    values.erase(std::unique(values.begin(), values.end()), values.end());
    return values;
  }

  /// Goes outwards through the answers to the first that does not fail. In the first round, it also counts
  /// those beyond.
  void take(double value, const Trial& said) {
    // Thin solids that were moved through each other are apart again.
    const bool is_through =
        path_->parameter() == distance && value < 0 && said.truth.verdict == Verdict::disjoint;
    const bool fails = !is_through && fails_alike(end_.failing, said);
    if (first_round_) {
      end_.failing_samples += !found_ && fails;
      end_.right_samples += !fails && said.right() && said.meets() == end_.failing.meets();
      end_.fails_beyond |= found_ && fails;
    }
    if (found_) return;
    found_ = !fails;
    if (fails) {
      end_.fails_at = value;
      end_.failing = said;
    } else if (!is_through) {
      end_.ends_at = value;
      end_.beyond = said;
    }
  }

  void end_round() {
    found_ = first_round_ = false;
    done_ = !end_.ends_at || is_narrow();
  }

  /// The value is a distance only up to rounding, and less exactly for overlaps. This encloses the distance.
  void end_as_enclosed() {
    end_.failing.narrow_distance();
    end_.fails_at = middle(end_.failing.distance);
    if (!end_.beyond || !end_.beyond->decided()) return;
    end_.beyond->narrow_distance();
    end_.ends_at = middle(end_.beyond->distance);
  }

  const SearchPath& path() const { return *path_; }
  const RegionEnd& end() const { return end_; }

 private:
  bool is_narrow() const {
    const double x = end_.fails_at, y = *end_.ends_at;
    return std::abs(x - y) <= region_share * std::max(std::abs(x), std::abs(y));
  }

  const SearchPath* path_;
  bool up_, first_round_ = true, found_ = false, done_ = false;
  RegionEnd end_;
};

void ask_round(std::vector<Search>& searches, const std::unique_ptr<Method>& method) {
  std::vector<std::pair<Search*, double>> asked;
  std::vector<Pair> pairs;
  for (Search& search : searches) {
    for (const double value : search.proposals()) {
      const auto pair = search.path().at(value);
      if (!pair) break;
      asked.emplace_back(&search, value);
      pairs.push_back(*pair);
    }
  }
  const std::vector<Trial> said = try_method(method, pairs);
  for (std::size_t i = 0; i < asked.size(); ++i) asked[i].first->take(asked[i].second, said[i]);
  for (Search& search : searches) search.end_round();
}

}  // namespace

std::vector<FailingRegion> failing_regions(const std::unique_ptr<Method>& method, const Trial& failing) {
  const auto located = locate(failing.pair, gap_width_tol);
  std::vector<SearchPath> paths;
  for (const Parameter p : parameters_of(failing.pair)) paths.emplace_back(failing.pair, located, p);
  std::vector<Search> searches;
  for (const SearchPath& path : paths)
    for (const bool up : {false, true}) searches.emplace_back(path, up, failing);
  for (int round = 0; round <= region_rounds_cap; ++round) ask_round(searches, method);
  std::vector<FailingRegion> regions;
  for (std::size_t i = 0; i < 2; ++i) searches[i].end_as_enclosed();
  for (std::size_t i = 0; i < paths.size(); ++i)
    regions.push_back(
        {paths[i].parameter(), paths[i].here(), searches[2 * i].end(), searches[2 * i + 1].end()});
  regions[0].at = middle(failing.distance);
  return regions;
}

}  // namespace cyl
