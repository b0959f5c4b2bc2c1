// SPDX-License-Identifier: MIT
#include "reports/page.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <map>
#include <stdexcept>
#include <vector>

#include "corpus/finding_words.hpp"
#include "corpus/pair_io.hpp"
#include "corpus/shell_words.hpp"
#include "corpus/store.hpp"
#include "fuzz/batch.hpp"
#include "reports/history.hpp"
#include "reports/kill_section.hpp"
#include "reports/tally_table.hpp"

namespace cyl {
namespace {

/// Bytes of a free text (an id, a note, a reason) that the page shows.
constexpr std::size_t text_cap = 300;
/// A cell is full red where one answer in ten is wrong; each of the seven decades below is a shade paler.
constexpr double shade_decades = 7;

constexpr const char* style = R"(
:root { color-scheme: light dark; --bg: #fff; --fg: #1b1b1b; --soft: #666; --line: #ddd; --panel: #f6f6f6;
  --bad: #b3261e; --warn: #8a5a00; --ok: #1f6f3f; }
@media (prefers-color-scheme: dark) { :root { --bg: #151515; --fg: #e8e8e8; --soft: #a0a0a0; --line: #3a3a3a;
  --panel: #202020; --bad: #ff8a80; --warn: #ffcc66; --ok: #7bd3a0; } }
body { margin: 0 auto; padding: 1rem; max-width: 72rem; background: var(--bg); color: var(--fg);
  font: 16px/1.45 system-ui, sans-serif; }
h1 { font-size: 1.4rem; } h2 { font-size: 1.15rem; margin-top: 2rem; } h3 { font-size: 1rem; margin: 0 0 .3rem; }
p, ul { margin: .4rem 0; } .soft { color: var(--soft); } .bad { color: var(--bad); } .warn { color: var(--warn); }
.ok { color: var(--ok); }
.wide { overflow-x: auto; }
table { border-collapse: collapse; font-size: .85rem; font-variant-numeric: tabular-nums; }
th, td { border: 1px solid var(--line); padding: .2rem .5rem; text-align: right; white-space: nowrap; }
td.text { text-align: left; white-space: normal; min-width: 18rem; }
th:first-child, td:first-child { text-align: left; position: sticky; left: 0; background: var(--bg); }
td.claim { white-space: normal; min-width: 16rem; text-align: left; }
details { border: 1px solid var(--line); border-radius: .4rem; margin: .6rem 0; padding: .4rem .7rem; }
summary { cursor: pointer; }
article { background: var(--panel); border-radius: .4rem; padding: .6rem .7rem; margin: .6rem 0; }
code { font: .8rem/1.4 ui-monospace, monospace; overflow-wrap: anywhere; }
code.copy { display: block; white-space: pre-wrap; user-select: all; -webkit-user-select: all; background: var(--bg);
  border: 1px solid var(--line); border-radius: .3rem; padding: .3rem .5rem; margin: .3rem 0; max-height: 9rem;
  overflow-y: auto; }
)";

std::string clipped(const std::string& text) {
  if (text.size() <= text_cap) return escape_html(text);
  std::size_t end = text_cap;  // not within a UTF-8 character
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xc0) == 0x80) --end;
  return escape_html(text.substr(0, end)) + "…";
}

/// 1234567 as 1,234,567.
std::string grouped(std::uint64_t n) {
  return n < 1000 ? std::to_string(n) : fmt::format("{},{:03}", grouped(n / 1000), n % 1000);
}

std::string percent(std::uint64_t part, std::uint64_t whole) {
  const double share = whole == 0 ? 0 : 100.0 * static_cast<double>(part) / static_cast<double>(whole);
  return fmt::format(fmt::runtime(share < 10 ? "{:.2g} %" : "{:.0f} %"), share);
}

std::string times(std::uint64_t n) { return n == 1 ? "once" : grouped(n) + " times"; }

/// A value of the run's configuration, or nothing where this run has none of that name.
std::string setting(const Config& config, const std::string& key) {
  const auto found = config.find(key);
  return found == config.end() ? "" : found->second;
}

// Headline
// ---------------------------------------------------------------------------------------------------------

/// "30 wrong_disjoint, 12 crash": what a method did beyond its claim, the most frequent first.
std::string kinds_of(const std::string& method, const std::vector<GroupRecord>& groups) {
  std::map<std::string, std::uint64_t> counts;
  for (const GroupRecord& g : groups) {
    if (g.method == method && g.severity == "contract") counts[g.kind] += g.count;
  }
  std::vector<std::pair<std::string, std::uint64_t>> sorted(counts.begin(), counts.end());
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const auto& x, const auto& y) { return x.second > y.second; });
  std::string text;
  for (const auto& [kind, count] : sorted) {
    if (!text.empty()) text += ", ";
    text += fmt::format("{} {}", grouped(count), clipped(kind));
  }
  return text;
}

