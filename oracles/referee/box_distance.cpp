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
#include <cmath>
#include <limits>

#include "corpus/pairs/support.hpp"
#include "oracles/referee/box_search.hpp"
#include "oracles/referee/great_circles.hpp"
#include "oracles/referee/interval.hpp"

namespace cyl {
namespace {

using Real = long double;
using Vec = Vec3<Real>;

/// Relative to the reach, which is the sum of all half lengths, radii and the way between the centres.
constexpr Real rounding_error = 0x1p-56L;

CorePair cores_of(const Pair& pair) { return {terms_of_pair<Real>(pair)}; }

/// A point of each core, each from its own centre, and the way from a's to b's.
struct Points {
  Vec way, on_a, on_b;
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
  constexpr Real infinity = std::numeric_limits<Real>::infinity(), thin_tol = 0x1p-56L;
  constexpr int steps_cap = 128;
  const Simplex<Real> s = search_box<Real>(pair, SimplexLimits<Real>{width, thin_tol, 0, false, steps_cap});
  Nearby best{{}, infinity, -infinity, {0, 0, 1}};
  const Vec on_a = s.on_a(), on_b = s.on_b();  // among slender triangles not as near as s.nearest
  best.take(pair, {on_b - on_a, on_a, on_b - pair.delta});
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
