// SPDX-License-Identifier: MIT
#include "fuzz/campaign/confirm_in_isolation.hpp"

#include "oracles/methods/contained.hpp"

namespace cyl {

std::vector<Suspect> confirm_in_isolation(std::span<const std::unique_ptr<Method>> methods,
                                          std::span<Trial> trials, std::span<const Suspect> suspects) {
  if (suspects.empty()) return {};
  std::vector<Pair> pairs;
  std::vector<Question> questions;
  for (const Suspect& doubt : suspects) {
    questions.push_back({doubt.method, pairs.size()});
    pairs.push_back(trials[doubt.pair].pair);
  }
  const std::vector<ContainedAnswer> said = ask_contained(methods, pairs, questions);
  std::vector<Suspect> gone;
  for (std::size_t q = 0; q < suspects.size(); ++q) {
    const auto again =
        compare(trials[suspects[q].pair], methods[suspects[q].method]->claim(), said[q].answer);
    if (!again || again->kind != suspects[q].kind) gone.push_back(suspects[q]);
  }
  return gone;
}

}  // namespace cyl
