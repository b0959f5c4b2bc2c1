// SPDX-License-Identifier: MIT
#include "corpus/store/run_facts.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <stdexcept>

#include "base/safe_text.hpp"

namespace cyl {

std::string value_of(const Config& config, const std::string& key) {
  const auto found = config.find(key);
  return found == config.end() ? "" : found->second;
}

Shard shard_of(const Config& config) {
  const std::string text = value_of(config, "shard");
  unsigned long long index = 0, count = 1, batch = 1;
  if (text.empty()) return {};
  if (std::sscanf(text.c_str(), "%llu/%llu of batches of %llu", &index, &count, &batch) != 3 ||
      index >= count || batch == 0) {
    throw std::runtime_error("'" + text + "' names no shard");
  }
  return {index, count, batch};
}

std::string format_shard(const Shard& shard) {
  if (shard.count == 1) return "";
  return fmt::format("{}/{} of batches of {}", shard.index, shard.count, shard.batch);
}

std::uint64_t independent_draws(std::string_view family, std::uint64_t pairs) {
  return family == climbed_name ? (pairs + climb_size - 1) / climb_size : pairs;
}

std::string describe_failed_checks(std::span<const SelfCheckRecord> checks) {
  std::string text;
  for (const SelfCheckRecord& a : checks) {
    if (a.found) continue;
    if (!text.empty()) text += "; ";
    text += fmt::format("planted fault {} ({}) was not found from index {} on", a.mutant, a.what, a.start);
    text += a.said.empty() ? fmt::format(" in {} pairs", a.pairs)
                           : fmt::format(", because its process ended: {}", a.said);
  }
  return text;
}

std::string format_self_checks(std::span<const SelfCheckRecord> checks) {
  if (checks.empty()) return {};
  if (const std::string failed = describe_failed_checks(checks); !failed.empty())
    return "SELF-CHECK FAILED: " + failed;
  std::uint64_t most = 0, milliseconds = 0;
  for (const SelfCheckRecord& a : checks) {
    most = std::max(most, a.pairs);
    milliseconds += a.milliseconds;
  }
  return fmt::format("self-check: {} found, each after at most {} pairs, in {:.1f} s",
                     counted(checks.size(), "planted fault"), most, static_cast<double>(milliseconds) / 1000);
}

}  // namespace cyl
