// SPDX-License-Identifier: MIT
#include "reports/run/report_data.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <stdexcept>
#include <unordered_map>
#include <vector>

#include "base/files.hpp"
#include "base/json.hpp"
#include "corpus/pairs/families.hpp"
#include "corpus/pairs/pair_json.hpp"
#include "corpus/store/stored_answers.hpp"
#include "oracles/methods/method.hpp"
#include "reports/run/page_template.hpp"
#include "reports/run/run_summary.hpp"
#include "reports/run/tally_table.hpp"
#include "reports/triage/case_distance.hpp"
#include "reports/triage/triage.hpp"

namespace cyl {
namespace {

using json = nlohmann::ordered_json;

/// Returns null for text that cannot be read.
json parsed(const std::string& text) { return json::parse(text, nullptr, false); }

// The run
// -----------------------------------------------------------------------------------------------------------

json run_json(const RunData& run, const std::vector<MethodTally>& tallies) {
  std::uint64_t pairs = 0;  // judged pairs; the next index of a shard also counts pairs of other shards
  for (const MethodTally& m : tallies)
    if (m.method == referee_row) pairs = m.total.asked;
  return {{"id", std::filesystem::canonical(run.folder).filename().string()},
          {"seed", value_of(run.config, "seed")},
          {"pairs", pairs},
          {"started", value_of(run.config, "started")},
          {"status", value_of(run.config, "status")},
          {"seconds", static_cast<double>(run.progress.milliseconds) / 1000},
          {"build", value_of(run.config, "build")},
          {"folder", run.folder}};
}

json methods_json(const RunData& run) {
  std::set<std::string, std::less<>> own;
  for (const auto& m : own_methods()) own.emplace(m->name());
  json all = json::array();
  for (const MethodRecord& m : run.methods) {
    json claim{{"relative", number_json(m.relative)},
               {"absolute", number_json(m.absolute)},
               {"source", m.source},
               {"stated", !m.assumed}};
    all.push_back({{"name", m.name},
                   {"library", own.contains(m.name) ? "ours" : m.library},
                   {"version", m.version},
                   {"claim", std::move(claim)},
                   {"own", own.contains(m.name)}});
  }
  return all;
}

json families_json(const std::vector<MethodTally>& tallies) {
  std::set<std::string> asked;
  for (const MethodTally& m : tallies)
    for (const TallyRecord& t : m.families) asked.insert(t.family);
  json all = json::array();
  const auto tell = [&](const std::string& name, std::string_view summary) {
    if (asked.erase(name) > 0) all.push_back({{"name", name}, {"summary", summary}});
  };
  tell(cases_family, "the case files, played first");
  for (const Family& f : campaign_families()) tell(std::string(f.name), f.summary);
  tell(fuzzed_family, "the corpus of a fuzzer, then changes of its pairs");
  for (const std::string& name : std::set(asked)) tell(name, "of another build");
  return all;
}

json tallies_json(const std::vector<MethodTally>& tallies) {
  json all = json::array();
  for (const MethodTally& m : tallies) {
    for (const TallyRecord& t : m.families) {
      all.push_back({{"method", t.method},
                     {"family", t.family},
                     {"asked", t.counts.asked},
                     {"declined", t.counts.declined},
                     {"failed", t.counts.failed},
                     {"contract", t.counts.contract},
                     {"resolution", t.counts.resolution},
                     {"undecided", t.counts.undecided}});
    }
  }
  return all;
}

// Findings
// -----------------------------------------------------------------------------------------------------------

/// The findings on one pair.
struct Shared {
  const FindingRecord* first = nullptr;
  const FoundPair* pair = nullptr;             ///< the pair of `first`
  std::set<std::string, std::less<>> methods;  ///< methods that have a finding on it
  std::optional<Enclosure> margin;             ///< the signed distance over the size, if a finding has it
};

json margin_json(const std::optional<Enclosure>& margin) {
  return margin ? json{number_json(margin->lo), number_json(margin->hi)} : json();
}

/// Lists equal answers once, with all methods that gave them. Omits witnesses of methods without a finding.
json said_on(const Shared& shared) {
  json said = json::array();
  std::map<std::string, std::size_t> known;
  const auto place_of = [&](json reported) {
    const auto [at, added] = known.try_emplace(reported.dump(), said.size());
    if (added) said.push_back({std::move(reported), json::array()});
    return at->second;
  };
  for_each_answer(parsed(shared.first->answers), [&](const json& answer, const auto& methods) {
    std::optional<std::size_t> whole, bare;  // places with witnesses and without
    for (const std::string& method : methods) {
      std::optional<std::size_t>& place = shared.methods.contains(method) ? whole : bare;
      if (!place) {
        json reported = answer;
        if (&place == &bare) {
          reported.erase("direction");
          reported.erase("point");
        }
        place = place_of(std::move(reported));
      }
      said[*place][1].push_back(method);
    }
  });
  return said;
}

/// Returns null if the record does not hold a pair.
json case_of(const Shared& shared) {
  const std::optional<Case>& line = shared.pair->line;
  if (!line) return nullptr;
  json reported = {{"pair", pair_json(line->pair)},
                   {"truth", parsed(shared.first->truth)},
                   {"margin", margin_json(shared.margin)}};
  if (!reported["truth"].is_object()) reported["truth"] = {{"verdict", "undecided"}};
  if (const auto verdict = shared.pair->truth) add_distance(reported, line->pair, *verdict, shared.margin);
  std::string note;
  for (const std::string& part : {line->id, line->source, line->note})
    if (!part.empty()) note += (note.empty() ? "" : "; ") + part;
  if (!note.empty()) reported["note"] = std::move(note);
  reported["said"] = said_on(shared);
  return reported;
}

void add_findings(json& report, const RunData& run) {
  std::unordered_map<std::int64_t, std::string> cause_of;
  for (const json& cause : report["causes"])
    for (const json& id : cause.at("findings"))
      cause_of.emplace(id.get<std::int64_t>(), cause.at("key").get<std::string>());

  const std::vector<FindingRecord>& records = run.findings;
  std::unordered_map<std::string, std::size_t> known;
  std::vector<Shared> shared;
  std::vector<std::size_t> case_at;
  for (std::size_t i = 0; i < records.size(); ++i) {
    const FindingRecord& f = records[i];
    const auto [at, added] = known.try_emplace(f.pair + '\n' + f.truth + '\n' + f.answers, shared.size());
    if (added) shared.push_back({&f, &run.pairs[i], {}, {}});
    Shared& s = shared[at->second];
    s.methods.insert(f.method);
    // The margin of a wrong distance is its error.
    if (!s.margin && f.kind != FindingKind::distance_outside) s.margin = f.margin;
    case_at.push_back(at->second);
  }

  json cases = json::array();
  std::vector<std::optional<std::size_t>> shown_at;
  for (const Shared& s : shared) {
    json reported = case_of(s);
    shown_at.push_back(reported.is_null() ? std::nullopt : std::optional(cases.size()));
    if (!reported.is_null()) cases.push_back(std::move(reported));
  }
  json findings = json::array();
  for (const std::size_t i : worst_first(run)) {
    const FindingRecord& f = records[i];
    if (!shown_at[case_at[i]]) continue;
    const auto cause = cause_of.find(f.id);
    findings.push_back({{"id", f.id},
                        {"method", f.method},
                        {"kind", to_string(f.kind)},
                        {"severity", to_string(f.severity)},
                        {"family", f.family},
                        {"cause", cause == cause_of.end() ? json() : json(cause->second)},
                        {"margin", margin_json(f.margin)},
                        {"case", *shown_at[case_at[i]]}});
    if (!f.reason.empty()) findings.back()["reason"] = f.reason;
  }
  std::uint64_t total = 0;
  for (const GroupRecord& g : run.groups) total += g.count;
  if (findings.size() < records.size()) report["unreadable"] = records.size() - findings.size();
  report["findings"] = std::move(findings);
  report["findings_total"] = total;
  report["cases"] = std::move(cases);
}

// Charts and the report
// -----------------------------------------------------------------------------------------------------------

void add_charts(json& report, const RunData& run) {
  for (const char* section : {"maps", "speed", "paths"}) {
    report[section] = run.charts.value(section, nlohmann::json::array());
    if (!report[section].is_array())
      throw std::runtime_error(fmt::format("{}/charts.json: {} is not an array", run.folder, section));
  }
  if (run.charts.contains("speed_on")) report["speed_on"] = run.charts.at("speed_on");
}

}  // namespace

std::string report_json(const RunData& run) {
  const std::vector<MethodTally> tallies = tally_methods(run.tallies);
  json report = {{"run", run_json(run, tallies)},
                 {"methods", methods_json(run)},
                 {"families", families_json(tallies)},
                 {"tallies", tallies_json(tallies)},
                 {"causes", causes_json(run.folder)}};
  add_findings(report, run);
  add_charts(report, run);
  return report.dump(-1, ' ', false, json::error_handler_t::replace);
}

void write_page(const RunData& run) {
  replace_file(run.folder + "/report.html", fill_template(report_json(run)));
}

}  // namespace cyl
