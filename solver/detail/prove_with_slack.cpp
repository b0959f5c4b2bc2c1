// SPDX-License-Identifier: MIT
#include "solver/detail/prove_with_slack.hpp"

#include "solver/detail/double_double.hpp"
#include "solver/detail/optimum.hpp"

namespace cyl {
namespace {

struct DeepVector {
  DoubleDouble x, y, z;
};

DeepVector operator+(const DeepVector& a, const DeepVector& b) noexcept {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
DeepVector operator*(const DoubleDouble& s, const DeepVector& a) noexcept {
  return {s * a.x, s * a.y, s * a.z};
}
DoubleDouble dot(const DeepVector& a, const DeepVector& b) noexcept {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
DeepVector cross(const DeepVector& a, const DeepVector& b) noexcept {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
DeepVector deep(const Vector3& a) noexcept { return {a.x(), a.y(), a.z()}; }
Vector3 rounded(const DeepVector& a) noexcept { return {a.x.hi, a.y.hi, a.z.hi}; }
DeepVector unit(const DeepVector& a) noexcept { return (DoubleDouble(1) / root(dot(a, a))) * a; }
DeepVector towards(const DeepVector& a, const DeepVector& delta) noexcept {
  return dot(a, delta) < DoubleDouble(0) ? DoubleDouble(-1) * a : a;
}

// Frame (frame.hpp) in twice the digits. The axes are of unit length anew: their cosine and sine have to
// agree.
class DeepFrame {
 public:
  using Scalar = DoubleDouble;

  DeepFrame(const Scaled& p, const Axes& axes) noexcept : w0_(unit(deep(p.w0))) {
    const DeepVector w1 = unit(deep(p.w1)), delta = deep(p.delta);
    f = shallow_sections(Couple<DoubleDouble>{w0_.x, w0_.y, w0_.z, w1.x, w1.y, w1.z, delta.x, delta.y,
                                              delta.z, p.r0, p.h0, p.r1, p.h1});
    const DeepVector aligned = DoubleDouble(axes.cosine < 0 ? -1 : 1) * w1;
    n_ = towards(unit(cross(w0_ + DoubleDouble(-1) * aligned, w0_ + aligned)), delta);
    m0_ = cross(w0_, n_);
    slices_ = {dot(delta, w0_), dot(delta, m0_), dot(delta, n_), dot(w1, w0_), dot(w1, m0_)};
    e_[0] = towards(w0_, delta);
    e_[1] = towards(w1, delta);
    e_[2] = towards(m0_, delta);
    e_[3] = towards(cross(w1, n_), delta);
  }

  Vector3 direction(int i, DoubleDouble a, int j, DoubleDouble b, DoubleDouble c) const noexcept {
    return rounded(a * e_[i] + b * e_[j] + c * n_);
  }
  const Slices<DoubleDouble>& slices() const noexcept { return slices_; }
  Vector3 at(DoubleDouble along, DoubleDouble beside, DoubleDouble u) const noexcept {
    return rounded(along * w0_ + beside * m0_ + u * n_);
  }

  Sections<DoubleDouble> f;

 private:
  DeepVector w0_, m0_, n_, e_[4];
  Slices<DoubleDouble> slices_;
};

// Every length moved by `by`; to 0 at least.
Scaled resized(const Scaled& p, double by) noexcept {
  return {p.w0,
          p.w1,
          p.delta,
          larger(0, p.r0 + by),
          larger(0, p.h0 + by),
          larger(0, p.r1 + by),
          larger(0, p.h1 + by),
          p.exponent};
}

}  // namespace

[[gnu::noinline]] void prove_with_slack(ProofTask& q, const Axes& axes) noexcept {
  const double slack = proof_slack_tol * q.reach;
  const auto search = [&](double by) {
    const Scaled p = resized(q.solids, by);
    const DeepFrame frame(p, axes);
    if (!prove_by_filter(q, p, frame)) prove_at_optimum(q, p, frame);
    return q.answer.proof != Proof::none;
  };
  // A point this near to both leaves no gap worth the search, a direction of so small an overlap no ball.
  if (!q.no_gap() && search(slack)) return;
  if (!q.no_slack()) search(-slack);
}

}  // namespace cyl
