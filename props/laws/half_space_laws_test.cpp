// SPDX-License-Identifier: MIT
// The laws with half-spaces: each catches a fault that code for planes may have. If other laws catch it too,
// they are listed.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "corpus/pairs/pair_numbers.hpp"
#include "oracles/referee/referee.hpp"
#include "props/laws/law_groups.hpp"
#include "props/laws/laws_test.hpp"

namespace cyl {
namespace {

const Solid& plane_of(const Pair& pair) { return is_half_space(pair.a) ? pair.a : pair.b; }
const Solid& solid_of(const Pair& pair) { return is_half_space(pair.a) ? pair.b : pair.a; }

/// How far the solid's centre is from the plane's point, along the plane.
double aside(const Pair& pair) {
  const Vector3 n = direction_of(plane_of(pair)), delta = solid_of(pair).center - plane_of(pair).center;
  return (delta - n.dot(delta) * n).stableNorm();
}

/// A right answer with a distance. A gap comes with its direction.
MethodAnswer measured(const Pair& pair) {
  if (!has_half_space(pair)) return ask_ours("distance", pair);
  MethodAnswer answer = ask_ours("exact", pair);
  answer.has_distance = true;
  answer.distance = approximate_distance(pair).value;
  return answer;
}

using Change = std::function<void(const Pair&, MethodAnswer&)>;

Numbers broken_by_verdict(const Change& change, std::string_view family = "half_space_cylinder") {
  return laws_broken_by(plant("exact", change), family);
}

Numbers broken_by_distance(const Change& change, std::string_view family = "half_space_cylinder") {
  return laws_broken_by(Planted([&](const Pair& pair) {
                          MethodAnswer answer = measured(pair);
                          change(pair, answer);
                          return answer;
                        }),
                        family);
}

/// Answers as for another pair.
Numbers broken_by_taking(const std::function<Pair(Pair)>& other) {
  return laws_broken_by(Planted([&](const Pair& pair) { return ask_ours("exact", other(pair)); }),
                        "half_space_cylinder");
}

TEST(HalfSpaceLaws, AreKeptByRightAnswers) {
  EXPECT_EQ(broken_by_distance([](const Pair&, MethodAnswer&) {}), Numbers{});
  EXPECT_EQ(broken_by_distance([](const Pair&, MethodAnswer&) {}, "half_space_normal"), Numbers{});
}

TEST(HalfSpaceLaws, CatchWhoKnowsNoPlaneInSecondPlace) {
  EXPECT_EQ(broken_by_verdict([](const Pair& pair, MethodAnswer& answer) {
              if (is_half_space(pair.b)) answer = answered(Verdict::undecided);
            }),
            Numbers{1});
}

TEST(HalfSpaceLaws, CatchAnAbsoluteTolerance) {
  EXPECT_EQ(broken_by_verdict([](const Pair& pair, MethodAnswer& answer) {
              if (size_of(pair) < 1e-6) answer = answered(Verdict::undecided);
            }),
            Numbers{2});
}

TEST(HalfSpaceLaws, CatchWhoLooksAtTheSenseOfTheSolidsAxis) {
  EXPECT_EQ(broken_by_verdict([](const Pair& pair, MethodAnswer& answer) {
              if (pair.a.axis.dot(pair.b.axis) < 0) answer = answered(Verdict::undecided);
            }),
            Numbers{3});
}

TEST(HalfSpaceLaws, CatchANormalThatIsTakenForAUnitVector) {
  EXPECT_EQ(broken_by_verdict([](const Pair& pair, MethodAnswer& answer) {
              if (plane_of(pair).axis.norm() > 1e6) answer = answered(Verdict::undecided);
            }),
            Numbers{4});
}

// The verdict is wrong, too.
TEST(HalfSpaceLaws, CatchANormalWithoutItsSign) {
  const Numbers broken = broken_by_taking([](Pair pair) {
    for (Solid* c : {&pair.a, &pair.b})
      if (is_half_space(*c)) c->axis = c->axis.cwiseAbs();
    return pair;
  });
  for (const int law : {5, 31}) EXPECT_TRUE(std::ranges::count(broken, law)) << law;
}

TEST(HalfSpaceLaws, CatchANormalThatLosesACoordinate) {
  const Numbers broken = broken_by_taking([](Pair pair) {
    for (Solid* c : {&pair.a, &pair.b})
      if (is_half_space(*c) && c->axis.z() < 0.9) c->axis.x() = 0;
    return pair;
  });
  for (const int law : {6, 20, 31}) EXPECT_TRUE(std::ranges::count(broken, law)) << law;
}

TEST(HalfSpaceLaws, CatchASolidThatGrowsOutOfThePlane) {
  EXPECT_EQ(broken_by_verdict([](const Pair& pair, MethodAnswer& answer) {
              const auto bits = std::bit_cast<std::uint64_t>(solid_of(pair).radius);
              if (bits % 4 == 0) answer = answered(Verdict::disjoint);
            }),
            (Numbers{10, 11, 12, 22, 31}));
}

// A plane without an inside. No solid of this family is wholly behind it.
TEST(HalfSpaceLaws, CatchASolidMissedBehindThePlane) {
  const auto misses = [](const Pair& pair, MethodAnswer& answer) {
    if (approximate_distance(pair).value < -size_of(pair)) answer = answered(Verdict::disjoint);
  };
  EXPECT_EQ(broken_by_verdict(misses, "half_space_tilted"), Numbers{11});
}

TEST(HalfSpaceLaws, CatchAGapThatIsTakenForContact) {
  const auto takes = [](const Pair& pair, MethodAnswer& answer) {
    if (approximate_distance(pair).value < 0.05 * size_of(pair)) answer = answered(Verdict::intersecting);
  };
  EXPECT_EQ(broken_by_verdict(takes), (Numbers{12, 31}));
}

// The small third solids of the triangle are that far away too.
TEST(HalfSpaceLaws, CatchADistanceThatStopsGrowing) {
  EXPECT_EQ(broken_by_distance([](const Pair& pair, MethodAnswer& answer) {
              answer.distance = std::min(answer.distance, 100 * size_of(pair));
            }),
            (Numbers{13, 23}));
}

TEST(HalfSpaceLaws, CatchACapsuleThatMissesWhatItsSphereMeets) {
  const Numbers broken = broken_by_verdict(
      [](const Pair& pair, MethodAnswer& answer) {
        if (solid_of(pair).height > 0) answer = answered(Verdict::disjoint);
      },
      "half_space_capsule");
  EXPECT_TRUE(std::ranges::count(broken, 14));
}

TEST(HalfSpaceLaws, CatchADistanceThatDependsOnThePlace) {
  EXPECT_EQ(broken_by_distance([](const Pair& pair, MethodAnswer& answer) {
              if (std::min(pair.a.center.norm(), pair.b.center.norm()) > 1e4 * size_of(pair))
                answer.distance *= 2;
            }),
            Numbers{21});
}

// A small turn leaves the normal at nearly unit length.
TEST(HalfSpaceLaws, CatchAVerdictThatMissesASmallTurn) {
  EXPECT_EQ(broken_by_verdict([](const Pair& pair, MethodAnswer& answer) {
              const double off = std::fabs(plane_of(pair).axis.squaredNorm() - 1);
              if (off > 0x1p-23 && off < 0x1p-19) answer = answered(Verdict::intersecting);
            }),
            Numbers{22});
}

TEST(HalfSpaceLaws, CatchAWayThatIsLongerThanAround) {
  EXPECT_EQ(broken_by_distance([](const Pair& pair, MethodAnswer& answer) {
              if (has_half_space(pair) && size_of(pair) < 0.03 && answer.distance > 0) answer.distance = 0;
            }),
            Numbers{23});
}

// The fault lies at a depth of 2^-20 of the size. No drawn pair has it, but a slide does.
TEST(HalfSpaceLaws, CatchADepthBeyondTheWayBack) {
  EXPECT_EQ(broken_by_distance([](const Pair& pair, MethodAnswer& answer) {
              const double part = answer.distance / size_of(pair);
              if (part < -9e-7 && part > -9.8e-7) answer.distance *= 2;
            }),
            Numbers{24});
}

TEST(HalfSpaceLaws, CatchARoundingThatCountsTwice) {
  const Numbers broken = broken_by_distance(
      [](const Pair& pair, MethodAnswer& answer) {
        if (answer.distance > solid_of(pair).rounding) answer.distance -= solid_of(pair).rounding;
      },
      "half_space_capsule");
  EXPECT_TRUE(std::ranges::count(broken, 25));
}

// No drawn solid lies that far from the point of the plane.
TEST(HalfSpaceLaws, CatchAPlaneThatEnds) {
  const auto ends = [](const Pair& pair, MethodAnswer& answer) {
    if (aside(pair) > 100 * size_of(pair)) answer = answered(Verdict::disjoint);
  };
  EXPECT_EQ(broken_by_verdict(ends), Numbers{26});
}

TEST(HalfSpaceLaws, CatchADistanceToThePointOfThePlane) {
  const auto to_point = [](const Pair& pair, MethodAnswer& answer) {
    if (aside(pair) > 100 * size_of(pair)) answer.distance += 1e-6 * size_of(pair);
  };
  EXPECT_EQ(broken_by_distance(to_point), Numbers{26});
}

// The sign is wrong if the solids touch.
TEST(HalfSpaceLaws, CatchADistanceTooLarge) {
  const auto adds = [](const Pair& pair, MethodAnswer& answer) { answer.distance += 1e-9 * size_of(pair); };
  EXPECT_EQ(broken_by_distance(adds), (Numbers{33, 34}));
}

TEST(HalfSpaceLaws, CatchADirectionThatDoesNotSeparate) {
  EXPECT_EQ(broken_by_verdict([](const Pair&, MethodAnswer& answer) {
              if (answer.witness == CertificateKind::direction) answer.set_direction(Vector3(1, 0, 0));
            }),
            Numbers{32});
}

TEST(HalfSpaceLaws, CatchADistanceOfTheOtherSign) {
  const Numbers broken = broken_by_distance(
      [](const Pair&, MethodAnswer& answer) { answer.distance = std::fabs(answer.distance); });
  for (const int law : {33, 34}) EXPECT_TRUE(std::ranges::count(broken, law)) << law;
}

TEST(HalfSpaceLaws, CatchADistanceBelowWhatADirectionProves) {
  const Numbers broken = broken_by_distance([](const Pair& pair, MethodAnswer& answer) {
    if (answer.distance > 0) answer.distance -= 1e-9 * size_of(pair);
  });
  for (const int law : {33, 42}) EXPECT_TRUE(std::ranges::count(broken, law)) << law;
}

}  // namespace
}  // namespace cyl
