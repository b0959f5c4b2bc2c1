// SPDX-License-Identifier: MIT
// Compares the referee with a slow twin. They share only the support gap. The twin is the ellipsoid method
// (Shor; Khachiyan) in 256-bit numbers over the ball |D| <= 1, on f~(D) = r0 |P0 D| + h0/2 |D.w0| + r1 |P1
// D| + h1/2 |D.w1| - D.delta. f~ is convex and f~(0) = 0. The solids are disjoint iff its minimum is below
// 0.
#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <string>

#include "base/vec3.hpp"
#include "corpus/pairs/families.hpp"
#include "corpus/pairs/pair_io.hpp"
#include "oracles/referee/multiprecision.hpp"
#include "oracles/referee/referee.hpp"

namespace cyl {
namespace {

using W3 = Vec3<MpFloat>;

W3 lift(const Vector3& v) { return {MpFloat(v.x()), MpFloat(v.y()), MpFloat(v.z())}; }

struct Slow {
  W3 w0, w1, delta;
  MpFloat r0, h0, r1, h1, size;

  explicit Slow(const Pair& p)
      : w0(lift(p.a.axis)),
        w1(lift(p.b.axis)),
        delta(lift(p.b.center) - lift(p.a.center)),
        r0(p.a.radius),
        h0(MpFloat(p.a.height) * MpFloat(0.5)),
        r1(p.b.radius),
        h1(MpFloat(p.b.height) * MpFloat(0.5)),
        size(r0 + r1 + h0 + h1) {
    w0 = w0 / sqrt(dot(w0, w0));
    w1 = w1 / sqrt(dot(w1, w1));
  }

  // f~(D) and a subgradient, the support point of D. If D is along an axis up to the last 56 bits, the
  // middle of the cap serves.
  MpFloat evaluate(const W3& d, W3& gradient) const {
    MpFloat value = -dot(d, delta);
    gradient = MpFloat(-1.0) * delta;
    auto add = [&](const W3& w, const MpFloat& r, const MpFloat& h) {
      const MpFloat t = dot(d, w);
      const W3 radial = d - t * w;
      const MpFloat length = sqrt(dot(radial, radial));
      if (length > abs(t) * MpFloat(0x1p-200)) gradient = gradient + MpFloat(r / length) * radial;
      gradient = gradient + (t < MpFloat(0.0) ? -h : h) * w;
      value = value + r * length + h * abs(t);
    };
    add(w0, r0, h0);
    add(w1, r1, h1);
    return value;
  }
};

// Returns disjoint, or intersecting if there is no gap of more than 2^-resolution size.
Verdict slow_verdict(const Pair& pair, int resolution) {
  const PrecisionScope precision(256);
  const Slow slow(pair);
  const MpFloat zero(0.0), one(1.0);
  const MpFloat least = slow.size * MpFloat(std::ldexp(1.0, -resolution));
  const MpFloat rounding = slow.size * MpFloat(0x1p-240);  // f~ of an exact tie comes out as +- this
  // The ellipsoid {D : (D - c)' P^-1 (D - c) <= 1}, at first the unit ball.
  W3 c{zero, zero, zero};
  std::array<W3, 3> p = {W3{one, zero, zero}, W3{zero, one, zero}, W3{zero, zero, one}};
  for (int step = 0; step < 40 * resolution; ++step) {
    W3 g;
    const MpFloat outside = dot(c, c) - one;
    const bool in_ball = outside <= zero;
    if (in_ball) {
      if (slow.evaluate(c, g) < -rounding) return Verdict::disjoint;
    } else {
      g = c;
    }
    const W3 pg{dot(p[0], g), dot(p[1], g), dot(p[2], g)};
    const MpFloat gpg = dot(g, pg);
    if (gpg <= zero) return Verdict::intersecting;  // this is the minimum
    const MpFloat width = sqrt(gpg);
    // All of the ellipsoid has f~ >= f~(c) - width >= -width, and the cut parts were higher than their
    // centres.
    if (in_ball && width < least) return Verdict::intersecting;
    const W3 step_to = MpFloat(one / (MpFloat(4.0) * width)) * pg;
    c = c - step_to;
    const MpFloat scale = MpFloat(9.0) / MpFloat(8.0), share = MpFloat(0.5) / gpg;
    for (std::size_t i = 0; i < 3; ++i) {
      const MpFloat& a = i == 0 ? pg.x : i == 1 ? pg.y : pg.z;
      p[i] = scale * (p[i] - MpFloat(share * a) * pg);
    }
  }
  return Verdict::undecided;
}

// Returns the number of pairs of each family: a few in daily tests, or as many as the environment states.
std::uint64_t pairs_a_family() {
  const char* asked = std::getenv("DAYLIGHT_TEXTBOOK_PAIRS");
  return asked ? std::strtoull(asked, nullptr, 10) : 4;
}

TEST(Textbook, AgreesWithTheRefereeOnEveryFamily) {
  constexpr int resolution = 64;  // bits: gaps and depths above 2^-64 size are resolved
  int disjoint = 0, intersecting = 0;
  for (const Family& family : families())
    for (std::uint64_t i = 0; i < pairs_a_family(); ++i) {
      const Pair pair = family.generate(314159, i);
      const Truth truth = judge(pair);
      const std::string what = std::string(family.name) + " " + std::to_string(i) + " " + format_pair(pair);
      const Verdict slow = slow_verdict(pair, resolution);
      ASSERT_NE(slow, Verdict::undecided) << what;
      if (truth.verdict == Verdict::undecided) continue;
      // A gap below the resolution looks like a meeting.
      if (truth.verdict == Verdict::disjoint && slow == Verdict::intersecting) {
        EXPECT_LT(enclose_distance(pair, truth).lo, 1e-15 * size_of(pair)) << what;
      } else {
        EXPECT_EQ(slow == Verdict::disjoint, truth.verdict == Verdict::disjoint) << what;
      }
      ++(slow == Verdict::disjoint ? disjoint : intersecting);
    }
  EXPECT_GT(disjoint, 20);
  EXPECT_GT(intersecting, 20);
  std::printf("%d disjoint and %d intersecting pairs agree\n", disjoint, intersecting);
}

}  // namespace
}  // namespace cyl
