// SPDX-License-Identifier: MIT
#include "reports/bench.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <utility>

#if defined(__x86_64__)
#include <x86intrin.h>
#endif

#include "corpus/families.hpp"
#include "corpus/pair_io.hpp"
#include "oracles/compare.hpp"
#include "oracles/contained.hpp"

namespace cyl {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double not_measured = std::numeric_limits<double>::quiet_NaN();

/// CPU time one method may take for its passes over one family before it counts as hung.
constexpr std::chrono::milliseconds timing_cpu_cap{120'000};

/// One way of asking one method.
struct Candidate {
  std::string method;
  std::string query;
  bool foreign = false;
  Claim claim;
  unsigned share = 1;
  std::function<Method::Call(std::span<const Pair>)> prepare;  ///< not timed
};

Verdict verdict_of(const MethodAnswer& answer) {
  if (answer.status == Status::failed) throw std::runtime_error(answer.reason);
  return answer.status == Status::answered ? answer.verdict : Verdict::undecided;
}

std::vector<Candidate> candidates_of(std::span<const std::unique_ptr<Method>> methods) {
  std::vector<Candidate> candidates;
  for (const auto& method : methods) {
    Candidate candidate{std::string(method->name()),
                        "prepared",
                        method->foreign(),
                        method->claim(),
                        method->share(),
                        [&asked = *method](std::span<const Pair> pairs) { return asked.prepare_all(pairs); }};
    if (candidate.prepare({})) candidates.push_back(candidate);
    candidate.query = "raw";
    candidate.prepare = [&asked = *method](std::span<const Pair> pairs) -> Method::Call {
      return [&asked, pairs](std::size_t i) { return verdict_of(asked.ask(pairs[i])); };
    };
    candidates.push_back(candidate);
  }
  return candidates;
}

// The containment of contained.hpp asks methods about pairs. What the bench wants run in a worker is dressed
// up as a method: asked about one pair it gives a verdict, or leaves a time in `distance`.
class Contained : public Method {
 public:
  explicit Contained(std::function<MethodAnswer(const Pair&)> ask) : ask_(std::move(ask)) {}
  std::string_view name() const override { return "bench"; }
  std::string_view version() const override { return ""; }
  Claim claim() const override { return {}; }
  MethodAnswer ask(const Pair& pair) override { return ask_(pair); }

 private:
  std::function<MethodAnswer(const Pair&)> ask_;
};

std::vector<MethodAnswer> in_worker(std::function<MethodAnswer(const Pair&)> ask, std::span<const Pair> pairs,
                                    std::chrono::milliseconds cpu_cap) {
  const std::unique_ptr<Method> methods[] = {std::make_unique<Contained>(std::move(ask))};
  std::vector<Question> questions;
  for (std::size_t i = 0; i < pairs.size(); ++i) questions.push_back({0, i});
  std::vector<MethodAnswer> answers;
  for (const ContainedAnswer& c : ask_contained(methods, pairs, questions, cpu_cap))
    answers.push_back(c.answer);
  return answers;
}

std::vector<MethodAnswer> verdicts(const Candidate& candidate, std::span<const Pair> pairs) {
  return in_worker(
      [&](const Pair& pair) {
        MethodAnswer answer;
        answer.verdict = candidate.prepare({&pair, 1})(0);
        answer.status = Status::answered;
        return answer;
      },
      pairs, call_cpu_cap);
}

/// Runs `measure` in a worker; its number, or NaN where it died.
double time_in_worker(const std::function<double()>& measure) {
  const Pair none;
  const MethodAnswer answer = in_worker(
      [&](const Pair&) {
        MethodAnswer timed;
        timed.distance = measure();
        timed.has_distance = true;
        timed.status = Status::answered;
        return timed;
      },
      {&none, 1}, timing_cpu_cap)[0];
  return answer.status == Status::answered ? answer.distance : not_measured;
}

double quantile(std::vector<double> values, double q) {
  if (values.empty()) return not_measured;
  const auto rank = static_cast<std::size_t>(q * static_cast<double>(values.size() - 1) + 0.5);
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(rank), values.end());
  return values[rank];
}

volatile unsigned sink;  // what the compiler must believe is looked at

double run_all(const Method::Call& call, std::span<const std::size_t> indices) {
  unsigned sum = 0;
  for (const std::size_t i : indices) sum += static_cast<unsigned>(call(i));
  sink = sum;
  return sum;
}

/// Mean nanoseconds a call of one pass, after a pass that is not timed.
double mean_ns(const Method::Call& call, std::span<const std::size_t> indices) {
  run_all(call, indices);
  const auto start = Clock::now();
  run_all(call, indices);
  const std::chrono::duration<double, std::nano> spent = Clock::now() - start;
  return spent.count() / static_cast<double>(indices.size());
}

/// A reading of the cycle counter that no instruction moves across.
std::uint64_t ticks() {
#if defined(__x86_64__)
  _mm_lfence();
  const std::uint64_t now = __rdtsc();
  _mm_lfence();
  return now;
#else
  return static_cast<std::uint64_t>(Clock::now().time_since_epoch().count());
#endif
}

/// The 99th percentile over pairs of the least time of each in `passes`, the least time of doing nothing
/// subtracted.
double p99_ns(const Method::Call& call, std::span<const std::size_t> indices, int passes) {
  constexpr auto never = std::numeric_limits<std::uint64_t>::max();
  const Method::Call nothing = [](std::size_t) { return Verdict::undecided; };
  const auto time = [](const Method::Call& timed, std::size_t i) {
    const std::uint64_t start = ticks();
    sink = static_cast<unsigned>(timed(i));
    return ticks() - start;
  };
  std::vector<std::uint64_t> least(indices.size(), never);
  std::uint64_t empty = never;
  const auto start = Clock::now();
  const std::uint64_t start_ticks = ticks();
  for (int pass = 0; pass < passes; ++pass) {
    for (std::size_t k = 0; k < indices.size(); ++k) {
      least[k] = std::min(least[k], time(call, indices[k]));
      empty = std::min(empty, time(nothing, indices[k]));
    }
  }
  const double all_ticks = static_cast<double>(ticks() - start_ticks);
  const std::chrono::duration<double, std::nano> all = Clock::now() - start;
  std::vector<double> ns;
  for (const std::uint64_t t : least)
    ns.push_back(static_cast<double>(t - std::min(t, empty)) * all.count() / all_ticks);
  return quantile(std::move(ns), 0.99);
}

/// A family's pairs and what the referee proved of them.
struct Proved {
  std::vector<Pair> pairs;
  std::vector<Truth> truths;
};

Proved prove(const Family& family, const BenchOptions& options) {
  const auto solver = select_methods(own_methods(), "decide");
  Proved proved;
  for (std::size_t i = 0; i < options.pairs; ++i) {
    proved.pairs.push_back(family.generate(options.seed, i));
    const MethodAnswer offered[] = {solver[0]->ask(proved.pairs[i])};
    proved.truths.push_back(judge(proved.pairs[i], offered));
  }
  return proved;
}

void count_faults(const Candidate& candidate, const Proved& proved, std::span<const MethodAnswer> answers,
                  BenchRow& row) {
  for (std::size_t i = 0; i < answers.size(); ++i) {
    const Pair& pair = proved.pairs[i];
    const Truth& truth = proved.truths[i];
    row.failed += answers[i].status == Status::failed;
    row.undecided += answers[i].status == Status::answered && answers[i].verdict == Verdict::undecided;
    LazyDistance distance([&](double width) { return enclose_distance(pair, truth, width); });
    const std::optional<Finding> finding = compare(pair, truth, distance, candidate.claim, answers[i]);
    if (!finding || answers[i].status != Status::answered) continue;
    row.wrong_disjoint += finding->kind == FindingKind::wrong_disjoint;
    row.wrong_intersecting += finding->kind == FindingKind::wrong_intersecting;
    row.wrong_below_claim += finding->severity == Severity::resolution;
  }
}

/// A candidate at work on one family.
struct Run {
  Candidate candidate;
  BenchRow row;
  std::vector<std::size_t> timed;  ///< the pairs it does not fail on
  std::vector<double> passes;      ///< mean ns of each
};

std::vector<BenchRow> bench_family(const Family& family, std::span<const Candidate> candidates,
                                   const BenchOptions& options,
                                   const std::function<void(std::string_view)>& progress) {
  progress(fmt::format("{}: proving {} pairs", family.name, options.pairs));
  const Proved proved = prove(family, options);
  std::vector<Run> runs;
  for (const Candidate& candidate : candidates) {
    progress(fmt::format("{}: verifying {} ({})", family.name, candidate.method, candidate.query));
    Run run{candidate, {}, {}, {}};
    run.row.method = candidate.method;
    run.row.family = family.name;
    run.row.query = candidate.query;
    run.row.foreign = candidate.foreign;
    run.row.pairs = std::max<std::size_t>(1, options.pairs / candidate.share);
    const auto answers = verdicts(candidate, std::span(proved.pairs).first(run.row.pairs));
    count_faults(candidate, proved, answers, run.row);
    for (std::size_t i = 0; i < answers.size(); ++i) {
      if (answers[i].status == Status::answered) run.timed.push_back(i);
    }
    runs.push_back(std::move(run));
  }

  std::vector<std::size_t> all(options.pairs);
  std::iota(all.begin(), all.end(), std::size_t{0});
  std::vector<double> empty;
  for (int pass = 0; pass < options.passes; ++pass) {
    progress(fmt::format("{}: timing, pass {} of {}", family.name, pass + 1, options.passes));
    empty.push_back(
        time_in_worker([&] { return mean_ns([](std::size_t) { return Verdict::undecided; }, all); }));
    for (Run& run : runs) {
      if (run.timed.empty()) continue;
      run.passes.push_back(
          time_in_worker([&] { return mean_ns(run.candidate.prepare(proved.pairs), run.timed); }));
    }
  }
  std::vector<BenchRow> rows;
  for (Run& run : runs) {
    progress(
        fmt::format("{}: slowest pairs of {} ({})", family.name, run.candidate.method, run.candidate.query));
    run.row.median_ns = quantile(run.passes, 0.5) - quantile(empty, 0.5);
    run.row.p99_ns = run.timed.empty() ? not_measured : time_in_worker([&] {
      return p99_ns(run.candidate.prepare(proved.pairs), run.timed, options.passes);
    });
    rows.push_back(run.row);
  }
  return rows;
}

std::string number(double ns) { return std::isfinite(ns) ? fmt::format("{:.1f}", ns) : "-"; }

}  // namespace

