// SPDX-License-Identifier: MIT
#include "fuzz/campaign/not_alone.hpp"

#include "oracles/methods/contained.hpp"

namespace cyl {

std::vector<Doubt> not_alone(std::span<const std::unique_ptr<Method>> methods, std::span<Trial> trials,
                             std::span<const Doubt> doubts) {
  if (doubts.empty()) return {};
  std::vector<Pair> pairs;
  std::vector<Question> questions;
  for (const Doubt& doubt : doubts) {
    questions.push_back({doubt.method, pairs.size()});
    pairs.push_back(trials[doubt.pair].pair);
  }
  const std::vector<ContainedAnswer> said = ask_contained(methods, pairs, questions);
  std::vector<Doubt> gone;
  for (std::size_t q = 0; q < doubts.size(); ++q) {
    const auto again = compare(trials[doubts[q].pair], methods[doubts[q].method]->claim(), said[q].answer);
    if (!again || again->kind != doubts[q].kind) gone.push_back(doubts[q]);
  }
  return gone;
}

}  // namespace cyl
