// SPDX-License-Identifier: MIT
#include "fuzz/campaign/workload.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "corpus/pairs/random_stream.hpp"
#include "corpus/store/run_facts.hpp"

namespace cyl {
namespace {

/// Turns of the corpus in a round, in which a family has one. A night then asks about the whole corpus.
constexpr std::uint64_t corpus_weight = 8;

}  // namespace

FamilyIndex family_index_of(const Workload& workload, std::uint64_t index) {
  const std::uint64_t cases = workload.cases.size(), families = workload.families.size();
  if (index < cases) return {0, index};
  const std::uint64_t turns = families + (workload.corpus.empty() ? 0 : corpus_weight),
                      round = (index - cases) / turns, turn = (index - cases) % turns;
  if (turn < families) return {1 + turn, round};
  return {1 + families, round * corpus_weight + (turn - families)};
}

Pair pair_at(const Workload& workload, std::uint64_t seed, const FamilyIndex& at) {
  if (at.family == 0) return workload.cases[at.index].pair;
  if (at.family <= workload.families.size()) return workload.families[at.family - 1].generate(seed, at.index);
  const Pair& known = workload.corpus[at.index % workload.corpus.size()];
  if (at.index < workload.corpus.size()) return known;
  return workload.change(known, RandomStream("corpus", seed, at.index).bits());
}

std::string family_name(const Workload& workload, std::size_t family) {
  if (family == 0) return cases_family;
  return family <= workload.families.size() ? std::string(workload.families[family - 1].name) : fuzzed_family;
}

std::size_t family_count(const Workload& workload) {
  return 1 + workload.families.size() + !workload.corpus.empty();
}

bool on_share(unsigned share, std::uint64_t seed, std::uint64_t index) {
  return share <= 1 || RandomStream("share", seed, index).below(share) == 0;
}

bool any_foreign(const Workload& workload) {
  return std::ranges::any_of(workload.methods, [](const auto& method) { return method->foreign(); });
}

std::string format_case_at(const Workload& workload, std::uint64_t seed, std::uint64_t index,
                           const FamilyIndex& at, const Pair& pair, const Truth& truth) {
  if (at.family == 0) return format_case(workload.cases[at.index]);
  Case line;
  line.pair = pair;
  line.id = fmt::format("{}/{}", family_name(workload, at.family), at.index);
  line.source = fmt::format("daylight campaign --seed {}, index {}", seed, index);
  if (truth.verdict != Verdict::undecided) line.truth = truth.verdict;
  return format_case(line);
}

std::uint64_t batch_size_for(const Workload& workload) {
  const auto is_program = [](const auto& method) { return method->program(); };
  if (std::any_of(workload.methods.begin(), workload.methods.end(), is_program)) return program_batch_size;
  return any_foreign(workload) ? batch_size : own_batch_size;
}

}  // namespace cyl
