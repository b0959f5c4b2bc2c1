// SPDX-License-Identifier: MIT
// Let f and K be as in great_circles.hpp, and g the signed distance of the cores, the greatest -f.
// 1. Any direction D gives g >= -f(D).
// 2. Points of the cores at a distance u give g <= u. The search of Gilbert, Johnson and Keerthi finds the
//    nearest ones, and the way between them is the D of the first bound. For tiny gaps that way has lost its
//    digits, and a direction square to a generator is better.
// 3. If the cores overlap, the least f over the circles is the depth. A pair that is apart by less than u has
//    a value of f up to u on the circles. (f is at most the gap at every normal of K at its nearest point,
//    and one of these is on a circle or is the disk's axis.) So greater values show that the cores overlap.
// Roundings move the whole boundary of K outward, in the same direction.
//
// All numbers are long double, so no length or its square over- or underflows. Rounding is bounded for all
// together: fewer than 250 operations on terms up to the reach.
#include "oracles/referee/box_distance.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "corpus/pairs/support.hpp"
#include "oracles/referee/great_circles.hpp"
#include "oracles/referee/interval.hpp"

namespace cyl {
namespace {

using Real = long double;
using Vec = Vec3<Real>;

/// Of the reach: the sum of all half lengths, radii and the way between the centres.
constexpr Real rounding_error = 0x1p-56L;

CorePair cores_of(const Pair& pair) {
  return {terms_of<Real>(pair.a), terms_of<Real>(pair.b),
          lifted<Real>(pair.b.center) - lifted<Real>(pair.a.center)};
}

Real reach_of(const CorePair& pair) {
  Real sum = norm(pair.delta);
  for (const Terms<Real>* s : {&pair.a, &pair.b})
    sum += s->radius + s->half + s->halves[0] + s->halves[1] + s->halves[2];
  return sum;
}

/// A point of each core, each from its own centre, and the way from a's to b's.
struct Points {
  Vec way, on_a, on_b;
};
Points farthest_against(const CorePair& pair, const Vec& d) {
  const Vec on_a = farthest(pair.a, d), on_b = farthest(pair.b, Real(-1) * d);
  return {pair.delta + on_b - on_a, on_a, on_b};
}

/// At most four ways, the last the newest.
class Simplex {
 public:
  /// Keeps the fewest ways whose hull holds the shortest one, and returns that. Its hull has the newest.
  Points shorten(const Points& added) {
    all_[count_++] = added;
    const unsigned newest = 1U << (count_ - 1);
    unsigned best = 0;
    Real least = std::numeric_limits<Real>::infinity();
    std::array<Real, 4> shares{};
    for (unsigned subset = newest; subset < 2 * newest; ++subset)
      if (const auto [ok, weights] = weights_of(subset); ok)
        if (const Vec way = mixed(weights).way; dot(way, way) < least) {
          least = dot(way, way);
          best = subset;
          shares = weights;
        }
    const Points found = mixed(shares);
    std::size_t kept = 0;
    for (std::size_t i = 0; i < count_; ++i)
      if ((best >> i & 1U) != 0) all_[kept++] = all_[i];
    count_ = kept;
    return found;
  }
  bool is_full() const { return count_ == 4; }

 private:
  Points mixed(const std::array<Real, 4>& weights) const {
    Points sum{};
    for (std::size_t i = 0; i < count_; ++i)
      if (weights[i] != 0)
        sum = {sum.way + weights[i] * all_[i].way, sum.on_a + weights[i] * all_[i].on_a,
               sum.on_b + weights[i] * all_[i].on_b};
    return sum;
  }

