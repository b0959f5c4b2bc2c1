// SPDX-License-Identifier: MIT
#include "reports/explain/explain.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/json.hpp"
#include "base/safe_text.hpp"
#include "base/usage_error.hpp"
#include "corpus/pairs/pair_io.hpp"
#include "corpus/pairs/pair_json.hpp"
#include "corpus/pairs/pair_numbers.hpp"
#include "corpus/pairs/truth_io.hpp"

namespace cyl {
namespace {

using json = nlohmann::ordered_json;

/// Describes the answer that was found beyond an end.
std::string beyond_in_words(const Trial& asked, const RegionEnd& end) {
  if (!end.beyond) return "as far as tried";
  const Trial& p = *end.beyond;
  if (p.finding()) return to_string(p.finding()->kind);
  if (!p.decided()) return "truth unproved";
  if (p.answer().status != Status::answered || p.answer().verdict == Verdict::undecided) return "no answer";
  if (p.meets() != asked.meets()) return p.meets() ? "they meet" : "they are apart";
  return "right";
}

/// The region of a parameter, if the explanation has regions.
const FailingRegion& region_of(const Explanation& e, Parameter parameter) {
  return e.regions[static_cast<std::size_t>(parameter)];
}

std::string column_title(Parameter p) {
  return std::string(to_string(p)) + (p == Parameter::angle   ? " (rad)"
                                      : p == Parameter::scale ? " (2^k)"
                                                              : "");
}

/// Returns "calls solids up to 9.9e-07 apart intersecting", ...
std::string failure_in_words(const Explanation& e) {
  switch (e.asked.finding()->kind) {
    case FindingKind::wrong_intersecting:
      return fmt::format("calls solids up to {:.3g} apart {}",
                         region_of(e, Parameter::distance).high.fails_at,
                         to_string(e.asked.answer().verdict));
    case FindingKind::wrong_disjoint: {
      const double depth = -region_of(e, Parameter::distance).low.fails_at;
      return depth > 0 ? fmt::format("calls solids that overlap by up to {:.3g} disjoint", depth)
                       : "calls solids that touch disjoint";
    }
    case FindingKind::distance_outside:
      return fmt::format("returns a distance of {} for solids {}", said_distance(e.asked),
                         distance_in_words(e.asked));
    case FindingKind::bad_witness:
      return fmt::format("returns a witness that proves nothing for solids {}", distance_in_words(e.asked));
    case FindingKind::reported:
      return fmt::format("failed on solids {}: {}", distance_in_words(e.asked), e.asked.answer().reason);
    default:
      return fmt::format("ends in {} on solids {}", to_string(e.asked.finding()->kind),
                         distance_in_words(e.asked));
  }
}

std::string joined(const std::vector<std::string>& words, const char* last) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i)
    text += (i == 0 ? "" : i + 1 == words.size() ? last : ", ") + words[i];
  return text;
}

bool helps(const Explanation& e, Transformation transformation) {
  return std::any_of(e.workarounds.begin(), e.workarounds.end(), [&](const Workaround& w) {
    return w.transformation == transformation && w.outcome == WorkaroundOutcome::right;
  });
}

/// Returns the cause that triage finds, and other changes that cure the failure.
std::vector<std::string> causes(const Explanation& e) {
  using enum Mechanism;
  std::vector<std::string> found;
  const Mechanism m = e.cause.mechanism;
  if (m != gone && m != setting && m != unclassified) {
    const std::string scale = scale_in_words(e.cause, e.asked);
    found.push_back(std::string(in_words(m)) + (scale.empty() ? "" : " (" + scale + ')'));
  }
  std::vector<std::string> settings;
  for (const Workaround& w : e.workarounds)
    if (w.transformation == Transformation::setting && w.outcome == WorkaroundOutcome::right)
      settings.push_back(w.method);
  if (!settings.empty())
    found.push_back(fmt::format("its setting ({} {} right)", joined(settings, " and "),
                                settings.size() == 1 ? "is" : "are"));
  if (e.regions.empty() && helps(e, Transformation::rescaled)) found.push_back("the scale (right at size 1)");
  if (m != offset && helps(e, Transformation::at_origin))
    found.push_back("the position (right at the origin)");
  if (helps(e, Transformation::unit_axes)) found.push_back("the lengths of the axes (right with unit axes)");
  if (helps(e, Transformation::exchanged)) found.push_back("the order (right with the solids exchanged)");
  return found;
}

/// Returns the parameters along which the failure continues on both sides as far as was tried.
std::vector<std::string> indifferent(const Explanation& e) {
  std::vector<std::string> found;
  for (const FailingRegion& r : e.regions)
    if (!r.low.ends_at && !r.high.ends_at && r.low.fails_at < r.high.fails_at)
      found.emplace_back(to_string(r.parameter));
  return found;
}

/// Whether the method itself ends the failure there, and not the truth or a refusal to answer.
bool method_ends_it(const Trial& asked, const RegionEnd& end) {
  return end.beyond && end.beyond->decided() && end.beyond->answer().status != Status::declined &&
         end.beyond->meets() == asked.meets();
}

