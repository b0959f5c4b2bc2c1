// SPDX-License-Identifier: MIT
#include "bench/bench.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "base/statistics.hpp"
#include "bench/bench_call.hpp"
#include "oracles/trial/trial.hpp"

namespace cyl {
namespace {

/// The width, relative to the size, of the enclosures with which distances and margins are compared. It is
/// the resolution of doubles. The enclosures that come back are some 3e-14 wide.
constexpr double enclosure_width = 1e-15;

/// A pair and the facts about it that the referee proved.
struct JudgedPair : Trial {
  using Trial::Trial;
  std::optional<Enclosure> narrow{};  ///< filled when first asked for
};

JudgedPair prove(const Pair& pair) {
  static const auto solver = certifying_method();
  const MethodAnswer offered[] = {solver->ask(pair)};
  return JudgedPair(pair, offered);
}

const Enclosure& distance_of(JudgedPair& p) {
  if (!p.narrow) p.narrow = enclose_distance(p.pair, p.truth, enclosure_width);
  return *p.narrow;
}

void count_faults(JudgedPair& proved, MethodAnswer answer, const Claim& claim, BenchRow& row) {
  if (answer.status != Status::answered) {
    ++(answer.status == Status::failed ? row.failed : row.undecided);
    return;
  }
  row.undecided += answer.verdict == Verdict::undecided;
  const double size = size_of(proved.pair);
  if (answer.has_distance && size > 0) {
    const Enclosure& real = distance_of(proved);
    const double said = answer.distance;
    row.max_error = std::fmax(row.max_error, std::max({0.0, real.lo - said, said - real.hi}) / size);
    row.max_error_at_most = std::fmax(row.max_error_at_most, std::max(real.hi - said, said - real.lo) / size);
  }
  answer.has_distance = false;
  const std::optional<Finding> finding = compare(proved, claim, answer);
  if (!finding) return;
  if (finding->kind == FindingKind::wrong_invalid) ++row.undecided;
  const bool disjoint = finding->kind == FindingKind::wrong_disjoint;
  if (!disjoint && finding->kind != FindingKind::wrong_intersecting) return;
  ++(disjoint ? row.wrong_disjoint : row.wrong_intersecting);
  row.wrong_below_claim += finding->severity == Severity::resolution;
  const Enclosure& real = distance_of(proved);
  row.wrong_at_margin += std::max(-real.lo, real.hi) >= right_from(row.family) * size;
}

/// A candidate at work on one family.
struct Run {
  Candidate candidate;
  BenchRow row;
  std::vector<Pair> timed;  ///< the pairs it does not fail on
  std::vector<Cost> rounds;
};

std::vector<double> values(std::span<const Cost> costs, double Cost::*field) {
  std::vector<double> finite;
  for (const Cost& cost : costs) {
    if (std::isfinite(cost.*field)) finite.push_back(cost.*field);
  }
  return finite;
}

Cost median(std::span<const Cost> costs) {
  return {quantile(values(costs, &Cost::ns), 0.5), quantile(values(costs, &Cost::instructions), 0.5)};
}

BenchRow make_row(const Candidate& candidate, std::string_view family) {
  BenchRow row;
  row.method = candidate.method->name();
  row.name = candidate.method->name_parts();
  row.family = family;
  row.query = candidate.query;
  row.foreign = candidate.method->foreign();
  return row;
}

void time(std::span<Run> runs, std::string_view family, std::size_t pairs, const BenchOptions& options,
          const BenchProgress& progress) {
  const double seconds = options.min_time / options.passes;
  std::vector<Cost> empty;
  for (int pass = 0; pass < options.passes; ++pass) {
    progress(fmt::format("{}: timing, pass {} of {}", family, pass + 1, options.passes));
    empty.push_back(time_nothing(pairs, seconds));
    for (Run& run : runs) {
      if (!run.timed.empty()) run.rounds.push_back(time_round(run.candidate, run.timed, seconds));
    }
  }
  for (Run& run : runs) {
    if (run.timed.empty()) continue;
    progress(fmt::format("{}: slowest pairs of {} ({})", family, run.row.method, run.row.query));
    const Cost nothing = run.candidate.query == "batch" ? Cost{0, 0} : median(empty);
    const Cost round = median(run.rounds);
    run.row.median_ns = round.ns - nothing.ns;
    run.row.instructions = round.instructions - nothing.instructions;
    run.row.spread_percent = spread_percent(values(run.rounds, &Cost::ns));
    if (options.shapes) continue;
    const CallTimes each = time_each(run.candidate, run.timed, options.passes);
    run.row.p50_ns = each.p50_ns;
    run.row.p99_ns = each.p99_ns;
    run.row.max_ns = each.max_ns;
  }
}

/// Asks one candidate and verifies its answers. Returns nothing if it is asked nothing or gives no distance.
std::optional<Run> verify(const Candidate& candidate, std::string_view family, std::span<JudgedPair> proved,
                          std::size_t least) {
  Run run{candidate, make_row(candidate, family), {}, {}};
  std::vector<std::size_t> asked;
  const std::size_t share = std::max<std::size_t>(1, proved.size() / candidate.method->share());
  for (std::size_t i = 0; i < std::min(proved.size(), std::max(share, least)); ++i) {
    if (!candidate.method->supports(proved[i].pair)) continue;
    const bool disjoint = proved[i].truth.verdict == Verdict::disjoint;
    if (!asks_distance(candidate) || (candidate.query == "distance") == disjoint) asked.push_back(i);
  }
  if (asked.empty()) return {};
  std::vector<Pair> pairs;
  for (const std::size_t i : asked) pairs.push_back(proved[i].pair);
  const std::vector<MethodAnswer> answers = ask_all(candidate, pairs);
  for (std::size_t k = 0; k < asked.size(); ++k) {
    count_faults(proved[asked[k]], answers[k], candidate.method->claim(), run.row);
    if (answers[k].status == Status::answered) run.timed.push_back(pairs[k]);
  }
  if (run.timed.size() > std::max(share, costly_timed)) run.timed.resize(std::max(share, costly_timed));
  run.row.pairs = asked.size();
  const bool gives_none = asks_distance(candidate) && run.row.undecided == asked.size();
  if (gives_none) return {};
  return run;
}

std::vector<BenchRow> bench_pairs(std::string_view family, std::vector<JudgedPair>& proved,
                                  std::span<const Candidate> candidates, const BenchOptions& options,
                                  const BenchProgress& progress) {
  std::vector<Run> runs;
  for (const Candidate& candidate : candidates) {
    progress(fmt::format("{}: verifying {} ({})", family, candidate.method->name(), candidate.query));
    if (std::optional<Run> run = verify(candidate, family, proved, options.curves ? costly_asked : 0))
      runs.push_back(std::move(*run));
  }
  time(runs, family, proved.size(), options, progress);
  std::vector<BenchRow> rows;
  for (Run& run : runs) rows.push_back(std::move(run.row));
  return rows;
}

std::string shapes_of(const Pair& pair) {
  const auto [first, second] = std::minmax({kind_of(pair.a), kind_of(pair.b)});
  return fmt::format("{}/{}", to_string(first), to_string(second));
}

}  // namespace

std::vector<BenchRow> bench(std::span<const std::unique_ptr<Method>> methods,
                            std::span<const Family> families, const BenchOptions& options,
                            const BenchProgress& progress) {
  std::vector<Candidate> candidates = candidates_of(methods);
  if (options.curves)
    std::erase_if(candidates, [](const Candidate& c) { return c.query == "raw" || c.query == "depth"; });
  if (options.shapes)
    std::erase_if(candidates, [](const Candidate& c) {
      return c.method->share() > 1 || (c.query != "verdict" && c.query != "certificate");
    });
  std::vector<BenchRow> rows;
  for (const Family& family : families) {
    progress(fmt::format("{}: proving {} pairs", family.name, options.pairs));
    std::map<std::string, std::vector<JudgedPair>> parts;
    for (std::size_t i = 0; i < options.pairs; ++i) {
      const Pair pair = family.generate(options.seed, i);
      parts[options.shapes ? fmt::format("{} {}", shapes_of(pair), family.name) : std::string(family.name)]
          .push_back(prove(pair));
    }
    for (auto& [name, proved] : parts)
      for (BenchRow& row : bench_pairs(name, proved, candidates, options, progress))
        rows.push_back(std::move(row));
  }
  return rows;
}

std::vector<Family> select_families(std::string_view spec) {
  std::vector<Family> all;
  std::vector<std::string> names;
  for (const std::span<const Family> some : {campaign_families(), margin_families()}) {
    for (const Family& family : some) {
      all.push_back(family);
      names.emplace_back(family.name);
    }
  }
  if (spec == "all") return all;
  std::vector<Family> kept;
  for (const std::size_t i : select_names(names, spec)) kept.push_back(all[i]);
  return kept;
}

}  // namespace cyl
