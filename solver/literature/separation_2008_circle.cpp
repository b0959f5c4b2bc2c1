// SPDX-License-Identifier: MIT
#include "solver/literature/separation_2008_circle.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <limits>
#include <span>

namespace cyl::literature {
namespace {

constexpr int degree_cap = 8;  ///< of a polynomial whose roots are asked for

struct RealRoots {
  std::array<double, degree_cap> x;
  int count = 0;
};

/// Returns the real roots of c[0] + c[1] x + ... + c[n] x^n, n <= degree_cap, as eigenvalues of the companion
/// matrix. A root counts as real if its imaginary part is at most `tolerance` times its size. Roots of
/// multiplicity m come m times, but 0 once, with an error of about 2^(-53/m). Returns none if a coefficient
/// is not finite, or if all are 0. Nothing is allocated.
RealRoots real_roots(std::span<const double> c, double tolerance) noexcept {
  RealRoots roots;
  for (double coefficient : c)
    if (!(std::fabs(coefficient) <= std::numeric_limits<double>::max())) return roots;
  int low = 0, high = static_cast<int>(c.size()) - 1;
  while (low < high && c[static_cast<std::size_t>(low)] == 0) ++low;
  while (low < high && c[static_cast<std::size_t>(high)] == 0) --high;
  if (low > 0 && c[static_cast<std::size_t>(low)] != 0) roots.x[static_cast<std::size_t>(roots.count++)] = 0;
  const int n = high - low;
  if (n == 0) return roots;

  // x = 2^shift y makes the outer coefficients about equal, the roots' geometric mean about 1.
  const auto at = [&](int k) { return c[static_cast<std::size_t>(low + k)]; };
  const int shift = (std::ilogb(at(0)) - std::ilogb(at(n))) / n;
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, degree_cap, degree_cap> companion(n, n);
  companion.setZero();
  companion.diagonal(-1).setOnes();
  for (int k = 0; k < n; ++k) companion(k, n - 1) = -std::scalbn(at(k) / at(n), (k - n) * shift);
  if (!companion.allFinite()) return roots;

  const Eigen::EigenSolver<decltype(companion)> solver(companion, false);
  if (solver.info() != Eigen::Success) return roots;
  for (int k = 0; k < n; ++k) {
    const auto root = solver.eigenvalues()[k];
    if (std::fabs(root.imag()) <= tolerance * std::abs(root))
      roots.x[static_cast<std::size_t>(roots.count++)] = std::scalbn(root.real(), shift);
  }
  return roots;
}

template <std::size_t n, std::size_t m>
std::array<double, n + m - 1> product(const std::array<double, n>& a,
                                      const std::array<double, m>& b) noexcept {
  std::array<double, n + m - 1> c{};
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < m; ++j) c[i + j] += a[i] * b[j];
  return c;
}

// G' rises: Newton's steps from a root of the polynomial, which the squarings have blurred.
double polish(const TangentLine& line, double x, double k, int steps) noexcept {
  for (int i = 0; i < steps; ++i) {
    const double step = (line.rise(x) - k) / line.bend(x);
    if (!(std::fabs(step) > 0x1p-53 * std::fabs(x))) break;
    x -= step;
  }
  return x;
}

// By the text, any U0 and V0 will do. With U along W0 x W1 the line would miss the likeliest direction.
TangentLine any_line(const Circle& q) noexcept {
  const Vector3 v = q.u0.cross(q.v0).unitOrthogonal();
  return {q, dot(v, q.u0), dot(v, q.v0)};
}

bool has_signs(const TangentLine& line, double x, double sigma1, double sigma2) noexcept {
  return sigma1 * (line.a1 * x + line.b1) >= 0 && sigma2 * (line.a2 * x + line.b2) >= 0;
}

// (a) D = x U + V never is U. But f may be negative at U, or it may be 0 with F falling all the way to it.
// With V along Delta neither can be, because f(U) >= 0 and F grows at both ends. Then a2 = 0, so both
// choices of sigma1 give k of one size, and one polynomial serves all four cases. If f itself is asked, a
// critical point need not be tested for the assumed signs. The literal version tests it.
bool separated_by_roots(const Circle& q, const Options& options, Finder& finder) noexcept {
  const double reach = std::hypot(q.a2, q.b2);
  if (!(reach > 0)) return false;
  const bool any = options.faults.has(Fault::tangent_line_misses_u0);
  const bool wrong = options.faults.has(Fault::derivative_of_the_wrong_term);
  const TangentLine line = any ? any_line(q) : TangentLine(q, q.a2 / reach, q.b2 / reach);
  if (!any && finder.separates(line.v)) return true;  // x = 0: of two segments the polynomial is 0
  for (const double sigma1 : {1.0, -1.0}) {
    const double k = (wrong ? line.b2 : any ? line.a2 : 0) - sigma1 * line.side * line.a1;
    const auto roots = real_roots(line.critical_polynomial(k), options.tolerance);
    for (int i = 0; i < roots.count; ++i) {
      const double root = roots.x[static_cast<std::size_t>(i)];
      for (const double sign : {1.0, -1.0}) {
        const double x = polish(line, root, sign * k, options.literal ? 0 : options.step_cap);
        if (options.literal && !has_signs(line, x, sign * sigma1, sign)) continue;
        if (finder.separates(line.direction(x))) return true;
      }
    }
    if (!any && !wrong && !options.literal) break;
  }
  return false;
}

/// The vector from the projection of solid 1 to that of the centre of solid 0, onto the plane of the circle.
/// It is (0, 0) if the centre is inside.
struct PlaneVector {
  double x = 0, y = 0;
};

PlaneVector from_rectangle(const Circle& q) noexcept {
  return {std::copysign(larger(std::fabs(q.a2) - q.side, 0), q.a2),
          std::copysign(larger(std::fabs(q.b2) - q.r1, 0), q.b2)};
}

// From the elliptical cap on the centre's side, with the length 1. In the unit r1 the ellipse about (side, 0)
// has half axes c and 1. The point of it nearest to an outer (u, v) is (c^2 u/(t + c^2), v/(t + 1)) with the
// one t > 0 that puts it there, the largest root.
PlaneVector from_ellipse(const Circle& q, const Options& options) noexcept {
  if (!(q.r1 > 0) || !(q.c > 0)) return {};
  const double u = (std::fabs(q.a2) - q.side) / q.r1, v = std::fabs(q.b2) / q.r1;
  if (!(u > 0)) return {};  // the rectangle is nearer
  const double c2 = q.c * q.c, u2 = c2 * u * u, v2 = v * v;
  const auto roots =
      real_roots(std::array<double, 5>{u2 + c2 * c2 * (v2 - 1), 2 * u2 + 2 * c2 * (v2 - 1 - c2),
                                       u2 + v2 - 1 - c2 * (4 + c2), -2 - 2 * c2, -1},
                 options.tolerance);
  double t = 0;
  for (int i = 0; i < roots.count; ++i) t = larger(t, roots.x[static_cast<std::size_t>(i)]);
  for (int i = 0; i < options.step_cap; ++i) {
    const double m = 1 / (t + c2), n = 1 / (t + 1);
    const double step = (u2 * m * m + v2 * n * n - 1) / (2 * (u2 * m * m * m + v2 * n * n * n));
    const double next = larger(t + step, 0);
    if (!(std::fabs(next - t) > 0x1p-53 * t)) break;
    t = next;
  }
  const double x = u / (t + c2), y = v / (t + 1), size = std::hypot(x, y);
  return {std::copysign(x / size, q.a2), std::copysign(y / size, q.b2)};
}

// (b) A disk about the origin against what is left of the other solid about (a2, b2).
bool separated_in_projection(const Circle& q, const Options& options, Finder& finder) noexcept {
  for (const PlaneVector v : {from_rectangle(q), from_ellipse(q, options)})
    if (finder.separates(q.direction(v.x, v.y))) return true;
  return false;
}

}  // namespace

