// SPDX-License-Identifier: MIT
// Encloses the signed distance, -min of f over unit directions, by branch and bound over the sphere. f is as
// in direction_bounds.cpp.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <queue>
#include <span>

#include "corpus/pairs/pair_numbers.hpp"
#include "oracles/referee/box_distance.hpp"
#include "oracles/referee/direction_bounds.hpp"
#include "oracles/referee/half_space.hpp"
#include "oracles/referee/interval.hpp"
#include "oracles/referee/nearest.hpp"
#include "oracles/referee/referee.hpp"
#include "oracles/referee/search.hpp"
#include "oracles/referee/witness_miss.hpp"

namespace cyl {
namespace {

/// The known facts about min f.
struct LeastValue {
  double width;                                           ///< how far apart `floor` and `best` may be
  double best = std::numeric_limits<double>::infinity();  ///< f(direction)
  double floor = -best;                                   ///< f is nowhere less
  Vec direction{};
  std::size_t cells = 0;  ///< parts of the sphere that were bounded

  bool is_found() const { return best - floor <= width; }
  void take(double value, const Vec& d) {
    if (value < best) best = value, direction = d;
  }
  void floor_at(double bound) { floor = std::max(floor, bound); }
};

// A square of one face of the cube around the sphere, in the face's coordinates.
struct Cell {
  int face;
  double s, t, half;
  double below;
  Vec best;                                                        // the direction of the least f so far
  bool tried = false;                                              // by a minimum nearby
  bool operator<(const Cell& o) const { return below > o.below; }  // the least bound first
};

Vec on_face(int face, double s, double t) {
  const double sign = face < 3 ? 1 : -1;
  return face % 3 == 0 ? Vec{sign, s, t} : face % 3 == 1 ? Vec{s, sign, t} : Vec{s, t, sign};
}

Cap cap_of(const Cell& c) {
  const Vec middle = on_face(c.face, c.s, c.t);
  Cap cap{normalized(middle), 1, 0};
  double square = 0;
  for (const double i : {-c.half, c.half})
    for (const double j : {-c.half, c.half}) {
      const Vec corner = on_face(c.face, c.s + i, c.t + j), off = cross(cap.center, corner);
      square = std::max(square, dot(off, off) / dot(corner, corner));
    }
  cap.sine = std::min(1.0, std::sqrt(square) * (1 + 0x1p-40));
  cap.cosine = std::sqrt((1 - cap.sine) * (1 + cap.sine));
  return cap;
}

// Unit vectors square to each other, the last along v.
std::array<Vec, 3> frame_on(const Vec& v) {
  const Vec z = length(v) > 0 ? normalized(v) : Vec{0, 0, 1};
  const Vec unit = normalized(square_to(z));
  return {unit, cross(z, unit), z};
}

class Minimum {
 public:
  Minimum(const DirectionBounds& sphere, const Vec& delta, LeastValue& least)
      : sphere_(sphere), frame_(frame_on(delta)), least_(least) {}

  /// Evaluates f at directions at which it may be least, until the minimum is found.
  void guess(std::span<const Vec> directions) {
    for (const Vec& d : directions)
      if (!least_.is_found()) take(sphere_.bounds_by_minimum({d, 1, guess_sine}, d, least_.best, 0));
  }

  /// Goes on from the best direction of all, as long as f becomes less.
  void descend() {
    double before = least_.best + 2 * least_.width;
    for (int round = 0; round < descent_cap && least_.best < before - least_.width && !least_.is_found();
         ++round) {
      before = least_.best;
      const Vec from = least_.direction;
      guess({&from, 1});
    }
  }

  void find(std::size_t most_cells) {
    constexpr double everything = -std::numeric_limits<double>::infinity();
    // f(D) = f(-D) - 2 D.delta, so the half of the sphere towards b is enough. Face 2 is in its middle.
    for (const int face : {2, 0, 1, 3, 4})
      for (const double s : {-0.5, 0.5})
        for (const double t : {-0.5, 0.5})
          if ((face == 2 || t > 0) && !least_.is_found()) add({face, s, t, 0.5, everything, {}});
    while (!queue_.empty() && !least_.is_found() && least_.best - queue_.top().below > least_.width &&
           least_.cells < most_cells) {
      Cell c = queue_.top();
      queue_.pop();
      if (!c.tried && c.half < coarse_tol) {
        c.below =
            std::max(c.below, take(sphere_.bounds_by_minimum(turned(cap_of(c)), c.best,
                                                             least_.best - least_.width, least_.width)));
        c.tried = true;
        if (c.below < least_.best) queue_.push(c);
        continue;
      }
      const double h = c.half / 2;
      for (const double i : {-h, h})
        for (const double j : {-h, h}) add({c.face, c.s + i, c.t + j, h, c.below, {}});
    }
    if (!least_.is_found()) least_.floor_at(queue_.empty() ? least_.best : queue_.top().below);
  }

