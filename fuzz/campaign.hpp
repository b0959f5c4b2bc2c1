// SPDX-License-Identifier: MIT
// A campaign: draws pairs from the case files and the families, asks every method, lets the referee judge, and
// stores what it finds. A pure function of (seed, pairs, families, methods); times and kind `hang` excepted.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace cyl {

struct CampaignOptions {
  std::string out;                 ///< run folder; created
  std::uint64_t seed = 0;
  std::uint64_t pairs = 0;         ///< 0: no limit
  std::chrono::milliseconds budget{0};  ///< 0: no limit; at least one of the two limits is set
  std::string methods;             ///< spec of select_methods; empty: all
  std::string families;            ///< same rule; empty: all
  std::string cases;               ///< folder of case files played first; empty: none
  unsigned jobs = 2;               ///< batches under way at once; does not change the findings
  bool resume = false;
};

}  // namespace cyl
