// SPDX-License-Identifier: MIT
#include "reports/gate/gate_json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>
#include <utility>

#include "base/json.hpp"
#include "base/safe_text.hpp"
#include "base/usage_error.hpp"
#include "corpus/pairs/pair_io.hpp"
#include "corpus/pairs/pair_json.hpp"

namespace cyl {
namespace {

using json = nlohmann::ordered_json;

/// Returns 16 hexadecimal digits, because some readers of JSON do not keep 64 bits of a number.
std::string hex(std::uint64_t digest) { return fmt::format("{:016x}", digest); }

json method(const GateMethod& m) {
  return {
      {"name", m.name},
      {"version", m.version},
      {"counts", {{"asked", m.counts.asked}, {"declined", m.counts.declined}, {"failed", m.counts.failed}}},
      {"rounded",
       {{"pairs", m.rounded.pairs}, {"wrong", m.rounded.wrong}, {"undecided", m.rounded.undecided}}}};
}

json failure(const JudgedFailure& f) {
  return {{"method", f.method},
          {"law", f.law->number},
          {"kind", f.kind},
          {"what", f.what},
          {"reason", f.reason},
          {"severity", to_string(f.severity)},
          {"phase", to_string(f.phase)},
          {"origin", f.origin},
          {"found", pair_json(f.found)},
          {"simplest", pair_json(f.simplest)},
          {"cause", f.cause},
          {"count", f.count},
          {"excess", number_json(f.excess)},
          {"reruns", f.reruns},
          {"failed_again", f.failed_again},
          {"known", f.known},
          {"in_base", f.in_base}};
}

constexpr std::pair<GatePhase, std::uint64_t GateAmount::*> drawing_phases[]{
    {GatePhase::laws, &GateAmount::law_rounds},
    {GatePhase::sample, &GateAmount::sample_rounds},
    {GatePhase::close_laws, &GateAmount::close_law_rounds},
    {GatePhase::close_sample, &GateAmount::close_rounds},
    {GatePhase::rounded_laws, &GateAmount::rounded_law_rounds},
    {GatePhase::rounded_sample, &GateAmount::rounded_rounds}};

}  // namespace

std::string gate_json(const JudgedGate& gate) {
  json methods = json::array(), failures = json::array(), phases = json::array();
  for (const GateMethod& m : gate.report.methods) methods.push_back(method(m));
  for (const JudgedFailure& f : gate.failures) failures.push_back(failure(f));
  for (const GatePhaseReport& p : gate.report.phases) {
    phases.push_back({{"phase", to_string(p.phase)},
                      {"rounds", p.rounds},
                      {"pairs", p.pairs},
                      {"milliseconds", p.time.count()},
                      {"digest", hex(p.digest)}});
  }
  json laws = json::array(), cases = json::array();
  for (const Law& law : all_laws()) laws.push_back(law.number);
  for (const std::uint64_t digest : gate.report.cases) cases.push_back(hex(digest));
  const json all = {{"seed", gate.report.seed},        {"pairs", gate.report.pairs},
                    {"not_asked", gate.not_asked},     {"laws", std::move(laws)},
                    {"cases", std::move(cases)},       {"methods", std::move(methods)},
                    {"failures", std::move(failures)}, {"phases", std::move(phases)}};
  return all.dump(1, ' ', false, json::error_handler_t::replace) + '\n';
}

GateBase read_base(const std::string& file) {
  const auto refuse = [&](const std::string& wrong) {
    throw InputError(file + ": " + wrong + ": give the file that an earlier gate wrote as JSON");
  };
  const auto natural = [&](const json& in, const char* key) {
    const json& value = in.at(key);
    if (!value.is_number_unsigned()) refuse(std::string("has no whole number as ") + key);
    return value.get<std::uint64_t>();
  };
  std::error_code fault;
  if (!std::filesystem::is_regular_file(file, fault)) refuse("is not a file");
  std::ifstream in(file);
  if (!in) refuse("cannot be opened");
  const json all = json::parse(in, nullptr, false);
  if (in.bad()) refuse("cannot be read");
  if (all.is_discarded()) refuse("is not JSON, or was cut off");
  GateBase base;
  try {
    base.seed = natural(all, "seed");
    for (const json& method : all.at("methods")) base.methods.push_back(method.at("name").get<std::string>());
    all.at("laws").get_to(base.laws);
    all.at("cases").get_to(base.cases);
    std::uint64_t replayed = 0;  // cases that were asked in full
    for (const json& phase : all.at("phases")) {
      const auto is = [&](GatePhase p) { return phase.at("phase") == to_string(p); };
      const std::uint64_t pairs = natural(phase, "pairs");
      if (is(GatePhase::corpus)) replayed = pairs;
      if (is(GatePhase::corpus_laws) && pairs < replayed) base.amount.cases_under_laws = pairs;
      for (const auto& [p, rounds] : drawing_phases) {
        if (!is(p)) continue;
        base.amount.*rounds = natural(phase, "rounds");
        phase.at("digest").get_to(base.digests[p]);
      }
    }
    base.pairs = natural(all, "pairs");
    for (const json& f : all.at("failures")) {
      auto& causes = f.at("severity") == to_string(Severity::resolution) ? base.within : base.causes;
      causes[f.at("cause").get<std::string>()] += natural(f, "count");
    }
  } catch (const json::exception&) {
    refuse("is not a report of the gate of this version");
  }
  return base;
}

void mark_known(JudgedGate& gate, const GateBase& base) {
  for (JudgedFailure& f : gate.failures) {
    if (f.cause.empty()) continue;
    if (const auto before = base.within.find(f.cause); !is_error(f) && before != base.within.end())
      f.in_base = before->second;
    const auto found = base.causes.find(f.cause);
    if (found == base.causes.end()) continue;
    f.in_base = found->second;
    f.known = f.count <= f.in_base || f.failed_again < f.reruns || f.kind == to_string(FindingKind::hang);
  }
}

void note_gaps(JudgedGate& gate, const GateBase& base) {
  const auto miss = [&](const std::string& what) { gate.not_asked.push_back(what + ", which the base has"); };
  for (const std::string& name : base.methods)
    if (std::ranges::count(gate.report.methods, name, &GateMethod::name) == 0) miss("method " + name);
  for (const int number : base.laws)
    if (std::ranges::count(all_laws(), number, &Law::number) == 0) miss(fmt::format("law {}", number));
  std::set<std::string> asked;
  for (const std::uint64_t digest : gate.report.cases) asked.insert(hex(digest));
  const auto missing =
      std::ranges::count_if(base.cases, [&](const std::string& digest) { return !asked.contains(digest); });
  if (missing > 0) miss(fmt::format("{} of {} cases", missing, base.cases.size()));
  for (const GatePhaseReport& phase : gate.report.phases) {
    const auto found = base.digests.find(phase.phase);
    if (found == base.digests.end()) continue;
    const auto rounds =
        std::ranges::find(drawing_phases, phase.phase, [](const auto& p) { return p.first; })->second;
    // If the time ran out before these rounds, that is already reported.
    if (phase.rounds == base.amount.*rounds && found->second != hex(phase.digest))
      miss(fmt::format("{}: the pairs", to_string(phase.phase)));
  }
  std::vector<std::string> gone;
  for (const auto& [cause, pairs] : base.causes)
    if (std::ranges::count(gate.failures, cause, &JudgedFailure::cause) == 0) gone.push_back(cause);
  if (gone.empty() || !gate.not_asked.empty()) return;
  const std::string named = fmt::format("{}", fmt::join(gone, ", "));
  gate.remarks.push_back({fmt::format("{} of the base {} gone: {}", counted(gone.size(), "failure"),
                                      gone.size() == 1 ? "is" : "are", named)});
}

}  // namespace cyl