/// The methods, and the cases' own statements: both may be wrong.
bool may_be_wrong(const MethodTally& m) { return is_method_row(m.method) || m.method == corpus_row; }

std::string headline(const std::vector<MethodTally>& tallies, const std::vector<GroupRecord>& groups) {
  std::string items;
  std::size_t right = 0;
  for (const MethodTally& m : tallies) {
    const Counts& c = m.total;
    if (!may_be_wrong(m)) continue;
    if (c.contract + c.failed == 0) {
      right += is_method_row(m.method);
      continue;
    }
    const std::uint64_t bad = c.contract + c.failed, answers = c.asked - c.declined;
    items +=
        fmt::format("<li><b>{}</b> <b class=\"bad\">{}</b> in {} answers ({}): {}</li>\n", clipped(m.method),
                    times(bad), grouped(answers), percent(bad, answers), kinds_of(m.method, groups));
  }
  if (items.empty())
    return "<p class=\"ok\">No method was wrong beyond its own claim, and none failed.</p>\n";
  return fmt::format(
      "<p>Wrong beyond their own claim, or failed:</p>\n<ul>\n{}</ul>\n<p>{} more {} not.</p>\n", items,
      right, right == 1 ? "was" : "were");
}

std::string facts(const Config& config, const Progress& progress, const std::vector<MethodTally>& tallies) {
  std::string undecided = "0";
  std::uint64_t pairs = 0;  // judged: of a shard, the next index tells of others' too
  for (const MethodTally& m : tallies) {
    if (m.method != referee_row) continue;
    undecided = grouped(m.total.undecided);
    pairs = m.total.asked;
  }
  std::string text = fmt::format(
      "<p class=\"soft\">{} pairs, seed {}, begun {}, {:.0f} s of running time; truth undecided on {} pairs.",
      grouped(pairs), escape_html(setting(config, "seed")), escape_html(setting(config, "started")),
      static_cast<double>(progress.milliseconds) / 1000, undecided);
  if (const std::string build = setting(config, "build"); !build.empty())
    text += " Build: " + clipped(build) + ".";
  if (const std::string shard = setting(config, "shard"); !shard.empty())
    text += " Shard " + clipped(shard) + ".";
  if (const std::string shards = setting(config, "shards"); !shards.empty())
    text += " Merged from " + clipped(shards) + " shards.";
  if (const std::string status = setting(config, "status"); !status.empty())
    text += " Status: " + clipped(status) + ".";
  return text + "</p>\n";
}

std::string severity_in_words(const std::string& severity) {
  if (severity == "contract") return "beyond its own claim";
  if (severity == "resolution") return "within its own claim";
  return "truth undecided";
}

// History
// ----------------------------------------------------------------------------------------------------------

std::string history_section(const History& history) {
  std::string text = fmt::format("<h2>History</h2>\n<p>{}</p>\n", escape_html(format_history(history)));
  std::string items;
  std::size_t listed = 0;
  for (const auto& [group, standing] : history.groups) {
    if (standing == Standing::known || ++listed > shown_cap) continue;
    items += fmt::format("<li>{}: <b>{}</b> {} <span class=\"soft\">{}, {}</span></li>\n",
                         to_string(standing), clipped(group.method), clipped(group.kind),
                         severity_in_words(group.severity), clipped(group.family));
  }
  if (items.empty()) return text;
  return text +
         fmt::format("<details><summary>What is not as it was</summary>\n<ul>\n{}</ul>\n</details>\n", items);
}

// Tables
// -----------------------------------------------------------------------------------------------------------

