// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <set>
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

/// Returns 10^-decade in the form that origins have, such as 1e-09. Decade 0 becomes 1.
std::string power(int decade) {
  return decade == 0 ? "1" : fmt::format("1e{}{:02}", decade < 0 ? '+' : '-', std::abs(decade));
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
  text += line("bucket", f.bucket);
  if (!f.again.empty()) text += line("again", f.again);
  text += line("found", f.found);
  text += line("simplest", f.simplest == f.found ? "no simpler pair was found" : f.simplest);
  text += line("replay", f.replay);
  for (const JudgedFailure* g : std::span(alike).subspan(1, std::min(also_cap, alike.size() - 1))) {
    text += line("also", fmt::format("{}, {}{}", one_line(g->bucket), counted(g->count, "pair"), grown(*g)));
    text += line("", format_pair(g->simplest));
  }
  if (alike.size() - 1 > also_cap)
    text += line("", fmt::format("{} more buckets, which --json FILE lists", alike.size() - 1 - also_cap));
  return text;
}

std::string failures_text(const JudgedGate& gate) {
  const std::vector<Alike> failing = alike_failures(gate, true), others = alike_failures(gate, false);
  const int code = exit_code(gate);
  const char* nothing = code == exit_findings     ? "No method fails the gate, but a suppression does.\n"
                        : !gate.not_asked.empty() ? "Nothing that was asked fails the gate.\n"
                        : code == exit_undecided  ? "Nothing fails the gate, but something is undecided.\n"
                                                  : "Nothing fails the gate.\n";
  std::string text =
      failing.empty() ? nothing : fmt::format("Fails the gate ({}):\n", grouped(failing.size()));
  for (std::size_t i = 0; i < failing.size(); ++i) text += in_full(i + 1, failing[i]);
  if (!others.empty())
    text += fmt::format("\n{} ({}):\n", "Does not fail the gate: known, or within the claim",
                        grouped(others.size()));
  for (std::size_t i = 0; i < std::min(brief_cap, others.size()); ++i) {
    const FailureView f = view_of(others[i]);
    const std::string buckets =
        others[i].size() == 1 ? f.bucket : fmt::format("{} and {} more", f.bucket, others[i].size() - 1);
    text += wrapped("  ", fmt::format("{}: {}, {}, {}: {}{}", f.method, f.law, f.pairs, buckets, f.what,
                                      others[i].front()->known ? " (known)" : ""));
  }
  if (others.size() > brief_cap) text += fmt::format("  and {} more\n", grouped(others.size() - brief_cap));
  return text;
}

std::string name_of(const CloseGateCell& c) {
  return fmt::format("{} {} {}", to_string(c.cell.lie), to_string(c.cell.band), power(c.cell.decade));
}

/// Gaps and overlaps are two questions with one bound each. Returns the worse bound.
double bound_of(const CloseGateCell& c) {
  return std::max(error_rate_bound(c.gaps, c.wrong_gaps), error_rate_bound(c.overlaps, c.wrong_overlaps));
}

/// The most cells that a text names.
constexpr std::size_t cells_named_cap = 6;

std::string named(const std::vector<const CloseGateCell*>& cells, bool bounds) {
  std::string text;
  for (std::size_t i = 0; i < std::min(cells.size(), cells_named_cap); ++i) {
    text += fmt::format("{}{}", i == 0 ? "" : ", ", name_of(*cells[i]));
    if (bounds) text += fmt::format(" (<= {:.1e})", bound_of(*cells[i]));
  }
  if (cells.size() > cells_named_cap) text += fmt::format(" and {} more", cells.size() - cells_named_cap);
  return text;
}

/// A cell is rare if it has less than this part of the gaps or overlaps of the median cell: a quarter.
constexpr std::uint64_t rare_part = 4;

std::string rate(double bound) { return fmt::format("<= {:.1e}", bound); }

/// A bound from here on states nothing.
constexpr double vain_bound = 0.5;

std::string rate_in_each(double worst) {
  return worst < vain_bound ? rate(worst) + " in each combination"
                            : "unknown in some combinations, which have too few pairs";
}

/// Returns "wrong beyond its claim on 3 of 70". If none is wrong, returns `right` and the number.
std::string success(std::uint64_t pairs, std::uint64_t wrong, const std::string& right) {
  return wrong == 0 ? fmt::format("{} {}", right, grouped(pairs))
                    : fmt::format("wrong beyond its claim on {} of {}", grouped(wrong), grouped(pairs));
}
constexpr const char* none_beyond = "never wrong beyond its claim on";

/// Returns one line for each fact.
std::string as_lines(const std::vector<std::string>& facts) {
  std::string text;
  for (const std::string& fact : facts) text += wrapped("  ", fact);
  return text;
}

