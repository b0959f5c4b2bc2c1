// SPDX-License-Identifier: MIT
// A campaign: draws pairs from the case files and the families, asks every method, lets the referee judge,
// and stores what it finds. A pure function of (seed, pairs, families, methods); times and
// kind `hang` excepted.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <string>

#include "fuzz/campaign/batch.hpp"

namespace cyl {

/// A budget that is used up. 0 means that there is no budget.
inline constexpr std::chrono::milliseconds spent_budget{-1};

struct CampaignOptions {
  std::string out;  ///< run folder; created
  std::uint64_t seed = 0;
  std::uint64_t shard = 0, shards = 1;  ///< does the batches of shard `shard` of `shards` alone
  std::uint64_t pairs = 0;              ///< of the run in all its sessions and shards. 0 is unlimited.
  std::chrono::milliseconds budget{0};  ///< wall time of this session. 0 is unlimited. At least one limit is
                                        ///< set.
  std::string cases;                    ///< folder of workload.cases, for --resume
  std::chrono::milliseconds fuzz{0};    ///< wall time of a fuzzer before the first pair, for --resume
  std::string fuzz_targets, fuzzing;    ///< what it fuzzes; what came of it, for the summary
  std::string guests;                   ///< the guests, for commands that ask them again
  std::string build;                    ///< what was built from what, for the record only
  unsigned jobs = 2;                    ///< batches under way at once; does not change the findings
  bool resume = false;       ///< go on with the run in `out`, which must agree with seed, shard and workload
  bool create_only = false;  ///< leave the new run unchanged, for --resume
};

/// Totals of the run so far, sessions before this one included.
struct CampaignProgress {
  std::uint64_t done = 0;  ///< indices
  std::uint64_t goal = 0;  ///< indices to do. 0 is unlimited.
  std::uint64_t contract = 0, resolution = 0, failed = 0, unresolved = 0;
  std::uint64_t session_done = 0;             ///< indices of this session
  std::chrono::milliseconds session_time{0};  ///< wall time of this session
};

/// CPU time of a session, of the campaign and of all processes that it started.
struct CampaignCost {
  std::chrono::nanoseconds all{0};
  std::chrono::nanoseconds asking{0}, judging{0};  ///< in calls of methods; in the referee's verdicts
  std::chrono::nanoseconds hung{0};                ///< in calls that hung, which `asking` leaves out
};

struct CampaignSummary {
  CampaignProgress progress;
  CampaignCost cost;
  bool interrupted = false;     ///< by SIGINT or SIGTERM before a limit: what was complete is stored
  bool fuzz_failed = false;     ///< its fuzzer found what a campaign cannot see
  std::string harness_failure;  ///< empty, or which pair broke the harness and how
};

/// Adds what the rows of a tally count.
void count(CampaignProgress& progress, const std::vector<TallyRecord>& tallies);

/// CPU time that each part of a batch may take that is run again to find the pair that broke it. A whole one
/// takes about a second.
inline constexpr std::chrono::seconds search_cpu_cap{60};

/// Runs until a limit is reached or a signal asks it to stop. Calls `on_progress` after every commit and at
/// least five times a second, from this thread. Throws std::runtime_error if the run folder cannot be used or
/// does not match.
CampaignSummary run_campaign(const CampaignOptions& options, const Workload& workload,
                             const std::function<void(const CampaignProgress&)>& on_progress = {});

/// 1 the harness failed, 2 contract findings or failures, of the fuzzer too, 3 none, but undecided truth
/// or interrupted, else 0.
int exit_code(const CampaignSummary& summary);

}  // namespace cyl
