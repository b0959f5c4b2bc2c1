// SPDX-License-Identifier: MIT
#include "reports/gate/gate_json.hpp"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "corpus/pairs/pair_io.hpp"
#include "corpus/pairs/pair_json.hpp"

namespace cyl {
namespace {

using json = nlohmann::ordered_json;

json pair(const Pair& p) { return {{"a", cylinder_json(p.a)}, {"b", cylinder_json(p.b)}}; }

json counts(const AnswerCounts& c) {
  json said;
  for (const Verdict v :
       {Verdict::disjoint, Verdict::intersecting, Verdict::touching, Verdict::undecided, Verdict::invalid})
    said[to_string(v)] = c.said[static_cast<std::size_t>(v)];
  return {{"asked", c.asked},
          {"declined", c.declined},
          {"failed", c.failed},
          {"hung_seconds", c.hung_seconds},
          {"said", std::move(said)}};
}

json method(const GateMethod& m) {
  json cells = json::array();
  for (const GateCell& c : m.cells) {
    cells.push_back({{"feature", c.feature},
                     {"decade", c.decade},
                     {"claimed", c.claimed},
                     {"pairs", c.pairs},
                     {"wrong", c.wrong},
                     {"undecided", c.undecided}});
  }
  return {{"name", m.name},
          {"version", m.version},
          {"claim",
           {{"relative", number_json(m.claim.relative)},
            {"absolute", number_json(m.claim.absolute)},
            {"source", m.claim.source}}},
          {"counts", counts(m.counts)},
          {"cells", std::move(cells)},
          {"remark", m.remark}};
}

json failure(const GateFailure& f) {
  return {{"method", f.method},
          {"law", f.law->number},
          {"name", f.law->name},
          {"kind", f.kind},
          {"what", f.what},
          {"severity", to_string(f.severity)},
          {"phase", to_string(f.phase)},
          {"origin", f.origin},
          {"found", pair(f.found)},
          {"simplest", pair(f.simplest)},
          {"bucket", f.bucket},
          {"count", f.count},
          {"reruns", f.reruns},
          {"failed_again", f.failed_again},
          {"reproduce", f.reproduce},
          {"known", f.known},
          {"in_base", f.in_base}};
}

}  // namespace

std::string gate_json(const GateReport& report) {
  json methods = json::array(), failures = json::array(), phases = json::array();
  for (const GateMethod& m : report.methods) methods.push_back(method(m));
  for (const GateFailure& f : report.failures) failures.push_back(failure(f));
  for (const GatePhaseReport& p : report.phases) {
    phases.push_back({{"phase", to_string(p.phase)},
                      {"rounds", p.rounds},
                      {"pairs", p.pairs},
                      {"milliseconds", p.time.count()}});
  }
  const json all = {{"seed", report.seed},           {"budget_milliseconds", report.budget.count()},
                    {"methods", std::move(methods)}, {"failures", std::move(failures)},
                    {"phases", std::move(phases)},   {"undecided_truths", report.undecided_truths},
                    {"drawn", report.drawn}};
  return all.dump(1, ' ', false, json::error_handler_t::replace) + '\n';
}

GateBase read_base(const std::string& file) {
  const auto refuse = [&](const std::string& wrong) {
    throw std::runtime_error(file + ": " + wrong + "; give the file that an earlier gate wrote as JSON");
  };
  const auto natural = [&](const json& in, const char* key) {
    const json& value = in.at(key);
    if (!value.is_number_unsigned()) refuse(std::string("has no whole number as ") + key);
    return value.get<std::uint64_t>();
  };
  std::error_code fault;
  if (!std::filesystem::is_regular_file(file, fault)) refuse("is no file");
  std::ifstream in(file);
  if (!in) refuse("cannot be opened");
  const json all = json::parse(in, nullptr, false);
  if (in.bad()) refuse("cannot be read");
  if (all.is_discarded()) refuse("is no JSON, or was cut off");
  GateBase base;
  try {
    base.seed = natural(all, "seed");
    base.budget = std::chrono::milliseconds(natural(all, "budget_milliseconds"));
    std::uint64_t cases = 0;
    for (const json& phase : all.at("phases")) {
      const auto is = [&](GatePhase p) { return phase.at("phase") == to_string(p); };
      if (is(GatePhase::corpus)) cases = natural(phase, "pairs");
      if (is(GatePhase::corpus_laws) && natural(phase, "pairs") < cases)
        base.amount.cases_under_laws = natural(phase, "pairs");
      if (is(GatePhase::laws)) base.amount.law_rounds = natural(phase, "rounds");
      if (is(GatePhase::sample)) base.amount.sample_rounds = natural(phase, "rounds");
    }
    for (const json& f : all.at("failures")) {
      // What the base breaks within its claims excuses nothing.
      if (f.at("severity") == to_string(Severity::resolution)) continue;
      base.buckets[f.at("bucket").get<std::string>()] += natural(f, "count");
    }
  } catch (const json::exception&) {
    refuse("is no report of this version's gate");
  }
  return base;
}

void mark_known(GateReport& report, const GateBase& base) {
  for (GateFailure& f : report.failures) {
    const auto found = base.buckets.find(f.bucket);
    if (f.bucket.empty() || found == base.buckets.end()) continue;
    f.in_base = found->second;
    f.known = f.count <= f.in_base || f.failed_again < f.reruns || f.kind == to_string(FindingKind::hang);
  }
}

}  // namespace cyl
