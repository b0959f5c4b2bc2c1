// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "base/json.hpp"
#include "base/safe_text.hpp"
#include "reports/gate/failure_text.hpp"
#include "reports/gate/gate_writers.hpp"

namespace cyl {
namespace {

using json = nlohmann::ordered_json;

std::string rule_id(const Law& law) { return fmt::format("law-{}", law.number); }

json text(const std::string& words) { return {{"text", words}}; }

json rule(const Law& law) {
  return {{"id", rule_id(law)},
          {"name", law.name},
          {"shortDescription", text(law_title(law))},
          {"help", text(fmt::format("{}. Scope: {}.", law.statement, law.where))}};
}

/// Returns the path of a URI (RFC 3986). Unreserved characters and '/' stay, all others are percent-encoded.
std::string uri_path(std::string_view path) {
  std::string uri;
  for (const char c : path) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                       std::string_view("-._~/").find(c) != std::string_view::npos;
    if (plain) {
      uri += c;
    } else {
      uri += fmt::format("%{:02X}", static_cast<unsigned>(static_cast<unsigned char>(c)));
    }
  }
  return uri;
}

json location(const SourceLine& place) {
  json artifact;
  if (place.file.starts_with('/')) {
    artifact["uri"] = "file://" + uri_path(place.file);
  } else {
    artifact["uri"] = uri_path(place.file);
    artifact["uriBaseId"] = "%SRCROOT%";
  }
  return {{"physicalLocation", {{"artifactLocation", artifact}, {"region", {{"startLine", place.line}}}}}};
}

json result(const JudgedFailure& f, bool compared) {
  const FailureView view = view_of(f);
  std::string message = fmt::format("{} breaks {}: {}. {}, the first: {}.", view.method, view.law, view.what,
                                    view.pairs, view.origin);
  if (!view.again.empty()) message += " It " + view.again + '.';
  json r = {{"ruleId", rule_id(*f.law)},
            {"level", is_error(f) ? "error" : "note"},
            {"message", text(message)},
            {"locations", view.place ? json::array({location(*view.place)}) : json::array()}};
  if (f.suppressed)
    r["suppressions"] = json::array({{{"kind", "external"}, {"justification", one_line(*f.suppressed)}}});
  if (!f.bucket.empty()) r["partialFingerprints"] = {{"bucket/v1", f.bucket}};
  if (compared) r["baselineState"] = f.known || (!is_error(f) && f.in_base > 0) ? "unchanged" : "new";
  r["properties"] = {
      {"method", f.method},  {"severity", to_string(f.severity)}, {"origin", view.origin}, {"count", f.count},
      {"found", view.found}, {"simplest", view.simplest},         {"replay", view.replay}};
  if (!f.reproduce.empty()) r["properties"]["reproduce"] = f.reproduce;
  return r;
}

}  // namespace

std::string gate_sarif(const JudgedGate& gate, std::string_view version, bool compared) {
  json rules = json::array(), results = json::array(), versions = json::object();
  for (const Law& law : all_laws()) rules.push_back(rule(law));
  for (const JudgedFailure& f : gate.failures) results.push_back(result(f, compared));
  for (const GateMethod& m : gate.report.methods) versions[valid_utf8(m.name)] = m.version;
  const json driver = {{"name", "daylight"}, {"version", version}, {"rules", std::move(rules)}};
  json notifications = json::array();
  for (const std::string& line : gate.not_asked)
    notifications.push_back({{"level", "error"}, {"message", text("Not asked: " + one_line(line))}});
  for (const GateRemark& r : gate.remarks)
    notifications.push_back(
        {{"level", r.exit_code == exit_findings ? "error" : "warning"}, {"message", text(one_line(r.text))}});
  const json invocation = {{"executionSuccessful", gate.not_asked.empty()},
                           {"toolExecutionNotifications", std::move(notifications)}};
  const json run = {
      {"tool", {{"driver", driver}}},
      {"invocations", json::array({invocation})},
      {"results", std::move(results)},
      {"properties",
       {{"seed", gate.report.seed}, {"pairs", gate.report.pairs}, {"versions", std::move(versions)}}}};
  const json log = {{"$schema", "https://json.schemastore.org/sarif-2.1.0.json"},
                    {"version", "2.1.0"},
                    {"runs", json::array({run})}};
  return log.dump(1, ' ', false, json::error_handler_t::replace) + '\n';
}

}  // namespace cyl
