// SPDX-License-Identifier: MIT
// Judges a library's answers about the vectors of smoke.h, in any test framework; vectors/cpp/glue has four.
// C++17, and no other header of this project but smoke.h.
#pragma once

#include <string>
#include <vector>

#include "smoke.h"

namespace daylight_v1 {  // <time.h> has a variable `daylight`

/// The answer of a library: that the solids are disjoint or meet, and the signed distance if it has one.
struct Said {
  enum Kind { declined, disjoint, meet, distance } kind = declined;
  double value = 0;

  static Said verdict(bool meets) { return {meets ? meet : disjoint, 0}; }
  static Said of_distance(double d) { return {distance, d}; }
};

/// Returns what is wrong with an answer, or nothing. `tolerance`: the length that the library states.
inline std::string wrong(const DaylightVector& v, const Said& said, double tolerance = 0) {
  const std::string truth = std::string(v.result < 0   ? "disjoint"
                                        : v.result > 0 ? "intersecting"
                                                       : "touching") +
                            ", at a distance of " + std::to_string(v.low) + " to " + std::to_string(v.high);
  switch (said.kind) {
    case Said::declined:
      return "";
    case Said::distance:
      if (said.value >= v.low - tolerance && said.value <= v.high + tolerance) return "";
      return "said a distance of " + std::to_string(said.value) + "; they are " + truth;
    default:
      if ((said.kind == Said::meet) == (v.result >= 0) || tolerance > v.acceptable_below) return "";
      return std::string("said that they ") + (said.kind == Said::meet ? "meet" : "are disjoint") +
             "; they are " + truth;
  }
}

/// The vectors of smoke.h that are not excluded.
inline std::vector<DaylightVector> vectors(const std::vector<std::string>& excluded = {}) {
  std::vector<DaylightVector> all;
  for (const DaylightVector& v : daylight_vectors) {
    bool left_out = false;
    for (const std::string& id : excluded) left_out |= id == v.id;
    if (!left_out) all.push_back(v);
  }
  return all;
}

}  // namespace daylight_v1
