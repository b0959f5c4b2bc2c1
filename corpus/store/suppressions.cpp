// SPDX-License-Identifier: MIT
#include "corpus/store/suppressions.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <utility>

#include "base/json.hpp"
#include "base/usage_error.hpp"

namespace cyl {
namespace {

using Json = nlohmann::json;

constexpr std::array<std::pair<const char*, std::string Suppression::*>, 5> fields{{
    {"bucket", &Suppression::cause},
    {"reason", &Suppression::reason},
    {"link", &Suppression::link},
    {"owner", &Suppression::owner},
    {"expires", &Suppression::expires},
}};

[[noreturn]] void refuse(std::size_t line, std::size_t at, const std::string& why) {
  throw std::invalid_argument("line " + std::to_string(line) + ", column " + std::to_string(at + 1) + ": " +
                              why);
}

/// Returns the place in the text of a key's value, or of the key itself, or 0.
std::size_t place_of(const std::string& text, const std::string& key) {
  const std::size_t at = text.find(Json(key).dump());
  if (at == text.npos) return 0;
  const std::size_t value = text.find_first_not_of(" \t:", at + Json(key).dump().size());
  return value == text.npos ? at : value;
}

bool is_date(const std::string& text) {
  constexpr std::string_view form = "dddd-dd-dd";
  if (text.size() != form.size()) return false;
  for (std::size_t i = 0; i < form.size(); ++i)
    if (form[i] == 'd' ? text[i] < '0' || text[i] > '9' : text[i] != form[i]) return false;
  const auto number = [&](std::size_t from, std::size_t count) {
    return static_cast<unsigned>(std::stoul(text.substr(from, count)));
  };
  return (std::chrono::year(static_cast<int>(number(0, 4))) / std::chrono::month(number(5, 2)) /
          std::chrono::day(number(8, 2)))
      .ok();
}

Suppression parse(const std::string& text, std::size_t line) {
  Json object;
  try {
    object = Json::parse(text);
  } catch (const Json::parse_error& error) {
    refuse(line, error.byte > 0 ? error.byte - 1 : 0, "no JSON");
  }
  if (!object.is_object()) refuse(line, 0, "no object");
  Suppression s;
  s.line = line;
  for (const auto& item : object.items()) {
    const std::string& key = item.key();
    const Json& value = item.value();
    const auto field =
        std::find_if(fields.begin(), fields.end(), [&](const auto& f) { return f.first == key; });
    if (field == fields.end()) refuse(line, text.find(Json(key).dump()), "'" + key + "' is not a field");
    if (!value.is_string()) refuse(line, place_of(text, key), key + " is not a text");
    if (value.get<std::string>().empty()) refuse(line, place_of(text, key), key + " is empty: fill it in");
    s.*field->second = value.get<std::string>();
  }
  for (const auto& [key, member] : fields)
    if ((s.*member).empty()) refuse(line, 0, std::string(key) + " is missing");
  if (!is_date(s.expires)) refuse(line, place_of(text, "expires"), "expires is not a day YYYY-MM-DD");
  return s;
}

}  // namespace

std::vector<Suppression> read_suppressions(std::istream& in) {
  std::vector<Suppression> all;
  std::string text;
  for (std::size_t line = 1; std::getline(in, text); ++line) {
    if (text.find_first_not_of(" \t\r") == text.npos) continue;
    Suppression s = parse(text, line);
    const auto same = std::find_if(all.begin(), all.end(), [&](const auto& x) { return x.cause == s.cause; });
    if (same != all.end())
      refuse(line, place_of(text, "bucket"), "the cause has line " + std::to_string(same->line) + " already");
    all.push_back(std::move(s));
  }
  return all;
}

std::vector<Suppression> read_suppressions(const std::optional<std::string>& given,
                                           const std::string& usual) {
  const std::string file = given.value_or(usual);
  if (file.empty()) return {};
  if (!std::filesystem::exists(file)) {
    if (given) throw UsageError(file + ": is not a file; '' means no suppressions");
    return {};
  }
  std::ifstream in(file);
  try {
    std::vector<Suppression> all = read_suppressions(in);
    if (in.bad() || !in.eof()) throw std::invalid_argument("cannot be read");
    return all;
  } catch (const std::invalid_argument& error) {
    throw UsageError(file + ": " + error.what());
  }
}

std::string line_of(const Suppression& s) {
  nlohmann::ordered_json line;
  for (const auto& [key, member] : fields) line[key] = s.*member;
  return line.dump();
}

// Days in this form have the order of their texts.
bool is_expired(const Suppression& suppression, std::string_view today) {
  return std::string_view(suppression.expires) < today;
}

const Suppression* find_suppression(const std::vector<Suppression>& suppressions, std::string_view cause,
                                    std::string_view today) {
  for (const Suppression& s : suppressions)
    if (s.cause == cause && !is_expired(s, today)) return &s;
  return nullptr;
}

}  // namespace cyl