std::string claim_in_words(const MethodRecord& method) {
  std::string words = "always right";
  if (method.relative != 0 || method.absolute != 0) {
    words = "right where |distance| is at least ";
    if (method.relative != 0) words += fmt::format("{} of the size", format_double(method.relative));
    if (method.relative != 0 && method.absolute != 0) words += " plus ";
    if (method.absolute != 0) words += fmt::format("a length of {}", format_double(method.absolute));
  }
  return fmt::format("{} <span class=\"soft\">{}</span>", escape_html(words), clipped(method.source));
}

std::string cell(std::uint64_t n) { return fmt::format("<td>{}</td>", n == 0 ? "" : grouped(n)); }

constexpr const char* number_titles =
    "<th>asked</th><th>declined</th><th>failed</th><th>wrong beyond its claim</th><th>wrong within it</th>"
    "<th>undecided</th><th>ns a pair</th>";

/// The numbers of `c` as the cells of a row, in the order of number_titles.
std::string number_cells(const Counts& c) {
  return cell(c.asked) + cell(c.declined) + cell(c.failed) + cell(c.contract) + cell(c.resolution) +
         cell(c.undecided) + cell(c.asked == 0 ? 0 : c.nanoseconds / c.asked);
}

std::string methods_table(const std::vector<MethodRecord>& methods, const std::vector<MethodTally>& tallies) {
  std::string text = fmt::format(
      "<h2>Methods</h2>\n<div class=\"wide\"><table>\n<tr><th>method</th>{}<th>version</th><th>its "
      "claim</th></tr>\n",
      number_titles);
  for (const MethodTally& m : tallies) {
    const auto method = std::find_if(methods.begin(), methods.end(),
                                     [&](const MethodRecord& r) { return r.name == m.method; });
    text += fmt::format("<tr><td>{}</td>{}", clipped(m.method), number_cells(m.total));
    text += fmt::format("<td>{}</td><td class=\"claim\">{}</td></tr>\n",
                        method == methods.end() ? "" : clipped(method->version),
                        method == methods.end() ? "" : claim_in_words(*method));
  }
  return text + "</table></div>\n";
}

std::string shade(std::uint64_t wrong, std::uint64_t asked, const char* colour) {
  if (wrong == 0 || asked == 0) return "";
  const double rate = static_cast<double>(wrong) / static_cast<double>(asked);
  const double depth = std::clamp((std::log10(rate) + 1 + shade_decades) / shade_decades, 0.1, 1.0);
  return fmt::format(" style=\"background:rgba({},{:.2f})\"", colour, 0.7 * depth);
}

std::string family_cell(const Counts& c) {
  if (c.asked == 0) return "<td></td>";
  std::string words;
  const auto add = [&](std::uint64_t n, const char* kind) {
    if (n == 0) return;
    if (!words.empty()) words += "<br>";
    words += grouped(n) + kind;
  };
  add(c.contract, "");
  add(c.failed, " failed");
  add(c.resolution, " within claim");
  const std::uint64_t bad = c.contract + c.failed;
  const std::string colour =
      bad > 0 ? shade(bad, c.asked, "211,47,47") : shade(c.resolution, c.asked, "230,160,0");
  return fmt::format("<td{}>{}</td>", colour, words);
}

std::string families_table(const std::vector<MethodTally>& tallies) {
  std::vector<std::string> families;
  std::map<std::string, std::map<std::string, Counts>> at;
  std::string text =
      "<h2>Where</h2>\n<p class=\"soft\">Answers that were wrong beyond the method's claim, failed, or wrong "
      "within "
      "its claim; the redder, the larger their share.</p>\n<div class=\"wide\"><table>\n<tr><th>family</th>";
  for (const MethodTally& m : tallies) {
    if (!may_be_wrong(m)) continue;
    text += fmt::format("<th>{}</th>", escape_html(m.method));
    for (const TallyRecord& t : m.families) {
      if (std::find(families.begin(), families.end(), t.family) == families.end())
        families.push_back(t.family);
      at[t.family][m.method] = t.counts;
    }
  }
  text += "</tr>\n";
  for (const std::string& family : families) {
    text += fmt::format("<tr><td>{}</td>", escape_html(family));
    for (const MethodTally& m : tallies) {
      if (may_be_wrong(m)) text += family_cell(at[family][m.method]);
    }
    text += "</tr>\n";
  }
  return text + "</table></div>\n";
}