  /// The point of the subset's affine hull nearest to 0, if it is in the hull.
  std::pair<bool, std::array<Real, 4>> weights_of(unsigned subset) const {
    std::array<std::size_t, 4> at{};
    std::size_t n = 0;
    for (std::size_t i = 0; i < count_; ++i)
      if ((subset >> i & 1U) != 0) at[n++] = i;
    const Vec &p = all_[at[0]].way, x = all_[at[1]].way - p, y = all_[at[2]].way - p, z = all_[at[3]].way - p;
    std::array<Real, 4> part{1, 0, 0, 0};  // unscaled, by place in the subset
    if (n == 2) {
      part = {dot(x, all_[at[1]].way), -dot(x, p), 0, 0};
    } else if (n == 3) {
      const Vec normal = cross(x, y);
      const auto area = [&](const Vec& a, const Vec& b) { return dot(normal, cross(a, b)); };
      const Vec &q = all_[at[1]].way, &r = all_[at[2]].way;
      part = {area(q, r), area(r, p), area(p, q), 0};
    } else if (n == 4) {
      const Vec &q = all_[at[1]].way, &r = all_[at[2]].way, &s = all_[at[3]].way;
      const Real sign = dot(x, cross(y, z)) < 0 ? -1 : 1;
      part = {sign * dot(q, cross(r, s)), -sign * dot(p, cross(r, s)), sign * dot(p, cross(q, s)),
              -sign * dot(p, cross(q, r))};
    }
    const Real sum = part[0] + part[1] + part[2] + part[3];
    std::array<Real, 4> weights{};
    if (!(sum > 0)) return {false, weights};
    for (std::size_t i = 0; i < n; ++i) {
      if (!(part[i] >= 0)) return {false, weights};
      weights[at[i]] = part[i] / sum;
    }
    return {true, weights};
  }

  std::array<Points, 4> all_{};
  std::size_t count_ = 0;
};

struct Nearby {
  Points points;
  Real most, least;  ///< the cores are at most and at least so far apart; `least` may be negative
  Vec direction;     ///< of `least`, of length 1

  void look(const CorePair& pair, const Vec& d) {
    if (const Real shown = -pair.value(d); shown > least) {
      least = shown;
      direction = d;
    }
  }
  void take(const CorePair& pair, const Points& found) {
    const Real length = norm(found.way);
    if (!(length < most)) return;
    points = found;
    most = length;
    if (length > 0) look(pair, found.way / length);
  }
};

/// Shortens the way until both bounds differ by `width`, or until rounding ends it. At a round edge, each
/// step halves the angle that is left.
Nearby find_nearby(const CorePair& pair, Real width) {
  constexpr int steps_cap = 128;
  const Real apart = norm(pair.delta);
  Vec d = apart > 0 ? pair.delta / apart : Vec{0, 0, 1};
  Nearby best{{}, std::numeric_limits<Real>::infinity(), -std::numeric_limits<Real>::infinity(), d};
  Simplex simplex;
  for (int step = 0; step < steps_cap; ++step) {
    const Points added = farthest_against(pair, d);
    if (const Real least = dot(added.way, d); least > best.least) {
      best.least = least;
      best.direction = d;
    }
    if (best.most - best.least <= width) break;
    const Points shorter = simplex.shorten(added);
    const Real length = norm(shorter.way);
    if (!(length < best.most)) break;
    best.points = shorter;
    best.most = length;
    if (length == 0 || simplex.is_full()) break;
    d = shorter.way / length;
  }
  return best;
}

/// The part of v that is square to the solid's axis.
Vec across(const Terms<Real>& s, const Vec& v) { return v - dot(v, s.axis) * s.axis; }

struct Moves {
  bool across;  ///< the disk too, not only along edges and axis
  Real times;   ///< the move that makes the way shortest
};
/// Moves a point of the core by what shortens the way from it.
void slide(const Terms<Real>& s, const Moves& moves, Vec& point, Vec& way) {
  const auto move = [&](const Vec& by) {
    point = point + by;
    way = way - by;
  };
  const auto along = [&](const Vec& e, Real half) {
    const Real at = dot(point, e);
    move((std::clamp(at + moves.times * dot(way, e), -half, half) - at) * e);
  };
  for (std::size_t i = 0; s.box && i < 3; ++i) along(s.edges[i], s.halves[i]);
  if (s.box) return;
  along(s.axis, s.half);
  if (!moves.across) return;
  const Vec at = across(s, point), wanted = at + moves.times * across(s, way);
  const Real far = norm(wanted);
  move((far > s.radius ? s.radius / far : Real(1)) * wanted - at);
}

/// Moves both points in turn, as long as the way gets shorter. Among slender triangles the search above gets
/// no farther than the root of its rounding. Edges that are nearly parallel need many rounds, so most moves
/// are exaggerated. Any factor below 2 shortens the way.
Points polished(const CorePair& pair, Points p, bool across) {
  constexpr int rounds_cap = 1024, rounds_together = 8;
  constexpr Real gain_tol = 0x1p-20L, far = 1.8L;  // the gain is relative
  p.way = pair.delta + p.on_b - p.on_a;
  Real before = norm(p.way);
  for (int round = 1; round <= rounds_cap; ++round) {
    const Moves moves{across, round % 4 == 0 ? Real(1) : far};
    Vec back = Real(-1) * p.way;
    slide(pair.b, moves, p.on_b, back);
    p.way = Real(-1) * back;
    slide(pair.a, moves, p.on_a, p.way);
    if (round % rounds_together != 0) continue;
    const Real length = norm(p.way);
    if (!(length < (1 - gain_tol) * before)) break;
    before = length;
  }
  p.way = pair.delta + p.on_b - p.on_a;
  return p;
}

/// The point of a cylinder moves to that of the rim that is farthest along d, if one is. The gap hardly
/// depends on the place along a rim and a line beside it, so moves in turn would not find it.
void move_to_rim(const Terms<Real>& s, const Vec& d, Vec& point) {
  constexpr Real cap_tol = 0x1p-20L;
  const Vec out = across(s, d);
  if (const Real beside = norm(out); !s.box && beside > cap_tol)
    point = dot(point, s.axis) * s.axis + (s.radius / beside) * out;
}

/// Encloses the signed distance of the cores, up to `slack` on either side. `direction` attains the lower
/// end.
struct Enclosed {
  Real lo, hi, slack;
  Vec direction;
  std::size_t cells = 0;
  Points points{};
};
Enclosed enclose_cores(const CorePair& pair, Real width, std::size_t most_cells) {
  const Real slack = rounding_error * reach_of(pair);
  width = std::max(width / 4, slack);  // the bounds are searched apart
  Nearby near = find_nearby(pair, width);
  if (near.most - near.least > width) near.take(pair, polished(pair, near.points, true));
  LeastOnCircles least;
  if (!(near.least > slack && near.most - near.least <= width)) {
    least = least_on_circles(pair, width, most_cells);
    near.look(pair, least.direction);
    Points rims = near.points;
    move_to_rim(pair.a, near.direction, rims.on_a);
    move_to_rim(pair.b, Real(-1) * near.direction, rims.on_b);
    near.take(pair, polished(pair, rims, false));
    if (least.best > near.most + slack) near.most = -least.floor;
  }
  return {near.least, std::max(near.most, near.least), slack, near.direction, least.cells, near.points};
}

Vector3 in_doubles(const Vec& v) {
  return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)};
}

}  // namespace

