// SPDX-License-Identifier: MIT
// Enclosing the signed distance, -min of f over unit directions, by branch and bound over the sphere.
//
// f(D) = max over x in K of D.x - D.delta, K = (solid a) - (solid b), both centred. So every y = x - delta
// with x in K bounds f from below by the plane D.y, and on a cap of angle rho about D0
//     min D.y = |y| cos(theta + rho),   theta the angle between y and D0.
// With y the support point of D0 that is second order in rho where f is smooth. f has kinks on the great
// circles square to either axis (the support point jumps along the solid's length) and at the axes (it jumps
// across the cap); near one, the cap is widened until its middle lies on the kink, where every point of that
// edge or disk is as good a support point, and the one that makes y most nearly parallel to D0 is taken. That
// bound is second order again.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <queue>

#include "corpus/pairs/pair_numbers.hpp"
#include "oracles/referee/interval.hpp"
#include "oracles/referee/referee.hpp"
#include "oracles/referee/search.hpp"

namespace cyl {
namespace {

using Vec = Vec3<double>;

/// Rounding in one bound or one value of f, as a multiple of the pair's reach r0 + h0 + r1 + h1 + |delta|: 4
/// units for the axes, fewer than 30 operations on terms no larger than the reach, doubled for the angles'
/// sines and cosines.
constexpr double bound_error = 64 * 0x1p-53;

double length(const Vec& v) { return std::sqrt(dot(v, v)); }

struct Solid {
  Vec axis;
  double radius, half;
};

struct Cap {
  Vec center;
  double cosine, sine;  // of its angle
};

struct Bounds {
  double below;    // of f on the cap
  double value;    // of f at the cap's middle
  double nearest;  // length of some y: the solids, if disjoint, are no farther apart
  Vec direction;   // where f has that value
};

class Search {
 public:
  explicit Search(const SearchPair<double>& p)
      : solids_{Solid{(1 / length(p.axis0)) * p.axis0, p.radius0, p.half0},
                Solid{(1 / length(p.axis1)) * p.axis1, p.radius1, p.half1}},
        delta_(p.delta) {
    const Vec n = cross(solids_[0].axis, solids_[1].axis);
    normal_ = (1 / length(n)) * n;
    reach_ = p.radius0 + p.half0 + p.radius1 + p.half1 + length(p.delta);
  }

  double reach() const { return reach_; }

  // f of a unit direction.
  double value(const Vec& d) const {
    double f = -dot(d, delta_);
    for (const Solid& s : solids_) {
      const double t = dot(d, s.axis);
      f += s.half * std::fabs(t) + s.radius * length(d - t * s.axis);
    }
    return f;
  }

  Bounds bounds(const Cap& cap) const {
    Bounds best = plane(cap, {false, false}, {false, false});
    auto consider = [&](const Vec& middle, std::array<bool, 2> on_circle, std::array<bool, 2> at_axis) {
      Cap moved;
      // untaken: a cap of the first cells has 36 degrees and holds its middle; twice 36 is less than 84
      if (!widen(cap, middle, moved)) return;
      const Bounds b = plane(moved, on_circle, at_axis);
      best.below = std::max(best.below, b.below);
      if (b.value < best.value) {
        best.value = b.value;
        best.direction = b.direction;
      }
      best.nearest = std::min(best.nearest, b.nearest);
    };
    for (std::size_t i = 0; i < 2; ++i) {
      const Vec& w = solids_[i].axis;
      const double t = dot(cap.center, w);
      if (std::fabs(t) <= cap.sine) {
        const Vec flat = cap.center - t * w, middle = (1 / length(flat)) * flat;
        consider(middle, {i == 0, i == 1}, {false, false});
        // Axes nearly parallel: both circles run through the cap side by side, or both poles lie in it.
        if (std::fabs(dot(middle, solids_[1 - i].axis)) <= cap.sine)
          consider(middle, {true, true}, {false, false});
      }
      const Vec pole = t < 0 ? -1.0 * w : w;
      if (length(cross(cap.center, pole)) <= cap.sine) {
        consider(pole, {false, false}, {i == 0, i == 1});
        consider(pole, {i == 1, i == 0}, {i == 0, i == 1});
        if (length(cross(pole, solids_[1 - i].axis)) <= cap.sine)
          consider(pole, {false, false}, {true, true});
      }
    }
    const Vec pole = dot(cap.center, normal_) < 0 ? -1.0 * normal_ : normal_;
    if (length(cross(cap.center, pole)) <= cap.sine) consider(pole, {true, true}, {false, false});
    return best;
  }

