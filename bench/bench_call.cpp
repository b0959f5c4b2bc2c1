// SPDX-License-Identifier: MIT
#include "bench/bench_call.hpp"

#include <sys/mman.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <system_error>
#include <utility>
#include <variant>

#include "oracles/methods/contained.hpp"

namespace cyl {
namespace {

/// The CPU time that a round may take beyond the time to fill. After that the method counts as hung.
constexpr std::chrono::milliseconds timing_cpu_cap{120'000};

Verdict verdict_of(const MethodAnswer& answer) {
  if (answer.status == Status::failed) throw std::runtime_error(answer.reason);
  return answer.status == Status::answered ? answer.verdict : Verdict::undecided;
}

using AnyCall = std::variant<Method::Call, Method::DistanceCall, Method::BatchCall>;

/// Prepares the calls, which is not timed.
AnyCall prepare(const Candidate& candidate, std::span<const Pair> pairs) {
  Method& method = *candidate.method;
  if (asks_distance(candidate)) return method.prepare_distances(pairs);
  if (candidate.query == "batch") return method.prepare_batch(pairs);
  if (candidate.query != "raw") {
    if (Method::Call call = method.prepare_all(pairs)) return call;
  }
  return Method::Call([&method, pairs](std::size_t i) { return verdict_of(method.ask(pairs[i])); });
}

// The containment of contained.hpp asks methods about pairs. This class makes a method of any work that the
// bench runs in a worker.
class Contained : public Method {
 public:
  using Ask = std::function<MethodAnswer(const Pair&)>;
  explicit Contained(Ask ask) : Method({"bench"}), ask_(std::move(ask)) {}
  std::string_view version() const override { return ""; }
  Claim claim() const override { return {}; }
  bool supports(SolidKind) const override { return true; }
  MethodAnswer answer(const Pair& pair) override { return ask_(pair); }

 private:
  Ask ask_;
};

std::vector<MethodAnswer> in_worker(Contained::Ask ask, std::span<const Pair> pairs,
                                    std::chrono::milliseconds cpu_cap) {
  const std::unique_ptr<Method> methods[] = {std::make_unique<Contained>(std::move(ask))};
  std::vector<Question> questions;
  for (std::size_t i = 0; i < pairs.size(); ++i) questions.push_back({0, i});
  std::vector<MethodAnswer> answers;
  for (const ContainedAnswer& c : ask_contained(methods, pairs, questions, {.call_cpu = cpu_cap}))
    answers.push_back(c.answer);
  return answers;
}

/// Runs `measure` in a worker. Returns its three numbers, or NaN if the worker died.
using Numbers = std::array<double, 3>;
Numbers in_worker(const std::function<Numbers()>& measure, double seconds) {
  const Pair none;
  const MethodAnswer answer = in_worker(
      [&](const Pair&) {
        const Numbers measured = measure();
        MethodAnswer carrier;
        carrier.status = Status::answered;
        std::copy(measured.begin(), measured.end(), carrier.head);
        return carrier;
      },
      {&none, 1}, timing_cpu_cap + std::chrono::milliseconds(static_cast<int>(1000 * seconds)))[0];
  if (answer.status != Status::answered) return {not_measured, not_measured, not_measured};
  return {answer.head[0], answer.head[1], answer.head[2]};
}

/// Bytes that a worker writes and its parent reads.
class SharedVerdicts {
 public:
  explicit SharedVerdicts(std::size_t count) : count_(count) {
    memory_ = mmap(nullptr, count, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (memory_ == MAP_FAILED) throw std::system_error(errno, std::generic_category(), "mmap");
    std::fill_n(static_cast<Verdict*>(memory_), count, Verdict::undecided);
  }
  ~SharedVerdicts() { munmap(memory_, count_); }
  SharedVerdicts(const SharedVerdicts&) = delete;
  SharedVerdicts& operator=(const SharedVerdicts&) = delete;
  std::span<Verdict> all() const { return {static_cast<Verdict*>(memory_), count_}; }

 private:
  std::size_t count_;
  void* memory_;
};

/// Writes the verdicts of a batch into `verdicts`. The answer states whether the batch came to its end.
MethodAnswer ask_batch(const Candidate& candidate, std::span<const Pair> pairs, std::span<Verdict> verdicts) {
  const Pair none;
  return in_worker(
      [&](const Pair&) {
        std::get<Method::BatchCall>(prepare(candidate, pairs))(verdicts);
        MethodAnswer done;
        done.status = Status::answered;
        return done;
      },
      {&none, 1}, timing_cpu_cap)[0];
}

MethodAnswer answer_of(const AnyCall& call) {
  MethodAnswer answer;
  answer.status = Status::answered;
  if (const auto* yes_no = std::get_if<Method::Call>(&call)) {
    answer.verdict = (*yes_no)(0);
  } else {
    answer.distance = std::get<Method::DistanceCall>(call)(0);
    answer.has_distance = !std::isnan(answer.distance);
    answer.verdict = answer.distance > 0 ? Verdict::disjoint : Verdict::intersecting;
    if (!answer.has_distance) answer.status = Status::declined;
  }
  return answer;
}

/// The calls that a row times: all of them, and the i-th alone.
struct Work {
  Series series;
  std::function<void(std::size_t)> one;
};

Work work_of(AnyCall prepared) {
  const auto any = std::make_shared<AnyCall>(std::move(prepared));  // copying it may copy every shape
  const auto work = [&]<class Number>(const auto* call, Number) -> Work {
    return {[any, call](std::span<const std::size_t> order) {
              Number sum = 0;
              for (const std::size_t i : order) sum += static_cast<Number>((*call)(i));
              keep(sum);
            },
            [any, call](std::size_t i) { keep(static_cast<Number>((*call)(i))); }};
  };
  if (const auto* call = std::get_if<Method::Call>(any.get())) return work(call, 0u);
  if (const auto* call = std::get_if<Method::DistanceCall>(any.get())) return work(call, 0.0);
  return {};
}

/// Returns batches of the same pairs in orders of their own, as many as fit into `batch_pairs`, taken in
/// rotation.
Series batch_work(const Candidate& candidate, std::span<const Pair> pairs) {
  constexpr std::size_t batch_pairs = 20'000;
  std::vector<Method::BatchCall> batches;
  std::vector<std::size_t> order(pairs.size());
  std::size_t stride = 0;
  do {
    shuffle(order, stride);
    std::vector<Pair> shuffled;
    for (const std::size_t i : order) shuffled.push_back(pairs[i]);
    batches.push_back(candidate.method->prepare_batch(shuffled));
  } while ((batches.size() + 1) * pairs.size() <= batch_pairs);
  return [batches = std::move(batches), verdicts = std::vector<Verdict>(pairs.size()),
          next = std::size_t{0}](std::span<const std::size_t>) mutable {
    batches[next](verdicts);
    next = (next + 1) % batches.size();
    keep(static_cast<unsigned>(verdicts[0]));
  };
}

}  // namespace

std::vector<Candidate> candidates_of(std::span<const std::unique_ptr<Method>> methods) {
  std::vector<Candidate> candidates;
  for (const auto& m : methods) {
    Method* method = m.get();
    const bool prepares = bool(method->prepare_all({}));
    candidates.push_back({method, prepares && method->claim().certified ? "certificate" : "verdict"});
    if (prepares) candidates.push_back({method, "raw"});
    if (method->prepare_distances({})) {
      candidates.push_back({method, "distance"});
      candidates.push_back({method, "depth"});
    }
    if (method->prepare_batch({})) candidates.push_back({method, "batch"});
  }
  return candidates;
}

std::vector<MethodAnswer> ask_all(const Candidate& candidate, std::span<const Pair> pairs) {
  if (candidate.query != "batch") {
    return in_worker(
        [&](const Pair& pair) {
          return answer_of(prepare(candidate, {&pair, 1}));
        },
        pairs, call_cpu_cap);
  }
  const SharedVerdicts verdicts(pairs.size());
  std::vector<MethodAnswer> answers(pairs.size(), ask_batch(candidate, pairs, verdicts.all()));
  for (std::size_t i = 0; i < pairs.size(); ++i) answers[i].verdict = verdicts.all()[i];
  return answers;
}

Cost time_round(const Candidate& candidate, std::span<const Pair> pairs, double seconds) {
  const Numbers numbers = in_worker(
      [&]() -> Numbers {
        const Series series = candidate.query == "batch" ? batch_work(candidate, pairs)
                                                         : work_of(prepare(candidate, pairs)).series;
        const Cost cost = series_cost(series, pairs.size(), std::chrono::duration<double>(seconds));
        return {cost.ns, cost.instructions, 0};
      },
      seconds);
  return {numbers[0], numbers[1]};
}

Cost time_nothing(std::size_t count, double seconds) {
  const Method::Call nothing = [](std::size_t) { return Verdict::undecided; };
  return series_cost(work_of(nothing).series, count, std::chrono::duration<double>(seconds));
}

CallTimes time_each(const Candidate& candidate, std::span<const Pair> pairs, int passes) {
  if (candidate.query == "batch") return {};
  const auto each = [&]() -> Numbers {
    const CallTimes times = time_calls(work_of(prepare(candidate, pairs)).one, pairs.size(), passes);
    return {times.p50_ns, times.p99_ns, times.max_ns};
  };
  const Numbers numbers = in_worker(each, 0);
  return {numbers[0], numbers[1], numbers[2]};
}

}  // namespace cyl
