// SPDX-License-Identifier: MIT
#include "props/gate/gate.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/mman.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <limits>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>

#include "corpus/pairs/pair_io.hpp"
#include "oracles/trial/trial.hpp"
#include "props/laws/laws_test.hpp"
#include "solver/distance.hpp"

namespace cyl {
namespace {

MethodAnswer honest(const Pair& pair) { return answered(intersect(pair.a, pair.b)); }

Planted::Ask always(Verdict verdict) {
  return [=](const Pair&) { return answered(verdict); };
}

MethodAnswer wrong_of_wide_a(const Pair& pair) {
  return pair.a.radius > pair.b.radius ? answered(Verdict::disjoint) : honest(pair);
}

const std::vector<Case>& few_cases() {
  static const std::vector<Case> cases = [] {
    std::vector<Case> all = read_case_folder(DAYLIGHT_SOURCE_DIR "/corpus/cases");
    std::erase_if(all, [](const Case& c) { return !c.file.ends_with("hand_made.jsonl"); });
    all.resize(40);
    return all;
  }();
  return cases;
}

/// One round of either law search, three of the strata and four of close contacts: 12 pairs of each stratum.
constexpr std::uint64_t few_pairs = 2500;

GateReport run_on(const Planted::Ask& ask, GateOptions options, std::span<const Case> cases = few_cases()) {
  std::vector<std::unique_ptr<Method>> methods;
  methods.push_back(std::make_unique<Planted>(ask, "planted", Claim{1e-12, 0, "planted"}));
  options.caps = {
      .call_cpu = std::chrono::milliseconds(100), .call_wall = std::chrono::milliseconds(100), .hangs = 2};
  return run_gate(methods, cases, options);
}

/// Leaves failures as they are found. This takes a tenth of the time.
GateReport gate_on(const Planted::Ask& ask, std::uint64_t pairs = few_pairs,
                   std::optional<std::chrono::milliseconds> cap = {}) {
  return run_on(ask, {.pairs = pairs, .cap = cap, .as_found = true});
}

/// Returns whether a contract failure of that law was reported, with `what` in its text.
bool reported(const GateReport& report, int law, const std::string& what = {}) {
  return std::ranges::any_of(report.failures, [&](const GateFailure& f) {
    return f.law->number == law && f.severity == Severity::contract && f.what.find(what) != std::string::npos;
  });
}

TEST(Gate, LetsAnHonestMethodPass) {
  const GateReport report = gate_on(honest);
  for (const GateFailure& f : report.failures)
    EXPECT_NE(f.severity, Severity::contract) << f.law->name << f.what;
  EXPECT_EQ(exit_code(report), 0);
  EXPECT_EQ(report.methods.at(0).remark, "");
  for (const GateCell& cell : report.methods.at(0).cells) {
    const std::string name = fmt::format("{} {}", to_string(cell.stratum.feature), cell.stratum.decade);
    EXPECT_EQ(cell.claimed, cell.drawn > 0 && cell.stratum.decade < last_close_decade) << name;
    if (cell.claimed) {
      EXPECT_EQ(cell.wrong, 0u) << name;
    }
  }
  ASSERT_EQ(report.methods.at(0).close_cells.size(), close_cell_count);
  for (const CloseGateCell& cell : report.methods.at(0).close_cells) {
    EXPECT_EQ(cell.claimed, cell.cell.decade < last_close_decade) << cell.cell.decade;
    EXPECT_GE(cell.gaps, 2u);
    EXPECT_GE(cell.overlaps, 2u);
    EXPECT_EQ(cell.wrong_gaps + cell.wrong_overlaps, 0u);
  }
  for (const GatePhaseReport& phase : report.phases) EXPECT_GT(phase.pairs, 0u) << to_string(phase.phase);
}

TEST(Gate, ACapOnTimeSaysWhatItDidNotAsk) {
  const GateReport report = gate_on(honest, few_pairs, std::chrono::milliseconds(0));
  const std::vector<std::string> all = {"corpus: 8 of 40 cases, since the time was over",
                                        "laws on the corpus: 40 of 40 cases, since the time was over",
                                        "laws on drawn pairs: 1 of 1 rounds, since the time was over",
                                        "sample of all strata: 3 of 3 rounds, since the time was over",
                                        "laws on close contacts: 1 of 1 rounds, since the time was over",
                                        "sample of close contacts: 4 of 4 rounds, since the time was over"};
  EXPECT_EQ(report.not_asked, all);
  EXPECT_EQ(exit_code(report), 3);
}

TEST(Gate, ACutGateStillFailsForWhatItFound) {
  // Even a fast machine does not draw so many pairs in that time.
  const GateReport report = gate_on(always(Verdict::intersecting), std::numeric_limits<std::uint32_t>::max(),
                                    std::chrono::seconds(1));
  EXPECT_FALSE(report.not_asked.empty());
  EXPECT_EQ(exit_code(report), 2);
}

TEST(Gate, ThePairsAreTheSameWhateverIsFound) {
  const auto digests = [](const Planted::Ask& ask) {
    std::vector<std::uint64_t> all;
    for (const GatePhaseReport& phase : gate_on(ask).phases) all.push_back(phase.digest);
    return all;
  };
  const auto all = digests(honest);
  EXPECT_EQ(std::set<std::uint64_t>(all.begin(), all.end()).size(), 5u) << "the corpus twice";
  EXPECT_EQ(all, digests(always(Verdict::disjoint)));
}

TEST(Gate, ReportsWhoAlwaysAbstainsOrDeclines) {
  for (const MethodAnswer& always : {answered(Verdict::undecided), MethodAnswer{}}) {
    const GateReport report = gate_on([&](const Pair&) { return always; });
    EXPECT_EQ(report.methods.at(0).remark, "abstains on every pair");
    EXPECT_EQ(exit_code(report), 3);
  }
}

TEST(Gate, DoesNotDoubtTheTruthOfWhatIsDeclined) {
  const GateReport report = gate_on([](const Pair& pair) {
    return pair.a.radius == 0 || pair.b.radius == 0 ? MethodAnswer{} : honest(pair);
  });
  EXPECT_GT(report.methods.at(0).counts.declined, 0u);
  EXPECT_EQ(report.undecided_truths, 0u);
  EXPECT_EQ(exit_code(report), 0);
}

TEST(Gate, ReportsWhoMostlyAbstains) {
  const GateReport report = gate_on(
      [](const Pair& pair) { return pair.a.axis.x() > 0.5 ? honest(pair) : answered(Verdict::undecided); });
  EXPECT_TRUE(report.methods.at(0).remark.starts_with("abstains on ")) << report.methods.at(0).remark;
  EXPECT_EQ(report.methods.at(0).remark.find("every"), std::string::npos);
  EXPECT_NE(exit_code(report), 0);
}

TEST(Gate, ReportsWhoAlwaysAnswersIntersecting) {
  const GateReport report = gate_on(always(Verdict::intersecting));
  EXPECT_EQ(report.methods.at(0).remark, "answers intersecting to every pair");
  EXPECT_TRUE(reported(report, 31, "wrong_intersecting"));
  EXPECT_EQ(exit_code(report), 2);
}

TEST(Gate, ReportsWhoSleepsAndEndsAllTheSame) {
  const auto sleeps = [](const Pair&) {
    std::this_thread::sleep_for(std::chrono::hours(1));
    return MethodAnswer{};
  };
  const GateReport report = run_on(sleeps, {.pairs = few_pairs});
  EXPECT_TRUE(reported(report, 30, "hang"));
  EXPECT_EQ(report.methods.at(0).remark, "hangs, and was not asked to the end");
  EXPECT_EQ(report.not_asked, std::vector<std::string>{"planted, after it had hung too often"});
  EXPECT_EQ(exit_code(report), 2);
  EXPECT_LT(report.methods.at(0).counts.hangs, 20u);
}

TEST(Gate, KeepsHowTheMethodFailedWhateverLawMeetsIt) {
  const GateReport report = gate_on([](const Pair& pair) {
    return pair.a.radius <= pair.b.radius ? honest(pair) : failed_answer(Failure::reported, "no convergence");
  });
  EXPECT_TRUE(reported(report, 30, "failed: no convergence"));
  std::set<int> laws;
  for (const GateFailure& f : report.failures) {
    if (!f.failed) continue;
    laws.insert(f.law->number);
    EXPECT_EQ(*f.failed, FindingKind::reported) << f.what;
    EXPECT_EQ(f.reason, "no convergence") << f.what;
  }
  EXPECT_GT(laws.size(), 3u) << "that change the pair";
}

TEST(Gate, SimplifiesRunsAgainAndDistinguishesCauses) {
  const GateReport report = run_on(wrong_of_wide_a, {.pairs = few_pairs});
  const auto is_wrong = [](const GateFailure& f) {
    return f.law->number == 31 && f.severity == Severity::contract;
  };
  const auto wrong = std::ranges::find_if(report.failures, is_wrong);
  ASSERT_NE(wrong, report.failures.end());
  EXPECT_GT(wrong->simplest.a.radius, wrong->simplest.b.radius);
  EXPECT_EQ(wrong->simplest.a.center, Vector3(0, 0, 0)) << wrong->origin;
  const double depth = -Trial(wrong->simplest).distance_at(1e-12).hi / size_of(wrong->simplest);
  EXPECT_EQ(wrong->what_of_simplest, fmt::format("wrong_disjoint, margin {:.3g}", depth)) << wrong->what;
  EXPECT_EQ(wrong->reruns, 10u);
  EXPECT_EQ(wrong->failed_again, 10u);
  EXPECT_TRUE(reported(report, 1)) << "swap";
  std::set<std::string> causes;
  for (const GateFailure& f : report.failures) {
    if (!is_wrong(f)) continue;
    EXPECT_TRUE(causes.insert(f.cause).second) << f.cause;
    EXPECT_TRUE(f.cause.starts_with("planted/wrong_disjoint/")) << f.cause;
  }
  EXPECT_GT(causes.size(), 5u);
}

/// A case that intersects.
const Pair& one_pair() { return std::ranges::find(few_cases(), Verdict::intersecting, &Case::truth)->pair; }

TEST(Gate, TheSimplestFailsWithoutTheQuestionsBeforeIt) {
  const std::string wrong = format_pair(one_pair());
  const GateReport report = run_on(
      [&](const Pair& pair) {
        static int calls = 0;  // of this worker
        const bool lies = format_pair(pair) == wrong || (++calls > 40 && pair.a.radius == pair.b.radius);
        return lies ? answered(Verdict::disjoint) : honest(pair);
      },
      {.pairs = 1});
  const auto found = std::ranges::find(report.failures, 10u, &GateFailure::failed_again);
  ASSERT_NE(found, report.failures.end());
  EXPECT_EQ(format_pair(found->simplest), wrong);
}

TEST(Gate, SaysWhatDependsOnLuck) {
  // Each worker loses its state when it ends. Shared memory keeps it.
  void* const shared =
      mmap(nullptr, sizeof(std::atomic<int>), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  ASSERT_NE(shared, MAP_FAILED);
  auto& calls = *new (shared) std::atomic<int>(0);
  const std::string wrong = format_pair(one_pair());
  const GateReport report = run_on(
      [&](const Pair& pair) {
        return format_pair(pair) == wrong && ++calls % 3 == 1 ? answered(Verdict::disjoint) : honest(pair);
      },
      {.pairs = 1});
  EXPECT_EQ(exit_code(report), 2);
  EXPECT_TRUE(std::ranges::any_of(report.failures, [](auto& f) { return f.failed_again < f.reruns; }));
  munmap(shared, sizeof calls);
}

TEST(Gate, SameSeedSameFailures) {
  const GateReport first = gate_on(wrong_of_wide_a), second = gate_on(wrong_of_wide_a);
  ASSERT_GT(first.failures.size(), 20u);
  ASSERT_EQ(first.failures.size(), second.failures.size());
  for (std::size_t i = 0; i < first.failures.size(); ++i) {
    const GateFailure &one = first.failures[i], &other = second.failures[i];
    EXPECT_EQ(one.origin, other.origin);
    EXPECT_EQ(one.cause, other.cause);
    EXPECT_EQ(one.count, other.count) << one.cause;
    EXPECT_EQ(format_pair(one.simplest), format_pair(other.simplest)) << one.cause;
  }
}

TEST(Gate, ShowsTheWorstOfACause) {
  std::vector<Case> cases(3);
  for (std::size_t i = 0; i < cases.size(); ++i)
    cases[i].pair = {{{0, 0, 0}, {0, 0, 1}, 1, 4}, {{0, std::array{1.9, 1.5, 1.8}[i], 0}, {1, 0, 0}, 1, 4}};
  const GateReport report = run_on(
      [](const Pair& pair) {
        return pair.a.height == 4 && pair.b.height == 4 ? answered(Verdict::disjoint) : honest(pair);
      },
      {.pairs = 1, .as_found = true}, cases);
  const auto wrong = std::ranges::find(report.failures, "wrong_disjoint", &GateFailure::kind);
  ASSERT_NE(wrong, report.failures.end());
  EXPECT_EQ(wrong->count, 3u);
  EXPECT_EQ(wrong->found.b.center.y(), 1.5);
  EXPECT_EQ(wrong->simplest.b.center.y(), 1.5);
  EXPECT_NEAR(wrong->excess, 0.05, 1e-9);
  EXPECT_TRUE(wrong->in_case());
}

TEST(Gate, ShowsAKeptCaseEvenIfADrawnPairIsWorse) {
  Case shallow;
  shallow.pair = {{{0, 0, 0}, {0, 0, 1}, 1, 4}, {{0, 1.999, 0}, {1, 0, 0}, 1, 4}};
  const GateReport report =
      run_on(always(Verdict::disjoint), {.pairs = 2000, .as_found = true}, {&shallow, 1});
  const auto kept = std::ranges::find(report.failures, true, &GateFailure::in_case);
  ASSERT_NE(kept, report.failures.end());
  EXPECT_GT(kept->count, 1u);
  EXPECT_EQ(kept->found.b.center.y(), 1.999);
}

TEST(Gate, AFailedAnswerIsNoWrongVerdict) {
  const GateReport report = gate_on([](const Pair& pair) -> MethodAnswer {
    if (pair.a.radius > pair.b.radius) throw std::runtime_error("wide");
    return honest(pair);
  });
  const GateMethod& method = report.methods.at(0);
  EXPECT_GT(method.counts.failed, 0u);
  EXPECT_GT(close_contacts_of(method).pairs, 0u);
  EXPECT_EQ(close_contacts_of(method).wrong, 0u);
  for (const GateCell& cell : method.cells) EXPECT_EQ(cell.wrong, 0u);
}

TEST(Gate, CountsWhatIsWrongInItsCellOfCloseContacts) {
  // Wrong if the axes are 1.5e-13 to 1e-12 from parallel. No stratum but containment has such axes.
  const GateReport report = gate_on([](const Pair& pair) {
    const double sine = pair.a.axis.cross(pair.b.axis).norm() / pair.a.axis.norm() / pair.b.axis.norm();
    return sine > 1.5e-13 && sine < 1e-12 ? answered(Verdict::disjoint) : honest(pair);
  });
  EXPECT_EQ(exit_code(report), 2);
  std::uint64_t wrong = 0;
  for (const CloseGateCell& cell : report.methods.at(0).close_cells) {
    const auto [lie, band, decade] = cell.cell;
    const bool at_fault = lie == AxesLie::near_parallel && band == AngleBand::tiny;
    if (at_fault) wrong += cell.wrong_overlaps;
    EXPECT_EQ(cell.wrong_gaps, 0u) << "disjoint is right there";
    EXPECT_TRUE(at_fault || cell.wrong_overlaps == 0)
        << to_string(lie) << ' ' << to_string(band) << ' ' << decade;
  }
  EXPECT_GT(wrong, 0u);
  for (const GateCell& cell : report.methods.at(0).cells) {
    if (cell.stratum.feature != ContactFeature::containment) {
      EXPECT_EQ(cell.wrong, 0u) << to_string(cell.stratum.feature);
    }
  }
}

TEST(Gate, AsksTheSamePairsWhereTheAmountIsGiven) {
  const GateReport report =
      run_on(honest,
             {.pairs = 1, .amount = GateAmount{.cases_under_laws = {}, .law_rounds = 3, .sample_rounds = 2}});
  EXPECT_EQ(report.phases.at(1).pairs, few_cases().size());
  EXPECT_EQ(report.phases.at(2).rounds, 3u);
  EXPECT_EQ(report.phases.at(3).rounds, 2u);
  EXPECT_GT(report.phases.at(3).pairs, 500u);
  EXPECT_EQ(report.phases.at(4).pairs + report.phases.at(5).pairs, 0u) << "as gates that knew none";
  EXPECT_EQ(exit_code(report), 0);
}

}  // namespace
}  // namespace cyl
