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
  std::string equivalent;              ///< why no test can see it; empty where one can
  std::vector<std::string> caught_by;  ///< names of detectors
  std::optional<std::uint64_t>
      family_index{};  ///< of the pair that a campaign found it with, among its family's
};

/// Returns the rows of a file in their order. Throws std::runtime_error that names the file where it cannot
/// be read or has another content.
std::vector<KillMatrixRow> read_kill_matrix(const std::string& file);

/// Returns the rows of the faults that campaigns soon find beyond the claim of a method, those alone of which
/// every method that may betray them is among `methods`.
std::vector<KillMatrixRow> faults_soon_found(const std::vector<KillMatrixRow>& rows,
                                             std::span<const std::unique_ptr<Method>> methods);

/// Returns what the page shows: how many planted faults there are, how many were caught and argued
/// equivalent, and every one of them with who caught it; null where the file does not exist. Throws as
/// read_kill_matrix() does.
nlohmann::ordered_json kill_data(const std::string& file);

}  // namespace cyl
