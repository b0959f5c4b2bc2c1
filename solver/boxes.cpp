// SPDX-License-Identifier: MIT
// The verdict on pairs with a box or a half-space. Derivation: boxes.md.
#include <bit>
#include <cmath>

#include "solver/detail/along_edges.hpp"
#include "solver/detail/certify.hpp"
#include "solver/detail/shapes.hpp"

namespace cyl {
namespace {

constexpr int next_of[] = {1, 2, 0}, last_of[] = {2, 0, 1};

// Bit 3 j + k: the product of edge k of a box and edge j of the other, e[j], separates them. A coordinate of
// v_j x x is along such a product.
[[gnu::always_inline]] inline unsigned products_apart(Seen half, Seen half1, Seen d,
                                                      const Seen (&e)[3]) noexcept {
  const Seen c01 = magnitude(cross(e[0], e[1])), c12 = magnitude(cross(e[1], e[2])),
             c20 = magnitude(cross(e[2], e[0]));
  const double h0 = half1.xy[0], h1 = half1.xy[1], h2 = half1.z;
  const auto apart = [&](int j, Seen other) {
    return are_above(magnitude(cross(e[j], d)), crosswise(half, magnitude(e[j])) + other) << 3 * j;
  };
  return apart(0, h1 * c01 + h2 * c20) | apart(1, h0 * c01 + h2 * c12) | apart(2, h0 * c20 + h1 * c12);
}

// The support of a cylinder's disk along e_i.
double share_of(const BoxView& v, int i) noexcept {
  const double w1 = v.e[0][next_of[i]], w2 = v.e[0][last_of[i]];
  return v.r == 0 ? 0 : v.r * std::sqrt(w1 * w1 + w2 * w2);
}

// Two boxes as seen from the first. Each step answers all its questions at once, because each alone would be
// an unpredictable branch.
struct TwoBoxes {
  [[gnu::always_inline]] TwoBoxes(const Prepared& a, const Prepared& b) noexcept
      : seen(a),
        half(half_of(a)),
        half1(half_of(b)),
        d(seen(b.center - a.center)),
        e{seen(b.unit_axis), seen(b.second_axis), seen(b.unit_axis.cross(b.second_axis))},
        size{magnitude(e[0]), magnitude(e[1]), magnitude(e[2])} {}
  // Along the edges of the second box.
  [[gnu::always_inline]] Seen from_second(Seen x) const noexcept {
    return {Both{dot(x, e[0]), dot(x, e[1])}, dot(x, e[2])};
  }
  // Whether a normal separates them by more than `contact`.
  [[gnu::always_inline]] unsigned apart_by_normal(double contact) const noexcept {
    const Seen beyond(both(contact), contact);
    const Seen reach0 = half + half1.xy[0] * size[0] + half1.xy[1] * size[1] + half1.z * size[2];
    const Seen reach1 = half1 + Seen(Both{dot(half, size[0]), dot(half, size[1])}, dot(half, size[2]));
    return are_above(magnitude(d), reach0 + beyond) | are_above(magnitude(from_second(d)), reach1 + beyond);
  }
  // Whether the second core has the point of the first that is nearest to its centre.
  [[gnu::always_inline]] unsigned meet() const noexcept {
    return are_above(magnitude(from_second(d - clamped(d, half))), half1) == 0;
  }

