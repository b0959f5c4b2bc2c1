// SPDX-License-Identifier: MIT
// Pairs as JSON values, with the fields of the case files.
#pragma once

#include <cmath>

#include "base/json.hpp"
#include "corpus/pairs/pair_io.hpp"

namespace cyl {

/// A number that JSON does not have becomes the string "nan", "inf" or "-inf".
inline nlohmann::ordered_json number_json(double x) {
  return std::isfinite(x) ? nlohmann::ordered_json(x) : nlohmann::ordered_json(format_double(x));
}

inline nlohmann::ordered_json vector_json(const Vector3& v) {
  return {number_json(v[0]), number_json(v[1]), number_json(v[2])};
}

inline nlohmann::ordered_json solid_json(const Solid& c) {
  if (c.shape == Shape::half_space)
    return {{"shape", "half_space"}, {"point", vector_json(c.center)}, {"normal", vector_json(c.axis)}};
  if (c.shape == Shape::box) {
    nlohmann::ordered_json box = {{"shape", "box"}, {"center", vector_json(c.center)}};
    for (const double edge : c.edges) box["edges"].push_back(number_json(edge));
    for (const double x : c.quaternion) box["quaternion"].push_back(number_json(x));
    if (c.rounding != 0) box["rounding"] = number_json(c.rounding);
    return box;
  }
  nlohmann::ordered_json cylinder = {{"center", vector_json(c.center)},
                                     {"axis", vector_json(c.axis)},
                                     {"radius", number_json(c.radius)},
                                     {"height", number_json(c.height)}};
  if (c.rounding != 0) cylinder["rounding"] = number_json(c.rounding);
  return cylinder;
}

inline nlohmann::ordered_json pair_json(const Pair& p) {
  return {{"a", solid_json(p.a)}, {"b", solid_json(p.b)}};
}

/// Returns the output of format_pair() as a value. Numbers without a decimal point are integers. The pair is
/// valid.
inline nlohmann::ordered_json pair_to_json(const Pair& p) { return parse_ordered_json(format_pair(p)); }

}  // namespace cyl
