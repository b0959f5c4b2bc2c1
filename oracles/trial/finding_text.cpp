// SPDX-License-Identifier: MIT
#include "oracles/trial/finding_text.hpp"

#include <fmt/format.h>

#include <cmath>

#include "base/json.hpp"
#include "corpus/pairs/pair_io.hpp"

namespace cyl {
namespace {

using json = nlohmann::ordered_json;

std::string text_at(const json& object, const char* key) {
  const auto found = object.find(key);
  return found != object.end() && found->is_string() ? found->get<std::string>() : "";
}

// A double, a list of doubles that stands for their exact sum, or an exact rational as text.
std::string coordinate(const json& x) {
  if (x.is_number()) return format_double(x.get<double>());
  if (x.is_string()) return x.get<std::string>();
  std::string sum;
  for (const json& term : x) {
    if (!term.is_number()) continue;
    const double x_i = term.get<double>();
    if (sum.empty()) {
      sum = format_double(x_i);
    } else {
      sum += (x_i < 0 ? " - " : " + ") + format_double(std::abs(x_i));
    }
  }
  return sum;
}

/// "(x, y, z)", or nothing where there is no such vector.
std::string vector_at(const json& object, const char* key) {
  const auto found = object.find(key);
  if (found == object.end() || !found->is_array() || found->size() != 3) return "";
  return fmt::format("({}, {}, {})", coordinate((*found)[0]), coordinate((*found)[1]),
                     coordinate((*found)[2]));
}

std::string certificate_in_words(const json& truth) {
  if (const std::string direction = vector_at(truth, "direction"); !direction.empty()) {
    return fmt::format(
        "A plane with normal {} separates them: all of a lies on one side, all of b on the other.",
        direction);
  }
  if (const std::string point = vector_at(truth, "point"); !point.empty()) {
    return fmt::format("The point {} lies in both.", point);
  }
  if (const auto near = truth.find("near"); near != truth.end() && near->is_object()) {
    return fmt::format(
        "They touch to within 2^-200 of their size: the point {} is that near to both, and along {} neither "
        "a gap nor "
        "an overlap is wider.",
        vector_at(*near, "point"), vector_at(*near, "direction"));
  }
  return "No verdict could be proved.";
}

json parse_object(std::string_view text) {
  json parsed = json::parse(text, nullptr, false);
  return parsed.is_object() ? parsed : json::object();
}

}  // namespace

TruthWords describe_truth(std::string_view text) {
  const json truth = parse_object(text);
  return {text_at(truth, "verdict"), certificate_in_words(truth)};
}

}  // namespace cyl
