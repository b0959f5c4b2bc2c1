// SPDX-License-Identifier: MIT
#include "fuzz/guided/fuzzing.hpp"

#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>
#include <fstream>

#include "base/files.hpp"
#include "base/scratch_test.hpp"
#include "fuzz/guided/record.hpp"

namespace cyl {
namespace {

namespace fs = std::filesystem;
using std::chrono::milliseconds;

const Pair pair{{{0, 0, 0}, {0, 0, 1}, 1, 2}, {{2, 0, 0}, {0, 0, 1}, 1, 2}};

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
    options_.target = "fake";
    options_.out = folder / "run";
    options_.budget = std::chrono::minutes(10);  // for what never comes
    options_.seed = 1;
    const Record record = encode_record(pair);
    std::ofstream(folder / "record", std::ios::binary)
        .write(reinterpret_cast<const char*>(record.data()), std::ssize(record));
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

  FuzzOptions options_;
};

TEST_F(Fuzzing, ReportsWhatJobsSeeAndKeepsTheirInputs) {
  live("cp $here/record $job/input; live");
  const FuzzSummary summary =
      fuzz_until([](const FuzzProgress& progress) { return progress.features == 12; });
  EXPECT_EQ(summary.harness_failure, "");
  EXPECT_EQ(summary.progress.executions, 9u);
  EXPECT_EQ(summary.progress.features, 12u);
  EXPECT_TRUE(summary.interrupted);
  EXPECT_TRUE(has("corpus/fake/input"));
  EXPECT_EQ(summary.kept_inputs, 2u);  // and the zeros it began with
  EXPECT_FALSE(has("fuzz/fake"));
  EXPECT_EQ(summary.failures.size(), 0u);
}

TEST_F(Fuzzing, KeepsWhatItFoundForTheCampaign) {
  live(
      "for kind in findings undecided; do mkdir $DAYLIGHT_FUZZ_OUT/$kind; cp $here/record "
      "$DAYLIGHT_FUZZ_OUT/$kind/$kind; done\n"
      "echo 'intersect breaks law swap: no; record findings' >$DAYLIGHT_FUZZ_OUT/broken; live");
  const FuzzSummary summary = fuzz_until([](const FuzzProgress& p) { return p.found == 1; });
  EXPECT_EQ(summary.failures, std::vector<std::string>{"intersect breaks law swap: no; record findings"});
  EXPECT_TRUE(has("corpus/found/findings"));
  EXPECT_TRUE(has("corpus/found/undecided"));
}

TEST_F(Fuzzing, DeathsAreFailures) {
  live("for kind in crash-1 crash-2 timeout-1 slow-unit-1; do cp $here/record ${died}$kind; done\nlive");
  const FuzzSummary summary =
      fuzz_until([](const FuzzProgress& progress) { return progress.features == 12; });
  EXPECT_EQ(summary.harness_failure, "");
  const std::vector<std::string> one_a_reason{
      "the target fake died (crash): SUMMARY: AddressSanitizer: stack-buffer-overflow a.cpp:3 in f; record "
      "crash-1",
      "the target fake died (timeout): takes more than 25 s; record timeout-1"};
  EXPECT_EQ(summary.failures, one_a_reason);
  EXPECT_TRUE(has("corpus/found/crash-1"));
  EXPECT_FALSE(has("corpus/found/crash-2"));
}

TEST_F(Fuzzing, BeginsWithTheCorporaOfAllTargetsAndNamesThePlugIn) {
  fs::create_directories(fs::path(options_.out) / "corpus/other");
  fs::copy_file(folder / "record", fs::path(options_.out) / "corpus/other/pair");
  options_.plugin = "./libmine.so";
  live("printf '%s\\n' \"${folders[@]##*/}\" $DAYLIGHT_FUZZ_PLUGIN >$here/stated; live");
  fuzz_until([](const FuzzProgress& progress) { return progress.features == 12; });
  EXPECT_EQ(read_file(folder / "stated"), "fake\nother\n./libmine.so\n");
  EXPECT_TRUE(has("corpus/fake/pair"));
}

TEST_F(Fuzzing, AnEngineThatCannotWorkIsTheHarnesssFailure) {
  live("echo 'ERROR: no such flag'; exit 1");
  FuzzSummary summary = run_fuzzing(options_);
  EXPECT_NE(summary.harness_failure.find("no such flag"), std::string::npos) << summary.harness_failure;
  fs::remove_all(options_.out);
  live("echo '#9: cov: 1 ft: 0 oom/timeout/crash: 0/0/3 time: 1s'; live");
  summary = run_fuzzing(options_);
  EXPECT_NE(summary.harness_failure.find("loses its jobs"), std::string::npos) << summary.harness_failure;
  fs::remove_all(options_.out);
  fs::remove(options_.program);
  summary = run_fuzzing(options_);
  EXPECT_NE(summary.harness_failure.find("cannot run"), std::string::npos) << summary.harness_failure;
}

TEST_F(Fuzzing, ARunCompletesOneThatWasKilled) {
  live("cp $here/record $job/input; live");
  const std::string whole = read_file(options_.program);
  std::string script = whole;
  script.replace(script.find("cp \"$folder\"/*"), 1, "exit 3; c");
  std::ofstream(options_.program) << script;
  FuzzSummary summary = fuzz_until([](const FuzzProgress& progress) { return progress.features == 12; });
  EXPECT_NE(summary.harness_failure.find("exit code 3"), std::string::npos) << summary.harness_failure;
  EXPECT_TRUE(has("fuzz/fake/jobs/engine.dir/C1/input"));
  live("live");
  options_.budget = milliseconds(200);
  summary = run_fuzzing(options_);
  EXPECT_EQ(summary.harness_failure, "");
  EXPECT_TRUE(has("corpus/fake/input"));
  EXPECT_FALSE(has("fuzz/fake"));
}

TEST_F(Fuzzing, EndsWithItsTime) {
  live("live");
  options_.budget = milliseconds(200);
  const FuzzSummary summary = run_fuzzing(options_);
  EXPECT_FALSE(summary.interrupted);
  EXPECT_EQ(summary.harness_failure, "");
  EXPECT_EQ(summary.kept_inputs, 1u) << "the zeros they began with";
}

}  // namespace
}  // namespace cyl