/// A parameter that the failure depends on: its region, and which of the ends the method sets.
struct Condition {
  const FailingRegion* region;
  bool low, high;
};

std::vector<Condition> conditions(const Explanation& e) {
  std::vector<Condition> found;
  for (const FailingRegion& r : e.regions) {
    if (r.parameter == Parameter::distance || r.parameter == Parameter::scale) continue;
    // Far from the origin, the rounding of the centres changes the pair.
    const bool low = method_ends_it(e.asked, r.low),
               high = r.parameter != Parameter::offset && method_ends_it(e.asked, r.high);
    if (low || high) found.push_back({&r, low, high});
  }
  return found;
}

/// Returns "angle 0.0093 to 0.045", "height of a from 0.3".
std::vector<std::string> in_words(const std::vector<Condition>& all) {
  std::vector<std::string> words;
  for (const auto& [r, low, high] : all)
    words.push_back(low && high ? fmt::format("{} {:.3g} to {:.3g}", to_string(r->parameter), r->low.fails_at,
                                              r->high.fails_at)
                    : high && r->high.fails_at == 0
                        ? fmt::format("{} 0", to_string(r->parameter))
                        : fmt::format("{} {} {:.3g}", to_string(r->parameter), low ? "from" : "up to",
                                      low ? r->low.fails_at : r->high.fails_at));
  return words;
}

/// Returns the ranges from which pairs are drawn. An end that the method does not set is at most this factor
/// from the pair.
std::vector<ParameterRange> ranges(const std::vector<Condition>& all) {
  constexpr double near = 16;
  std::vector<ParameterRange> found;
  for (const auto& [r, low, high] : all) {
    ParameterRange range{r->parameter, r->low.fails_at, r->high.fails_at};
    if (!low) range.low = std::max(range.low, r->at / near);
    if (!high) range.high = std::min(range.high, r->at * near);
    found.push_back(range);
  }
  return found;
}

std::string mechanism(const Explanation& e) {
  std::string text = fmt::format("{} {}.", e.method, failure_in_words(e));
  const std::vector<std::string> found = causes(e);
  text += found.empty() ? " No other setting, scale, position, order or axis length makes it right."
                        : " Cause: " + joined(found, "; and ") + ".";
  if (const auto only = in_words(conditions(e)); !only.empty())
    text += " It fails only with " + joined(only, " and ") + ".";
  if (const auto rest = indifferent(e); !rest.empty())
    text += fmt::format(" The {} {} not matter.", joined(rest, " and "), rest.size() == 1 ? "does" : "do");
  return text;
}

std::string number(double x) { return x == 0 ? "0" : fmt::format("{:.4g}", x); }

std::string regions_table(const Explanation& e) {
  constexpr const char* row = "{:<16} {:>11} {:>11} {:>11}   {:<18} {}\n";
  std::string text = fmt::format(fmt::runtime(row), "fails along", "from", "here", "to", "below", "above");
  for (const FailingRegion& r : e.regions)
    text += fmt::format(fmt::runtime(row), column_title(r.parameter), number(r.low.fails_at), number(r.at),
                        number(r.high.fails_at), beyond_in_words(e.asked, r.low),
                        beyond_in_words(e.asked, r.high));
  return text;
}

/// If verdicts are wrong, the table marks the decades that the method's claim allows.
std::string curve_table(const Explanation& e) {
  const CalibrationCurve& c = *e.curve;
  const double size = size_of(e.asked.pair);
  const double claimed = is_refuted_verdict(e.asked.finding()->kind) ? reach(e.claim, size) / size : 0;
  const auto only = in_words(conditions(e));
  std::string text = fmt::format(
      "\nshare of similar failures among random {} pairs of the same size{} (seed {}), with exact 95 % "
      "bounds\n"
      "{:<8} {:>9} {:>9} {:>9}   {}\n",
      to_string(c.feature), only.empty() ? "" : " with " + joined(only, " and "), c.seed, "margin", "trials",
      "fail", "share", "bounds");
  for (const CalibrationPoint& p : c.points) {
    if (p.trials == 0) continue;
    text +=
        fmt::format("1e-{:02}    {:>9} {:>9} {:>9.3g}   {:.2g} to {:.2g}{}\n", p.decade, p.trials, p.failures,
                    static_cast<double>(p.failures) / static_cast<double>(p.trials), p.rate.lower,
                    p.rate.upper, std::pow(10, -p.decade) <= claimed ? ", within its claim" : "");
  }
  return text;
}

std::string said_in_words(const MethodAnswer& answer) {
  if (answer.status != Status::answered) return one_line(answer.reason);
  return to_string(answer.verdict) +
         (answer.has_distance ? fmt::format(", distance {:.6g}", answer.distance) : "");
}

