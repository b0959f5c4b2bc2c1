// SPDX-License-Identifier: MIT
// Compares the answers of builds of the same source. They differ in compiler, level of optimization, fused
// multiply-add, and denormal numbers flushed to 0. bench/stability/builds.sh makes the builds and runs them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "oracles/methods/method.hpp"
#include "oracles/trial/trial.hpp"

namespace cyl {

/// The differences of one method's answers.
struct BuildDifference {
  std::string method, build, against;
  std::uint64_t pairs = 0;              ///< asked in both builds
  std::uint64_t verdicts_changed = 0;   ///< the verdict, or whether there is one
  std::uint64_t beyond_claim = 0;       ///< those whose new verdict is proved wrong beyond the method's claim
  std::uint64_t distances_changed = 0;  ///< the number, or whether there is one
  std::optional<double> largest_change;  ///< relative to the size, of distances that both builds have
};

/// Returns the pairs for the comparison of builds: the first pairs of every family, and pairs of every
/// stratum in three scales. These are as they are, scaled so that products vanish (2^-500), to just above the
/// least normal numbers (2^-1010), and to denormal lengths (2^-1060, rounded).
std::vector<Pair> build_pairs();

/// Holds builds against one another; what is proved of a pair is found once.
class BuildComparison {
 public:
  BuildComparison(std::span<const std::unique_ptr<Method>> methods, std::span<const Pair> pairs)
      : methods_(methods), pairs_(pairs) {}
  /// Returns the differences by method. Answers are by pair and then method, as build_answers_main.cpp writes
  /// them; those at indices outside the method's share do not count. The names of the builds stay empty.
  std::vector<BuildDifference> compare(std::span<const MethodAnswer> against,
                                       std::span<const MethodAnswer> build);

 private:
  bool is_wrong_beyond_claim(std::size_t pair, const Method& method, const MethodAnswer& answer);

  std::span<const std::unique_ptr<Method>> methods_;
  std::span<const Pair> pairs_;
  std::map<std::size_t, Proofs> proofs_;
};

nlohmann::json to_json(const BuildDifference& difference);
/// Returns the differences in a file like bench/stability/builds.jsonl, whose first line names their source.
/// Returns an empty list if there is no such file. Throws std::runtime_error that names the file if its
/// content is different.
nlohmann::json builds_json(const std::filesystem::path& file);

}  // namespace cyl
