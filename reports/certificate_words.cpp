// SPDX-License-Identifier: MIT
#include "reports/certificate_words.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "corpus/pair_io.hpp"

namespace cyl {
namespace {

using nlohmann::json;

// A double, a list of doubles that stands for their exact sum, or an exact rational as text.
std::string coordinate(const json& x) {
  if (x.is_number()) return format_double(x.get<double>());
  if (x.is_string()) return x.get<std::string>();
  std::string sum;
  for (const json& term : x) {
    if (!sum.empty()) sum += " + ";
    sum += coordinate(term);
  }
  return sum;
}

std::string vector_of(const json& v) {
  return fmt::format("({}, {}, {})", coordinate(v.at(0)), coordinate(v.at(1)), coordinate(v.at(2)));
}

}  // namespace

std::string certificate_in_words(std::string_view truth_json) {
  const json truth = json::parse(truth_json);
  if (const auto d = truth.find("direction"); d != truth.end()) {
    return fmt::format(
        "A plane with normal {} separates them: all of a lies on one side, all of b on the other.",
        vector_of(*d));
  }
  if (const auto p = truth.find("point"); p != truth.end()) {
    return fmt::format("The point {} lies in both.", vector_of(*p));
  }
  if (const auto n = truth.find("near"); n != truth.end()) {
    return fmt::format(
        "They touch to within 2^-200 of their size: the point {} is that near to both, and along {} neither "
        "a gap nor "
        "an overlap is wider.",
        vector_of(n->at("point")), vector_of(n->at("direction")));
  }
  return "No verdict could be proved.";
}

}  // namespace cyl
