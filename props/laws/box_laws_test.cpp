// SPDX-License-Identifier: MIT
// The laws with boxes: each catches a fault that code for boxes may have. If other laws catch it too, they
// are listed.
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "corpus/pairs/pair_numbers.hpp"
#include "props/laws/laws_test.hpp"

namespace cyl {
namespace {

const Solid& box_of(const Pair& pair) { return is_box(pair.a) ? pair.a : pair.b; }
double quaternion_length(const Solid& box) {
  return Eigen::Vector4d::Map(box.quaternion.data()).stableNorm();
}

void turn_verdict(MethodAnswer& answer) {
  answer = answered(answer.verdict == Verdict::disjoint ? Verdict::intersecting : Verdict::disjoint);
}

using Change = std::function<void(const Pair&, MethodAnswer&)>;
Numbers broken_by(const Change& change, std::string_view family = "box_edges") {
  return laws_broken_by(plant("exact", change), family);
}

TEST(BoxLaws, AreKeptByRightAnswers) {
  for (const char* family : {"box_edges", "box_flush", "box_half_space", "box_quaternion"})
    EXPECT_EQ(broken_by([](const Pair&, MethodAnswer&) {}, family), Numbers{}) << family;
}

TEST(BoxLaws, CatchAnAbsoluteTolerance) {
  EXPECT_EQ(broken_by([](const Pair& pair, MethodAnswer& answer) {
              if (size_of(pair) < 1e-6) answer = answered(Verdict::undecided);
            }),
            Numbers{2});
}

TEST(BoxLaws, CatchWhoLooksAtTheSignOfAQuaternion) {
  EXPECT_EQ(broken_by([](const Pair& pair, MethodAnswer& answer) {
              if (pair.a.quaternion[0] * pair.b.quaternion[0] < 0) answer = answered(Verdict::undecided);
            }),
            Numbers{3});
}

TEST(BoxLaws, CatchAQuaternionThatIsTakenForAUnitVector) {
  EXPECT_EQ(broken_by([](const Pair& pair, MethodAnswer& answer) {
              if (quaternion_length(box_of(pair)) > 1e6) answer = answered(Verdict::undecided);
            }),
            Numbers{4});
}

// The verdict is wrong, too.
TEST(BoxLaws, CatchAQuaternionThatTurnsTheOtherWay) {
  const Numbers broken = laws_broken_by(Planted([](Pair pair) {
                                          for (Solid* c : {&pair.a, &pair.b})
                                            for (double& x : c->quaternion) x = std::fabs(x);
                                          return ask_ours("exact", pair);
                                        }),
                                        "box_edges");
  for (const int law : {5, 31}) EXPECT_TRUE(std::ranges::count(broken, law)) << law;
}

// Only this law asks about quaternions of large integers. With other names for the edges their sum is even.
TEST(BoxLaws, CatchEdgesThatAreExchanged) {
  EXPECT_EQ(broken_by(
                [](const Pair& pair, MethodAnswer& answer) {
                  const auto& q = box_of(pair).quaternion;
                  const double length = quaternion_length(box_of(pair));
                  if (length > 0x1p39 && length < 0x1p44 && std::fmod(q[0] + q[1] + q[2] + q[3], 2) == 0)
                    turn_verdict(answer);
                },
                "box_cylinder"),
            Numbers{7});
}

TEST(BoxLaws, CatchABoxThatGrowsOutOfAnother) {
  const Numbers broken = broken_by([](const Pair& pair, MethodAnswer& answer) {
    if (std::bit_cast<std::uint64_t>(box_of(pair).edges[1]) % 4 == 0) answer = answered(Verdict::disjoint);
  });
  EXPECT_TRUE(std::ranges::count(broken, 10));
}

// No other law puts another shape into the place of a box.
TEST(BoxLaws, CatchAWrongAnswerAboutWhatIsAroundOrInside) {
  EXPECT_EQ(broken_by(
                [](const Pair& pair, MethodAnswer& answer) {
                  if (!has_box(pair)) turn_verdict(answer);
                },
                "box_cylinder"),
            Numbers{15});
}

}  // namespace
}  // namespace cyl
