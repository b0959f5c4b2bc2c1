// SPDX-License-Identifier: MIT
// Copy this file, daylight_vectors.hpp and smoke.h into your tests, and define collide().
#define BOOST_TEST_MODULE Daylight
#include <boost/test/included/unit_test.hpp>

#include "daylight_vectors.hpp"

daylight_v1::Said collide(const double a[9], const double b[9]);

BOOST_AUTO_TEST_CASE(daylight_vectors_judged) {
  constexpr double tolerance = 0;           // that your library states
  const std::vector<std::string> excluded;  // ids, each with a comment that gives the reason
  for (const DaylightVector& v : daylight_v1::vectors(excluded)) {
    BOOST_TEST_CONTEXT(v.id) { BOOST_TEST(daylight_v1::wrong(v, collide(v.a, v.b), tolerance) == ""); }
  }
}
