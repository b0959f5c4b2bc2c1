// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "base/usage_error.hpp"
#include "corpus/pairs/pair_io.hpp"
#include "corpus/store/run_facts.hpp"
#include "corpus/store/stored_answers.hpp"
#include "oracles/methods/guest_protocol.hpp"
#include "oracles/trial/trial.hpp"
#include "reports/triage/causes.hpp"
#include "reports/triage/group_findings.hpp"
#include "reports/triage/triage_context.hpp"

namespace cyl {
namespace {

using Json = nlohmann::json;

[[noreturn]] void refuse(const FindingRecord& f, const std::string& why) {
  throw InputError(fmt::format("finding {} of the run ({} {}) {}: it is damaged or forged", f.id, f.method,
                               to_string(f.kind), why));
}

/// Returns a stored answer, or nothing if none can be read. The store does not have error bounds and side
/// effects. Numbers that are not finite are stored as texts.
std::optional<MethodAnswer> answer_of(const Json& stored) {
  if (const auto failed = stored.find("failed"); failed != stored.end() && failed->is_string())
    return failed_answer(from_word<Failure>(failed->get<std::string>()).value_or(Failure::crash), "");
  const GuestLine line = parse_guest_line(stored.dump());
  if (line.answer) return method_answer(*line.answer, false);
  if (!stored.contains("verdict")) return {};
  return failed_answer(Failure::non_finite, "");
}

/// Judges a pair and the stored answer of its finding again, as the campaign did.
class JudgedAgain {
 public:
  explicit JudgedAgain(const FindingRecord& f) : f_(f), line_(parse_case(f.pair, 1).value.value()) {
    std::vector<MethodAnswer> offered;
    for_each_answer(Json::parse(f.answers, nullptr, false), [&](const Json& stored, const auto& methods) {
      const auto answer = answer_of(stored);
      if (!answer) return;
      offered.push_back(*answer);
      if (std::ranges::count(methods, f.method) > 0) answer_ = answer;
    });
    trial_ = Trial(line_.pair, WitnessSet({}).with_own_witness(line_.pair, offered));
  }

  /// Returns what the store should state, or nothing if the answer is right or missing.
  std::optional<Finding> finding(const Claim& claim) {
    const bool of_case = f_.method == corpus_row;
    if (of_case) return line_.truth ? compare_statement(trial_, *line_.truth) : std::nullopt;
    if (f_.method == referee_row) return Finding{FindingKind::undecided_truth, Severity::unresolved, {}};
    if (!answer_) return {};
    if (f_.kind == FindingKind::nondeterminism) return Finding{f_.kind, Severity::contract, {}};
    if (f_.kind == FindingKind::side_effect)  // the margin is that of the pair, as for a failure
      return Finding{f_.kind, f_.severity, compare(trial_, claim, failed_answer(Failure::crash, ""))->margin};
    std::optional<Finding> found = compare(trial_, claim, *answer_);
    if (found && f_.kind == FindingKind::state_dependent) found->kind = f_.kind;
    return found;
  }

 private:
  const FindingRecord& f_;
  Case line_;
  std::optional<MethodAnswer> answer_;
  Trial trial_;
};

void check(const FindingRecord& f, std::span<const MethodRecord> asked, bool own) {
  if (f.margin && !(f.margin->lo >= 0 && f.margin->lo <= f.margin->hi)) refuse(f, "has no such margin");
  // The store does not have the error bounds and exact witnesses of our own methods.
  if (own && (f.kind == FindingKind::distance_outside || f.kind == FindingKind::bad_witness)) return;
  Claim claim;
  const auto method = std::ranges::find(asked, f.method, &MethodRecord::name);
  if (method != asked.end()) claim = {method->relative, method->absolute, {}};
  claim.decides = DecisionScope::all;  // "undecided" is a finding only if the method promised to decide
  const std::optional<Finding> now = JudgedAgain(f).finding(claim);
  if (!now) refuse(f, "is refuted: its stored answer is right, or missing");
  if (now->kind != f.kind || now->severity != f.severity)
    refuse(f, fmt::format("is {}, but its stored answer is {} ({})", in_words(f.severity),
                          to_string(now->kind), in_words(now->severity)));
  const bool both = now->margin && f.margin;
  if (now->margin.has_value() != f.margin.has_value() ||
      (both && (f.margin->lo > now->margin->hi || now->margin->lo > f.margin->hi)))
    refuse(f, fmt::format("states another margin than the {:.3g} of its stored answer",
                          now->margin ? now->margin->lo : 0));
}

}  // namespace

void check_shown_findings(const TriageContext& context, std::span<const MethodRecord> asked,
                          std::span<const Cause> causes) {
  for (const MethodRecord& m : asked) {
    const auto here = position_of(context.methods, m.name);
    if (!here || context.methods[*here]->version() != m.version) continue;
    const Claim claim = context.methods[*here]->claim();
    if (claim.relative != m.relative || claim.absolute != m.absolute)
      throw InputError(fmt::format(
          "the run states another claim of {} {} than this build: use the build that made the run", m.name,
          m.version));
  }
  for (const Cause& b : causes) {
    const FindingRecord *worst = nullptr, *least = nullptr, *gravest = nullptr;
    for (const std::int64_t id : b.findings) {
      const auto found = context.by_id.find(id);
      if (found == context.by_id.end()) continue;
      const FindingRecord& f = *found->second->record;
      if (gravest == nullptr && f.severity == b.severity) gravest = &f;
      if (f.kind != b.kind || !f.margin) continue;
      if (worst == nullptr || least_margin(f) > least_margin(*worst)) worst = &f;
      if (least == nullptr || least_margin(f) < least_margin(*least)) least = &f;
    }
    for (const FindingRecord* f : std::set{worst, least, gravest}) {
      if (f == nullptr) continue;
      const auto here = position_of(context.methods, f->method);
      check(*f, asked, here && !context.methods[*here]->foreign());
    }
  }
}

}  // namespace cyl
