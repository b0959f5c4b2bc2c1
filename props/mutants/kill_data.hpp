// SPDX-License-Identifier: MIT
// The rows of a kill matrix, as `daylight mutants matrix --json FILE` writes them: read for the page, and for
// the campaigns that plant faults.
#pragma once

#include <cstdint>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "oracles/methods/method.hpp"

namespace cyl {

struct KillMatrixRow {
  int mutant = 0;  ///< 0: the program as it is
  std::string file, what;
  std::string asks;                    ///< names of methods, as select_methods() takes them
  std::string equivalent;              ///< why no test can detect it; empty if a test can
  std::vector<std::string> caught_by;  ///< names of detectors
  std::optional<std::uint64_t>
      family_index{};  ///< of the pair that a campaign found it with, among its family's
};

/// Returns the rows of a file in their order. Throws std::runtime_error that names the file if it cannot be
/// read or has other content.
std::vector<KillMatrixRow> read_kill_matrix(const std::string& file);

/// Returns the rows of the faults that campaigns soon find beyond the claim of a method, if every method that
/// may detect them is among `methods`.
std::vector<KillMatrixRow> faults_soon_found(const std::vector<KillMatrixRow>& rows,
                                             std::span<const std::unique_ptr<Method>> methods);

/// Returns the data of the page: the numbers of planted faults, of detected ones, and of faults argued to be
/// equivalent. Then each fault with its detectors. Null if the file does not exist. Throws like
/// read_kill_matrix().
nlohmann::ordered_json kill_data(const std::string& file);

}  // namespace cyl
