// SPDX-License-Identifier: MIT
// The nearest points of a box and another core, and points that both share. Derivation: boxes.md, section 5.
#include <cmath>

#include "solver/detail/shapes.hpp"

namespace cyl {
namespace {

constexpr int projection_steps = 3, edge_step_cap = 60;

class Nearest {
 public:
  Nearest(const BoxView& v, double contact) noexcept
      : v_(v),
        contact_(contact),
        reach_(v.half.sum() + v.half1.sum() + v.r + v.h + length(v.d) + larger(contact, 0)) {}

  NearestPoints run() noexcept {
    best_.square = 0x1p1000;
    Vector3 on0 = clamped(v_.d, v_.half);
    for (int i = 0; i < projection_steps; ++i) {
      const Vector3 on1 = v_.nearest_to(on0);
      if (consider(on0, on1)) return best_;
      on0 = clamped(on1, v_.half);
      if (consider(on0, on1)) return best_;
    }
    look_at_edges() || look_at_vertices();
    return best_;
  }

 private:
  // Returns true if the question is answered.
  bool consider(const Vector3& on0, const Vector3& on1) noexcept {
    ++best_.steps;
    const Vector3 way = on1 - on0;
    const double square = dot(way, way);
    if (!(square < best_.square)) return false;
    best_.on0 = on0;
    best_.on1 = on1;
    best_.square = square;
    if (contact_ < 0) return false;
    if (square <= contact_ * contact_) return true;
    const double gap = v_.gap(way);
    return best_.apart = gap > 0 && gap * gap > contact_ * contact_ * square;
  }

  // The edge p + t g, |t| <= 1. The square of the distance is convex in t: Newton's method with a bracket.
  bool look_along(const Vector3& p, const Vector3& g) noexcept {
    const double size = dot(g, g);
    double t = size > 0 ? smaller(1, larger(-1, dot(best_.on1 - p, g) / size)) : 0, lo = -1, hi = 1;
    bool saw_lo = false, saw_hi = false;
    for (int i = 0; i < edge_step_cap; ++i) {
      const Vector3 x = p + t * g, y = v_.nearest_to(x), way = y - x;
      if (consider(x, y)) return true;
      const double slope = -dot(way, g), square = dot(way, way);
      // The distance anywhere on the rest of the edge is at least `least` over the distance here.
      const double rest = slope < 0 ? hi - t : t - lo, least = square - std::fabs(slope) * rest;
      if (slope == 0 || least >= (std::sqrt(best_.square) - unit_roundoff_error * reach_) * std::sqrt(square))
        return false;
      (slope > 0 ? hi : lo) = t;
      (slope > 0 ? saw_hi : saw_lo) = true;
      double next = t - slope / v_.bend(x, g);  // may be infinite
      if (!(next > lo && next < hi)) {
        if (slope > 0 ? saw_lo : saw_hi)
          next = 0.5 * (lo + hi);
        else
          next = slope > 0 ? lo : hi;
      }
      if (next == t || hi - lo < 0x1p-60) return false;
      t = next;
    }
    return false;
  }

  bool look_at_edges() noexcept {
    const Vector3& half = v_.half;
    for (int i = 0; i < 3; ++i)
      for (int k = 0; k < 4; ++k) {
        const int l = (i + 1) % 3, m = (i + 2) % 3;
        Vector3 p(0, 0, 0), g(0, 0, 0);
        g[i] = half[i];
        p[l] = k & 1 ? half[l] : -half[l];
        p[m] = k & 2 ? half[m] : -half[m];
        if (look_along(p, g)) return true;
      }
    return false;
  }

  // Vertices of the other box, or the points of a cylinder that are lowest over a facet.
  bool look_at_vertices() noexcept {
    if (v_.box) {
      for (int k = 0; k < 8; ++k) {
        const Vector3 at = v_.d + (k & 1 ? 1 : -1) * v_.half1[0] * v_.e[0] +
                           (k & 2 ? 1 : -1) * v_.half1[1] * v_.e[1] +
                           (k & 4 ? 1 : -1) * v_.half1[2] * v_.e[2];
        if (consider(clamped(at, v_.half), at)) return true;
      }
      return false;
    }
    for (int i = 0; i < 3; ++i) {
      Vector3 down(0, 0, 0);
      down[i] = v_.d[i] < 0 ? 1 : -1;
      // Made square to the axis twice, because little is left over a level cap.
      Vector3 rim = down - dot(down, v_.e[0]) * v_.e[0];
      rim -= dot(rim, v_.e[0]) * v_.e[0];
      const double size = length(rim);
      rim *= size > separation_error ? v_.r / size : 0;
      for (const double end : {v_.h, -v_.h}) {
        const Vector3 middle = v_.d + end * v_.e[0], at = middle + rim;
        if (consider(clamped(at, v_.half), at) || consider(clamped(middle, v_.half), middle)) return true;
      }
    }
    return false;
  }

