// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <vector>

#include "base/safe_text.hpp"
#include "base/statistics.hpp"
#include "corpus/pairs/pair_io.hpp"
#include "reports/gate/failure_text.hpp"
#include "reports/gate/gate_writers.hpp"

namespace cyl {
namespace {

// A line breaks only between words.
constexpr std::size_t line_width = 100;

/// Breaks `text` into lines. Later lines are indented to the first word of `text`, by two columns at least.
std::string wrapped(const std::string& first, const std::string& text) {
  const std::size_t indent = std::max<std::size_t>(first.size(), 2);
  std::string lines = first;
  std::size_t column = first.size();
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find(' ', begin), text.size());
    if (begin > 0 && column + 1 + (end - begin) > line_width) {
      lines += '\n' + std::string(indent, ' ');
      column = indent;
    } else if (begin > 0) {
      lines += ' ';
      ++column;
    }
    lines += text.substr(begin, end - begin);
    column += end - begin;
    begin = end + 1;
  }
  return lines + '\n';
}

std::string claim_in_words(const Claim& claim) {
  std::string words = "claims to be right on every pair";
  if (claim.relative != 0 || claim.absolute != 0) {
    words = "claims to be right if |distance| is at least ";
    if (claim.relative != 0) words += format_double(claim.relative) + " of the size";
    if (claim.relative != 0 && claim.absolute != 0) words += " plus ";
    if (claim.absolute != 0) words += "a length of " + format_double(claim.absolute);
  }
  if (!claim.source.empty()) words += fmt::format(" ({})", one_line(claim.source));
  return words;
}

std::string methods_table(const JudgedGate& gate) {
  constexpr const char* row = "{:<28} {:<16} {:>15} {:>11} {:>11} {:>9}\n";
  std::string text =
      fmt::format(fmt::runtime(row), "method", "version", "asked", "declined", "undecided", "failed");
  for (const GateMethod& m : gate.report.methods) {
    const auto undecided = m.counts.said[static_cast<std::size_t>(Verdict::undecided)];
    text += fmt::format(fmt::runtime(row), one_line(m.name), one_line(m.version), grouped(m.counts.asked),
                        grouped(m.counts.declined), grouped(undecided), grouped(m.counts.failed));
    text += wrapped("  ", claim_in_words(m.claim));
    if (!m.remark.empty()) text += wrapped("  ", one_line(m.remark));
  }
  return text;
}

std::string in_full(std::size_t number, const Alike& alike) {
  const JudgedFailure& first = *alike.front();
  const FailureView f = view_of(alike);
  const auto line = [](const char* title, const std::string& words) {
    return fmt::format("   {:<11}{}\n", title, words);
  };
  const auto grown = [](const JudgedFailure& g) {
    return g.in_base == 0 ? "" : fmt::format(", {} in the base", grouped(g.in_base));
  };
  std::string text =
      wrapped(fmt::format("{}. ", number), fmt::format("{} breaks {} on {}{}: {}", f.method, f.law, f.pairs,
                                                       alike.size() == 1 ? grown(first) : "", f.what));
  text += wrapped(fmt::format("   {:<11}", "law"), std::string(first.law->statement));
  text += line("origin", fmt::format("{} ({})", f.origin, to_string(first.phase)));
  text += line("cause", f.cause);
  if (!f.again.empty()) text += line("again", f.again);
  text += line("found", f.found);
  text += line("simplest", f.simplest == f.found ? "no simpler pair was found" : f.simplest);
  text += line("replay", f.replay);
  for (const JudgedFailure* g : std::span(alike).subspan(1, std::min(also_cap, alike.size() - 1))) {
    text += line("also", fmt::format("{}, {}{}", one_line(g->cause), counted(g->count, "pair"), grown(*g)));
    text += line("", format_pair(g->simplest));
  }
  if (alike.size() - 1 > also_cap)
    text += line(
        "", fmt::format("{}, which --json FILE lists", counted(alike.size() - 1 - also_cap, "more cause")));
  return text;
}

