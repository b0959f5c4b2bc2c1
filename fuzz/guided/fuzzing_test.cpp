// SPDX-License-Identifier: MIT
#include "fuzz/guided/fuzzing.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <string>

#include "base/scratch_test.hpp"
#include "corpus/pairs/pair_io.hpp"
#include "fuzz/guided/counters.hpp"
#include "fuzz/guided/record.hpp"
#include "fuzz/guided/visited.hpp"

namespace cyl {
namespace {

namespace fs = std::filesystem;
using std::chrono::milliseconds;

const Pair pair{{{0, 0, 0}, {0, 0, 1}, 1, 2}, {{2, 0, 0}, {0, 0, 1}, 1, 2}};
constexpr Stratum cap_cap{ContactFeature::cap_cap, 3, AngleClass::parallel},
    cap_rim{ContactFeature::cap_rim, 2, AngleClass::within_1e_12};

// An engine as the driver sees one: goes on with `life` for a run, merges by copying, and dies of an input as
// `death` states.
constexpr const char* engine = R"(#!/bin/bash
folders=()
for word; do
  case $word in
    -merge=1) merge=1 ;; -fork=*) fork=1 ;; -artifact_prefix=*) died=${word#*=} ;; -*) ;;
    *) folders+=("$word") ;;
  esac
