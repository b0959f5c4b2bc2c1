// SPDX-License-Identifier: MIT
// The distance of solids grown by balls, from that of their cores.
#include <cmath>

#include "solver/decide.hpp"
#include "solver/detail/shapes.hpp"

namespace cyl {
namespace {

// Lengths above this may add up to more than the largest double.
constexpr double huge_tol = 0x1p1000;

// Each solid grows by a ball: what lies between them shrinks by both radii, whether it is a gap or a depth.
// `way`: the unit vector between the points if a gap stays.
void grow(Distance& d, const Vector3& way, double rounding_a, double rounding_b) noexcept {
  const double contact_distance = rounding_a + rounding_b;
  const bool apart = d.value > 0;
  d.error += 4 * unit_roundoff_error * larger(contact_distance, std::fabs(d.value));
  d.value -= contact_distance;
  d.on_a += rounding_a * (d.value > 0 ? way : d.direction);
  d.on_b -= rounding_b * (d.value > 0 ? way : d.direction);
  // Every direction's f grows by as much. If the cores are apart, `error` shows that there is no lower one.
  d.least = d.value <= 0 && (d.least || apart);
  d.verdict = d.value > 0 ? Verdict::disjoint : Verdict::intersecting;
}

// With a box, the direction that proves the gap may be off the line of the points by the root of rounding.
Vector3 way_between(const Prepared& a, const Prepared& b, const Distance& d) noexcept {
  const Vector3 way = (b.center - a.center) + (d.on_b - d.on_a);
  const double most = max_abs(way);
  if (!(most > 0)) return d.direction;
  const Vector3 scaled = way * power_of_two(-exponent_of(most));
  return scaled / length(scaled);
}

double longest_of(const Prepared& c) noexcept {
  return larger(larger(max_abs(c.center), c.rounding), larger(larger(c.radius, c.height), max_abs(c.edges)));
}

// Its core, in another unit.
Prepared core_in_unit(const Prepared& c, double unit) noexcept {
  Prepared core = core_of(c);
  if (unit != 1) {
    core.center *= unit;
    core.radius *= unit;
    core.height *= unit;
    core.edges *= unit;
  }
  return core;
}

}  // namespace

Distance distance(const Prepared& a, const Prepared& b) noexcept {
  if ((a.defect != Defect::none) | (b.defect != Defect::none)) {
    Distance out;
    out.verdict = Verdict::invalid;
    return out;
  }
  const bool other = has_other_shape(a, b);
  if (a.shape == Shape::half_space && b.shape == Shape::half_space) {
    Distance out;
    out.verdict = Verdict::invalid;
    return out;
  }
  if (a.rounding + b.rounding == 0) return other ? distance_of_shapes(a, b) : distance_of_cores(a, b, false);
  // The gap of the cores or the sum of the roundings may exceed the largest double, although their difference
  // does not. Lengths near it are made so small that neither does. The loss of lengths that become subnormal
  // is far below the error.
  const double unit = larger(longest_of(a), longest_of(b)) > huge_tol ? 0x1p-4 : 1;
  const Prepared core_a = core_in_unit(a, unit), core_b = core_in_unit(b, unit);
  Distance out = other ? distance_of_shapes(core_a, core_b, unit * (a.rounding + b.rounding))
                       : distance_of_cores(core_a, core_b, true);
  grow(out, other ? way_between(core_a, core_b, out) : out.direction, unit * a.rounding, unit * b.rounding);
  if (unit != 1) {
    out.value = in_range(out.value / unit);
    out.error = in_range(out.error / unit);
    for (int i = 0; i < 3; ++i) {
      out.on_a[i] = in_range(out.on_a[i] / unit);
      out.on_b[i] = in_range(out.on_b[i] / unit);
    }
  }
  // Within rounding decide() has the last word; half of the error is within it of any gap there.
  if (out.value <= 0 && -out.value <= out.error && decide(a, b).verdict == Verdict::disjoint) {
    out.verdict = Verdict::disjoint;
    out.value = 0.5 * out.error;
    out.least = false;
  }
  return out;
}

Distance distance(const Solid& a, const Solid& b) noexcept { return distance(prepare(a), prepare(b)); }

}  // namespace cyl
