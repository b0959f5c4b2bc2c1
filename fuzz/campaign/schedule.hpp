// SPDX-License-Identifier: MIT
// The family of each pair of a run. A family of weight w has w evenly spread turns in every round. If all
// weights are 1, the families take turns in their order. A pure function of weights and index.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace cyl {

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

}  // namespace cyl
