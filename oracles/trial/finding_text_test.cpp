// SPDX-License-Identifier: MIT
#include "oracles/trial/finding_text.hpp"

#include <gtest/gtest.h>

namespace cyl {
namespace {

TEST(InWords, NamesTheWitnessExactly) {
  EXPECT_EQ(in_words({CertificateKind::direction, {{1, -0.1, 1e-300}, {}, {}}, {}}),
            "A plane with normal (1, -0.1, 1e-300) separates them: all of a lies on one side, all of b on "
            "the other.");
  EXPECT_EQ(in_words({CertificateKind::point, {{1, 0, -2}, {1e-20, 0, -0.5}, {"", "1/3", ""}}, {}}),
            "The point (1 + 1e-20, 1/3, -2 - 0.5) lies in both.");
  EXPECT_NE(in_words({CertificateKind::near, {{1, 2, 3}, {}, {}}, {{-0.0, 0, 1}, {}, {}}})
                .find("the point (1, 2, 3) is that near to both, and along (0, 0, 1)"),
            std::string::npos);
  EXPECT_EQ(in_words(Certificate{}), "No verdict could be proved.");
}

}  // namespace
}  // namespace cyl
