// SPDX-License-Identifier: MIT
// Copy this file, daylight_vectors.hpp and smoke.h into your tests, and define collide().
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>

#include "daylight_vectors.hpp"

daylight_v1::Said collide(const double a[9], const double b[9]);

TEST_CASE("Daylight") {
  constexpr double tolerance = 0;           // that your library states
  const std::vector<std::string> excluded;  // ids, each with a comment that gives the reason
  for (const DaylightVector& v : daylight_v1::vectors(excluded)) SUBCASE(v.id) {
      const std::string wrong = daylight_v1::wrong(v, collide(v.a, v.b), tolerance);
      CHECK_MESSAGE(wrong.empty(), std::string(v.id), ": ", wrong);
    }
}
