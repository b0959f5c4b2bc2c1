// SPDX-License-Identifier: MIT
// The names in a stored run: keys of its configuration, rows and families. Campaigns write them, reports read
// them.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "corpus/store/run_store.hpp"
#include "corpus/store/shard.hpp"

namespace cyl {

/// Names that stand in place of a method's: for the truths that cases state, and for the referee.
inline constexpr const char* corpus_row = "corpus";
inline constexpr const char* referee_row = "referee";
/// One row a Stage, in its order: how many pairs ended there, decided or not, and the time that they took.
inline constexpr std::array<const char*, 3> stage_rows{"referee-filter", "referee-wide", "referee-exact"};
/// Returns whether a row belongs to a method and is not one of the rows above.
constexpr bool is_method_row(std::string_view name) {
  return name != corpus_row && name != referee_row &&
         std::find(stage_rows.begin(), stage_rows.end(), name) == stage_rows.end();
}

/// Values of "status" in a run's configuration. A killed run stays `running`. A run that an
/// error of daylight ended has `failed: ` and the message.
inline constexpr const char *status_planned = "planned", *status_running = "running",
                            *status_stopped = "stopped", *status_complete = "complete",
                            *status_failed = "failed: ";

/// The entry of a run whose fuzzer found a failure that a campaign does not see: a broken law, a dead
/// process.
inline constexpr const char* fuzz_failed_key = "fuzz_failed";

/// A value of a configuration, or an empty text.
std::string value_of(const Config& config, const std::string& key);
/// A value that every run has, and one that is a whole number. Throws InputError that names the key if it is
/// missing, or no such number.
const std::string& text_of(const Config& config, const std::string& key);
std::uint64_t number_of(const Config& config, const std::string& key);
/// Returns the shard of a run from its configuration, or the whole run if it names none. Throws
/// InputError if the entry is not a shard.
Shard shard_of(const Config& config);
/// Throws InputError unless the referee of the run judged every pair of its own below the next index.
void check_progress(const RunStore& run);
/// Returns the entry that shard_of() reads.
std::string format_shard(const Shard& shard);

/// Returns the verdict that the run proved of the pair of a finding, or nothing if it stores none.
std::optional<Verdict> proved_verdict(const FindingRecord& finding);

/// The family names of the cases, and of the pairs from the corpus of a fuzzer.
inline constexpr const char *cases_family = "cases", *fuzzed_family = "fuzzed";

}  // namespace cyl