std::vector<BenchRow> bench(const BenchOptions& options,
                            const std::function<void(std::string_view)>& progress) {
  const auto methods =
      options.methods.empty() ? all_methods() : select_methods(all_methods(), options.methods);
  const std::vector<Candidate> candidates = candidates_of(methods);
  std::vector<std::string> names;
  for (const Family& family : families()) names.emplace_back(family.name);
  std::vector<std::size_t> chosen(names.size());
  std::iota(chosen.begin(), chosen.end(), std::size_t{0});
  if (!options.families.empty()) chosen = select_names(names, options.families);
  std::vector<BenchRow> rows;
  for (const std::size_t i : chosen) {
    for (BenchRow& row : bench_family(families()[i], candidates, options, progress))
      rows.push_back(std::move(row));
  }
  return rows;
}

std::string format_bench_table(std::span<const BenchRow> rows) {
  std::map<std::pair<std::string, std::string>, double> unit;  // of (family, query)
  for (const BenchRow& row : rows) {
    if (row.method == "intersect") unit[{row.family, row.query}] = row.median_ns;
  }
  std::string text;
  std::string family;
  for (const BenchRow& row : rows) {
    if (row.family != family) {
      family = row.family;
      text += fmt::format("{}{}\n{:<30}{:<10}{:>7}{:>11}{:>11}{:>8}{:>9}{:>9}{:>9}{:>7}{:>7}\n",
                          text.empty() ? "" : "\n", family, "method", "query", "pairs", "ns/pair", "p99 ns",
                          "ratio", "disj(!)", "inter(!)", "claimed", "undec", "failed");
    }
    const auto base = unit.find({row.family, row.query});
    const double ratio = base == unit.end() ? not_measured : row.median_ns / base->second;
    text +=
        fmt::format("{:<30}{:<10}{:>7}{:>11}{:>11}{:>8}{:>9}{:>9}{:>9}{:>7}{:>7}\n", row.method, row.query,
                    row.pairs, number(row.median_ns), number(row.p99_ns), number(ratio), row.wrong_disjoint,
                    row.wrong_intersecting, row.wrong_below_claim, row.undecided, row.failed);
  }
  return text +
         "\nns/pair: median of the passes' means. p99: over pairs. ratio: times the ns of `intersect`, same "
         "query.\n"
         "prepared: shapes are built before the clock starts. raw: inside the call, as a foreign method's "
         "adapter\n"
         "does it. disj(!), inter(!): wrongly said disjoint, intersecting; claimed: of these, within its own "
         "claim.\n";
}

std::string format_bench_row(const BenchRow& row) {
  const auto json = [](double ns) { return std::isfinite(ns) ? format_double(ns) : std::string("null"); };
  return fmt::format(
      R"({{"method":{},"family":{},"query":{},"foreign":{},"n":{},"median_ns":{},"p99_ns":{},)"
      R"("wrong_disjoint":{},"wrong_intersecting":{},"wrong_below_claim":{},"undecided":{},"failed":{}}})",
      quote_json(row.method), quote_json(row.family), quote_json(row.query), row.foreign, row.pairs,
      json(row.median_ns), json(row.p99_ns), row.wrong_disjoint, row.wrong_intersecting,
      row.wrong_below_claim, row.undecided, row.failed);
}

}  // namespace cyl
