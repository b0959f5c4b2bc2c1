// SPDX-License-Identifier: MIT
// Truths and answers as text: numbers that JSON does not have, and the hulls of a point.
#include "corpus/pairs/truth_io.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace cyl {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity(),
                 largest = std::numeric_limits<double>::max();

TEST(TruthIo, WritesAnEndThatNoDoubleReachesAsDecimals) {
  const Truth apart{.verdict = Verdict::disjoint, .certificate = {}};
  const Enclosure far{largest, infinity}, deep{-infinity, -largest}, near{0.5, 0.75};
  EXPECT_EQ(format_truth(apart, &far),
            R"({"verdict":"disjoint","distance":[1.7976931348623157e+308,"6.3e308"],"stage":"filter"})");
  EXPECT_EQ(format_truth(apart, &deep),
            R"({"verdict":"disjoint","distance":["-6.3e308",-1.7976931348623157e+308],"stage":"filter"})");
  EXPECT_EQ(format_truth(apart, &near), R"({"verdict":"disjoint","distance":[0.5,0.75],"stage":"filter"})");
  EXPECT_EQ(truth_to_json(apart, &far)["distance"][1], "6.3e308");
  EXPECT_EQ(format_end(-1.5), "-1.5");
}

TEST(TruthIo, NamesTheHullsOfAPointThatNeedsThem) {
  MethodAnswer answer;
  answer.status = Status::answered;
  answer.verdict = Verdict::intersecting;
  Certificate point{CertificateKind::point, {{0, 1, 0}, {0.25, 0, 0}, {}}, {}};
  answer.set_witness(point);
  EXPECT_EQ(format_method_answer(answer), R"({"verdict":"intersecting","point":[[0,0.25],1,0]})");
  point.hulls = {Hull::line, Hull::space};
  answer.set_witness(point);
  const std::string text = R"("point":[[0,0.25],1,0],"hulls":["line","space"]})";
  EXPECT_EQ(format_method_answer(answer), R"({"verdict":"intersecting",)" + text);
  EXPECT_EQ(format_certificate(point), '{' + text);
  point.hulls = {Hull::plane, Hull::center};
  EXPECT_EQ(format_certificate(point), R"({"point":[[0,0.25],1,0],"hulls":["plane","center"]})");
}

}  // namespace
}  // namespace cyl
