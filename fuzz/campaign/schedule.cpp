// SPDX-License-Identifier: MIT
#include "fuzz/campaign/schedule.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "base/usage_error.hpp"
#include "corpus/store/run_store.hpp"

namespace cyl {

// Smooth weighted round robin: each step all gain their weight, the richest (the first of equals) has the
// turn and pays the sum. After a round every credit is 0 again. Equal weights give the order itself.
Schedule::Schedule(std::vector<unsigned> weights) : weights_(std::move(weights)) {
  const std::int64_t sum = std::accumulate(weights_.begin(), weights_.end(), std::int64_t{0});
  std::vector<std::int64_t> credit(weights_.size());
  std::vector<std::uint64_t> had(weights_.size());
  for (std::int64_t step = 0; step < sum; ++step) {
    for (std::size_t f = 0; f < weights_.size(); ++f) credit[f] += weights_[f];
    const auto richest = std::max_element(credit.begin(), credit.end());
    *richest -= sum;
    const auto family = static_cast<std::size_t>(richest - credit.begin());
    round_.push_back({family, had[family]++});
  }
}

std::vector<unsigned> weights_from(const std::string& folder, std::span<const Family> families) {
  std::vector<std::string> runs;
  if (!holds_run(folder)) runs = runs_in(folder);
  if (runs.empty()) runs.push_back(folder);  // if this folder holds no run, opening it reports so
  std::map<std::string, std::set<std::pair<std::string, FindingKind>>> found;
  for (const std::string& run : runs) {
    for (const GroupRecord& g : RunStore::open(run).groups()) {
      if (g.severity == Severity::contract) found[g.family].emplace(g.method, g.kind);
    }
  }
  std::size_t most = 1;
  for (const Family& family : families) most = std::max(most, found[std::string(family.name)].size());
  std::vector<unsigned> weights;
  for (const Family& family : families) {
    const std::size_t more = (weight_cap - 1) * found[std::string(family.name)].size();
    weights.push_back(static_cast<unsigned>(1 + (more + most / 2) / most));
  }
  return weights;
}

std::string format_weights(std::span<const unsigned> weights) {
  const bool equal = std::all_of(weights.begin(), weights.end(), [](unsigned w) { return w == 1; });
  return equal ? "" : fmt::format("{}", fmt::join(weights, " "));
}

std::vector<unsigned> parse_weights(const std::string& text) {
  std::istringstream in(text);
  std::vector<unsigned> weights;
  for (unsigned w = 0; in >> w;) weights.push_back(w);
  const bool whole = in.eof() && std::find(weights.begin(), weights.end(), 0u) == weights.end();
  if (!whole) throw InputError("'" + text + "' is not a list of weights of families");
  return weights;
}

}  // namespace cyl
