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

}  // namespace cyl
