// SPDX-License-Identifier: MIT
// The referee on half-spaces, against distances computed with 2,000 bits from cosines, which it does not use.
#include "oracles/referee/half_space.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "base/from_environment_test.hpp"
#include "corpus/pairs/families.hpp"
#include "corpus/pairs/pair_io.hpp"
#include "corpus/pairs/pair_numbers.hpp"
#include "oracles/referee/proof_check_test.hpp"

namespace cyl {
namespace {

constexpr int bits = 2000;

Vec3<MpFloat> wide(const Vector3& v) { return {MpFloat(v[0]), MpFloat(v[1]), MpFloat(v[2])}; }

/// The distance of the centre from the plane, less the extent of the solid towards it. With the cosine c of
/// normal and axis, this extent is radius sqrt(1 - c^2) + height/2 |c| + rounding.
MpFloat distance_by_cosine(const Pair& pair) {
  const Solid &plane = is_half_space(pair.a) ? pair.a : pair.b,
              &solid = is_half_space(pair.a) ? pair.b : pair.a;
  const Vec3<MpFloat> n = wide(plane.axis), w = wide(solid.axis);
  const MpFloat one(1.0), length = sqrt(dot(n, n)), c = dot(n, w) / (length * sqrt(dot(w, w)));
  const MpFloat square = one - c * c, sine = square > MpFloat(0.0) ? sqrt(square) : MpFloat(0.0);
  return dot(n, wide(solid.center) - wide(plane.center)) / length - MpFloat(solid.radius) * sine -
         MpFloat(solid.height) / MpFloat(2.0) * abs(c) - MpFloat(solid.rounding);
}

TEST(HalfSpace, VerdictDistanceAndCertificateOfEveryFamily) {
  const std::uint64_t seed = from_environment("DAYLIGHT_SEED", 20261121);
  const std::uint64_t many = from_environment("DAYLIGHT_HALF_SPACE_PAIRS", 240);
  for (const Family& family : half_space_families()) {
    int touching = 0, apart = 0;
    for (std::uint64_t i = 0; i < many; ++i) {
      const Pair pair = family.generate(seed, i);
      ASSERT_TRUE(is_legal(pair)) << format_pair(pair);
      const Truth truth = judge(pair);
      const PrecisionScope precision(bits);
      const MpFloat distance = distance_by_cosine(pair), zero(0.0);
      // A distance that is not 0 is a sum of roots of doubles, and far above this.
      const MpFloat rounding(std::ldexp(size_of(pair), -900));
      const bool is_zero = !(abs(distance) > rounding);
      touching += is_zero;
      apart += !is_zero && distance > zero;
      const Verdict expected = is_zero           ? Verdict::touching
                               : distance > zero ? Verdict::disjoint
                                                 : Verdict::intersecting;
      ASSERT_EQ(to_string(truth.verdict), std::string(to_string(expected))) << format_pair(pair);
      ASSERT_EQ(judge_verdict(pair).verdict, expected);
      ASSERT_TRUE(is_proof(pair, truth)) << format_pair(pair);
      if (is_zero) continue;
      const Enclosure e = enclose_distance(pair, truth);
      ASSERT_TRUE(MpFloat(e.lo) <= distance + rounding && distance <= MpFloat(e.hi) + rounding)
          << format_pair(pair);
      ASSERT_LE(e.hi, std::nextafter(e.lo, INFINITY)) << format_pair(pair);
      const double size = size_of(pair) + (pair.b.center - pair.a.center).stableNorm();
      EXPECT_NEAR(measure_with_points(pair).value, e.lo, 1e-15 * size) << format_pair(pair);
    }
    EXPECT_GT(apart, static_cast<int>(many / 8)) << family.name;
    EXPECT_LT(touching, static_cast<int>(many / 4)) << family.name;
  }
}

TEST(HalfSpace, OnlyItsNormalSeparates) {
  const Solid plane{.axis = {0, 0, 2}, .shape = Shape::half_space}, ball{.center = {0, 0, 3}, .rounding = 1};
  const auto sign = [&](const Pair& pair, double x, double z) {
    return support_gap_sign(pair, Rational3{x, 0, z}, 128);
  };
  EXPECT_EQ(sign({plane, ball}, 0, 1), -1);
  EXPECT_EQ(sign({plane, ball}, 0, -1), 1);
  EXPECT_EQ(sign({plane, ball}, 0x1p-60, 1), 1);
  EXPECT_EQ(sign({ball, plane}, 0, -1), -1);
}

TEST(HalfSpace, ADeepestPointBeyondTheDoublesIsProvedToo) {
  Pair pair;
  pair.a = {Vector3(0, 0, 0), Vector3(1, 1, 0), 1.75e308, 1.75e308};
  pair.b.shape = Shape::half_space;
  pair.b.axis = Vector3(1, 0, 0);
  ASSERT_TRUE(is_legal(pair)) << format_pair(pair);
  const Truth truth = judge(pair);
  EXPECT_EQ(truth.verdict, Verdict::intersecting);
  EXPECT_NE(truth.certificate.kind, CertificateKind::none);
}

}  // namespace
}  // namespace cyl