  SeenFrom seen;
  Seen half, half1, d, e[3], size[3];
};

Verdict intersect_boxes(const Prepared& a, const Prepared& b, double contact) noexcept {
  const TwoBoxes boxes(a, b);
  const unsigned apart = boxes.apart_by_normal(contact);
  if ((apart | boxes.meet()) != 0) return verdict_of(apart == 0);
  const bool meet = (contact == 0 || boxes.apart_by_normal(0) == 0) &&
                    products_apart(boxes.half, boxes.half1, boxes.d, boxes.e) == 0;
  if (meet | (contact == 0)) return verdict_of(meet);
  return verdict_of(nearest_points(BoxView(a, b), contact).square <= contact * contact);
}

}  // namespace

Verdict intersect_box(const Prepared& a, const Prepared& b, double contact) noexcept {
  if (b.shape == Shape::box) return intersect_boxes(a, b, contact);
  const BoxView v(a, b);
  if (contact == 0) {
    if (v.r > 0 && holds(v, clamped(v.d, v.half), 0)) return Verdict::intersecting;
    return verdict_of(separating_axis(v) < 0 && (v.r == 0 || clip(v).meets));
  }
  const NearestPoints found = nearest_points(v, contact);
  if (found.square <= contact * contact) return Verdict::intersecting;
  if (found.apart) return Verdict::disjoint;
  return verdict_of(separating_axis(v) < 0 && clip(v).meets);
}

BoxView::BoxView(const Prepared& a, const Prepared& b) noexcept
    : edges(a),
      half(0.5 * a.edges),
      d(edges.seen(b.center - a.center)),
      box(b.shape == Shape::box),
      r(b.radius),
      h(0.5 * b.height) {
  e[0] = edges.seen(b.unit_axis);
  if (!box) return;
  e[1] = edges.seen(b.second_axis);
  e[2] = edges.seen(b.unit_axis.cross(b.second_axis));
  half1 = 0.5 * b.edges;
}

double BoxView::support(const Vector3& x) const noexcept {
  if (!box) return r * length(x.cross(e[0])) + h * std::fabs(dot(x, e[0]));
  return half1[0] * std::fabs(dot(x, e[0])) + half1[1] * std::fabs(dot(x, e[1])) +
         half1[2] * std::fabs(dot(x, e[2]));
}

double BoxView::gap(const Vector3& x) const noexcept {
  return dot(x, d) - half[0] * std::fabs(x[0]) - half[1] * std::fabs(x[1]) - half[2] * std::fabs(x[2]) -
         support(x);
}

Vector3 BoxView::nearest_to(const Vector3& x, double less) const noexcept {
  const Vector3 y = x - d;
  if (!box) return d + nearest(y, e[0], r - less, h - less);
  return d + (clamped(dot(y, e[0]), half1[0] - less) * e[0] + clamped(dot(y, e[1]), half1[1] - less) * e[1] +
              clamped(dot(y, e[2]), half1[2] - less) * e[2]);
}

double BoxView::bend(const Vector3& x, const Vector3& g) const noexcept {
  const Vector3 y = x - d;
  double sum = 0;
  if (box) {
    for (int j = 0; j < 3; ++j)
      if (std::fabs(dot(y, e[j])) > half1[j]) sum += square(dot(g, e[j]));
    return sum;
  }
  const double along = dot(y, e[0]), g_along = dot(g, e[0]);
  if (std::fabs(along) > h) sum = square(g_along);
  const Vector3 across = y - along * e[0], g_across = g - g_along * e[0];
  const double away = length(across);
  if (!(away > r)) return sum;
  const double radial = square(dot(g_across, across) / away);
  return sum + radial + positive(dot(g_across, g_across) - radial) * (1 - r / away);
}

int separating_normal(const BoxView& v, double slack) noexcept {
  const Vector3 &d = v.d, *e = v.e;
  for (int i = 0; i < 3; ++i)
    if (std::fabs(d[i]) >
        slack + (v.half[i] + (v.box ? v.half1[0] * std::fabs(e[0][i]) + v.half1[1] * std::fabs(e[1][i]) +
                                          v.half1[2] * std::fabs(e[2][i])
                                    : v.h * std::fabs(e[0][i]) + share_of(v, i))))
      return i;
  for (int j = 0; j < (v.box ? 3 : 1); ++j)
    if (std::fabs(dot(d, e[j])) > slack + ((v.box ? v.half1[j] : v.h) + v.half[0] * std::fabs(e[j][0]) +
                                           v.half[1] * std::fabs(e[j][1]) + v.half[2] * std::fabs(e[j][2])))
      return 3 + j;
  return -1;
}

bool holds(const BoxView& v, const Vector3& at, double slack) noexcept {
  const Vector3 x = at - v.d;
  const double along = dot(x, v.e[0]);
  if (v.box)
    return (std::fabs(along) <= v.half1[0] - slack) & (std::fabs(dot(x, v.e[1])) <= v.half1[1] - slack) &
           (std::fabs(dot(x, v.e[2])) <= v.half1[2] - slack);
  const Vector3 across = x - along * v.e[0];
  const double room = v.r - slack;
  return (room >= 0) & (std::fabs(along) <= v.h - slack) & (dot(across, across) <= room * room);
}

int separating_product(const BoxView& v) noexcept {
  if (v.box) {
    const Seen e[] = {Seen(v.e[0]), Seen(v.e[1]), Seen(v.e[2])};
    const unsigned apart = products_apart(Seen(v.half), Seen(v.half1), Seen(v.d), e);
    return apart == 0 ? -1 : 6 + std::countr_zero(apart);
  }
  const Vector3 &w = v.e[0], &d = v.d;
  for (int i = 0; i < 3; ++i) {
    const int l = next_of[i], m = last_of[i];
    if (std::fabs(w[l] * d[m] - w[m] * d[l]) >
        v.half[l] * std::fabs(w[m]) + v.half[m] * std::fabs(w[l]) + share_of(v, i))
      return 4 + i;
  }
  return v.gap(d - clamped(d, v.half)) > 0 ? 7 : -1;
}

int separating_axis(const BoxView& v) noexcept {
  const int normal = separating_normal(v, 0);
  // A common point of boxes is a frequent case.
  if (normal >= 0 || (v.box && holds(v, clamped(v.d, v.half), 0))) return normal;
  return separating_product(v);
}

Vector3 axis_of(const BoxView& v, int index) noexcept {
  Vector3 unit(0, 0, 0);
  if (index < 3) {
    unit[index] = 1;
    return unit;
  }
  if (v.box && index < 6) return v.e[index - 3];
  if (v.box) {
    unit[(index - 6) % 3] = 1;
    return unit.cross(v.e[(index - 6) / 3]);
  }
  if (index == 3) return v.e[0];
  if (index == 7) return v.d - clamped(v.d, v.half);
  unit[index - 4] = 1;
  return unit.cross(v.e[0]);
}

// In coordinates along p, q and w, square to each other. Each edge is cut by both caps once. So every point
// here belongs to one polytope, the box between two planes within rounding of the caps.
ClippedBox clip(const BoxView& v) noexcept {
  ClippedBox best;
  const Vector3& w = v.e[0];
  // The axis may pass through the box.
  double lo = -v.h, hi = v.h;
  for (int i = 0; i < 3; ++i) {
    if (w[i] == 0) {
      if (std::fabs(v.d[i]) > v.half[i]) hi = -1e300;
      continue;
    }
    const double t0 = (-v.half[i] - v.d[i]) / w[i], t1 = (v.half[i] - v.d[i]) / w[i];
    lo = larger(lo, smaller(t0, t1));
    hi = smaller(hi, larger(t0, t1));
  }
  if (lo <= hi) {
    best.at = v.d + 0.5 * (lo + hi) * w;
    best.meets = true;
    return best;
  }
  int least = 0;
  for (int i = 1; i < 3; ++i)
    if (std::fabs(w[i]) < std::fabs(w[least])) least = i;
  Vector3 p(0, 0, 0);
  p[least] = 1;
  p = w.cross(p);
  p /= length(p);
  const Vector3 q = w.cross(p);
  const auto turned = [&](const Vector3& x) { return Vector3(dot(x, p), dot(x, q), dot(x, w)); };
  const Vector3 center = turned(-v.d);
  Vector3 g[3], corner[8];
  for (int i = 0; i < 3; ++i) g[i] = v.half[i] * Vector3(p[i], q[i], w[i]);
  for (int k = 0; k < 8; ++k)
    corner[k] = center + ((k & 1) ? g[0] : Vector3(-g[0])) + ((k & 2) ? g[1] : Vector3(-g[1])) +
                ((k & 4) ? g[2] : Vector3(-g[2]));
  const double square_r = v.r * v.r;
  // The point of a segment that is nearest to the axis. Returns true if that is in the cylinder.
  const auto consider = [&](const Vector3& from, const Vector3& to, int edge) {
    const double x = to[0] - from[0], y = to[1] - from[1], size = x * x + y * y;
    double t = -(from[0] * x + from[1] * y);
    t = t <= 0 ? 0 : t >= size ? 1 : t / size;
    const Vector3 at = t <= 0.5 ? Vector3(from + t * (to - from)) : Vector3(to - (1 - t) * (to - from));
    const double square = at[0] * at[0] + at[1] * at[1];
    if (square < best.square) {
      best.square = square;
      best.at = at;
      best.edge = edge;
    }
    return square <= square_r;
  };
  Vector3 cut[2][12];
  bool is_cut[2][12];
  bool any_cut = false;
  best.meets = [&] {
    for (int i = 0, n = 0; i < 3; ++i)
      for (int k = 0; k < 8; ++k) {
        if (k >> i & 1) continue;
        const Vector3 &from = corner[k], &to = corner[k | 1 << i];
        Vector3 ends[2] = {from, to};
        for (int cap = 0; cap < 2; ++cap) {
          const double sign = cap == 0 ? 1 : -1, above0 = sign * from[2] - v.h, above1 = sign * to[2] - v.h;
          is_cut[cap][n] = (above0 > 0) != (above1 > 0);
          if (!is_cut[cap][n]) continue;
          any_cut = true;
          // From the end that is nearer to the cap.
          const double t = above0 / (above0 - above1);
          Vector3 at = t <= 0.5 ? Vector3(from + t * (to - from))
                                : Vector3(to + above1 / (above0 - above1) * (to - from));
          at[2] = sign * v.h;
          cut[cap][n] = at;
          ends[above1 > 0] = at;
        }
        ++n;
        if ((from[2] > v.h && to[2] > v.h) || (from[2] < -v.h && to[2] < -v.h)) continue;
        if (consider(ends[0], ends[1], i)) return true;
      }
    if (!any_cut) return false;
    // Edge n is along i = n / 4. Facet (i, side) has the edges along the other two on this side.
    for (int cap = 0; cap < 2; ++cap)
      for (int i = 0; i < 3; ++i)
        for (int side = 0; side < 2; ++side) {
          const Vector3* first = nullptr;
          for (int of = 0; of < 3; ++of) {
            if (of == i) continue;
            // The edges along `of` are counted by the bits of the other two.
            const int low = of == 0 ? 1 : 0, bit = i == low ? 1 : 2;
            for (int m = 0; m < 4; ++m) {
              const int n = 4 * of + m;
              if (((m & bit) != 0) != (side != 0) || !is_cut[cap][n]) continue;
              if (!first)
                first = &cut[cap][n];
              else if (consider(*first, cut[cap][n], -1))
                return true;
            }
          }
        }
    return false;
  }();
  best.out = best.at[0] * p + best.at[1] * q;
  best.at = v.d + best.at[0] * p + best.at[1] * q + best.at[2] * w;
  return best;
}

bool boxes_out_of_order(const Prepared& a, const Prepared& b) noexcept {
  const Vector3* const numbers[][2] = {{&a.edges, &b.edges},
                                       {&a.unit_axis, &b.unit_axis},
                                       {&a.second_axis, &b.second_axis},
                                       {&a.center, &b.center}};
  for (const auto& [x, y] : numbers)
    for (int i = 0; i < 3; ++i)
      if ((*x)[i] != (*y)[i]) return (*x)[i] > (*y)[i];
  return a.rounding > b.rounding;
}

PairInUnit in_unit(const Prepared& a, const Prepared& b, double clearance) noexcept {
  const auto longest = [](const Prepared& c) {
    return larger(larger(c.radius, c.height), larger(c.rounding, max_abs(c.edges)));
  };
  const double widest = larger(larger(longest(a), longest(b)), clearance);
  // The point of a plane may be far away. Its difference from the other centre would be rounded.
  const bool plane = a.shape == Shape::half_space;
  const double farthest = 0x1p-900 * larger(max_abs(a.center), max_abs(b.center));
  Vector3 delta = b.center - a.center;
  double most = larger(widest, plane ? farthest : max_abs(delta));
  int shift = 0;  // as in scale()
  if (!(most < 0x1p1000))
    shift = -200;
  else if (most < 0x1p-800)
    shift = 200;
  const double before = power_of_two(shift);
  delta = shift < 0 ? Vector3(b.center * before - a.center * before) : Vector3(delta * before);
  most = larger(widest * before, plane ? farthest * before : max_abs(delta));
  const int exponent = most > 0 ? exponent_of(most) : 0;
  const double unit = power_of_two(-exponent);
  PairInUnit p{a, b, 0, exponent - shift};
  for (Prepared* const c : {&p.a, &p.b}) {
    c->radius = c->radius * before * unit;
    c->height = c->height * before * unit;
    c->rounding = c->rounding * before * unit;
    c->edges = c->edges * before * unit;
    c->center = plane ? Vector3(c->center * before * unit) : Vector3(0, 0, 0);
    c->traits |= Prepared::moderate;
  }
  if (!plane) p.b.center = delta * unit;
  p.contact = contact_distance_of(p.a, p.b, clearance * before * unit);
  return p;
}

}  // namespace cyl