std::string workarounds_table(const Explanation& e) {
  std::string text = "\n";
  for (const Workaround& w : e.workarounds) {
    const std::string what =
        w.transformation == Transformation::setting ? w.method : std::string(to_string(w.transformation));
    text += fmt::format("{:<30} {:<18}", what, to_string(w.outcome));
    if (w.outcome != WorkaroundOutcome::no_change)
      text += fmt::format(" {} for solids {}", said_in_words(w.after.answer()), distance_in_words(w.after));
    text += '\n';
  }
  return text;
}

json trial_json(const Trial& p) {
  json object{{"pair", pair_to_json(p.pair)},
              {"truth", truth_to_json(p.truth, p.decided() ? &p.distance : nullptr)},
              {"answer", answer_to_json(p.answer())}};
  object["finding"] = p.finding() ? json(to_string(p.finding()->kind)) : json(nullptr);
  return object;
}

json end_json(const RegionEnd& end) {
  return {{"fails_at", number_json(end.fails_at)},
          {"failing", trial_json(end.failing)},
          {"ends_at", end.ends_at ? number_json(*end.ends_at) : json(nullptr)},
          {"beyond", end.beyond ? trial_json(*end.beyond) : json(nullptr)}};
}

json curve_json(const CalibrationCurve& c, const std::vector<ParameterRange>& within) {
  json drawn_within = json::array();
  for (const ParameterRange& r : within)
    drawn_within.push_back({{"parameter", to_string(r.parameter)}, {"low", r.low}, {"high", r.high}});
  json bins = json::array();
  for (const CalibrationPoint& p : c.points)
    bins.push_back({{"decade", p.decade},
                    {"drawn", p.drawn},
                    {"trials", p.trials},
                    {"failures", p.failures},
                    {"lower", p.rate.lower},
                    {"upper", p.rate.upper}});
  return {{"feature", to_string(c.feature)},
          {"seed", c.seed},
          {"scaled_by_exponent", c.exponent},
          {"within", std::move(drawn_within)},
          {"bins", std::move(bins)}};
}

}  // namespace

Explanation explain(std::span<const std::unique_ptr<Method>> methods, std::string_view name, FindingKind kind,
                    const Pair& pair, std::uint64_t seed) {
  const auto& method = find_method(methods, name);
  Explanation e{std::string(name), method->claim(), try_method(method, pair), {}, {}, {}, {}, {}};
  if (kind == FindingKind::state_dependent)
    throw UsageError(
        fmt::format("{} fails in this way only after other pairs, not on this pair alone", name));
  if (!e.asked.fails(kind))
    throw UsageError(fmt::format("{} has no {} on this pair now: it answers {}", name, to_string(kind),
                                 format_method_answer(e.asked.answer())));
  if (kind != FindingKind::hang) {
    const auto index = static_cast<std::size_t>(&method - methods.data());
    e.cause = classify_closely(methods, {index, kind, pair}, probe_caps);
    e.regions = failing_regions(method, e.asked);
    e.curve = calibration_curve(method, e.asked, seed, ranges(conditions(e)));
  }
  e.workarounds = try_workarounds(methods, method, e.asked);
  e.mechanism = mechanism(e);
  return e;
}

std::string explanation_text(const Explanation& e) {
  std::string text = fmt::format("{} answers {} for solids {}: {} ({})\n{}\n", e.method,
                                 one_line(format_method_answer(e.asked.answer())), distance_in_words(e.asked),
                                 to_string(e.asked.finding()->kind), in_words(e.asked.finding()->severity),
                                 format_pair(e.asked.pair));
  if (!e.regions.empty()) text += '\n' + regions_table(e);
  if (e.curve) text += curve_table(e);
  return text + workarounds_table(e) + "\n" + e.mechanism + "\n";
}

std::string explanation_json(const Explanation& e) {
  json regions = json::array(), workarounds = json::array();
  for (const FailingRegion& r : e.regions)
    regions.push_back({{"parameter", to_string(r.parameter)},
                       {"at", number_json(r.at)},
                       {"low", end_json(r.low)},
                       {"high", end_json(r.high)}});
  for (const Workaround& w : e.workarounds)
    workarounds.push_back(
        {{"remedy", to_string(w.transformation)},
         {"method", w.method},
         {"effect", to_string(w.outcome)},
         {"after", w.outcome == WorkaroundOutcome::no_change ? json(nullptr) : trial_json(w.after)}});
  const json all{{"method", e.method},
                 {"claim", {{"relative", e.claim.relative}, {"absolute", e.claim.absolute}}},
                 {"kind", to_string(e.asked.finding()->kind)},
                 {"severity", to_string(e.asked.finding()->severity)},
                 {"asked", trial_json(e.asked)},
                 {"regions", std::move(regions)},
                 {"curve", e.curve ? curve_json(*e.curve, ranges(conditions(e))) : json(nullptr)},
                 {"cures", std::move(workarounds)},
                 {"mechanism", e.mechanism}};
  return all.dump(1, ' ', false, json::error_handler_t::replace) + '\n';
}

}  // namespace cyl
