// SPDX-License-Identifier: MIT
#include "props/laws/examine.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace cyl {
namespace {

/// What one law wants asked of one method about one pair: a stretch of all questions of the second round.
struct Errand {
  std::size_t method, pair;
  const Law* law;
  std::vector<Asked> asked;
  std::size_t first_question = 0;
};

void count(AnswerCounts& counts, const MethodAnswer& answer) {
  ++counts.asked;
  counts.declined += answer.status == Status::declined;
  counts.failed += answer.status == Status::failed;
  if (answer.status == Status::answered) ++counts.said[static_cast<std::size_t>(answer.verdict)];
}

void count_hang(AnswerCounts& counts, const ContainedAnswer& said) {
  if (said.answer.failure != Failure::hang) return;
  ++counts.hangs;
  counts.hung_seconds += said.nanoseconds * 1e-9;
}

}  // namespace

AnswerCounts& AnswerCounts::operator+=(const AnswerCounts& other) {
  asked += other.asked;
  declined += other.declined;
  failed += other.failed;
  hangs += other.hangs;
  hung_seconds += other.hung_seconds;
  for (std::size_t i = 0; i < said.size(); ++i) said[i] += other.said[i];
  return *this;
}

Examined examine(std::span<const std::unique_ptr<Method>> methods, std::span<const Pair> pairs,
                 const Wanted& wanted, const Caps& caps) {
  Examined result;
  result.counts.resize(methods.size());
  result.truths.resize(pairs.size());

  // Method by method, so that each worker stays with one library.
  std::vector<Question> questions;
  for (std::size_t m = 0; m < methods.size(); ++m) {
    if (std::none_of(all_laws().begin(), all_laws().end(), [&](const Law& law) { return wanted(m, law); }))
      continue;
    for (std::size_t p = 0; p < pairs.size(); ++p) questions.push_back({m, p});
  }
  const std::vector<ContainedAnswer> said = ask_contained(methods, pairs, questions, caps);
  result.answers.resize(methods.size() * pairs.size());
  for (std::size_t q = 0; q < questions.size(); ++q) {
    result.answers[questions[q].pair * methods.size() + questions[q].method] = said[q].answer;
    count(result.counts[questions[q].method], said[q].answer);
    count_hang(result.counts[questions[q].method], said[q]);
  }
  const auto answer = [&](std::size_t m, std::size_t p) -> const MethodAnswer& {
    return result.answers[p * methods.size() + m];
  };

  std::vector<Errand> errands;
  std::vector<Pair> changed;
  std::vector<Question> further;
  for (std::size_t m = 0; m < methods.size(); ++m) {
    for (std::size_t p = 0; p < pairs.size(); ++p) {
      for (const Law& law : all_laws()) {
        if (!wanted(m, law)) continue;
        Errand errand{m, p, &law, {}};
        if (law.ask != needs_none) {
          if (answer(m, p).status != Status::answered) continue;
          errand.asked = law.ask(*methods[m], pairs[p], answer(m, p));
          if (errand.asked.empty()) continue;
          errand.first_question = further.size();
          for (const Asked& asked : errand.asked) {
            further.push_back({m, changed.size(), asked.mode});
            changed.push_back(asked.pair);
          }
        }
        errands.push_back(std::move(errand));
      }
    }
  }
  std::vector<MethodAnswer> further_answers;
  const std::vector<ContainedAnswer> said_further = ask_contained(methods, changed, further, caps);
  for (std::size_t q = 0; q < further.size(); ++q) {
    further_answers.push_back(said_further[q].answer);
    count_hang(result.counts[further[q].method], said_further[q]);
  }

  // By pair, so that what is proved of it serves all methods.
  std::vector<std::vector<const Errand*>> by_pair(pairs.size());
  for (const Errand& errand : errands) by_pair[errand.pair].push_back(&errand);
  for (std::size_t p = 0; p < pairs.size(); ++p) {
    Proofs proofs(pairs[p], std::span(result.answers).subspan(p * methods.size(), methods.size()));
    for (const Errand* errand : by_pair[p]) {
      const LawCase c{*methods[errand->method],
                      pairs[p],
                      answer(errand->method, p),
                      errand->asked,
                      std::span(further_answers).subspan(errand->first_question, errand->asked.size()),
                      proofs};
      const auto failed = std::find_if(c.answers.begin(), c.answers.end(),
                                       [](const MethodAnswer& a) { return a.status == Status::failed; });
      auto broken =
          failed == c.answers.end()
              ? errand->law->broken(c)
              : Broken{fmt::format("fails on a changed pair: {}", failed->reason), Severity::contract};
      if (!broken) continue;
      result.broken.push_back({errand->method,
                               p,
                               errand->law,
                               std::move(*broken),
                               errand->asked,
                               {c.answers.begin(), c.answers.end()}});
    }
    if (const Trial* proved = proofs.known(pairs[p])) result.truths[p] = proved->truth.verdict;
  }
  return result;
}

std::optional<Broken> broken_by(Method& method, const Law& law, const Pair& pair) {
  const MethodAnswer first = method.ask(pair);
  Proofs proofs(pair, {&first, 1});
  std::vector<Asked> asked;
  if (law.ask != needs_none) {
    if (first.status != Status::answered) return {};
    asked = law.ask(method, pair, first);
    if (asked.empty()) return {};
  }
  std::vector<MethodAnswer> answers;
  for (const Asked& a : asked) answers.push_back(call(method, a.pair, a.mode));
  return law.broken({method, pair, first, asked, answers, proofs});
}

}  // namespace cyl
