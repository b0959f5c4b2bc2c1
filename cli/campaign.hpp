// SPDX-License-Identifier: MIT
// The run of a campaign, for the commands that begin one.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "cli/guests.hpp"

namespace cyl {

struct CampaignArguments {
  std::string budget, out, methods, families, shard, resume;
  std::optional<std::string> cases;
  std::string corpus;
  std::vector<std::string> fuzz_targets = {"core", "xcheck"};
  unsigned fuzz = 0;         ///< percent of the time for a fuzzer, which begins
  bool corpus_only = false;  ///< the pairs are those of the fuzzer alone
  std::optional<std::uint64_t> pairs;
  std::optional<std::uint64_t> seed;
  unsigned jobs = std::max(1u, std::thread::hardware_concurrency());
  bool list = false, table = false;
  GuestOptions guests;
};

int campaign(const CampaignArguments& arguments);

}  // namespace cyl