  const BoxView& v_;
  const double contact_, reach_;
  NearestPoints best_{};
};

// The part of the segment from + t g, |t| <= 1, in |x.e_i - c_i| <= half_i. Here x.e_i is given for both.
bool middle_of_part(const Vector3& from, const Vector3& g, const Vector3& half, double& t) noexcept {
  for (int i = 0; i < 3; ++i)
    if (std::fabs(from[i]) > half[i] + std::fabs(g[i])) return false;  // most, without a division
  double lo = -1, hi = 1;
  for (int i = 0; i < 3; ++i) {
    if (g[i] == 0) continue;
    const double t0 = (-half[i] - from[i]) / g[i], t1 = (half[i] - from[i]) / g[i];
    lo = larger(lo, smaller(t0, t1));
    hi = smaller(hi, larger(t0, t1));
  }
  t = 0.5 * (lo + hi);
  return lo <= hi;
}

}  // namespace

int find_directions(const BoxView& v, const Vector3& on1, const Vector3& way,
                    Vector3 (&found)[direction_cap]) noexcept {
  const Vector3 tangent = v.e[0].cross(on1 - v.d);
  const bool round = !v.box && v.r > 0;
  int count = 0;
  for (int i = 0; i < (v.box ? box_axes : cylinder_axes); ++i) found[count++] = axis_of(v, i);
  // Square to edges of the other one, of the first box, or of both, which may differ by less than `most`.
  for (const double square_tol : {0.0, 0x1p-26, 0x1p-10})
    for (int which = square_tol > 0 ? 1 : 3; which <= 3; ++which) {
      Vector3 d = way;
      const double most = square_tol * length(way);
      for (int j = 0; j < (v.box ? 3 : 1); ++j)
        if ((which & 1) && std::fabs(dot(d, v.e[j])) < most) d -= dot(d, v.e[j]) * v.e[j];
      for (int i = 0; i < 3; ++i)
        if ((which & 2) && std::fabs(d[i]) < most) d[i] = 0;
      found[count++] = d;
      if (round) found[count++] = dot(tangent, tangent) * d - dot(tangent, d) * tangent;
    }
  if (!round) return count;
  for (int i = 0; i < 3; ++i) found[count++] = tangent.cross(Vector3(i == 0, i == 1, i == 2));
  const ClippedBox clipped = clip(v);
  found[count++] = clipped.out;
  if (clipped.edge < 0) return count;
  const Vector3 edge(clipped.edge == 0, clipped.edge == 1, clipped.edge == 2);
  found[count++] = v.e[0].cross(clipped.out).cross(edge);
  return count;
}

// The gap is concave in D, and |D| is convex. So their ratio has one maximum on a plane if a gap is > 0.
Vector3 best_direction(const BoxView& v, const Vector3& way) noexcept {
  const Vector3 n = way / length(way), p = n.cross(Vector3(std::fabs(n[0]) < 0.6, std::fabs(n[0]) >= 0.6, 0)),
                u = p / length(p), w = n.cross(u);
  constexpr double width_tol = 0x1p-4;
  const auto search = [](auto value) {
    return golden_section(value, -width_tol, width_tol, 66);  // to 2^-50
  };
  const auto at = [&](double s, double t) { return Vector3(n + s * u + t * w); };
  const auto second = [&](double s) {
    return search([&](double t) { return v.gap(at(s, t)) / length(at(s, t)); });
  };
  const double s = search([&](double x) {
    const Vector3 d = at(x, second(x));
    return v.gap(d) / length(d);
  });
  return at(s, second(s));
}

NearestPoints nearest_points(const BoxView& v, double contact) noexcept { return Nearest(v, contact).run(); }

bool find_common_point(const BoxView& v, Vector3& at) noexcept {
  if (!v.box && v.r > 0) {
    const ClippedBox clipped = clip(v);
    at = clipped.at;
    return clipped.meets;
  }
  double t = 0;
  if (!v.box) {
    const Vector3 g = v.h * v.e[0];
    if (!middle_of_part(v.d, g, v.half, t)) return false;
    at = v.d + t * g;
    return true;
  }
  const auto seen = [&](const Vector3& x) { return Vector3(dot(x, v.e[0]), dot(x, v.e[1]), dot(x, v.e[2])); };
  // An edge may seem to be just outside if facets and edges coincide but for rounding.
  const double slack = 0.5 * box_error * (v.half.sum() + v.half1.sum() + length(v.d));
  const Vector3 half = v.half + Vector3(slack, slack, slack), half1 = v.half1 + Vector3(slack, slack, slack);
  at = clamped(v.d, v.half);
  if (const Vector3 y = seen(at - v.d); clamped(y, v.half1) == y) return true;
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 4; ++k) {
      const int l = (i + 1) % 3, m = (i + 2) % 3;
      const double side_l = k & 1 ? 1 : -1, side_m = k & 2 ? 1 : -1;
      Vector3 p(0, 0, 0), g(0, 0, 0);
      g[i] = v.half[i];
      p[l] = side_l * v.half[l];
      p[m] = side_m * v.half[m];
      if (middle_of_part(seen(p - v.d), seen(g), half1, t)) {
        at = p + t * g;
        return true;
      }
      g = v.half1[i] * v.e[i];
      p = v.d + side_l * v.half1[l] * v.e[l] + side_m * v.half1[m] * v.e[m];
      if (middle_of_part(p, g, half, t)) {
        at = p + t * g;
        return true;
      }
    }
  return false;
}

}  // namespace cyl
