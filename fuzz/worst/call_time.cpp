// SPDX-License-Identifier: MIT
#include "fuzz/worst/call_time.hpp"

#include <algorithm>
#include <ctime>
#include <limits>
#include <utility>
#include <vector>

#include "base/statistics.hpp"
#include "corpus/pairs/families.hpp"
#include "oracles/methods/contained.hpp"

namespace cyl {
namespace {

/// A call is timed this often, and its least time counts. Calls that take too long are timed less often.
constexpr int timed_calls = 3;
constexpr double repeat_ns_cap = 1e8;
constexpr int clock_looks = 8;

/// Answers with the time of a call as the distance.
class Timed final : public Method {
 public:
  Timed(Method& method, double (*clock)()) : Method(method.name_parts()), method_(method), clock_(clock) {}
  std::string_view version() const override { return method_.version(); }
  Claim claim() const override { return method_.claim(); }
  bool supports(SolidKind kind) const override { return method_.supports(kind); }
  MethodAnswer answer(const Pair& pair) override {
    MethodAnswer answer;
    const double reading = least_time(clock_looks, [] {});
    const double least = least_time(timed_calls, [&] { answer = method_.ask(pair); });
    answer.has_distance = true;
    answer.distance = std::max(0.0, least - reading);
    answer.witness = CertificateKind::none;
    return answer;
  }

 private:
  template <class Call>
  double least_time(int times, Call call) const {
    double least = std::numeric_limits<double>::infinity(), all = 0;
    for (int i = 0; i < times && all < repeat_ns_cap; ++i) {
      const double start = clock_();
      call();
      const double ns = clock_() - start;
      least = std::min(least, ns);
      all += ns;
    }
    return least;
  }

  Method& method_;
  double (*clock_)();
};

double nanoseconds_on(clockid_t clock) {
  timespec t{};
  clock_gettime(clock, &t);
  return 1e9 * static_cast<double>(t.tv_sec) + static_cast<double>(t.tv_nsec);
}

}  // namespace

double cpu_clock() { return nanoseconds_on(CLOCK_PROCESS_CPUTIME_ID); }
double wall_clock() { return nanoseconds_on(CLOCK_MONOTONIC); }

std::unique_ptr<Method> timed(Method& method, double (*clock)()) {
  return std::make_unique<Timed>(method, clock);
}

std::optional<double> usual_ns(const std::unique_ptr<Method>& method, double (*clock)()) {
  constexpr std::uint64_t count = 101, seed = 1;
  const std::unique_ptr<Method> asked = timed(*method, clock);
  std::vector<Pair> pairs;
  std::vector<Question> questions;
  for (std::uint64_t i = 0; i < count; ++i) {
    questions.push_back({0, pairs.size()});
    pairs.push_back(find_family("random")->generate(seed, i));
  }
  std::vector<double> ns;
  for (const ContainedAnswer& said : ask_contained({&asked, 1}, pairs, questions, {.hangs = 1}))
    if (said.answer.status == Status::answered) ns.push_back(said.answer.distance);
  if (ns.empty()) return {};
  return quantile(std::move(ns), 0.5);
}

}  // namespace cyl
