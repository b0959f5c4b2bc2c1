// SPDX-License-Identifier: MIT
#include "reports/certificate_words.hpp"

#include <gtest/gtest.h>

namespace cyl {
namespace {

TEST(CertificateInWords, NamesTheWitnessExactly) {
  EXPECT_EQ(certificate_in_words(R"({"verdict":"disjoint","direction":[1,-0.1,1e-300],"stage":"filter"})"),
            "A plane with normal (1, -0.1, 1e-300) separates them: all of a lies on one side, all of b on "
            "the other.");
  EXPECT_EQ(certificate_in_words(R"({"verdict":"intersecting","point":[[1,1e-20],"1/3",0]})"),
            "The point (1 + 1e-20, 1/3, 0) lies in both.");
  EXPECT_NE(certificate_in_words(R"({"verdict":"touching","near":{"point":[1,2,3],"direction":[0,0,1]}})")
                .find("the point (1, 2, 3) is that near to both, and along (0, 0, 1)"),
            std::string::npos);
  EXPECT_EQ(certificate_in_words(R"({"verdict":"undecided"})"), "No verdict could be proved.");
}

}  // namespace
}  // namespace cyl