 private:
  /// Cells of this half width are too wide for the bound by a minimum, in most cases.
  static constexpr double coarse_tol = 0.5;
  /// A guess within this sine of a kink belongs on the kink.
  static constexpr double guess_sine = 0x1p-12;

  /// Rounds of a descent. Along a bent valley each round gets no farther than a guess may.
  static constexpr int descent_cap = 32;

  Cap turned(Cap cap) const {
    const auto& [x, y, z] = frame_;
    cap.center = cap.center.x * x + cap.center.y * y + cap.center.z * z;
    return cap;
  }

  double take(const Bounds& b) {
    least_.take(b.value, b.direction);
    least_.floor_at(-b.nearest);
    return b.below;
  }

  void add(Cell c) {
    const Bounds b = sphere_.bounds(turned(cap_of(c)), least_.best);
    ++least_.cells;
    c.below = std::max(c.below, take(b));
    c.best = b.direction;
    if (c.below < least_.best) queue_.push(c);
  }

  const DirectionBounds& sphere_;
  const std::array<Vec, 3> frame_;
  LeastValue& least_;
  std::priority_queue<Cell> queue_;
};

// For axes that are exactly parallel. The distances along the axis and across it decide everything.
LeastValue parallel(const SearchPair<double>& p) {
  const Vec axis = normalized(p.axis0);
  const double height = dot(p.delta, axis);
  const Vec w = height < 0 ? -1.0 * axis : axis;
  const double along = std::fabs(height) - p.half0 - p.half1;
  const double radial = length(cross(p.delta, w)), across = radial - p.radius0 - p.radius1;
  // This makes the direction perpendicular to the axis again after the difference has lost digits. If nearly
  // all were lost, any direction across is as good.
  Vec out = p.delta - dot(p.delta, w) * w;
  if (length(out) > 0) out = normalized(out);
  out = out - dot(out, w) * w;
  if (!(length(out) > 0.5)) out = square_to(w);
  out = normalized(out);
  const bool corner = along > 0 && across > 0;
  const double distance = corner ? std::sqrt(along * along + across * across) : std::max(along, across);
  const Vec d = corner ? normalized(along * w + across * out) : along > across ? w : out;
  return {0, -distance, -distance, d};
}

// How far x, relative to a's centre, is from both solids together. The solids are at most so far apart.
double way_to_both(const SearchPair<double>& p, const Vec& x) {
  const auto beyond = [](const Vec& axis, double radius, double half, const Vec& y) {
    const Vec w = normalized(axis);
    const double along = dot(y, w);
    const double out = std::max(0.0, std::fabs(along) - half);
    const double across = std::max(0.0, length(y - along * w) - radius);
    return std::sqrt(out * out + across * across);
  };
  return beyond(p.axis0, p.radius0, p.half0, x) + beyond(p.axis1, p.radius1, p.half1, x - p.delta);
}

// The results of a search from a point of a. They are the distance of two points, the nearest in most cases,
// and two directions. One goes from one point to the other. The other is perpendicular to both rims there,
// which is exact if the points are too close for the first.
struct Nearby {
  Nearest<double> points;
  std::array<Vec, 2> directions;
};

Nearby nearest_from(const SearchPair<double>& p, const Vec& start) {
  constexpr int rounds = 4;
  Nearest<double> n{start, p.delta, 0};
  for (int round = 0; round < rounds; ++round) n = refine_nearest(p, 53, n.on_a, n.on_b);
  const Vec way = n.on_b - n.on_a, between = length(way) > 0 ? way : p.delta;
  Vec square = cross(cross(p.axis0, n.on_a), cross(p.axis1, n.on_b - p.delta));
  if (dot(square, between) < 0) square = -1.0 * square;
  return {n, {normalized(between), normalized(length(square) > 0 ? square : between)}};
}

// Encloses |distance| if one guess shows that it is within the given width. If the solids are apart, their
// distance is at most the sum of the distances of a point from both. If they overlap, their depth is at most
// f in any direction. Otherwise nearly touching pairs would take all cells of the sphere.
std::optional<Enclosure> enclose_near_touching(const Pair& pair, Verdict verdict, double relative_width) {
  int exponent = 0;
  const SearchPair<double> p = double_pair(pair, exponent);
  const double size = p.radius0 + p.radius1 + 2 * (p.half0 + p.half1);
  if (size == 0) return std::nullopt;
  const DirectionBounds sphere(p);
  const double slack = bound_error * sphere.reach();
  const Found<double> found = search(p, 53);
  double bound = std::numeric_limits<double>::infinity();
  if (verdict == Verdict::disjoint && found.has_point) bound = way_to_both(p, found.point);
  if (verdict == Verdict::intersecting && found.has_direction)
    bound = sphere.value(normalized(found.direction));
  if (!(bound <= std::max(relative_width * size, slack))) return std::nullopt;
  const double most = interval_detail::next_up(std::ldexp(std::max(0.0, bound) + slack, exponent));
  return verdict == Verdict::disjoint ? Enclosure{0, most} : Enclosure{-most, 0};
}

bool meet(Verdict verdict) { return verdict == Verdict::intersecting || verdict == Verdict::touching; }

// The distance of rounded solids is that of their cores less the roundings, in the same direction. The
// difference of the solids is that of the cores grown by a ball, which moves its whole boundary outward by
// the radius.
AttainedDistance shrunk_by_roundings(const Pair& pair, const Truth& truth, double relative_width) {
  Pair cores = pair;
  cores.a.rounding = cores.b.rounding = 0;
  const double core_size = size_of(cores);
  const double core_width = core_size > 0 ? relative_width * (size_of(pair) / core_size) : relative_width;
  AttainedDistance found = attain_distance(cores, judge_verdict(cores), std::min(core_width, 1.0));
  const Interval shrunk =
      Interval(found.distance.lo, found.distance.hi) - Interval(pair.a.rounding) - Interval(pair.b.rounding);
  found.distance = {shrunk.lo, shrunk.hi};
  if (meet(truth.verdict)) found.distance.hi = std::min(found.distance.hi, 0.0);
  return found;
}

// Narrows the least f to a width relative to the size, or until so many cells were bounded.
LeastValue least_value(const SearchPair<double>& p, const DirectionBounds& bounds, bool disjoint,
                       double relative_width, std::size_t most_cells) {
  const double size = p.radius0 + p.radius1 + 2 * (p.half0 + p.half1);
  const Vec c = cross(p.axis0, p.axis1);
  if (size == 0) {
    const double apart = length(p.delta);
    // not covered: points in one place touch, and the gate asks for no distance of touching pairs
    return {0, -apart, -apart, apart > 0 ? normalized(p.delta) : Vec{0, 0, 1}};
  }
  if (c.x == 0 && c.y == 0 && c.z == 0) return parallel(p);
  LeastValue f{std::max(relative_width * size, bound_error * bounds.reach())};
  Minimum minimum(bounds, p.delta, f);
  if (disjoint) {
    const auto from = [&](const Vec& start) {
      if (f.is_found()) return;
      const Nearby n = nearest_from(p, start);
      f.floor_at(-n.points.apart);
      minimum.guess(n.directions);
    };
    from({0, 0, 0});
    for (const Vec& corner : crossings_of_rims(p)) from(corner);
    minimum.descend();
  }
  for (const Vec& likely : bounds.likely()) f.take(bounds.value(likely), likely);
  if (!f.is_found()) minimum.find(most_cells);
  return f;
}

}  // namespace

AttainedDistance attain_distance(const Pair& pair, const Truth& truth, double relative_width) {
  // not covered: a family's pairs are valid
  if (truth.verdict == Verdict::invalid) return {};
  if (has_half_space(pair)) return attain_half_space(pair);
  if (has_box(pair)) return attain_box(pair, truth.verdict, relative_width);
  if (is_rounded(pair)) return shrunk_by_roundings(pair, truth, relative_width);
  int exponent = 0;
  const SearchPair<double> p = double_pair(pair, exponent);
  const DirectionBounds bounds(p);
  const double slack = bound_error * bounds.reach();
  LeastValue f = least_value(p, bounds, truth.verdict == Verdict::disjoint, relative_width, cell_cap);
  f.floor = std::min(f.floor, f.best);
  const Vec& d = f.direction;
  const std::array<double, 3> direction{d.x, d.y, d.z};
  // Converts to the scene's unit, rounded outward, then adds the bound that the verdict alone gives.
  using interval_detail::next_down, interval_detail::next_up;
  Enclosure e{next_down(std::ldexp(-f.best - slack, exponent)),
              next_up(std::ldexp(-f.floor + slack, exponent))};
  if (meet(truth.verdict)) e.hi = std::min(e.hi, 0.0);
  return {e, direction, f.cells};
}

Enclosure enclose_distance(const Pair& pair, const Truth& truth, double relative_width) {
  // not covered: that the distance is 0 the gate takes from the verdict
  if (truth.verdict == Verdict::touching) return {0, 0};
  if (!is_rounded(pair) && !has_half_space(pair) && !has_box(pair))
    if (const auto near = enclose_near_touching(pair, truth.verdict, relative_width)) return *near;
  Enclosure found = attain_distance(pair, truth, relative_width).distance;
  if (truth.verdict == Verdict::disjoint) found.lo = std::max(found.lo, 0.0);
  return found;
}

// The value is -f of the best direction found, so an error of the direction counts by its square only.
MeasuredDistance approximate_distance(const Pair& pair) {
  constexpr std::size_t measured_cell_cap = 192;
  if (!is_legal(pair)) return {};
  if (has_half_space(pair)) return measure_half_space(pair);
  if (has_box(pair)) return measure_box(pair, false);
  int exponent = 0;
  const SearchPair<double> p = double_pair(pair, exponent);
  const DirectionBounds bounds(p);
  const Found<double> found = search(p, 53);
  const bool apart = found.has_direction && bounds.value(normalized(found.direction)) < 0;
  LeastValue f = least_value(p, bounds, apart, apart ? gap_width_tol : depth_width_tol, measured_cell_cap);
  if (found.has_direction) {
    const Vec guess = normalized(found.direction);
    f.take(bounds.value(guess), guess);
  }
  constexpr double largest = std::numeric_limits<double>::max();
  const double value = std::ldexp(-f.best, exponent) - pair.a.rounding - pair.b.rounding;
  return {std::clamp(value, -largest, largest), {f.direction.x, f.direction.y, f.direction.z}, {}, {}};
}

MeasuredDistance measure_with_points(const Pair& pair) {
  if (is_legal(pair) && has_box(pair) && !has_half_space(pair)) return measure_box(pair, true);
  MeasuredDistance measured = approximate_distance(pair);
  if (measured.direction.isZero(0) || has_half_space(pair)) return measured;
  int exponent = 0;
  SearchPair<double> p = double_pair(pair, exponent);
  const Vec d = lifted<double>(measured.direction);
  // If the cores overlap, b moves until they are a little apart, to see which points face each other.
  constexpr double parted_tol = 0x1p-10;  // of the reach
  constexpr int measured_rounds_cap = 16;
  const DirectionBounds cores(p);
  if (const double depth = cores.value(d); depth >= 0)
    p.delta = p.delta + (depth + parted_tol * cores.reach()) * d;
  const DirectionBounds bounds(p);
  const Terms<double> a{normalized(p.axis0), p.radius0, p.half0}, b{normalized(p.axis1), p.radius1, p.half1};
  Nearest<double> near{farthest(a, d), p.delta + farthest(b, -1.0 * d), 0};
  const double most = -bounds.value(d) + bound_error * bounds.reach();
  for (int round = 0; round < measured_rounds_cap && (round == 0 || near.apart > most); ++round)
    near = refine_nearest(p, 53, near.on_a, near.on_b);
  const auto point = [&](const Vec& v, double rounding) {
    const Vector3 in_scene(std::ldexp(v.x, exponent), std::ldexp(v.y, exponent), std::ldexp(v.z, exponent));
    return Vector3(in_scene + rounding * measured.direction);
  };
  measured.on_a = point(near.on_a, pair.a.rounding);
  measured.on_b = point(near.on_b - p.delta, -pair.b.rounding);
  return measured;
}

// A width that is relative to the size may be wider than the distance. Then the certificate itself has a
// bound of the right sign. It is the gap that its direction shows, or the radius of a ball in both solids.
// not covered within: for `check --distance`. The gate asks at its own widths.
Enclosure enclose_distance(const Pair& pair, const Truth& truth) {
  if (truth.verdict == Verdict::touching) return {0, 0};
  if (has_half_space(pair)) return attain_half_space(pair).distance;
  const bool disjoint = truth.verdict == Verdict::disjoint;
  Enclosure distance = attain_distance(pair, truth, disjoint ? gap_width_tol : depth_width_tol).distance;
  if (disjoint ? distance.lo > 0 : distance.hi < 0) return distance;
  constexpr double rounding_error = 0x1p-50;  // of the miss to a double, and of this product
  MethodAnswer certificate;
  certificate.set_witness(truth.certificate);
  const double bound = (1 - rounding_error) * std::min(0.0, witness_miss(pair, certificate).value_or(0));
  if (disjoint) distance.lo = std::max(distance.lo, -bound);
  if (truth.verdict == Verdict::intersecting) distance.hi = std::min(distance.hi, bound);
  return distance;
}

}  // namespace cyl
