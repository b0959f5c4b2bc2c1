// SPDX-License-Identifier: MIT
#include "corpus/store/batch_text.hpp"

#include <bit>
#include <stdexcept>

#include "base/json.hpp"

namespace cyl {
namespace {

using nlohmann::json;

}  // namespace

// Margins go as their bits: JSON has no infinity.
std::string format_batch(const BatchRecord& batch) {
  json tallies = json::array(), groups = json::array(), findings = json::array(), cells = json::array();
  for (const auto& [method, family, c] : batch.tallies) {
    tallies.push_back({method, family, c.asked, c.declined, c.failed, c.contract, c.resolution, c.undecided,
                       c.nanoseconds});
  }
  for (const GroupRecord& g : batch.groups) {
    groups.push_back({g.method, g.kind, g.severity, g.family, g.count, g.binade});
  }
  for (const FindingRecord& f : batch.findings) {
    json margin = json::array();
    if (f.margin)
      margin = {std::bit_cast<std::uint64_t>(f.margin->lo), std::bit_cast<std::uint64_t>(f.margin->hi)};
    findings.push_back({f.index, f.family, f.family_index, f.method, f.kind, f.severity, margin, f.pair,
                        f.answers, f.truth, f.stage, f.reason});
  }
  for (const CellRecord& c : batch.cells) cells.push_back({c.plane, c.x, c.y, format_cell_counts(c.methods)});
  return json{tallies, groups, findings, cells}.dump(-1, ' ', false, json::error_handler_t::replace);
}

BatchRecord parse_batch(std::string_view text) try {
  BatchRecord batch;
  const json all = parse_json(text);
  for (const json& t : all.at(0)) {
    batch.tallies.push_back(
        {t.at(0), t.at(1), Counts{t.at(2), t.at(3), t.at(4), t.at(5), t.at(6), t.at(7), t.at(8)}});
  }
  for (const json& g : all.at(1))
    batch.groups.push_back({g.at(0), g.at(1), g.at(2), g.at(3), g.at(4), g.at(5)});
  for (const json& t : all.at(2)) {
    FindingRecord f;
    f.index = t.at(0);
    f.family = t.at(1);
    f.family_index = t.at(2);
    f.method = t.at(3);
    f.kind = t.at(4);
    f.severity = t.at(5);
    if (const json& margin = t.at(6); !margin.empty()) {
      f.margin = MarginRecord{std::bit_cast<double>(margin.at(0).get<std::uint64_t>()),
                              std::bit_cast<double>(margin.at(1).get<std::uint64_t>())};
    }
    f.pair = t.at(7);
    f.answers = t.at(8);
    f.truth = t.at(9);
    f.stage = t.at(10);
    f.reason = t.at(11);
    batch.findings.push_back(std::move(f));
  }
  for (const json& c : all.at(3))
    batch.cells.push_back({c.at(0), c.at(1), c.at(2), parse_cell_counts(c.at(3).get<std::string>())});
  return batch;
} catch (const json::exception& e) {
  throw std::runtime_error(std::string("a batch cannot be read: ") + e.what());
}

}  // namespace cyl
