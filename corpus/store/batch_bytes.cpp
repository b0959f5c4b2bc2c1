// SPDX-License-Identifier: MIT
#include "corpus/store/batch_bytes.hpp"

#include <stdexcept>
#include <tuple>

#include "base/json.hpp"
#include "base/safe_text.hpp"

// CBOR keeps infinities and the sign of 0, and makes all NaNs one.
template <>
struct nlohmann::adl_serializer<std::optional<cyl::Enclosure>> {
  static void to_json(json& to, const std::optional<cyl::Enclosure>& margin) {
    to = json::array();
    if (margin) to = {margin->lo, margin->hi};
  }
  static void from_json(const json& from, std::optional<cyl::Enclosure>& margin) {
    if (!from.empty()) margin = cyl::Enclosure{from.at(0), from.at(1)};
  }
};

namespace cyl {
using nlohmann::json;

/// An enum travels as its word, so that no number without a meaning comes in.
template <class Enum>
requires std::is_enum_v<Enum>
void to_json(json& to, Enum value) { to = to_string(value); }
template <class Enum>
requires std::is_enum_v<Enum>
void from_json(const json& from, Enum& value) {
  const auto word = from.get<std::string>();
  const std::optional<Enum> known = from_word<Enum>(word);
  if (!known) throw std::runtime_error("a batch cannot be read: it has the unknown word " + word);
  value = *known;
}

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Counts, asked, declined, failed, contract, resolution, undecided,
                                   nanoseconds, hung_nanoseconds)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(TallyRecord, method, family, counts)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(GroupRecord, method, kind, severity, family, count, binade)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(FindingRecord, index, family, family_index, method, kind, severity, margin,
                                   pair, answers, truth, reason)

static void to_json(json& to, const CellRecord& c) {
  to = {c.plane, c.x, c.y, format_cell_counts(c.methods)};
}
static void from_json(const json& from, CellRecord& c) {
  c = {from.at(0), from.at(1), from.at(2), parse_cell_counts(from.at(3).get<std::string>())};
}

std::string format_batch(const BatchRecord& batch) {
  std::vector<FindingRecord> findings = batch.findings;
  const FindingRecord* first = nullptr;  // of the pair
  for (FindingRecord& f : findings) {
    f.reason = valid_utf8(f.reason);
    if (first && first->index == f.index) {
      for (std::string* text : {&f.pair, &f.answers, &f.truth}) text->clear();
      continue;
    }
    for (std::string* text : {&f.pair, &f.answers}) *text = valid_utf8(*text);
    first = &f;
  }
  return format_cbor({batch.tallies, batch.groups, findings, batch.cells});
}

BatchRecord parse_batch(std::string_view bytes) try {
  BatchRecord batch;
  const json all = parse_cbor(bytes);
  all.at(0).get_to(batch.tallies);
  all.at(1).get_to(batch.groups);
  all.at(2).get_to(batch.findings);
  for (std::size_t i = 1; i < batch.findings.size(); ++i) {
    FindingRecord& f = batch.findings[i];
    if (const FindingRecord& before = batch.findings[i - 1]; f.index == before.index)
      std::tie(f.pair, f.answers, f.truth) = std::tie(before.pair, before.answers, before.truth);
  }
  all.at(3).get_to(batch.cells);
  return batch;
} catch (const json::exception& error) {
  throw std::runtime_error(std::string("a batch cannot be read: ") + error.what());
}

}  // namespace cyl
