// SPDX-License-Identifier: MIT
#include "props/laws/examine.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace cyl {
namespace {

/// The questions of one law to one method about one pair. They are consecutive in the second round.
struct Job {
  std::size_t method, pair;
  const Law* law;
  std::vector<LawQuery> asked;
  std::size_t first_question = 0;
};

void count(AnswerCounts& counts, const ContainedAnswer& said) {
  if (!said.asked) return;
  const MethodAnswer& answer = said.answer;
  ++counts.asked;
  counts.declined += answer.status == Status::declined;
  counts.failed += answer.status == Status::failed;
  if (answer.status == Status::answered) ++counts.said[static_cast<std::size_t>(answer.verdict)];
}

void count_loss(AnswerCounts& counts, const ContainedAnswer& said) {
  counts.crashes += said.answer.failure == Failure::crash;
  if (said.answer.failure != Failure::hang) return;
  ++counts.hangs;
  counts.hung_seconds += said.nanoseconds * 1e-9;
}

/// The two rounds of questions, and the results of the laws.
class Examination {
 public:
  Examination(std::span<const std::unique_ptr<Method>> methods, std::span<const Pair> pairs,
              const LawFilter& wanted, Asker& asker)
      : methods_(methods), pairs_(pairs), wanted_(wanted), asker_(asker), offers_(methods) {
    result_.counts.resize(methods.size());
    result_.truths.resize(pairs.size());
    result_.answers.resize(methods.size() * pairs.size());
  }

  Examined run() {
    ask_pairs();
    make_jobs();
    ask_further();
    // Goes by pair, so that what is proved of a pair serves all methods.
    std::vector<std::vector<const Job*>> by_pair(pairs_.size());
    for (const Job& job : jobs_) by_pair[job.pair].push_back(&job);
    for (std::size_t p = 0; p < pairs_.size(); ++p) hold_to_laws(p, by_pair[p]);
    return std::move(result_);
  }

 private:
  MethodAnswer& answer(std::size_t m, std::size_t p) { return result_.answers[p * methods_.size() + m]; }

  // Goes method by method, so that each worker stays with one library.
  void ask_pairs() {
    std::vector<Question> questions;
    for (std::size_t m = 0; m < methods_.size(); ++m) {
      const auto wanted_of_it = [&](const Law& law) { return wanted_(m, law); };
      if (std::none_of(all_laws().begin(), all_laws().end(), wanted_of_it)) continue;
      for (std::size_t p = 0; p < pairs_.size(); ++p) {
        if (methods_[m]->supports(pairs_[p]))
          questions.push_back({m, p});
        else
          answer(m, p) = methods_[m]->decline(pairs_[p]);
      }
    }
    const std::vector<ContainedAnswer> said = asker_.ask(pairs_, questions);
    for (std::size_t q = 0; q < questions.size(); ++q) {
      answer(questions[q].method, questions[q].pair) = said[q].answer;
      count(result_.counts[questions[q].method], said[q]);
      count_loss(result_.counts[questions[q].method], said[q]);
    }
  }

  void make_jobs() {
    for (std::size_t m = 0; m < methods_.size(); ++m)
      for (std::size_t p = 0; p < pairs_.size(); ++p) {
        if (!methods_[m]->supports(pairs_[p])) continue;
        for (const Law& law : all_laws())
          if (wanted_(m, law)) add_job({m, p, &law, {}});
      }
  }

  void add_job(Job job) {
    if (job.law->queries != needs_none) {
      const MethodAnswer& first = answer(job.method, job.pair);
      if (first.status != Status::answered) return;
      job.asked = job.law->queries(*methods_[job.method], pairs_[job.pair], first);
      if (job.asked.empty()) return;
      job.first_question = further_.size();
      for (const LawQuery& asked : job.asked) {
        further_.push_back({job.method, changed_.size(), asked.mode});
        changed_.push_back(asked.pair);
      }
    }
    jobs_.push_back(std::move(job));
  }

  void ask_further() {
    const std::vector<ContainedAnswer> said = asker_.ask(changed_, further_);
    for (std::size_t q = 0; q < further_.size(); ++q) {
      further_answers_.push_back(said[q].answer);
      count_loss(result_.counts[further_[q].method], said[q]);
    }
  }

  void hold_to_laws(std::size_t p, const std::vector<const Job*>& jobs) {
    const auto said = std::span(result_.answers).subspan(p * methods_.size(), methods_.size());
    Proofs proofs(pairs_[p], offers_.with_own_witness(pairs_[p], said));
    for (const Job* job : jobs) {
      const auto answers = std::span(further_answers_).subspan(job->first_question, job->asked.size());
      const LawCase c{*methods_[job->method], pairs_[p], answer(job->method, p), job->asked, answers, proofs};
      auto violation = violation_on(*job->law, c);
      if (!violation) continue;
      result_.violations.push_back(
          {job->method, p, job->law, std::move(*violation), job->asked, {answers.begin(), answers.end()}});
    }
    if (const Trial* proved = proofs.known(pairs_[p])) result_.truths[p] = proved->truth.verdict;
  }

  static std::optional<Violation> violation_on(const Law& law, const LawCase& c) {
    const auto failed = std::ranges::find(c.answers, Status::failed, &MethodAnswer::status);
    if (failed == c.answers.end()) return law.check(c);
    return Violation{fmt::format("fails on a changed pair: {}", failed->reason), Severity::contract,
                     finding_of(failed->failure), failed->reason};
  }

  std::span<const std::unique_ptr<Method>> methods_;
  std::span<const Pair> pairs_;
  const LawFilter& wanted_;
  Asker& asker_;
  WitnessSet offers_;
  std::vector<Job> jobs_;
  // For the second round: the pairs that the laws made.
  std::vector<Pair> changed_;
  std::vector<Question> further_;
  std::vector<MethodAnswer> further_answers_;
  Examined result_;
};

}  // namespace

AnswerCounts& AnswerCounts::operator+=(const AnswerCounts& other) {
  asked += other.asked;
  declined += other.declined;
  failed += other.failed;
  hangs += other.hangs;
  crashes += other.crashes;
  hung_seconds += other.hung_seconds;
  for (std::size_t i = 0; i < said.size(); ++i) said[i] += other.said[i];
  return *this;
}

Examined examine(std::span<const std::unique_ptr<Method>> methods, std::span<const Pair> pairs,
                 const LawFilter& wanted, Asker& asker) {
  return Examination(methods, pairs, wanted, asker).run();
}

Examined examine(std::span<const std::unique_ptr<Method>> methods, std::span<const Pair> pairs,
                 const LawFilter& wanted, const Caps& caps) {
  Asker asker(methods, caps);
  return examine(methods, pairs, wanted, asker);
}

std::optional<Violation> violation_of(Method& method, const Law& law, const Pair& pair) {
  const MethodAnswer first = method.ask(pair);
  Proofs proofs(pair, {&first, 1});
  std::vector<LawQuery> asked;
  if (law.queries != needs_none) {
    if (first.status != Status::answered) return {};
    asked = law.queries(method, pair, first);
    if (asked.empty()) return {};
  }
  std::vector<MethodAnswer> answers;
  for (const LawQuery& a : asked) answers.push_back(call(method, a.pair, a.mode));
  return law.check({method, pair, first, asked, answers, proofs});
}

}  // namespace cyl
