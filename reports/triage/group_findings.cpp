// SPDX-License-Identifier: MIT
#include "reports/triage/group_findings.hpp"

#include <algorithm>

#include "corpus/pairs/pair_io.hpp"
#include "corpus/store/run_facts.hpp"
#include "reports/triage/causes.hpp"

namespace cyl {
namespace {

void add(CauseFindings& group, const FindingRecord& finding, const CauseRecord& cause) {
  group.findings.push_back(&finding);
  group.mechanisms.insert(cause.mechanism);
  const std::string& labels = cause.labels.text;
  for (std::size_t at = 0; at < labels.size();) {
    const std::size_t end = std::min(labels.find('\n', at), labels.size());
    ++group.labels[labels.substr(at, end - at)];
    at = end + 1;
  }
  if (group.worst == nullptr || is_worse(finding, *group.worst)) group.worst = &finding;
}

void offer(CauseFindings& group, const FindingRecord* of, const std::string& line, bool as_found,
           bool finished = false) {
  const auto parsed = parse_case(line, 1).value;
  if (!parsed || (!as_found && !is_legal(parsed->pair))) return;
  group.candidates.push_back({as_found, finished, complexity(parsed->pair), of, parsed->pair});
}

/// Adds `found` findings to the counts of their causes, in proportion to the examined ones. The larger parts
/// get the remainder first.
void share_out(std::uint64_t found, const std::map<std::string, std::uint64_t>& examined,
               std::map<std::string, std::uint64_t>& counts) {
  std::uint64_t all = 0, given = 0;
  for (const auto& [cause, n] : examined) all += n;
  std::vector<std::pair<std::uint64_t, std::string>> parts;
  for (const auto& [cause, n] : examined) {
    const std::uint64_t share = found / all * n + found % all * n / all;
    counts[cause] += share;
    given += share;
    parts.emplace_back(n, cause);
  }
  std::sort(parts.rbegin(), parts.rend());
  for (std::size_t i = 0; !parts.empty() && given < found; ++given, ++i)
    ++counts[parts[i % parts.size()].second];
}

}  // namespace

double least_margin(const FindingRecord& f) { return f.margin ? f.margin->lo : -1; }

bool is_worse(const FindingRecord& x, const FindingRecord& y) {
  return std::pair(is_refuted_verdict(x.kind), least_margin(x)) >
         std::pair(is_refuted_verdict(y.kind), least_margin(y));
}

// Findings within a claim have keys of their own (cause_key), so that a cause has one severity.
std::map<std::string, CauseFindings> group_by_cause(const TriageRecords& records) {
  std::map<std::int64_t, const FindingRecord*> by_id;
  for (const FindingRecord& f : records.findings) by_id[f.id] = &f;
  std::map<std::string, CauseFindings> groups;
  std::map<std::int64_t, CauseFindings*> group_of;
  for (const CauseRecord& c : records.causes) {
    const auto found = by_id.find(c.finding);
    if (found == by_id.end()) continue;
    group_of[c.finding] = &groups[c.cause];
    add(groups[c.cause], *found->second, c);
  }
  for (const SimpleRecord& s : records.simples) {
    if (!group_of.contains(s.finding)) continue;
    offer(*group_of[s.finding], by_id[s.finding], s.pair, false, s.ended);
  }
  for (auto& [key, group] : groups)
    for (const FindingRecord* f : group.findings) offer(group, f, f->pair, true);
  return groups;
}

std::map<std::string, std::uint64_t> count_by_cause(const std::vector<GroupRecord>& groups,
                                                    const std::vector<FindingRecord>& findings,
                                                    const std::vector<CauseRecord>& causes) {
  std::map<std::int64_t, const std::string*> cause_of;
  for (const CauseRecord& c : causes) cause_of[c.finding] = &c.cause;
  std::map<FindingGroup, std::map<std::string, std::uint64_t>> examined;
  for (const FindingRecord& f : findings)
    if (const auto cause = cause_of.find(f.id); cause != cause_of.end()) ++examined[f][*cause->second];
  std::map<std::string, std::uint64_t> counts;
  for (const GroupRecord& g : groups) share_out(g.count, examined[g], counts);
  return counts;
}

}  // namespace cyl