 private:
  // The cap about `middle` that holds `cap`; false where it is no help any more (more than a right angle).
  static bool widen(const Cap& cap, const Vec& middle, Cap& out) {
    const double c = std::min(1.0, dot(cap.center, middle)), s = length(cross(cap.center, middle));
    out = {middle, cap.cosine * c - cap.sine * s, cap.sine * c + cap.cosine * s};
    return out.cosine > 0.1;
  }

  // The bound by one plane. Where the cap's middle lies on the kink of solid i (square to its axis, or along
  // it) the support point is free along its length, or across its cap.
  Bounds plane(const Cap& cap, std::array<bool, 2> on_circle, std::array<bool, 2> at_axis) const {
    const Vec& d = cap.center;
    Vec y = -1.0 * delta_;
    double value = -dot(d, delta_);
    for (std::size_t i = 0; i < 2; ++i) {
      const Solid& s = solids_[i];
      const double t = dot(d, s.axis);
      const Vec radial = d - t * s.axis;
      const double spread = length(radial);
      value += s.half * std::fabs(t) + s.radius * spread;
      if (!on_circle[i]) y = y + (t < 0 ? -s.half : s.half) * s.axis;
      if (!at_axis[i] && spread > 0) {
        // Near the axis the difference has lost digits: square to the axis again, or the point would leave
        // the rim; where nearly all was lost the middle of the cap serves.
        const Vec out = (1 / spread) * radial, flat = out - dot(out, s.axis) * s.axis;
        const double kept = length(flat);
        if (kept > 0.5) y = y + (s.radius / kept) * flat;
      }
    }
    std::array<double, 2> slide{};
    std::array<Vec, 2> shift{};
    for (int round = 0; round < 3; ++round)  // one round is exact unless both solids are free
      for (std::size_t i = 0; i < 2; ++i) {
        const Solid& s = solids_[i];
        if (on_circle[i]) {
          y = y - slide[i] * s.axis;
          slide[i] = std::clamp(dot(y, d) * dot(d, s.axis) - dot(y, s.axis), -s.half, s.half);
          y = y + slide[i] * s.axis;
        }
        if (at_axis[i]) {
          y = y - shift[i];
          const Vec off = y - dot(y, s.axis) * s.axis;
          const double size = length(off);
          shift[i] = size > s.radius ? (-s.radius / size) * off : -1.0 * off;
          y = y + shift[i];
        }
      }
    const double along = dot(d, y), beside = length(y - along * d);
    // theta + rho beyond a half turn: the plane's least value is -|y|.
    const bool past = beside * cap.cosine + along * cap.sine < 0;
    const double size = length(y);
    return {past ? -size : along * cap.cosine - beside * cap.sine, value, size, d};
  }