std::string full_table(const std::vector<MethodTally>& tallies) {
  std::string text =
      "<h2>Every number</h2>\n<p class=\"soft\">Each method, family by family; then what the cases state "
      "and the referee, in all and for each of its stages.</p>\n";
  for (const MethodTally& m : tallies) {
    text += fmt::format(
        "<details><summary>{}</summary>\n<div class=\"wide\"><table>\n<tr><th>family</th>{}</tr>\n"
        "<tr><td><b>all</b></td>{}</tr>\n",
        clipped(m.method), number_titles, number_cells(m.total));
    for (const TallyRecord& t : m.families)
      text += fmt::format("<tr><td>{}</td>{}</tr>\n", clipped(t.family), number_cells(t.counts));
    text += "</table></div>\n</details>\n";
  }
  return text;
}

// Findings
// ---------------------------------------------------------------------------------------------------------

struct Group {
  std::string method, kind, severity;
  std::uint64_t count = 0;
  std::vector<FindingRecord> findings;  ///< the worst first
};

/// A failure has no margin: it is as bad as can be.
double badness(const FindingRecord& f) {
  return f.margin ? f.margin->lo : std::numeric_limits<double>::infinity();
}

int rank(const std::string& severity) {
  return severity == "contract" ? 0 : severity == "resolution" ? 1 : 2;
}

std::vector<Group> group_findings(const RunStore& store) {
  std::map<std::tuple<std::string, std::string, std::string>, Group> groups;
  for (const GroupRecord& g : store.groups()) {
    Group& group = groups[{g.method, g.kind, g.severity}];
    group.method = g.method;
    group.kind = g.kind;
    group.severity = g.severity;
    group.count += g.count;
  }
  for (FindingRecord& f : store.findings())
    groups[{f.method, f.kind, f.severity}].findings.push_back(std::move(f));
  std::vector<Group> sorted;
  for (auto& [key, group] : groups) {
    std::stable_sort(group.findings.begin(), group.findings.end(),
                     [](const FindingRecord& x, const FindingRecord& y) { return badness(x) > badness(y); });
    sorted.push_back(std::move(group));
  }
  const auto worst = [](const Group& g) { return g.findings.empty() ? 0 : badness(g.findings.front()); };
  std::stable_sort(sorted.begin(), sorted.end(), [&](const Group& x, const Group& y) {
    return rank(x.severity) != rank(y.severity) ? rank(x.severity) < rank(y.severity) : worst(x) > worst(y);
  });
  return sorted;
}

std::string margin_in_words(const FindingRecord& f) {
  if (!f.margin) return "";
  const auto bound = [](double x) { return std::isinf(x) ? "infinity" : fmt::format("{:.3g}", x); };
  return fmt::format("<p>Off by {} to {} of their size (r + h + r + h).</p>\n", bound(f.margin->lo),
                     bound(f.margin->hi));
}

// The line that is shown holds the pair alone: what else a case carries may be long.
std::string pair_in_words(const FindingRecord& f) {
  const CaseLine line = parse_case(f.pair, 1);
  if (!line.value) return fmt::format("<code class=\"copy\">{}</code>\n", clipped(f.pair));
  std::string text =
      fmt::format("<code class=\"copy\">{}</code>\n", escape_html(format_pair(line.value->pair)));
  const auto remark = [&](const char* what, const std::string& words) {
    if (!words.empty()) text += fmt::format("<p class=\"soft\">{} {}</p>\n", what, clipped(words));
  };
  if (f.family == "cases") {
    remark("Case:", line.value->id);
    remark("From:", line.value->source);
    remark("Note:", line.value->note);
  }
  return text;
}

