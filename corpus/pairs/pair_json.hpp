// SPDX-License-Identifier: MIT
// Pairs as JSON values, with the fields of the case files.
#pragma once

#include <cmath>
#include <string>

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

/// Returns the output of format_pair() as a value. Numbers without a decimal point are integers, but -0 keeps
/// its sign.
inline nlohmann::ordered_json pair_json(const Pair& p) {
  std::string text = format_pair(p);
  for (std::size_t at = 0; (at = text.find("-0", at)) != text.npos; at += 2)
    if (text[at + 2] == ',' || text[at + 2] == ']' || text[at + 2] == '}') text.insert(at + 2, ".0");
  return parse_ordered_json(text);
}
inline nlohmann::ordered_json solid_json(const Solid& c) { return pair_json({c, {}})["a"]; }

}  // namespace cyl
