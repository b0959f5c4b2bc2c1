// SPDX-License-Identifier: MIT
#include "reports/run/tally_table.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "fuzz/campaign/batch.hpp"

namespace cyl {
namespace {

constexpr int name_width = 30, number_width = 11;

std::string row(const std::string& name, const Counts& c) {
  const auto number = [](std::uint64_t n) {
    return fmt::format("{:>{}}", n == 0 ? "-" : std::to_string(n), number_width);
  };
  std::string line = fmt::format("{:<{}}", name, name_width);
  for (const std::uint64_t n : {c.asked, c.declined, c.failed, c.contract, c.resolution, c.undecided})
    line += number(n);
  line += number(c.asked == 0 ? 0 : c.nanoseconds / c.asked);
  line += '\n';
  return line;
}

}  // namespace

// A batch lists its rows in the order of the run, but a family or a method may appear only in a later batch;
// the corpus and the referee come last in every batch, so they are moved behind whatever came after them.
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
  std::string text = fmt::format("{:<{}}", "", name_width);
  for (const char* title :
       {"asked", "declined", "failed", "contract", "resolution", "undecided", "ns/pair"}) {
    text += fmt::format("{:>{}}", title, number_width);
  }
  text += '\n';
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