std::string failures_text(const JudgedGate& gate) {
  const std::vector<Alike> failing = alike_failures(gate, true), others = alike_failures(gate, false);
  const int code = exit_code(gate);
  const char* nothing = !gate.not_asked.empty()  ? "Nothing that was asked fails the gate.\n"
                        : code == exit_undecided ? "Nothing fails the gate, but something is undecided.\n"
                                                 : "Nothing fails the gate.\n";
  std::string text =
      failing.empty() ? nothing : fmt::format("Fails the gate ({}):\n", grouped(failing.size()));
  for (std::size_t i = 0; i < failing.size(); ++i) text += in_full(i + 1, failing[i]);
  if (!others.empty())
    text += fmt::format("\n{} ({}):\n", "Does not fail the gate: known, or within the claim",
                        grouped(others.size()));
  for (std::size_t i = 0; i < std::min(brief_cap, others.size()); ++i) {
    const FailureView f = view_of(others[i]);
    const std::string causes =
        others[i].size() == 1 ? f.cause : fmt::format("{} and {} more", f.cause, others[i].size() - 1);
    text += wrapped("  ", fmt::format("{}: {}, {}, {}: {}{}", f.method, f.law, f.pairs, causes, f.what,
                                      others[i].front()->known ? " (known)" : ""));
  }
  if (others.size() > brief_cap) text += fmt::format("  and {} more\n", grouped(others.size() - brief_cap));
  return text;
}

std::string rate(double bound) { return fmt::format("<= {:.1e}", bound); }

/// A bound from here on states nothing.
constexpr double vain_bound = 0.5;

/// Returns "wrong beyond its claim on 3 of 70". If none is wrong, returns `right` and the number.
std::string success(std::uint64_t pairs, std::uint64_t wrong, const std::string& right) {
  return wrong == 0 ? fmt::format("{} {}", right, grouped(pairs))
                    : fmt::format("wrong beyond its claim on {} of {}", grouped(wrong), grouped(pairs));
}
constexpr const char* none_beyond = "never wrong beyond its claim on";

/// Lines on what one sample shows about the combinations that a method claims.
struct Sample {
  std::uint64_t pairs = 0, wrong = 0, undecided = 0;
  std::uint64_t combinations = 0, empty = 0;  ///< those with decided pairs, and those without
  double worst = 0;                           ///< the largest bound of the error rate in a combination
  bool few = false;  ///< whether the pairs of a combination would prove nothing even if all were right

  /// `bound_if_right` is the bound if no pair of the cell were wrong.
  void add(std::uint64_t in_cell, std::uint64_t wrong_in_cell, std::uint64_t undecided_in_cell, double bound,
           double bound_if_right) {
    undecided += undecided_in_cell;
    ++(in_cell == 0 ? empty : combinations);
    if (in_cell == 0) return;
    pairs += in_cell;
    wrong += wrong_in_cell;
    worst = std::max(worst, bound);
    few |= bound_if_right >= vain_bound;
  }

  std::string rate_in_each(const char* of) const {
    return few ? fmt::format("unknown in some combinations of {}, which have too few pairs", of)
               : fmt::format("{} in each of {} of {}", rate(worst), counted(combinations, "combination"), of);
  }

  /// Returns the lines below the first one.
  std::string facts(const std::string& rates) const {
    std::string text;
    if (pairs > 0) text += wrapped("  ", fmt::format("The error rate is {}, at 95 % confidence.", rates));
    if (undecided > 0) text += wrapped("  ", fmt::format("It is undecided on {} more.", grouped(undecided)));
    if (pairs > 0 && empty > 0)
      text += wrapped("  ", fmt::format("No pair was decided in {}.", counted(empty, "combination")));
    return text;
  }
};

