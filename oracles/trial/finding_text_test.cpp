// SPDX-License-Identifier: MIT
#include "oracles/trial/finding_text.hpp"

#include <gtest/gtest.h>

namespace cyl {
namespace {

TEST(DescribeTruth, NamesTheWitnessExactly) {
  const TruthWords apart =
      describe_truth(R"({"verdict":"disjoint","direction":[1,-0.1,1e-300],"stage":"filter"})");
  EXPECT_EQ(apart.verdict, "disjoint");
  EXPECT_EQ(apart.certificate,
            "A plane with normal (1, -0.1, 1e-300) separates them: all of a lies on one side, all of b on "
            "the other.");
  EXPECT_EQ(describe_truth(R"({"verdict":"intersecting","point":[[1,1e-20],"1/3",[-2,-0.5]]})").certificate,
            "The point (1 + 1e-20, 1/3, -2 - 0.5) lies in both.");
  EXPECT_NE(describe_truth(R"({"verdict":"touching","near":{"point":[1,2,3],"direction":[0,0,1]}})")
                .certificate.find("the point (1, 2, 3) is that near to both, and along (0, 0, 1)"),
            std::string::npos);
  EXPECT_EQ(describe_truth(R"({"verdict":"undecided"})").certificate, "No verdict could be proved.");
}

TEST(DescribeTruth, SurvivesAnyText) {
  for (const char* text :
       {"", "null", "[]", "{", R"({"verdict":3,"point":[1,2]})", R"({"point":7})", R"({"near":{"point":{}}})",
        R"({"near":[],"direction":"x","point":[{},[[]],null]})"})
    describe_truth(text);
}

}  // namespace
}  // namespace cyl
