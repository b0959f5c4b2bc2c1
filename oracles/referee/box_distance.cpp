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
// All is searched in doubles, in the unit of terms_in_unit(). The first two bounds are then computed in twins
// (shown_distance.hpp). If they are far apart, the nearest points are searched in twins.
//
// Rounding of the third, in units of 2^-53 of the reach. Edges are known to 12. So a circle's plane is known
// to 16, and the length of D to 9. Shadows add 5, their sum 9, and the point of the disk 12. A product with y
// is off by 5. At c the products with y0 and y1 may differ by 20. The sum is less than 128.
#include "oracles/referee/box_distance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "oracles/referee/great_circles.hpp"
#include "oracles/referee/shown_distance.hpp"

namespace cyl {
namespace {

using Vec = Vec3<double>;

/// Relative to the reach, which is the sum of all half lengths, radii and the way between the centres.
constexpr double rounding_error = 0x1p-46;

/// A point of each core, each from its own centre, and the way from a's to b's.
struct Points {
  Vec way, on_a, on_b;
};

struct Nearby {
  Points points;
  double most, least;  ///< the cores are at most and at least so far apart; `least` may be negative
  Vec direction;       ///< of `least`, of length 1

  void look(const CorePair& pair, const Vec& d) {
    if (const double shown = -pair.value(d); shown > least) {
      least = shown;
      direction = d;
    }
  }
  void take(const CorePair& pair, const Points& found) {
    const double length = norm(found.way);
    if (length > short_tol) look(pair, found.way / length);
    if (!(length < most)) return;
    points = found;
    most = length;
  }
};

Vec in_doubles(const Vec3<Twin>& v) { return {v.x.hi, v.y.hi, v.z.hi}; }
const Vec& in_doubles(const Vec& v) { return v; }

/// Shortens the way until both bounds differ by `width`, or until rounding ends it. At a round edge, each
/// step halves the angle that is left.
template <class R>
Points search_points(const TermsPair<R>& pair, double width, double thin) {
  constexpr int steps_cap = 128;
  const Simplex<R> s = search_box<R>(pair, SimplexLimits<R>{width, thin, 0.0, false, steps_cap});
  const Vec3<R> on_a = s.on_a(), on_b = s.on_b();  // among slender triangles not as near as s.nearest
  return {in_doubles(on_b - on_a), in_doubles(on_a), in_doubles(on_b - pair.delta)};
}
Nearby find_nearby(const CorePair& pair, double width) {
  constexpr double infinity = std::numeric_limits<double>::infinity(), thin_tol = 0x1p-45;
  Nearby best{{}, infinity, -infinity, {0, 0, 1}};
  best.take(pair, search_points(pair, width, thin_tol));
  return best;
}

/// An enclosure in the unit of terms_in_unit(). The direction of `near` attains the lower end.
struct Enclosed {
  int exponent = 0;
  CorePair cores;
  double size;
  Nearby near{};
  ShownBounds bounds{};
  LeastOnCircles least{};

  Enclosed(const Pair& pair, double relative_width, std::size_t most_cells)
      : cores{terms_in_unit<double>(pair, exponent)}, size(std::ldexp(size_of(pair), -exponent)) {
    const double slack = rounding_error * reach_of(cores) + short_error;
    const double width = std::max(relative_width * size / 4, slack);  // the bounds are searched apart
    near = find_nearby(cores, width);
    if (!(near.least > slack && near.most - near.least <= width)) {
      least = least_on_circles(cores, width, most_cells);
      near.look(cores, least.direction);
    }
    const TermsPair<Twin> p = terms_in_unit<Twin>(pair, exponent);
    const auto bound = [&] {
      bounds = shown_bounds(p, near.direction, near.points.on_a, near.points.on_b);
      if (least.best > near.most + slack) bounds.hi = Twin(slack - least.floor) - p.a.rounding - p.b.rounding;
    };
    bound();
    if (bounds.hi - bounds.lo > Twin(2 * width)) {  // rounding ended the search in doubles
      constexpr double fine_tol = 0x1p-80, thin_tol = 0x1p-90;
      near.take(cores, search_points(p, fine_tol, thin_tol));
      bound();
    }
    bounds.hi = std::max(bounds.lo, bounds.hi);
  }
};

Vector3 in_scene(const Vec& v, int exponent) {
  return {std::ldexp(v.x, exponent), std::ldexp(v.y, exponent), std::ldexp(v.z, exponent)};
}

}  // namespace

AttainedDistance attain_box(const Pair& pair, Verdict verdict, double relative_width) {
  const Enclosed e(pair, relative_width, cell_cap);
  Enclosure found = e.bounds.in_scene(e.exponent);
  if (verdict == Verdict::intersecting || verdict == Verdict::touching) found.hi = std::min(found.hi, 0.0);
  return {found, {e.near.direction.x, e.near.direction.y, e.near.direction.z}, e.least.cells};
}

MeasuredDistance measure_box(const Pair& pair, bool with_points) {
  constexpr std::size_t measured_cell_cap = 512;
  constexpr double parted_tol = 0x1p-10;  // of the reach
  constexpr double largest = std::numeric_limits<double>::max();
  Enclosed e(pair, depth_width_tol, measured_cell_cap);
  const Vec& d = e.near.direction;
  const double value = std::ldexp(e.bounds.lo.hi, e.exponent);
  MeasuredDistance measured{std::clamp(value, -largest, largest), {d.x, d.y, d.z}, {}, {}};
  if (!with_points) return measured;
  // If the cores overlap, b moves until they are a little apart, to see which points face each other.
  if (e.near.least <= 0) {
    e.cores.delta = e.cores.delta + (parted_tol * reach_of(e.cores) - e.near.least) * d;
    e.near.points = find_nearby(e.cores, gap_width_tol * e.size).points;
  }
  measured.on_a = in_scene(e.near.points.on_a + e.cores.a.rounding * d, e.exponent);
  measured.on_b = in_scene(e.near.points.on_b - e.cores.b.rounding * d, e.exponent);
  return measured;
}

}  // namespace cyl
