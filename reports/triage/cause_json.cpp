// SPDX-License-Identifier: MIT
#include <stdexcept>

#include "base/number_text.hpp"
#include "corpus/pairs/pair_io.hpp"
#include "corpus/pairs/pair_json.hpp"
#include "reports/triage/causes.hpp"

namespace cyl {
namespace {

using Json = nlohmann::json;

/// Calls `visit` with the name and the value of each field that JSON holds unchanged.
template <class B, class Visit>
void visit_plain(B& b, Visit visit) {
  visit("key", b.key);
  visit("method", b.method);
  visit("methods", b.methods);
  visit("methods_of_kind", b.methods_of_kind);
  visit("count", b.count);
  visit("families", b.families);
  visit("findings", b.findings);
  visit("simplified", b.simplified);
  visit("seen_again", b.seen_again);
  visit("asked_before", b.asked_before);
  visit("cause", b.description);
  visit("labels", b.labels);
  visit("first_seen", b.first_seen);
  visit("last_seen", b.last_seen);
  visit("first_version", b.first_version);
  visit("last_version", b.last_version);
}

Json margin_json(const std::optional<Enclosure>& margin) {
  if (!margin) return nullptr;
  return {number_json(margin->lo), number_json(margin->hi)};
}

/// Reads an end of an enclosure, as number_json() writes it.
double end_of(const Json& x) {
  if (!x.is_string()) return x.get<double>();
  const auto number = number_in<double>(x.get<std::string>());
  if (!number) throw std::runtime_error(x.dump() + " is not a number");
  return *number;
}

template <Worded E>
E word_of(const Json& word) {
  const auto value = from_word<E>(word.get<std::string>());
  if (!value) throw std::runtime_error(word.dump() + " is not a word that this version writes");
  return *value;
}

/// Reads the pair and the margin of a Case of the page.
ShownCase case_of(const Json& j) {
  ShownCase shown{parse_case(j.at("pair").dump(), 1).value.value().pair, {}, j.dump()};
  if (const Json& margin = j.at("margin"); !margin.is_null())
    shown.margin = Enclosure{end_of(margin.at(0)), end_of(margin.at(1))};
  return shown;
}

}  // namespace

Json to_json(const Cause& b) {
  Json j{{"kind", to_string(b.kind)},
         {"simplest", parse_json(b.simplest.page)},
         {"worst", b.worst ? parse_json(b.worst->page) : Json()},
         {"severity", to_string(b.severity)},
         {"margin", margin_json(b.margin)},
         {"status", nullptr}};
  if (b.status) j["status"] = to_string(*b.status);
  visit_plain(b, [&](const char* key, const auto& value) { j[key] = value; });
  return j;
}

Json to_json(const std::vector<Cause>& causes) {
  Json all = Json::array();
  for (const Cause& b : causes) all.push_back(to_json(b));
  return all;
}

Cause cause_from_json(const Json& j) {
  Cause b;
  visit_plain(b, [&](const char* key, auto& value) { j.at(key).get_to(value); });
  b.simplest = case_of(j.at("simplest"));
  if (const Json& worst = j.at("worst"); !worst.is_null()) b.worst = case_of(worst);
  b.kind = word_of<FindingKind>(j.at("kind"));
  b.severity = word_of<Severity>(j.at("severity"));
  if (const Json& margin = j.at("margin"); !margin.is_null())
    b.margin = Enclosure{end_of(margin.at(0)), end_of(margin.at(1))};
  if (const Json& status = j.at("status"); !status.is_null()) b.status = word_of<Recurrence>(status);
  return b;
}

}  // namespace cyl
