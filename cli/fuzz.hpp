// SPDX-License-Identifier: MIT
// The fuzzer before a campaign, which gives it a corpus.
#pragma once

#include <string>

#include "cli/campaign.hpp"
#include "fuzz/campaign/campaign.hpp"

namespace cyl {

/// Returns the path of the program that fuzzes a target, beside this executable if clang built that, else in
/// the folder of the clang build. Throws std::runtime_error, with the remedy, if there is none.
std::string fuzz_program(const std::string& target);

/// Reads "25%". Throws UsageError if the text has another form.
unsigned parse_share(const std::string& text);

/// Gives a fuzzer its share of the time of a new run. Reports it if there is no fuzzer here, and throws
/// std::runtime_error then if the run has no other pairs.
void plan_fuzzing(const CampaignArguments& arguments, CampaignOptions& options);

/// Fills corpus/ in the folder of a run from the corpus of another run, which it first reads completely.
/// Throws std::runtime_error if a file there is not a record.
void begin_corpus(const std::string& run, const std::string& from);

/// Fuzzes for the time that the run has left for it, and keeps what came of it in the run. Returns false if a
/// signal stopped it. Throws std::runtime_error if the fuzzer fails.
bool fuzz_before_campaign(const CampaignOptions& options);

}  // namespace cyl
