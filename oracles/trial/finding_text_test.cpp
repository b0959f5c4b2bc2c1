// SPDX-License-Identifier: MIT
#include "oracles/trial/finding_text.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "oracles/trial/trial.hpp"

namespace cyl {
namespace {

TEST(InWords, NamesTheWitnessExactly) {
  EXPECT_EQ(in_words({CertificateKind::direction, {{1, -0.1, 1e-300}, {}, {}}, {}}),
            "A plane with normal (1, -0.1, 1e-300) separates them: all of a lies on one side, all of b on "
            "the other.");
  EXPECT_EQ(in_words({CertificateKind::point, {{1, 0, -2}, {1e-20, 0, -0.5}, {"", "1/3", ""}}, {}}),
            "The point (1 + 1e-20, 1/3, -2.5) lies in both.");
  EXPECT_NE(in_words({CertificateKind::near, {{1, 2, 3}, {}, {}}, {{-0.0, 0, 1}, {}, {}}})
                .find("The point (1, 2, 3) is at most that far from either solid. Along (0, 0, 1)"),
            std::string::npos);
  const std::string long_third = "1" + std::string(4000, '0') + "/3" + std::string(4000, '0');
  EXPECT_EQ(
      in_words({CertificateKind::point, {{1, 0, 0}, {}, {"", long_third, ""}}, {}}),
      "The point (1, about 0.3333333333333333, 0) lies in both. The certificate has its exact fractions.");
  EXPECT_EQ(in_words(Certificate{}), "No verdict could be proved.");
}

TEST(InWords, ADistanceBeyondTheDoublesHasABound) {
  Trial trial(Pair{{{1.7e308, 0, 0}, {0, 0, 1}, 1, 1}, {{-1.7e308, 0, 0}, {0, 0, 1}, 1, 1}});
  trial.distance = {std::numeric_limits<double>::max(), std::numeric_limits<double>::infinity()};
  EXPECT_EQ(distance_in_words(trial), "more than 1.79e308 apart");
}

TEST(InWords, ASumThatIsADoubleIsShownAsOne) {
  EXPECT_EQ(in_words({CertificateKind::point, {{3, 8, 0.1}, {-3, -7, 0.2}, {}}, {}}),
            "The point (0, 1, 0.1 + 0.2) lies in both.");
}

TEST(InWords, AMarginBeyondMeasureIsNoNumber) {
  EXPECT_EQ(margin_in_words({0.25, 0.5}), "margin 0.25 to 0.5");
  EXPECT_EQ(margin_in_words({0.25, 0.25}), "margin 0.25");
  EXPECT_EQ(margin_in_words({3.3e299, std::numeric_limits<double>::infinity()}),
            "margin of more than 1000 sizes");
}

// Two cylinders of radius and height 1, with centres 3 apart. The size is 4, and f along x is 2 - 3.
TEST(InWords, AWitnessMissesBySoMuch) {
  const Pair pair{{{0, 0, 0}, {0, 0, 2}, 1, 1}, {{3, 0, 0}, {0, 0, 1}, 1, 1}};
  const auto miss = [&](CertificateKind kind, double x, double y, double z) {
    MethodAnswer answer;
    answer.status = Status::answered;
    answer.witness = kind;
    answer.head[0] = x, answer.head[1] = y, answer.head[2] = z;
    return miss_in_words(pair, answer);
  };
  EXPECT_EQ(miss(CertificateKind::direction, 5, 0, 0), "") << "it separates";
  EXPECT_EQ(miss(CertificateKind::direction, 0, 5, 0),
            "the direction gives f(D) = 0.5 of the size, not below 0");
  EXPECT_EQ(miss(CertificateKind::direction, 0, 0, 0.5),
            "the direction gives f(D) = 0.25 of the size, not below 0");
  EXPECT_EQ(miss(CertificateKind::point, 1, 0, 0.5), "the point lies 0.25 of the size outside");
  EXPECT_EQ(miss(CertificateKind::point, 2, 0, 2.5), "the point lies 0.5 of the size outside");
  EXPECT_EQ(miss(CertificateKind::none, 1, 0, 0), "");
  EXPECT_EQ(miss(CertificateKind::direction, 0, 0, 0), "");
  const Pair tangent{{{0, 0, 0}, {0, 0, 1}, 1, 1}, {{2, 0, 0}, {0, 0, 1}, 1, 1}};
  MethodAnswer answer;
  answer.set_direction({1, 0, 0});
  EXPECT_EQ(miss_in_words(tangent, answer), "the direction gives f(D) = 0 exactly, which separates nothing");
}

}  // namespace
}  // namespace cyl
