// SPDX-License-Identifier: MIT
#include "props/checks/checks.hpp"

#include <gtest/gtest.h>

#include "props/checks/drawn_pairs.hpp"

namespace cyl {
namespace {

/// Not the one that the gate takes where nothing else is said.
constexpr std::uint64_t seed = 2;

TEST(Checks, HoldForTheRefereeAndTheSolver) {
  for (const auto check : {check_arithmetic, check_certificates, check_touching, check_searches,
                           check_batches, check_promises}) {
    Checked checked;
    check(checked, seed);
    EXPECT_GT(checked.asked(), 1000u);
    EXPECT_EQ(checked.wrong(), std::vector<std::string>{});
  }
}

TEST(Checks, TellTheFirstOfEachKindAndHowMany) {
  Checked checked;
  checked.expect(true, "right");
  checked.expect(false, "wrong:", 1, "of", 2.5);
  checked.expect(false, "wrong:", 2);
  checked.expect(false, "bad");
  EXPECT_EQ(checked.asked(), 4u);
  EXPECT_EQ(checked.wrong(), (std::vector<std::string>{"bad (1 times)", "wrong: 1 of 2.5 (2 times)"}));
}

TEST(Checks, ACaseOfAnotherTruthIsWrong) {
  Case c;
  c.id = "balls";
  c.pair = {{Vector3(0, 0, 0), Vector3(0, 0, 1), 1, 2}, {Vector3(2, 0, 0), Vector3(0, 0, 1), 1, 2}};
  c.truth = Verdict::touching;
  Checked right, wrong;
  check_known(right, {&c, 1});
  EXPECT_TRUE(right.wrong().empty());
  c.truth = Verdict::intersecting;
  check_known(wrong, {&c, 1});
  EXPECT_EQ(wrong.wrong().size(), 1u);
}

}  // namespace
}  // namespace cyl