/// Returns what close contacts prove about the claimed cells. Empty if the method was asked about none.
std::string close_in_words(const GateMethod& method) {
  Sample sample;
  // Gaps and overlaps are two questions with one bound each. The worse one counts.
  for (const CloseGateCell& c : method.close_cells)
    if (c.claimed)
      sample.add(
          c.gaps + c.overlaps, c.wrong_gaps + c.wrong_overlaps, c.undecided,
          std::max(error_rate_bound(c.gaps, c.wrong_gaps), error_rate_bound(c.overlaps, c.wrong_overlaps)),
          std::max(error_rate_bound(c.gaps, 0), error_rate_bound(c.overlaps, 0)));
  const std::string name = one_line(method.name);
  const VerdictCount all = close_contacts_of(method);
  sample.undecided = all.undecided;
  if (all.pairs == 0)
    return all.undecided == 0 ? "" : wrapped("", name + " is undecided on all close contacts.");
  return wrapped("", fmt::format("The verdict of {} is {} close contacts.", name,
                                 success(all.pairs, all.wrong, none_beyond))) +
         sample.facts(sample.rate_in_each("axis position, angle and margin, for gaps and for overlaps"));
}

std::string rounded_in_words(const GateMethod& method) {
  const VerdictCount& count = method.rounded;
  if (count.pairs + count.undecided == 0) return {};
  const std::string name = one_line(method.name);
  if (count.pairs == 0) return wrapped("", name + " is undecided on all rounded solids.");
  const std::string text = wrapped(
      "", fmt::format(
              "The verdict of {} is {} with a sphere, capsule, rounded cylinder, half-space or box.", name,
              success(count.pairs, count.wrong, none_beyond) + (count.pairs == 1 ? " pair" : " pairs")));
  Sample sample;
  for (const VerdictCount& c : method.by_kinds)
    if (c.pairs > 0)
      sample.add(c.pairs, c.wrong, 0, error_rate_bound(c.pairs, c.wrong), error_rate_bound(c.pairs, 0));
  sample.undecided = count.undecided;
  return text +
         sample.facts(fmt::format("{} overall and {}", rate(error_rate_bound(count.pairs, count.wrong)),
                                  sample.rate_in_each("shapes")));
}

/// Returns what the random sample of all strata proves about the cells that the method claims.
std::string strata_in_words(const GateMethod& method) {
  Sample sample;
  for (const GateCell& c : method.cells)
    if (c.claimed)
      sample.add(c.pairs, c.wrong, c.undecided, error_rate_bound(c.pairs, c.wrong),
                 error_rate_bound(c.pairs, 0));
  const std::string name = one_line(method.name);
  const std::string first =
      sample.pairs > 0
          ? fmt::format("The verdict of {} is {} independent random pairs whose margin exceeds its claim.",
                        name, success(sample.pairs, sample.wrong, "right on all"))
          : fmt::format("Nothing is proved of {}: it decided no random pair whose margin exceeds its claim.",
                        name);
  return wrapped("", first) +
         sample.facts(fmt::format("{} overall and {}", rate(error_rate_bound(sample.pairs, sample.wrong)),
                                  sample.rate_in_each("contact feature and decade of margin")));
}

}  // namespace

std::string proved_in_words(const GateMethod& method) {
  const bool only_rounded =
      method.rounded.pairs > 0 &&
      std::ranges::none_of(method.cells, [](const GateCell& c) { return c.claimed && c.pairs > 0; });
  return (only_rounded ? "" : strata_in_words(method)) + close_in_words(method) + rounded_in_words(method);
}

std::string gate_text(const JudgedGate& gate) {
  std::string text;
  for (const GatePhaseReport& p : gate.report.phases) {
    text += fmt::format("{:<24} {:>18} {:>9}.{} s\n", to_string(p.phase), counted(p.pairs, "pair"),
                        p.time.count() / 1000, p.time.count() % 1000 / 100);
  }
  std::uint64_t drawn = 0;
  for (const GatePhaseReport& p : gate.report.phases) drawn += p.rounds > 0 ? p.pairs : 0;
  text += fmt::format("Whole rounds drew {}, for --pairs {}.\n", counted(drawn, "pair"), gate.report.pairs);
  for (const std::string& line : gate.not_asked) text += wrapped("NOT ASKED: ", one_line(line));
  text += '\n' + methods_table(gate) + '\n' + failures_text(gate) + '\n';
  for (const GateMethod& m : gate.report.methods) text += proved_in_words(m);
  for (const GateRemark& r : gate.remarks) text += wrapped("", one_line(r.text) + '.');
  return text;
}

}  // namespace cyl
