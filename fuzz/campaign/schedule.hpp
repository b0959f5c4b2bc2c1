// SPDX-License-Identifier: MIT
// The family of each pair of a run. A family of weight w has w evenly spread turns in every round. If all
// weights are 1, the families take turns in their order. A pure function of weights and index.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "corpus/pairs/families.hpp"

namespace cyl {

/// The most turns in a round, compared with a family without findings. Every family keeps its turns, and
/// fruitful families take most of a campaign.
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

/// Weights from 1 to weight_cap, in proportion to the number of different findings (method and kind) beyond a
/// claim that an earlier run has in the family. `folder` is that run, or a folder of runs, which count
/// together. Throws UsageError if it is neither.
std::vector<unsigned> weights_from(const std::string& folder, std::span<const Family> families);

/// Weights as a run's configuration keeps them, "3 1 1"; empty for equal ones, which need no record.
std::string format_weights(std::span<const unsigned> weights);
/// Returns what format_weights was given. Throws std::runtime_error on anything else.
std::vector<unsigned> parse_weights(const std::string& text);

}  // namespace cyl
