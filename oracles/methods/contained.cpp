// SPDX-License-Identifier: MIT
#include "oracles/methods/contained.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <map>
#include <string>
#include <thread>

#include "oracles/methods/worker.hpp"

namespace cyl {
namespace {

bool all_finite(const MethodAnswer& a) {
  const auto finite = [](double x) { return std::isfinite(x); };
  return (!a.states_distance() || finite(a.distance)) &&
         (a.witness == CertificateKind::none ||
          (std::all_of(a.head, a.head + 3, finite) && std::all_of(a.tail, a.tail + 3, finite) &&
           std::all_of(a.other_head, a.other_head + 3, finite) &&
           std::all_of(a.other_tail, a.other_tail + 3, finite)));
}

bool well_formed(const MethodAnswer& a) {
  return a.status <= Status::failed && a.failure <= Failure::reported && a.verdict <= Verdict::invalid &&
         a.witness <= CertificateKind::points && a.witness != CertificateKind::near &&
         a.hulls[0] <= Hull::center && a.hulls[1] <= Hull::center && a.side_effect <= SideEffect::thread;
}

MethodAnswer cannot_be_called_so() { return declined_answer("cannot be asked this way"); }

/// The number of lines that are sent to a program before the first of them must be answered.
constexpr std::size_t ahead_cap = 64;

/// A batch of one would show no mix-up of pairs or lanes, so this pair is in the other places. It is a wall
/// beside a rim, with which our kernel is busy for three steps.
const Pair company{{Vector3(0, 0, 0), Vector3(0, 0, 1), 5, 1}, {Vector3(-5, 5, 1), Vector3(1, -5, 1), 1, 10}};

/// The places of the pair that is asked about: within lanes of four and eight, and in the rest.
constexpr std::size_t batch_size = 9, asked_places[] = {1, 4, 8};

}  // namespace

MethodAnswer call(Method& method, const Pair& pair, CallMode mode) {
  switch (mode) {
    case CallMode::usual:
      break;
    case CallMode::other_thread: {
      MethodAnswer answer;
      std::exception_ptr thrown;
      std::thread([&] {
        try {
          answer = method.ask(pair);
        } catch (...) {
          thrown = std::current_exception();
        }
      }).join();
      if (thrown) std::rethrow_exception(thrown);
      return answer;
    }
    case CallMode::prepared: {
      const Method::Call call = method.prepare_all({&pair, 1});
      return call ? answered(call(0)) : cannot_be_called_so();
    }
    case CallMode::batch: {
      std::array<Pair, batch_size> pairs;
      pairs.fill(company);
      for (const std::size_t place : asked_places) pairs[place] = pair;
      const Method::BatchCall call = method.prepare_batch(pairs);
      if (!call) return cannot_be_called_so();
      std::array<Verdict, batch_size> verdicts;
      verdicts.fill(Verdict::undecided);
      call(verdicts);
      const Verdict first = verdicts[asked_places[0]];
      const auto same = [&](std::size_t place) { return verdicts[place] == first; };
      if (std::ranges::all_of(asked_places, same)) return answered(first);
      const Verdict alone = method.ask(pair).verdict;  // at least one place has another verdict
      const auto other = [&](std::size_t place) { return verdicts[place] != alone; };
      return answered(verdicts[*std::ranges::find_if(asked_places, other)]);
    }
  }
  return method.ask(pair);
}

MethodAnswer checked(MethodAnswer answer) {
  answer.reason[sizeof answer.reason - 1] = 0;
  if (!well_formed(answer)) {
    return failed_answer(Failure::malformed,
                         "no answer: status " + std::to_string(static_cast<int>(answer.status)) +
                             ", verdict " + std::to_string(static_cast<int>(answer.verdict)) + ", witness " +
                             std::to_string(static_cast<int>(answer.witness)));
  }
  if (answer.status == Status::answered && !all_finite(answer)) {
    answer.status = Status::failed;
    answer.failure = Failure::non_finite;
    answer.set_reason(answer.states_distance() && !std::isfinite(answer.distance)
                          ? "distance is " + std::to_string(answer.distance)
                          : "the witness is not finite");
  }
  return answer;
}

MethodAnswer ask_noexcept(Method& method, const Pair& pair, CallMode mode) {
  try {
    return checked(call(method, pair, mode));
  } catch (const std::exception& e) {
    return failed_answer(Failure::exception, e.what());
  } catch (...) {
    return failed_answer(Failure::exception, "thrown: not a std::exception");
  }
}

std::chrono::milliseconds cpu_cap_of(const Method& method) {
  return method.is_out_of_process() || method.guest() ? call_cpu_cap : library_cpu_cap;
}

static Caps caps_of_libraries(Caps caps) {
  caps.call_cpu = std::min(caps.call_cpu, library_cpu_cap);
  return caps;
}

/// The workers, and the methods that each of them asks.
class Asker::Parts {
 public:
  Parts(std::span<const std::unique_ptr<Method>> methods, const Caps& caps)
      : methods_(methods), caps_(caps), common_(methods, false, caps_of_libraries(caps)) {}

  std::vector<ContainedAnswer> ask(std::span<const Pair> pairs, std::span<const Question> questions) {
    std::vector<ContainedAnswer> answers(questions.size());
    hangs_.assign(methods_.size(), 0);
    crashes_.assign(methods_.size(), 0);
    // The questions for one worker stay together, so that blocks are full.
    std::map<Worker*, std::vector<std::size_t>> of_worker;
    std::vector<Worker*> in_order;
    for (std::size_t i = 0; i < questions.size(); ++i) {
      Worker* const worker = worker_of(questions[i].method);
      auto& queue = of_worker[worker];
      if (queue.empty()) in_order.push_back(worker);
      queue.push_back(i);
    }
    for (Worker* const worker : in_order) {
      if (worker)
        ask_worker(*worker, of_worker[worker], pairs, questions, answers);
      else
        ask_here(of_worker[worker], pairs, questions, answers);
    }
    return answers;
  }

