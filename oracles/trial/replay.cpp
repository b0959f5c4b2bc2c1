// SPDX-License-Identifier: MIT
#include "oracles/trial/replay.hpp"

namespace cyl {
namespace {

Replayed judge_answers(std::span<const std::unique_ptr<Method>> methods, const Pair& pair,
                       std::span<const ContainedAnswer> said) {
  Replayed result;
  for (std::size_t m = 0; m < methods.size(); ++m) result.answers.push_back(said[2 * m].answer);
  result.truth = judge(pair, result.answers);
  LazyDistance distance([&](double width) { return enclose_distance(pair, result.truth, width); });
  for (std::size_t m = 0; m < methods.size(); ++m) {
    auto wrong = compare(pair, result.truth, distance, methods[m]->claim(), result.answers[m]);
    if (!wrong && !same_answer(result.answers[m], said[2 * m + 1].answer)) {
      wrong = Finding{FindingKind::nondeterminism, Severity::contract, {}};
    }
    result.findings.push_back(wrong);
  }
  const bool decided = result.truth.verdict != Verdict::undecided && result.truth.verdict != Verdict::invalid;
  if (decided && !distance.known()) distance.at(1e-6);
  if (decided) result.distance = *distance.known();
  return result;
}

}  // namespace

std::vector<Replayed> replay(std::span<const std::unique_ptr<Method>> methods, std::span<const Pair> pairs,
                             const Caps& caps) {
  std::vector<Question> questions;
  for (std::size_t p = 0; p < pairs.size(); ++p) {
    for (std::size_t m = 0; m < methods.size(); ++m) questions.insert(questions.end(), 2, Question{m, p});
  }
  const std::vector<ContainedAnswer> said = ask_contained(methods, pairs, questions, caps);
  const std::size_t stride = 2 * methods.size();
  std::vector<Replayed> results;
  for (std::size_t p = 0; p < pairs.size(); ++p) {
    results.push_back(judge_answers(methods, pairs[p], std::span(said).subspan(p * stride, stride)));
  }
  return results;
}

}  // namespace cyl