/// Returns what close contacts prove about the claimed cells. Empty if the method was asked about none.
std::string close_in_words(const GateMethod& method) {
  std::vector<const CloseGateCell*> empty, rare, full;
  std::vector<std::uint64_t> gaps, overlaps;
  std::uint64_t wrong = 0, decided = 0, undecided = 0;
  for (const CloseGateCell& c : method.close_cells) {
    if (!c.claimed) continue;
    gaps.push_back(c.gaps);
    overlaps.push_back(c.overlaps);
    undecided += c.undecided;
    decided += c.gaps + c.overlaps;
    wrong += c.wrong_gaps + c.wrong_overlaps;
  }
  const std::string name = one_line(method.name);
  if (decided == 0) return undecided == 0 ? "" : wrapped("", name + " is undecided on all close contacts.");
  const auto middle = [](std::vector<std::uint64_t> n) {
    const auto at = n.begin() + static_cast<std::ptrdiff_t>(n.size() / 2);
    std::nth_element(n.begin(), at, n.end());
    return *at;
  };
  const std::uint64_t usual_gaps = middle(gaps), usual_overlaps = middle(overlaps);
  std::uint64_t least_gaps = 0, least_overlaps = 0;
  double worst = 0;
  for (const CloseGateCell& c : method.close_cells) {
    if (!c.claimed) continue;
    const bool few = c.gaps * rare_part < usual_gaps || c.overlaps * rare_part < usual_overlaps;
    (c.gaps + c.overlaps == 0 ? empty : few ? rare : full).push_back(&c);
    if (full.empty() || full.back() != &c) continue;
    least_gaps = full.size() == 1 ? c.gaps : std::min(least_gaps, c.gaps);
    least_overlaps = full.size() == 1 ? c.overlaps : std::min(least_overlaps, c.overlaps);
    worst = std::max(worst, bound_of(c));
  }
  std::vector<std::string> facts;
  facts.push_back(fmt::format("They cover {} of axis position, small angle and decade of margin.",
                              counted(full.size(), "combination")));
  facts.push_back(fmt::format("Each combination has at least {} and {}.", counted(least_gaps, "gap"),
                              counted(least_overlaps, "overlap")));
  facts.push_back(fmt::format("The error rate is {}, for gaps and for overlaps, at 95 % confidence.",
                              rate_in_each(worst)));
  if (undecided > 0) facts.push_back(fmt::format("It is undecided on {} more.", grouped(undecided)));
  if (!rare.empty()) facts.push_back("Few pairs: " + named(rare, true) + '.');
  if (!empty.empty()) facts.push_back("No decided pair: " + named(empty, false) + '.');
  return wrapped("", fmt::format("{} is {} close contacts.", name, success(decided, wrong, none_beyond))) +
         as_lines(facts);
}

std::string rounded_in_words(const GateMethod& method) {
  const RoundedCount& count = method.rounded;
  if (count.pairs + count.undecided == 0) return {};
  const std::string name = one_line(method.name);
  if (count.pairs == 0) return wrapped("", name + " is undecided on all rounded solids.");
  std::vector<std::string> facts;
  if (count.undecided > 0)
    facts.push_back(fmt::format("It is undecided on {} more.", grouped(count.undecided)));
  return wrapped("", fmt::format("{} is {} with a sphere, capsule or rounded cylinder.", name,
                                 success(count.pairs, count.wrong, none_beyond) +
                                     (count.pairs == 1 ? " pair" : " pairs"))) +
         as_lines(facts);
}

/// Returns what the random sample of all strata proves about the cells that the method claims.
std::string strata_in_words(const GateMethod& method) {
  std::set<ContactFeature> features;
  std::set<int> decades;
  std::uint64_t cells = 0, wrong = 0, wrong_cells = 0, undecided = 0, all = 0, least = 0, most = 0;
  double worst = 0;
  std::string empty;
  for (const GateCell& c : method.cells) {
    if (!c.claimed) continue;
    undecided += c.undecided;
    if (c.pairs == 0) {
      empty += fmt::format("{}{} {}", empty.empty() ? "" : ", ", to_string(c.stratum.feature),
                           power(c.stratum.decade));
      continue;
    }
    features.insert(c.stratum.feature);
    decades.insert(c.stratum.decade);
    least = cells == 0 ? c.pairs : std::min(least, c.pairs);
    most = std::max(most, c.pairs);
    ++cells;
    all += c.pairs;
    wrong += c.wrong;
    wrong_cells += c.wrong > 0;
    worst = std::max(worst, error_rate_bound(c.pairs, c.wrong));
  }
  const std::string name = one_line(method.name);
  std::vector<std::string> facts;
  if (cells > 0) {
    // The decade d holds margins above 10^(-d-1) and up to 10^-d.
    facts.push_back(fmt::format("They cover {} of {} and {} of margin from {} to {}.",
                                counted(cells, "combination"), counted(features.size(), "contact feature"),
                                counted(decades.size(), "decade"), power(*decades.begin()),
                                power(*decades.rbegin() + 1)));
    if (wrong > 0) facts.push_back(fmt::format("Its errors lie in {}.", counted(wrong_cells, "combination")));
    facts.push_back(fmt::format(
        "Each combination has {}.",
        least == most ? counted(least, "pair") : grouped(least) + " to " + counted(most, "pair")));
    facts.push_back(fmt::format("The error rate is {} overall and {}, at 95 % confidence.",
                                rate(error_rate_bound(all, wrong)), rate_in_each(worst)));
  }
  if (undecided > 0) facts.push_back(fmt::format("It is undecided on {} more.", grouped(undecided)));
  if (!empty.empty()) facts.push_back(fmt::format("No decided pair: {}.", empty));
  const std::string first =
      cells > 0
          ? fmt::format("{} is {} independent random pairs whose margin exceeds its claim.", name,
                        success(all, wrong, "right on all"))
          : fmt::format("Nothing is proved of {}: it decided no random pair whose margin exceeds its claim.",
                        name);
  return wrapped("", first) + as_lines(facts);
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
  for (const std::string& line : gate.not_asked) text += wrapped("NOT ASKED: ", one_line(line));
  text += '\n' + methods_table(gate) + '\n' + failures_text(gate) + '\n';
  for (const GateMethod& m : gate.report.methods) text += proved_in_words(m);
  for (const GateRemark& r : gate.remarks) text += wrapped("", one_line(r.text) + '.');
  return text;
}

}  // namespace cyl