AttainedDistance attain_box(const Pair& pair, Verdict verdict, double relative_width) {
  const Enclosed e = enclose_cores(cores_of(pair), Real(relative_width) * size_of(pair), cell_cap);
  const Real roundings = Real(pair.a.rounding) + Real(pair.b.rounding),
             slack = e.slack + 0x1p-62L * roundings;
  using interval_detail::next_down, interval_detail::next_up;
  Enclosure found{next_down(static_cast<double>(e.lo - roundings - slack)),
                  next_up(static_cast<double>(e.hi - roundings + slack))};
  if (verdict == Verdict::intersecting || verdict == Verdict::touching) found.hi = std::min(found.hi, 0.0);
  const Vector3 d = in_doubles(e.direction);
  return {found, {d.x(), d.y(), d.z()}, e.cells};
}

MeasuredDistance measure_box(const Pair& pair, bool with_points) {
  constexpr std::size_t measured_cell_cap = 512;
  constexpr Real parted_tol = 0x1p-10L;  // of the reach
  CorePair cores = cores_of(pair);
  const Real size = size_of(pair);
  Enclosed e = enclose_cores(cores, depth_width_tol * size, measured_cell_cap);
  const Real value =
      std::clamp(e.lo - Real(pair.a.rounding) - Real(pair.b.rounding),
                 -Real(std::numeric_limits<double>::max()), Real(std::numeric_limits<double>::max()));
  const Vec& d = e.direction;
  MeasuredDistance measured{static_cast<double>(value), in_doubles(d), {}, {}};
  if (!with_points) return measured;
  // If the cores overlap, b moves until they are a little apart, to see which points face each other.
  if (e.lo <= e.slack) {
    cores.delta = cores.delta + (parted_tol * reach_of(cores) - e.lo) * d;
    e.points = find_nearby(cores, gap_width_tol * size).points;
  }
  measured.on_a = in_doubles(e.points.on_a + Real(pair.a.rounding) * d);
  measured.on_b = in_doubles(e.points.on_b - Real(pair.b.rounding) * d);
  return measured;
}

}  // namespace cyl
