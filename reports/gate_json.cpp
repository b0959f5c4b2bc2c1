// SPDX-License-Identifier: MIT
#include "reports/gate_json.hpp"

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "corpus/pair_io.hpp"

namespace cyl {
namespace {

using json = nlohmann::ordered_json;

json number(double x) { return std::isfinite(x) ? json(x) : json(format_double(x)); }

json vector(const Vector3& v) { return {number(v[0]), number(v[1]), number(v[2])}; }

json cylinder(const Cylinder& c) {
  return {{"center", vector(c.center)},
          {"axis", vector(c.axis)},
          {"radius", number(c.radius)},
          {"height", number(c.height)}};
}

json pair(const Pair& p) { return {{"a", cylinder(p.a)}, {"b", cylinder(p.b)}}; }

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
           {{"relative", number(m.claim.relative)},
            {"absolute", number(m.claim.absolute)},
            {"source", m.claim.source}}},
          {"counts", counts(m.counts)},
          {"cells", std::move(cells)},
          {"remark", m.remark}};
}

json failure(const GateFailure& f) {
  return {{"method", f.method},
          {"law", f.law->number},
          {"name", f.law->name},
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
          {"known", f.known}};
}

}  // namespace

std::string gate_json(const GateReport& report) {
  json methods = json::array(), failures = json::array(), phases = json::array();
  for (const GateMethod& m : report.methods) methods.push_back(method(m));
  for (const GateFailure& f : report.failures) failures.push_back(failure(f));
  for (const GatePhaseReport& p : report.phases) {
    phases.push_back({{"phase", to_string(p.phase)}, {"pairs", p.pairs}, {"milliseconds", p.time.count()}});
  }
  const json all = {{"seed", report.seed},
                    {"methods", std::move(methods)},
                    {"failures", std::move(failures)},
                    {"phases", std::move(phases)},
                    {"undecided_truths", report.undecided_truths},
                    {"drawn", report.drawn}};
  return all.dump(1, ' ', false, json::error_handler_t::replace) + '\n';
}

std::set<std::string> read_buckets(const std::string& file) {
  const auto refuse = [&](const std::string& wrong) {
    throw std::runtime_error(file + ": " + wrong + "; give the file that an earlier gate wrote as JSON");
  };
  std::ifstream in(file);
  if (!in) refuse("cannot be opened");
  const json all = json::parse(in, nullptr, false);
  if (in.bad()) refuse("cannot be read");
  if (all.is_discarded()) refuse("is no JSON, or was cut off");
  const auto failures = all.is_object() ? all.find("failures") : all.end();
  if (!all.is_object() || failures == all.end() || !failures->is_array())
    refuse("has no list 'failures' and so is no report of the gate");
  std::set<std::string> buckets;
  for (const json& f : *failures) {
    if (!f.is_object() || !f.contains("bucket") || !f["bucket"].is_string())
      refuse("holds a failure without a bucket");
    // What the base breaks within its claims excuses nothing.
    if (f.contains("severity") && f["severity"] == to_string(Severity::resolution)) continue;
    buckets.insert(f["bucket"].get<std::string>());
  }
  return buckets;
}

void mark_known(GateReport& report, const std::set<std::string>& base) {
  for (GateFailure& f : report.failures) f.known = !f.bucket.empty() && base.contains(f.bucket);
}

}  // namespace cyl
