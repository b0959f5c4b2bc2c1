// SPDX-License-Identifier: MIT
// Copy this file, daylight_vectors.hpp and smoke.h into your tests, and define collide().
#include <gtest/gtest.h>

#include "daylight_vectors.hpp"

daylight_v1::Said collide(const double a[9], const double b[9]);

namespace {

constexpr double tolerance = 0;           // that your library states
const std::vector<std::string> excluded;  // ids, each with a comment that gives the reason

class Vectors : public testing::TestWithParam<DaylightVector> {};

TEST_P(Vectors, Judged) {
  const daylight_v1::Said said = collide(GetParam().a, GetParam().b);
  if (said.kind == daylight_v1::Said::declined) GTEST_SKIP() << "declined";
  EXPECT_EQ(daylight_v1::wrong(GetParam(), said, tolerance), "") << GetParam().id;
}

std::string name_of(const testing::TestParamInfo<DaylightVector>& info) {
  return std::string(info.param.id).replace(2, 1, "_");
}

INSTANTIATE_TEST_SUITE_P(Daylight, Vectors, testing::ValuesIn(daylight_v1::vectors(excluded)), name_of);

}  // namespace
