// SPDX-License-Identifier: MIT
#include "fuzz/campaign/workload.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "corpus/pairs/random_stream.hpp"
#include "corpus/store/run_facts.hpp"

namespace cyl {

Schedule schedule_of(const Workload& workload) {
  std::vector<unsigned> weights(workload.weights.begin(), workload.weights.end());
  if (weights.empty()) weights.assign(workload.families.size(), 1);
  return Schedule(std::move(weights));
}

FamilyIndex family_index_of(const Workload& workload, const Schedule& schedule, std::uint64_t index) {
  const std::uint64_t cases = workload.cases.size();
  if (index < cases) return {0, index};
  const auto [family, own] = schedule.at(index - cases);
  return {1 + family, own};
}

std::string family_name(const Workload& workload, std::size_t family) {
  return family == 0 ? cases_family : std::string(workload.families[family - 1].name);
}

bool on_share(unsigned share, std::uint64_t seed, std::uint64_t index) {
  return share <= 1 || RandomStream("share", seed, index).below(share) == 0;
}

bool any_foreign(const Workload& workload) {
  return std::any_of(workload.methods.begin(), workload.methods.end(),
                     [](const auto& method) { return method->foreign(); });
}

}  // namespace cyl
