// SPDX-License-Identifier: MIT
#include "oracles/methods/guest_protocol.hpp"

#include <algorithm>
#include <initializer_list>
#include <stdexcept>

#include "base/enum_words.hpp"
#include "base/json.hpp"

namespace cyl {
namespace {

using nlohmann::json;

/// The most bytes of a line that an error text repeats.
constexpr std::size_t shown_cap = 40;

std::string shown(std::string_view text) {
  const std::string part(text.substr(0, shown_cap));
  return json(part + (text.size() > shown_cap ? "..." : ""))
      .dump(-1, ' ', false, json::error_handler_t::replace);
}

double number(const json& value, const char* what) {
  if (!value.is_number()) throw std::invalid_argument(std::string(what) + " is no number");
  return value.get<double>();
}

std::string text_of(const json& object, const char* key) {
  const auto found = object.find(key);
  if (found == object.end()) return {};
  if (!found->is_string()) throw std::invalid_argument(std::string(key) + " is no string");
  return found->get<std::string>();
}

const json& three_of(const json& value, const char* what) {
  if (!value.is_array() || value.size() != 3)
    throw std::invalid_argument(std::string(what) + " is no list of 3");
  return value;
}

Verdict verdict_of(const std::string& word) {
  if (const auto verdict = from_word<Verdict>(word)) return *verdict;
  throw std::invalid_argument("the verdict is " + shown(word));
}

/// Throws if the object has another key than these: a misspelt key would be ignored.
void refuse_other_keys(const json& object, const char* what, std::initializer_list<std::string_view> known) {
  for (const auto& [key, value] : object.items())
    if (std::ranges::find(known, key) == known.end())
      throw std::invalid_argument(std::string(what) + " has the unknown key " + shown(key));
}

GuestAnswer answer_of(const json& line) {
  GuestAnswer answer;
  answer.verdict = verdict_of(text_of(line, "verdict"));
  if (const auto d = line.find("distance"); d != line.end()) answer.distance = number(*d, "distance");
  if (const auto d = line.find("distance_at_least"); d != line.end())
    answer.at_least = number(*d, "distance_at_least");
  if (answer.distance && answer.at_least)
    throw std::invalid_argument("both a distance and a distance_at_least");
  if (const auto d = line.find("direction"); d != line.end()) {
    answer.direction.emplace();
    for (std::size_t i = 0; i < 3; ++i)
      (*answer.direction)[i] = number(three_of(*d, "direction")[i], "a coordinate of direction");
  }
  if (const auto p = line.find("point"); p != line.end()) {
    answer.point.emplace();
    for (std::size_t i = 0; i < 3; ++i) {
      const json& x = three_of(*p, "point")[i];
      const bool sum = x.is_array() && x.size() == 2;
      (*answer.point)[i] = number(sum ? x[0] : x, "a coordinate of point");
      (*answer.point)[i + 3] = sum ? number(x[1], "a coordinate of point") : 0;
    }
  }
  return answer;
}

SizeRange sizes_of(const json& sizes) {
  if (!sizes.is_object()) throw std::invalid_argument("sizes is not an object");
  refuse_other_keys(sizes, "sizes", {"least", "greatest", "aspect", "zero", "coordinate", "gap"});
  SizeRange range;
  for (const auto& [key, limit] :
       {std::pair("least", &range.least), std::pair("greatest", &range.greatest),
        std::pair("aspect", &range.aspect), std::pair("coordinate", &range.coordinate),
        std::pair("gap", &range.gap)}) {
    if (const auto found = sizes.find(key); found != sizes.end()) *limit = number(*found, key);
    if (!(*limit >= 0)) throw std::invalid_argument(std::string(key) + " of sizes is negative");
  }
  if (range.greatest < range.least) throw std::invalid_argument("greatest of sizes is less than least");
  if (const auto zero = sizes.find("zero"); zero != sizes.end()) {
    if (!zero->is_boolean()) throw std::invalid_argument("zero of sizes is not true or false");
    range.zero_lengths = zero->get<bool>();
  }
  return range;
}

GuestHello hello_of(const json& line) {
  refuse_other_keys(
      line, "the hello",
      {"name", "version", "claim", "takes", "sizes", "rounded_rims", "depth", "call", "install", "files"});
  GuestHello hello;
  hello.name = text_of(line, "name");
  hello.version = text_of(line, "version");
  if (const auto supports = line.find("takes"); supports != line.end()) {
    if (!supports->is_array()) throw std::invalid_argument("takes is no list");
    if (supports->empty()) throw std::invalid_argument("takes is empty, so there is nothing to ask");
    hello.supports.fill(false);
    for (const json& word : *supports) {
      const auto kind = from_word<SolidKind>(word.is_string() ? word.get<std::string>() : "");
      if (!kind)
        throw std::invalid_argument(
            "takes has what is none of sphere, capsule, cylinder, rounded, half_space, box, rounded_box");
      hello.supports[static_cast<std::size_t>(*kind)] = true;
    }
    if (*supports == json::array({"half_space"}))
      throw std::invalid_argument("takes has half_space alone, and no pair has two");
  }
  if (const auto sizes = line.find("sizes"); sizes != line.end()) hello.sizes = sizes_of(*sizes);
  if (const auto rims = line.find("rounded_rims"); rims != line.end())
    hello.rounded_rims = number(*rims, "rounded_rims");
  if (const std::string depth = text_of(line, "depth"); !depth.empty()) {
    if (depth != "exact" && depth != "at_most")
      throw std::invalid_argument("depth is neither exact nor at_most");
    hello.depth_at_most = depth == "at_most";
  }
  hello.upstream = {text_of(line, "call"), text_of(line, "install"), {}};
  for (const json& file : line.value("files", json::array()))
    hello.upstream.files.push_back(file.is_string() ? file.get<std::string>()
                                                    : throw std::invalid_argument("a file is no string"));
  const auto claim = line.find("claim");
  if (claim == line.end()) return hello;
  if (!claim->is_object()) throw std::invalid_argument("claim is no object");
  refuse_other_keys(*claim, "claim", {"relative", "absolute", "source"});
  for (const auto& [key, value] :
       {std::pair("relative", &hello.relative), std::pair("absolute", &hello.absolute)}) {
    if (const auto found = claim->find(key); found != claim->end()) *value = number(*found, key);
    if (!(*value >= 0)) throw std::invalid_argument(std::string(key) + " of the claim is negative");
  }
  hello.claim_source = text_of(*claim, "source");
  return hello;
}

GuestLine read(std::string_view text) {
  const json line = parse_json(text);
  if (!line.is_object()) throw std::invalid_argument("no object");
  GuestLine out;
  if (line.contains("verdict")) {
    out.answer = answer_of(line);
  } else if (line.contains("declined") || line.contains("error")) {
    out.answer.emplace();
    out.answer->declined = line.contains("declined");
    out.answer->reason = text_of(line, out.answer->declined ? "declined" : "error");
  } else if (line.contains("name") || line.contains("version") || line.contains("claim") ||
             line.contains("takes") || line.contains("sizes")) {
    out.hello = hello_of(line);
  } else {
    throw std::invalid_argument("neither a verdict nor declined, error or a hello");
  }
  return out;
}

}  // namespace

GuestLine parse_guest_line(std::string_view text) {
  GuestLine out;
  try {
    return read(text);
  } catch (const json::exception&) {  // its text may quote much of the line
    out.error = "not JSON: " + shown(text);
  } catch (const std::invalid_argument& wrong) {
    out.error = std::string(wrong.what()) + ": " + shown(text);
  }
  return out;
}

MethodAnswer method_answer(const GuestAnswer& said, bool depth_at_most) {
  if (!said.verdict && !said.declined) return failed_answer(Failure::reported, said.reason);
  if (said.declined) return declined_answer(said.reason);
  MethodAnswer answer = answered(*said.verdict);
  answer.has_distance = said.distance.has_value();
  answer.at_least = said.at_least.has_value();
  answer.distance = said.distance.value_or(said.at_least.value_or(0));
  if (depth_at_most) answer.bound_depth();
  const bool meet = answer.verdict == Verdict::intersecting || answer.verdict == Verdict::touching;
  if (said.point && (meet || !said.direction)) {
    answer.witness = CertificateKind::point;
    std::copy_n(said.point->data(), 3, answer.head);
    std::copy_n(said.point->data() + 3, 3, answer.tail);
  } else if (said.direction) {
    answer.set_direction(Vector3((*said.direction)[0], (*said.direction)[1], (*said.direction)[2]));
  }
  return answer;
}

}  // namespace cyl
