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

// An engine as the driver sees one: reads its arguments, goes on with `life`, merges by copying.
constexpr const char* engine = R"(#!/bin/bash
folders=()
for word; do
  case $word in -merge=1) merge=1 ;; -artifact_prefix=*) prefix=${word#*=} ;; -*) ;; *) folders+=("$word") ;; esac
done
here=$(dirname "$0")
if [[ $merge ]]; then
  for folder in "${folders[@]:1}"; do cp "$folder"/* "${folders[0]}"; done
  exit 0
fi
corpus=${folders[0]} worker=${DAYLIGHT_FUZZ_OUT##*worker-}
trap 'exit 0' USR1
live() { echo "#2 INITED cov: 1 ft: 5 corp: 1"; echo "#9 NEW cov: 1 ft: 12 corp: 2"; while :; do sleep 0.05; done; }
)";

class Fuzzing : public testing::Test, protected Scratch {
 protected:
  void SetUp() override {
    options_.program = folder / "engine";
    options_.target = "fuzz_fake";
    options_.out = folder / "run";
    options_.budget = std::chrono::minutes(10);  // for what never comes
    options_.exchange_interval = milliseconds(200);
    options_.seed = 1;
    const Record record = encode_record(pair);
    std::ofstream(folder / "record", std::ios::binary)
        .write(reinterpret_cast<const char*>(record.data()), std::ssize(record));
    for (const Stratum& s : {cap_cap, cap_rim}) {
      Visited seen;
      const auto number = static_cast<unsigned>(s.feature);
      seen.executions = 70 + number;
      seen.strata[index_of(s)] = 1;
      std::ofstream(folder / ("visited-" + std::to_string(number)), std::ios::binary)
          .write(reinterpret_cast<const char*>(&seen), sizeof seen);
    }
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
  /// Whether a worker has an input.
  bool has(unsigned worker, const char* input) const {
    return fs::exists(fs::path(options_.out) / ("worker-" + std::to_string(worker)) / "corpus" / input);
  }
  std::string text(const fs::path& file) {
    std::ifstream in(file);
    return {std::istreambuf_iterator<char>(in), {}};
  }

  FuzzOptions options_;
};

TEST_F(Fuzzing, UnitesWhatWorkersSee) {
  live(
      "cp $here/visited-$((3 + worker)) $DAYLIGHT_FUZZ_OUT/visited; cp $here/record $corpus/input-$worker; "
      "live");
  const FuzzSummary summary = fuzz_until([&](const FuzzProgress& progress) {
    return progress.workers[0].features == 12 && progress.workers[1].features == 12 && has(1, "input-2") &&
           has(2, "input-1");
  });
  EXPECT_EQ(summary.harness_failure, "");
  ASSERT_EQ(summary.progress.workers.size(), 2u);
  EXPECT_EQ(summary.progress.workers[0].executions, 74u);
  EXPECT_EQ(summary.progress.workers[1].executions, 75u);
  EXPECT_EQ(summary.progress.workers[0].features, 12u);
  EXPECT_EQ(summary.progress.workers[0].first_features, 5u);
  EXPECT_EQ(summary.progress.strata, 2u);
  EXPECT_EQ(summary.never_visited.size(), summary.possible_strata - 2);
  EXPECT_EQ(std::count(summary.never_visited.begin(), summary.never_visited.end(), to_string(cap_cap)), 0);
  for (const unsigned worker : {1u, 2u})  // each has the other's, and both are merged
    for (const char* input : {"input-1", "input-2"}) EXPECT_TRUE(has(worker, input)) << worker << input;
  EXPECT_TRUE(fs::exists(fs::path(options_.out) / "corpus" / "input-1"));
  EXPECT_EQ(summary.kept_inputs, 3u);  // and the zeros they began with
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

TEST_F(Fuzzing, ADeathIsAFindingAndTheWorkerStartsAgain) {
  options_.jobs = 1;
  live(
      "[[ -e $here/died ]] && live\ntouch $here/died; cp $here/record ${prefix}crash-1\n"
      "echo 'SUMMARY: AddressSanitizer: stack-buffer-overflow a.cpp:3 in f'; exit 77");
  const FuzzSummary summary =
      fuzz_until([](const FuzzProgress& progress) { return progress.workers[0].features == 12; });
  EXPECT_EQ(summary.harness_failure, "");
  EXPECT_EQ(summary.progress.workers[0].deaths, 1u);
  ASSERT_EQ(summary.findings.size(), 1u);
  const CaseLine line = parse_case(summary.findings[0], 1);
  ASSERT_TRUE(line.value);
  EXPECT_EQ(line.value->note,
            "fuzz_fake/crash: SUMMARY: AddressSanitizer: stack-buffer-overflow a.cpp:3 in f");
  EXPECT_EQ(format_pair(line.value->pair), format_pair(pair));
  EXPECT_EQ(exit_code(summary), 2);
}

TEST_F(Fuzzing, AWorkerThatCannotLiveIsTheHarnesssFailure) {
  live("echo 'ERROR: no such flag'; exit 1");
  FuzzSummary summary = run_fuzzing(options_);
  EXPECT_NE(summary.harness_failure.find("no such flag"), std::string::npos) << summary.harness_failure;
  EXPECT_EQ(exit_code(summary), 1);
  fs::remove(options_.program);
  summary = run_fuzzing(options_);
  EXPECT_NE(summary.harness_failure.find("cannot run"), std::string::npos) << summary.harness_failure;
  EXPECT_EQ(exit_code(summary), 1);
}

TEST_F(Fuzzing, AMergeThatFailsLeavesTheCorpora) {
  live("cp $here/record $corpus/input-$worker; live");
  std::string script = text(options_.program);
  script.replace(script.find("cp \"$folder\"/*"), 1, "exit 3; c");
  std::ofstream(options_.program) << script;
  const FuzzSummary summary = fuzz_until([&](const FuzzProgress&) { return has(1, "input-1"); });
  EXPECT_NE(summary.harness_failure.find("exit code 3"), std::string::npos) << summary.harness_failure;
  EXPECT_TRUE(has(1, "input-1"));
}

TEST_F(Fuzzing, EndsWithItsTime) {
  live("live");
  options_.budget = milliseconds(200);
  const FuzzSummary summary = run_fuzzing(options_);
  EXPECT_FALSE(summary.interrupted);
  EXPECT_EQ(summary.harness_failure, "");
  EXPECT_EQ(summary.kept_inputs, 1u) << "the zeros they began with";
}

TEST_F(Fuzzing, EndsInOrderWhenAsked) {
  live("cp $here/record $corpus/input-$worker; live");
  const FuzzSummary summary = fuzz_until([&](const FuzzProgress&) { return has(1, "input-1"); });
  EXPECT_TRUE(summary.interrupted);
  EXPECT_EQ(summary.harness_failure, "");
  EXPECT_TRUE(fs::exists(fs::path(options_.out) / "corpus" / "input-1"));
}

TEST_F(Fuzzing, WhatWasVisitedOutlivesTheProcess) {
  const std::string file = folder / "visited";
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