 private:
  Worker* worker_of(std::size_t m) {
    if (methods_[m]->is_out_of_process()) return nullptr;
    if (!methods_[m]->guest()) return &common_;
    return &guests_.try_emplace(m, methods_, true, caps_).first->second;
  }

  bool given_up(std::size_t m) const {
    return hangs_[m] >= caps_.hangs || crashes_[m] >= caps_.program_crashes || caps_.out_of_time();
  }
  ContainedAnswer gave_up(std::size_t m) const {
    ContainedAnswer said;
    said.asked = false;
    if (caps_.out_of_time())
      said.answer.set_reason("no time was left");
    else
      said.answer.set_reason("not asked any more after " + std::to_string(hangs_[m]) + " hangs and " +
                             std::to_string(crashes_[m]) + " crashes");
    return said;
  }
  void count_hang(std::size_t m, ContainedAnswer& said) {
    if (said.answer.failure != Failure::hang || ++hangs_[m] != caps_.hangs) return;
    said.answer.set_reason(std::string(said.answer.reason) +
                           "; not asked about the pairs after it, for it was hang " +
                           std::to_string(hangs_[m]));
  }

  void ask_worker(Worker& worker, std::span<const std::size_t> queue, std::span<const Pair> pairs,
                  std::span<const Question> questions, std::vector<ContainedAnswer>& answers) {
    std::vector<std::size_t> block;
    std::vector<Question> posted;
    for (std::size_t next = 0; next < queue.size();) {
      block.clear();
      posted.clear();
      for (; next < queue.size() && block.size() < block_cap; ++next) {
        const Question& q = questions[queue[next]];
        if (given_up(q.method)) {
          answers[queue[next]] = gave_up(q.method);
          continue;
        }
        block.push_back(next);
        posted.push_back(q);
      }
      if (block.empty()) break;
      const std::vector<ContainedAnswer> said = worker.ask(pairs, posted);
      for (std::size_t i = 0; i < said.size(); ++i) {
        answers[queue[block[i]]] = said[i];
        count_hang(posted[i].method, answers[queue[block[i]]]);
      }
      if (said.size() < block.size()) next = block[said.size()];
    }
  }

  void ask_here(std::span<const std::size_t> queue, std::span<const Pair> pairs,
                std::span<const Question> questions, std::vector<ContainedAnswer>& answers) {
    std::size_t stretch = ahead_cap;  // few after a failure, because the next ones are likely to share it
    for (std::size_t at = 0; at < queue.size();) {
      const Question& q = questions[queue[at]];
      std::size_t end = at + 1;
      while (end < queue.size() && end - at < stretch && q.mode == CallMode::usual &&
             questions[queue[end]].method == q.method && questions[queue[end]].mode == q.mode)
        ++end;
      if (given_up(q.method)) {
        answers[queue[at++]] = gave_up(q.method);
        continue;
      }
      std::vector<Pair> asked;
      for (std::size_t i = at; i < end; ++i) asked.push_back(pairs[questions[queue[i]].pair]);
      const std::vector<ContainedAnswer> said = ask_stretch(*methods_[q.method], asked, q.mode);
      bool broke = false;
      for (std::size_t i = 0; i < said.size(); ++i) {
        answers[queue[at + i]] = said[i];
        count_hang(q.method, answers[queue[at + i]]);
        broke = broke || said[i].answer.status == Status::failed;
        crashes_[q.method] += said[i].answer.failure == Failure::crash;
      }
      at += said.size();
      stretch = broke ? 1 : std::min(ahead_cap, 2 * stretch);
    }
  }

  /// Asks about all pairs, or about the pairs up to a failure.
  static std::vector<ContainedAnswer> ask_stretch(Method& method, std::span<const Pair> pairs,
                                                  CallMode mode) {
    const std::chrono::nanoseconds start = method.cpu_time();
    std::vector<MethodAnswer> answers(pairs.size());
    if (mode != CallMode::usual)
      answers[0] = ask_noexcept(method, pairs[0], mode);
    else
      answers.resize(method.ask_many(pairs, answers));
    const double spent = static_cast<double>((method.cpu_time() - start).count());
    std::vector<ContainedAnswer> said;
    for (const MethodAnswer& answer : answers)
      said.push_back({checked(answer), std::max(0.0, spent) / static_cast<double>(answers.size())});
    return said;
  }

  std::span<const std::unique_ptr<Method>> methods_;
  const Caps caps_;
  Worker common_;
  std::map<std::size_t, Worker> guests_;
  std::vector<unsigned> hangs_, crashes_;  ///< of the methods, in this call of ask()
};

Asker::Asker(std::span<const std::unique_ptr<Method>> methods, const Caps& caps)
    : parts_(std::make_unique<Parts>(methods, caps)) {}
Asker::~Asker() = default;
Asker::Asker(Asker&&) noexcept = default;
Asker& Asker::operator=(Asker&&) noexcept = default;

std::vector<ContainedAnswer> Asker::ask(std::span<const Pair> pairs, std::span<const Question> questions) {
  return parts_->ask(pairs, questions);
}

std::vector<ContainedAnswer> ask_contained(std::span<const std::unique_ptr<Method>> methods,
                                           std::span<const Pair> pairs, std::span<const Question> questions,
                                           const Caps& caps) {
  return Asker(methods, caps).ask(pairs, questions);
}

}  // namespace cyl
