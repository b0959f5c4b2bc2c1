// SPDX-License-Identifier: MIT
#include "fuzz/campaign/schedule.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace cyl {

// Smooth weighted round robin: each step all gain their weight, the richest (the first of equals) has the
// turn and pays the sum. After a round every credit is 0 again. Equal weights give the order itself.
Schedule::Schedule(std::vector<unsigned> weights) : weights_(std::move(weights)) {
  const std::int64_t sum = std::accumulate(weights_.begin(), weights_.end(), std::int64_t{0});
  std::vector<std::int64_t> credit(weights_.size());
  std::vector<std::uint64_t> had(weights_.size());
  for (std::int64_t step = 0; step < sum; ++step) {
    for (std::size_t f = 0; f < weights_.size(); ++f) credit[f] += weights_[f];
    const auto richest = std::max_element(credit.begin(), credit.end());
    *richest -= sum;
    const auto family = static_cast<std::size_t>(richest - credit.begin());
    round_.push_back({family, had[family]++});
  }
}

}  // namespace cyl
