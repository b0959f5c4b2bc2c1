// SPDX-License-Identifier: MIT
#include "reports/run/tally_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "corpus/store/run_facts.hpp"

namespace cyl {
namespace {

constexpr int name_width = 30;
constexpr std::array<std::string_view, 7> titles{"asked",        "declined",  "failed", "beyond claim",
                                                 "within claim", "undecided", "ns/pair"};

/// Makes each cell two columns wider than its title, and wide enough for the counts of a long run.
std::string line_of(std::string_view name, const std::array<std::string, titles.size()>& cells) {
  std::string line = fmt::format("{:<{}}", name, name_width);
  for (std::size_t i = 0; i < cells.size(); ++i)
    line += fmt::format("{:>{}}", cells[i], std::max<std::size_t>(titles[i].size() + 2, 11));
  return line + '\n';
}

std::string row(const std::string& name, const Counts& c) {
  const auto number = [](std::uint64_t n) { return n == 0 ? "-" : std::to_string(n); };
  return line_of(
      name, {number(c.asked), number(c.declined), number(c.failed), number(c.contract), number(c.resolution),
             number(c.undecided), number(c.asked == 0 ? 0 : c.nanoseconds / c.asked)});
}

}  // namespace

// A batch lists its rows in the order of the run, but a family or a method may first appear in a later
// batch. The corpus and the referee come last in every batch, so this moves them behind all methods.
std::vector<MethodTally> tally_methods(const std::vector<TallyRecord>& tallies) {
  std::vector<MethodTally> all;
  for (const TallyRecord& t : tallies) {
    auto found =
        std::find_if(all.begin(), all.end(), [&](const MethodTally& m) { return m.method == t.method; });
    if (found == all.end()) found = all.insert(all.end(), MethodTally{t.method, {}, {}});
    found->total += t.counts;
    found->families.push_back(t);
  }
  std::stable_partition(all.begin(), all.end(), [](const MethodTally& m) { return is_method_row(m.method); });
  return all;
}

std::string format_tallies(const std::vector<MethodTally>& tallies) {
  std::array<std::string, titles.size()> head;
  std::copy(titles.begin(), titles.end(), head.begin());
  std::string text = line_of("", head);
  for (const MethodTally& m : tallies) {
    text += row(m.method, m.total);
    for (const auto& [method, family, counts] : m.families) {
      if (counts.failed + counts.contract == 0) continue;
      text += row("  " + family, counts);
    }
  }
  return text;
}

}  // namespace cyl