  std::array<Solid, 2> solids_;
  Vec delta_, normal_;
  double reach_;
};

// A square of one face of the cube around the sphere, in the face's coordinates.
struct Cell {
  int face;
  double s, t, half;
  double below;
  bool operator<(const Cell& o) const { return below > o.below; }  // the least bound first
};

Vec on_sphere(int face, double s, double t) {
  const double sign = face < 3 ? 1 : -1;
  const Vec v = face % 3 == 0 ? Vec{sign, s, t} : face % 3 == 1 ? Vec{s, sign, t} : Vec{s, t, sign};
  return (1 / length(v)) * v;
}

Cap cap_of(const Cell& c) {
  Cap cap{on_sphere(c.face, c.s, c.t), 1, 0};
  for (const double i : {-1.0, 1.0})
    for (const double j : {-1.0, 1.0}) {
      const Vec corner = on_sphere(c.face, c.s + i * c.half, c.t + j * c.half);
      cap.sine = std::max(cap.sine, length(cross(cap.center, corner)));
    }
  cap.sine = std::min(1.0, cap.sine * (1 + 0x1p-40));
  cap.cosine = std::sqrt((1 - cap.sine) * (1 + cap.sine));
  return cap;
}

struct Range {
  double lo, hi;  // of min f
  Vec direction;  // where f is hi
  std::size_t cells = 0;
};

Range minimise(const Search& search, double width) {
  std::priority_queue<Cell> queue;
  double best = std::numeric_limits<double>::infinity();
  double floor = -best;  // |y| >= the distance, so -|y| bounds f from below on the whole sphere
  Vec direction{};
  std::size_t cells = 0;
  auto add = [&](Cell c) {
    const Bounds b = search.bounds(cap_of(c));
    ++cells;
    if (b.value < best) {
      best = b.value;
      direction = b.direction;
    }
    floor = std::max(floor, -b.nearest);
    c.below = std::max(c.below, b.below);
    if (c.below < best) queue.push(c);
  };
  const double everything = -std::numeric_limits<double>::infinity();
  for (int face = 0; face < 6; ++face)
    for (const double s : {-0.5, 0.5})
      for (const double t : {-0.5, 0.5}) add({face, s, t, 0.5, everything});
  while (!queue.empty() && best - std::max(floor, queue.top().below) > width && cells < cell_cap) {
    const Cell c = queue.top();
    queue.pop();
    const double h = c.half / 2;
    for (const double i : {-h, h})
      for (const double j : {-h, h}) add({c.face, c.s + i, c.t + j, h, c.below});
  }
  return {queue.empty() ? best : std::min(best, std::max(floor, queue.top().below)), best, direction, cells};
}

// Axes exactly parallel: how far the solids are apart along the axis and across it says everything.
Range parallel(const SearchPair<double>& p) {
  const Vec axis = (1 / length(p.axis0)) * p.axis0;
  const double height = dot(p.delta, axis);
  const Vec w = height < 0 ? -1.0 * axis : axis;
  const double along = std::fabs(height) - p.half0 - p.half1;
  const double radial = length(cross(p.delta, w)), across = radial - p.radius0 - p.radius1;
  // Square to the axis again after the difference has lost digits; where nearly all were lost, any direction
  // across is as good.
  Vec out = p.delta - dot(p.delta, w) * w;
  if (length(out) > 0) out = (1 / length(out)) * out;
  out = out - dot(out, w) * w;
  if (!(length(out) > 0.5)) out = cross(w, std::fabs(w.x) < 0.5 ? Vec{1, 0, 0} : Vec{0, 1, 0});
  out = (1 / length(out)) * out;
  const bool corner = along > 0 && across > 0;
  const double distance = corner ? std::sqrt(along * along + across * across) : std::max(along, across);
  const Vec d = corner ? (along / distance) * w + (across / distance) * out : along > across ? w : out;
  return {-distance, -distance, d};
}

// How far x, relative to a's centre, is from both solids together: the solids are no farther apart.
double way_to_both(const SearchPair<double>& p, const Vec& x) {
  const auto beyond = [](const Vec& axis, double radius, double half, const Vec& y) {
    const Vec w = (1 / length(axis)) * axis;
    const double along = dot(y, w);
    const double out = std::max(0.0, std::fabs(along) - half);
    const double across = std::max(0.0, length(y - along * w) - radius);
    return std::sqrt(out * out + across * across);
  };
  return beyond(p.axis0, p.radius0, p.half0, x) + beyond(p.axis1, p.radius1, p.half1, x - p.delta);
}

// |distance| where one guess shows that it is within the width asked for: apart the solids are no farther
// than a point's way to both, and no deeper than f anywhere. Nearly touching pairs would take all of the
// sphere's cells.
std::optional<Enclosure> enclose_near_touching(const Pair& pair, Verdict verdict, double relative_width) {
  int exponent = 0;
  const SearchPair<double> p = double_pair(pair, exponent);
  const double size = p.radius0 + p.radius1 + 2 * (p.half0 + p.half1);
  if (size == 0) return std::nullopt;
  const Search sphere(p);
  const double slack = bound_error * sphere.reach();
  const Found<double> found = search(p, 53);
  double bound = std::numeric_limits<double>::infinity();
  if (verdict == Verdict::disjoint && found.has_point) bound = way_to_both(p, found.point);
  if (verdict == Verdict::intersecting && found.has_direction) {
    const Vec& d = found.direction;
    const Vec even = (1 / std::max({std::fabs(d.x), std::fabs(d.y), std::fabs(d.z)})) * d;
    bound = sphere.value((1 / length(even)) * even);
  }
  if (!(bound <= std::max(relative_width * size, slack))) return std::nullopt;
  const double most = interval_detail::next_up(std::ldexp(std::max(0.0, bound) + slack, exponent));
  return verdict == Verdict::disjoint ? Enclosure{0, most} : Enclosure{-most, 0};
}

// The distance of rounded solids is that of their cores less the roundings, at the same direction: the
// difference of the solids is that of the cores grown by a ball, which moves its whole boundary outward by
// the radius.
AttainedDistance shrunk_by_roundings(const Pair& pair, const Truth& truth, double relative_width) {
  Pair cores = pair;
  cores.a.rounding = cores.b.rounding = 0;
  const double core_size = size_of(cores);
  const double core_width = core_size > 0 ? relative_width * (size_of(pair) / core_size) : relative_width;
  AttainedDistance found = attain_distance(cores, judge_verdict(cores), std::min(core_width, 1.0));
  if (truth.verdict == Verdict::touching) return {{0, 0}, found.direction, found.cells};
  const Interval shrunk =
      Interval(found.distance.lo, found.distance.hi) - Interval(pair.a.rounding) - Interval(pair.b.rounding);
  found.distance = {shrunk.lo, shrunk.hi};
  if (truth.verdict == Verdict::disjoint) found.distance.lo = std::max(found.distance.lo, 0.0);
  if (truth.verdict == Verdict::intersecting) found.distance.hi = std::min(found.distance.hi, 0.0);
  return found;
}

}  // namespace

AttainedDistance attain_distance(const Pair& pair, const Truth& truth, double relative_width) {
  // untaken: a family's pairs are valid
  if (truth.verdict == Verdict::invalid) return {};
  if (is_rounded(pair)) return shrunk_by_roundings(pair, truth, relative_width);
  int exponent = 0;
  const SearchPair<double> p = double_pair(pair, exponent);
  const double size = p.radius0 + p.radius1 + 2 * (p.half0 + p.half1);
  const Vec c = cross(p.axis0, p.axis1);
  const Search search(p);
  const double slack = bound_error * search.reach();
  Range f;
  if (size == 0) {
    const double apart = length(p.delta);
    // untaken: points in one place touch, of which the gate asks no distance
    f = {-apart, -apart, apart > 0 ? (1 / apart) * p.delta : Vec{0, 0, 1}};
  } else if (c.x == 0 && c.y == 0 && c.z == 0) {
    f = parallel(p);
  } else {
    f = minimise(search, std::max(relative_width * size, slack));
  }
  const Vec& d = f.direction;
  const std::array<double, 3> direction{d.x, d.y, d.z};
  if (truth.verdict == Verdict::touching) return {{0, 0}, direction, f.cells};
  // Back to the scene's unit, outward; then what the verdict alone tells.
  using interval_detail::next_down, interval_detail::next_up;
  Enclosure e{next_down(std::ldexp(-f.hi - slack, exponent)), next_up(std::ldexp(-f.lo + slack, exponent))};
  if (truth.verdict == Verdict::disjoint) e.lo = std::max(e.lo, 0.0);
  if (truth.verdict == Verdict::intersecting) e.hi = std::min(e.hi, 0.0);
  return {e, direction, f.cells};
}

Enclosure enclose_distance(const Pair& pair, const Truth& truth, double relative_width) {
  // untaken: that the distance is 0 the gate takes from the verdict
  if (truth.verdict == Verdict::touching) return {0, 0};
  if (is_rounded(pair)) return attain_distance(pair, truth, relative_width).distance;
  if (const auto near = enclose_near_touching(pair, truth.verdict, relative_width)) return *near;
  return attain_distance(pair, truth, relative_width).distance;
}

// untaken within: for `check --distance`; the gate asks at widths of its own
Enclosure enclose_distance(const Pair& pair, const Truth& truth) {
  if (truth.verdict == Verdict::touching) return {0, 0};
  const double width = truth.verdict == Verdict::disjoint ? gap_width_tol : depth_width_tol;
  return attain_distance(pair, truth, width).distance;
}

}  // namespace cyl
