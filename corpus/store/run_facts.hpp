// SPDX-License-Identifier: MIT
// The meaning of the entries, rows and families of a stored run: the words that campaigns write and reports
// read.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "corpus/store/run_store.hpp"
#include "corpus/store/shard.hpp"

namespace cyl {

/// Rows of the tally, and findings, that do not belong to a method: the truths that cases state, and the
/// referee.
inline constexpr const char* corpus_row = "corpus";
inline constexpr const char* referee_row = "referee";
/// How often each arithmetic gave the verdict, decided or not, and the time of the pairs that it got, in the
/// order of Stage.
inline constexpr std::array<const char*, 3> stage_rows{"referee-filter", "referee-wide", "referee-exact"};
/// Returns whether a row belongs to a method and is not one of the rows above.
constexpr bool is_method_row(std::string_view name) {
  return name != corpus_row && name != referee_row &&
         std::find(stage_rows.begin(), stage_rows.end(), name) == stage_rows.end();
}

/// Values of "status" in a run's configuration. A killed run stays `running`. A run with a fault of the
/// harness has `failed: ` and the cause.
inline constexpr const char *status_planned = "planned", *status_running = "running",
                            *status_stopped = "stopped", *status_complete = "complete",
                            *status_failed = "failed: ";

/// A value of a configuration, or an empty text.
std::string value_of(const Config& config, const std::string& key);
/// Returns the shard of a run from its configuration, or the whole run if it names none. Throws
/// std::runtime_error if the entry is not a shard.
Shard shard_of(const Config& config);
/// Returns the entry that shard_of() reads.
std::string format_shard(const Shard& shard);

/// The family name of the cases.
inline constexpr const char* cases_family = "cases";
/// The family whose pairs are climbed, and the pairs of one climb.
inline constexpr const char* climbed_name = "climbed";
inline constexpr std::uint64_t climb_size = 256;
/// Returns how many of `pairs` pairs of a family were drawn independently of each other, at least: the pairs
/// of one climb are not.
std::uint64_t independent_draws(std::string_view family, std::uint64_t pairs);

/// Returns each fault that was not found, in words; empty if all were.
std::string describe_failed_checks(std::span<const SelfCheckRecord> checks);
/// Returns "self-check: 7 planted faults found, ..", or which were not; empty if none was planted.
std::string format_self_checks(std::span<const SelfCheckRecord> checks);

}  // namespace cyl