// U = (v_y, -v_x) in the circle's coordinates. There |P1 D|^2 = c^2 x^2 + y^2, and the other side is along
// x.
TangentLine::TangentLine(const Circle& q, double v_x, double v_y) noexcept
    : r0(q.r0),
      r1(q.r1),
      side(q.side),
      q2(q.c * q.c * v_y * v_y + v_x * v_x),
      q1((q.c * q.c - 1) * v_x * v_y),
      q0(q.c * q.c * v_x * v_x + v_y * v_y),
      a1(v_y),
      b1(v_x),
      a2(q.a2 * v_y - q.b2 * v_x),
      b2(q.a2 * v_x + q.b2 * v_y),
      u(q.direction(v_y, -v_x)),
      v(q.direction(v_x, v_y)) {}

double TangentLine::rise(double x) const noexcept {
  return r0 * x / std::sqrt(1 + x * x) + r1 * (q2 * x + q1) / std::sqrt((q2 * x + 2 * q1) * x + q0);
}

double TangentLine::bend(double x) const noexcept {
  const double s0 = 1 + x * x, s1 = (q2 * x + 2 * q1) * x + q0;
  return r0 / (s0 * std::sqrt(s0)) + r1 * (q2 * q0 - q1 * q1) / (s1 * std::sqrt(s1));
}

// L0 = r0 x, L1 = r1 (q2 x + q1) over the roots of Q0 and Q1:
// 4 L0^2 L1^2 Q0 Q1 - (k^2 Q0 Q1 - L0^2 Q1 - L1^2 Q0)^2, in the unit of its largest length.
std::array<double, 9> TangentLine::critical_polynomial(double k) const noexcept {
  const double unit = std::max({r0, r1, std::fabs(k)});
  if (!(unit > 0)) return {};
  const std::array<double, 2> l0{0, r0 / unit}, l1{r1 / unit * q1, r1 / unit * q2};
  const std::array<double, 3> s0{1, 0, 1}, s1{q0, 2 * q1, q2};
  const auto both = product(s0, s1), m0 = product(product(l0, l0), s1), m1 = product(product(l1, l1), s0);
  std::array<double, 5> inner;
  for (std::size_t i = 0; i < 5; ++i) inner[i] = k / unit * (k / unit) * both[i] - m0[i] - m1[i];
  const auto left = product(m0, m1), right = product(inner, inner);
  std::array<double, 9> c;
  for (std::size_t i = 0; i < 9; ++i) c[i] = 4 * left[i] - right[i];
  return c;
}

bool separated_on_circle(const Solids& solids, int i, CircleWay way, const Options& options,
                         Finder& finder) noexcept {
  const Circle circle(solids, i);
  return way == CircleWay::polynomial ? separated_by_roots(circle, options, finder)
                                      : separated_in_projection(circle, options, finder);
}

}  // namespace cyl::literature
