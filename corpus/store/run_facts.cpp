// SPDX-License-Identifier: MIT
#include "corpus/store/run_facts.hpp"

#include <fmt/format.h>

#include "base/json.hpp"
#include "base/number_text.hpp"
#include "base/safe_text.hpp"
#include "base/usage_error.hpp"

namespace cyl {

std::string value_of(const Config& config, const std::string& key) {
  const auto found = config.find(key);
  return found == config.end() ? "" : found->second;
}

const std::string& text_of(const Config& config, const std::string& key) {
  const auto found = config.find(key);
  if (found == config.end()) throw InputError("the run does not state its " + key);
  return found->second;
}

std::uint64_t number_of(const Config& config, const std::string& key) {
  const std::string& text = text_of(config, key);
  const auto number = number_in<std::uint64_t>(text);
  if (!number) throw InputError(fmt::format("the {} of the run is '{}', no whole number", key, text));
  return *number;
}

Shard shard_of(const Config& config) {
  const std::string text = value_of(config, "shard");
  unsigned long long index = 0, count = 1, batch = 1;
  if (text.empty()) return {};
  if (std::sscanf(text.c_str(), "%llu/%llu of batches of %llu", &index, &count, &batch) != 3 ||
      index >= count || batch == 0) {
    throw InputError("the shard of the run is '" + text + "', no shard");
  }
  return {index, count, batch};
}

void check_progress(const RunStore& run) {
  const std::uint64_t own = shard_of(run.config()).below(run.progress().next);
  std::uint64_t judged = 0;
  for (const TallyRecord& t : run.tallies())
    if (t.method == referee_row) judged += t.counts.asked;
  if (judged != own)
    throw InputError(
        fmt::format("the run states that it did {} pairs, and its referee judged {}: it is damaged or forged",
                    own, judged));
}

std::optional<Verdict> proved_verdict(const FindingRecord& finding) {
  const auto truth = nlohmann::json::parse(finding.truth, nullptr, false);
  if (!truth.is_object() || !truth.contains("verdict") || !truth["verdict"].is_string()) return {};
  const auto verdict = from_word<Verdict>(truth["verdict"].get_ref<const std::string&>());
  return verdict == Verdict::undecided || verdict == Verdict::invalid ? std::nullopt : verdict;
}

std::string format_shard(const Shard& shard) {
  if (shard.count == 1) return "";
  return fmt::format("{}/{} of batches of {}", shard.index, shard.count, shard.batch);
}

}  // namespace cyl
