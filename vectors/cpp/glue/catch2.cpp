// SPDX-License-Identifier: MIT
// Copy this file, daylight_vectors.hpp and smoke.h into your tests, and define collide().
#if __has_include(<catch2/catch_all.hpp>)  // version 3; link Catch2::Catch2WithMain
#include <catch2/catch_all.hpp>
#else
#define CATCH_CONFIG_MAIN
#include <catch2/catch.hpp>
#endif

#include "daylight_vectors.hpp"

daylight_v1::Said collide(const double a[9], const double b[9]);

TEST_CASE("Daylight") {
  constexpr double tolerance = 0;           // that your library states
  const std::vector<std::string> excluded;  // ids, each with a comment that gives the reason
  for (const DaylightVector& v : daylight_v1::vectors(excluded)) DYNAMIC_SECTION(v.id) {
      CHECK(daylight_v1::wrong(v, collide(v.a, v.b), tolerance) == "");
    }
}