std::string article(const FindingRecord& f, const std::string& run_folder) {
  std::string text =
      fmt::format("<article id=\"f{}\">\n<h3>#{} <span class=\"soft\">{} {}, index {}</span></h3>\n", f.id,
                  f.id, escape_html(f.family), f.family_index, f.index);
  text += margin_in_words(f);
  text += pair_in_words(f);
  const TruthWords truth = describe_truth(f.truth);
  text += fmt::format("<p><b>Truth: {}.</b> {} <span class=\"soft\">Settled in {} arithmetic.</span></p>\n",
                      clipped(truth.verdict), escape_html(truth.certificate), clipped(f.stage));
  text += "<details><summary>What each method said</summary>\n<ul>\n";
  for (const auto& [method, words] : describe_answers(f.answers)) {
    text += fmt::format("<li>{}{}{}: <code>{}</code></li>\n", method == f.method ? "<b class=\"bad\">" : "",
                        escape_html(method), method == f.method ? "</b>" : "", clipped(words));
  }
  text += "</ul>\n</details>\n";
  if (!f.reason.empty()) text += fmt::format("<p>In its own words: <code>{}</code></p>\n", clipped(f.reason));
  text += fmt::format("<code class=\"copy\">./daylight replay {}</code>\n</article>\n",
                      escape_html(shell_quoted(fmt::format("{}:{}", run_folder, f.id))));
  return text;
}

std::string findings_section(const std::vector<Group>& groups, const std::string& run_folder) {
  std::string text = "<h2>Findings</h2>\n";
  if (groups.empty()) return text + "<p class=\"ok\">None.</p>\n";
  std::size_t left = shown_cap;
  for (const Group& g : groups) {
    const std::size_t shown = std::min({g.findings.size(), shown_per_group_cap, left});
    left -= shown;
    text += fmt::format(
        "<details{}>\n<summary><b>{}</b> {} <span class=\"{}\">{}</span>: {} found, {} kept, {} "
        "shown</summary>\n",
        g.severity == "contract" ? " open=\"open\"" : "", escape_html(g.method), escape_html(g.kind),
        g.severity == "contract" ? "bad" : "warn", severity_in_words(g.severity), grouped(g.count),
        g.findings.size(), shown);
    for (std::size_t i = 0; i < shown; ++i) text += article(g.findings[i], run_folder);
    text += "</details>\n";
  }
  return text;
}

void write_whole(const std::string& file, const std::string& text) {
  const std::string unfinished = fmt::format("{}.{}", file, getpid());
  std::ofstream out(unfinished, std::ios::binary);
  out << text;
  out.close();
  if (!out) throw std::runtime_error("cannot write " + unfinished);
  std::filesystem::rename(unfinished, file);
}

}  // namespace

std::string escape_html(std::string_view text) {
  std::string safe;
  safe.reserve(text.size());
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (const unsigned control = leading_bidi_control(text.substr(i))) {
      safe += escaped_code(control);
      i += 2;
      continue;
    }
    const char c = text[i];
    switch (c) {
      case '&':
        safe += "&amp;";
        break;
      case '<':
        safe += "&lt;";
        break;
      case '>':
        safe += "&gt;";
        break;
      case '"':
        safe += "&quot;";
        break;
      case '\'':
        safe += "&#39;";
        break;
      default:
        if ((static_cast<unsigned char>(c) < 0x20 && c != '\n' && c != '\t') || c == 0x7f) {
          safe += "\xef\xbf\xbd";
        } else {
          safe += c;
        }
    }
  }
  return safe;
}

void write_page(const std::string& run_folder, const std::string& kill_matrix) {
  const RunStore store = RunStore::open(run_folder);
  const Config config = store.config();
  const std::vector<MethodTally> tallies = tally_methods(store);
  std::string page = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src "
      "'unsafe-inline'\"/>\n"
      "<title>daylight, seed {}</title>\n<style>{}</style>\n</head>\n<body>\n<h1>Who was wrong about two "
      "cylinders?</h1>\n",
      escape_html(setting(config, "seed")), style);
  page += headline(tallies, store.groups());
  page += facts(config, store.progress(), tallies);
  if (const History history = compare_with_earlier(run_folder); history.runs + history.unreadable > 0)
    page += history_section(history);
  page += families_table(tallies);
  page += findings_section(group_findings(store), run_folder);
  page += methods_table(store.methods(), tallies);
  page += full_table(tallies);
  if (!kill_matrix.empty()) page += kill_section(kill_matrix);
  page += "</body>\n</html>\n";
  write_whole(run_folder + "/report.html", page);
}

}  // namespace cyl
