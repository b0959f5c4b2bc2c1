// SPDX-License-Identifier: MIT
// Which family draws which pair of a run. A family of weight w has w turns in every round, spread evenly; all
// weights 1: the families in their order, over and over. A pure function of weights and index.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "corpus/pairs/families.hpp"

namespace cyl {

/// The most turns in a round of a family against one that never found anything: nobody starves, and what has
/// been fruitful takes most of a campaign.
inline constexpr unsigned weight_cap = 8;

class Schedule {
 public:
  struct Turn {
    std::size_t family;
    std::uint64_t index;  ///< of the family's own pairs
  };

  /// Weights of at least 1, one a family.
  explicit Schedule(std::vector<unsigned> weights);
  Turn at(std::uint64_t index) const {
    const Slot& slot = round_[index % round_.size()];
    return {slot.family, index / round_.size() * weights_[slot.family] + slot.before};
  }

 private:
  struct Slot {
    std::size_t family;
    std::uint64_t before;  ///< turns the family had earlier in the round
  };
  std::vector<unsigned> weights_;
  std::vector<Slot> round_;
};

/// Weights from 1 to weight_cap: in proportion to how many different things (method and kind) an earlier run
/// found wrong beyond a claim in the family. `folder` holds that run, or is a folder of runs, which count
/// together. Throws UsageError where it is neither.
std::vector<unsigned> weights_from(const std::string& folder, std::span<const Family> families);

/// Weights as a run's configuration keeps them, "3 1 1"; empty for equal ones, which need no record.
std::string format_weights(std::span<const unsigned> weights);
/// Returns what format_weights was given. Throws std::runtime_error on anything else.
std::vector<unsigned> parse_weights(const std::string& text);

}  // namespace cyl