done
here=$(dirname "$0") job=$TMPDIR/engine.dir/C1
if [[ $merge ]]; then
  for folder in "${folders[@]:1}"; do cp "$folder"/* "${folders[0]}"; done
  exit 0
fi
[[ $fork ]] || { echo 'SUMMARY: AddressSanitizer: stack-buffer-overflow a.cpp:3 in f'; exit 77; }
mkdir -p "$job"
live() { echo "#2: cov: 1 ft: 5 corp: 1"; echo "#9: cov: 1 ft: 12 corp: 2"; while :; do sleep 0.05; done; }
)";

class Fuzzing : public testing::Test, protected Scratch {
 protected:
  void SetUp() override {
    options_.program = folder / "engine";
    options_.target = "fuzz_fake";
    options_.out = folder / "run";
    options_.budget = std::chrono::minutes(10);  // for what never comes
    options_.seed = 1;
    const Record record = encode_record(pair);
    std::ofstream(folder / "record", std::ios::binary)
        .write(reinterpret_cast<const char*>(record.data()), std::ssize(record));
    Visited seen;
    seen.executions = 74;
    for (const Stratum& s : {cap_cap, cap_rim}) seen.strata[index_of(s)] = 1;
    std::ofstream(folder / "visited", std::ios::binary)
        .write(reinterpret_cast<const char*>(&seen), sizeof seen);
  }

  void live(const std::string& life) {
    std::ofstream(options_.program) << engine << life;
    fs::permissions(options_.program, fs::perms::owner_all);
  }
  /// Fuzzes, and interrupts it once what shall be seen is seen.
  FuzzSummary fuzz_until(const std::function<bool(const FuzzProgress&)>& seen) {
    return run_fuzzing(options_, [&](const FuzzProgress& progress) {
      if (seen(progress)) raise(SIGINT);
    });
  }
  bool has(const char* file) const { return fs::exists(fs::path(options_.out) / file); }
  std::string text(const fs::path& file) {
    std::ifstream in(file);
    return {std::istreambuf_iterator<char>(in), {}};
  }

  FuzzOptions options_;
};

TEST_F(Fuzzing, ReportsWhatJobsSeeAndKeepsTheirInputs) {
  live("cp $here/visited $DAYLIGHT_FUZZ_OUT/visited; cp $here/record $job/input; live");
  const FuzzSummary summary =
      fuzz_until([](const FuzzProgress& progress) { return progress.features == 12; });
  EXPECT_EQ(summary.harness_failure, "");
  EXPECT_EQ(summary.progress.executions, 74u);
  EXPECT_EQ(summary.progress.features, 12u);
  EXPECT_EQ(summary.progress.strata, 2u);
  EXPECT_EQ(summary.never_visited.size(), summary.possible_strata - 2);
  EXPECT_EQ(std::count(summary.never_visited.begin(), summary.never_visited.end(), to_string(cap_cap)), 0);
  EXPECT_TRUE(summary.interrupted);
  EXPECT_TRUE(has("corpus/input"));
  EXPECT_EQ(summary.kept_inputs, 2u);  // and the zeros it began with
  EXPECT_FALSE(has("unfinished"));
  EXPECT_EQ(exit_code(summary), 0);
}

TEST_F(Fuzzing, KeepsFindingsOncePerBucket) {
  Case c;
  c.pair = pair;
  c.id = "abcdefghijkl";
  std::ofstream(folder / "line") << format_case(c) << '\n';
  live("cp $here/line $DAYLIGHT_FUZZ_OUT/findings.jsonl; live");
  for (int run = 0; run < 2; ++run) {  // the second knows it from the first
    const FuzzSummary summary = fuzz_until([](const FuzzProgress& p) { return p.findings == 1; });
    ASSERT_EQ(summary.findings.size(), 1u);
    EXPECT_EQ(summary.findings[0], format_case(c));
    EXPECT_EQ(exit_code(summary), 2);
    EXPECT_EQ(text(fs::path(options_.out) / "findings.jsonl"), format_case(c) + '\n');
  }
}

TEST_F(Fuzzing, DeathsAreFindings) {
  live("for kind in crash timeout slow-unit; do cp $here/record ${died}$kind-1; done\nlive");
  const FuzzSummary summary =
      fuzz_until([](const FuzzProgress& progress) { return progress.features == 12; });
  EXPECT_EQ(summary.harness_failure, "");
  ASSERT_EQ(summary.findings.size(), 2u);
  const char* const notes[] = {
      "fuzz_fake/crash: SUMMARY: AddressSanitizer: stack-buffer-overflow a.cpp:3 in f",
      "fuzz_fake/timeout: takes more than 25 s"};
  for (std::size_t i = 0; i < 2; ++i) {
    const CaseLine line = parse_case(summary.findings[i], 1);
    ASSERT_TRUE(line.value);
    EXPECT_EQ(line.value->note, notes[i]);
    EXPECT_EQ(format_pair(line.value->pair), format_pair(pair));
  }
  EXPECT_EQ(exit_code(summary), 2);
}

TEST_F(Fuzzing, AnEngineThatCannotWorkIsTheHarnesssFailure) {
  live("echo 'ERROR: no such flag'; exit 1");
  FuzzSummary summary = run_fuzzing(options_);
  EXPECT_NE(summary.harness_failure.find("no such flag"), std::string::npos) << summary.harness_failure;
  EXPECT_EQ(exit_code(summary), 1);
  fs::remove_all(options_.out);
  live("echo '#9: cov: 1 ft: 0 oom/timeout/crash: 0/0/3 time: 1s'; live");
  summary = run_fuzzing(options_);
  EXPECT_NE(summary.harness_failure.find("loses its jobs"), std::string::npos) << summary.harness_failure;
  fs::remove_all(options_.out);
  fs::remove(options_.program);
  summary = run_fuzzing(options_);
  EXPECT_NE(summary.harness_failure.find("cannot run"), std::string::npos) << summary.harness_failure;
  EXPECT_EQ(exit_code(summary), 1);
}

TEST_F(Fuzzing, ARunCompletesOneThatWasKilled) {
  live("cp $here/record $job/input; live");
  const std::string whole = text(options_.program);
  std::string script = whole;
  script.replace(script.find("cp \"$folder\"/*"), 1, "exit 3; c");
  std::ofstream(options_.program) << script;
  FuzzSummary summary = fuzz_until([](const FuzzProgress& progress) { return progress.features == 12; });
  EXPECT_NE(summary.harness_failure.find("exit code 3"), std::string::npos) << summary.harness_failure;
  EXPECT_TRUE(has("unfinished/jobs/engine.dir/C1/input"));
  live("live");
  options_.budget = milliseconds(200);
  summary = run_fuzzing(options_);
  EXPECT_EQ(summary.harness_failure, "");
  EXPECT_TRUE(has("corpus/input"));
  EXPECT_FALSE(has("unfinished"));
}

TEST_F(Fuzzing, EndsWithItsTime) {
  live("live");
  options_.budget = milliseconds(200);
  const FuzzSummary summary = run_fuzzing(options_);
  EXPECT_FALSE(summary.interrupted);
  EXPECT_EQ(summary.harness_failure, "");
  EXPECT_EQ(summary.kept_inputs, 1u) << "the zeros they began with";
}

TEST_F(Fuzzing, WhatWasVisitedOutlivesTheProcess) {
  const std::string file = folder / "mapped";
  EXPECT_EQ(read_visited(file).executions, 0u);
  keep_visited(file);
  visited().executions = 7;
  visited().strata[index_of(cap_rim)] = 1;
  EXPECT_EQ(read_visited(file).executions, 7u);
  EXPECT_EQ(read_visited(file).strata[index_of(cap_rim)], 1);
  keep_visited(file);  // as by the next process
  EXPECT_EQ(visited().executions, 7u);
  for (std::size_t i = 0; i < visited().strata.size(); ++i) EXPECT_EQ(index_of(stratum_at(i)), i);
}

}  // namespace
}  // namespace cyl
