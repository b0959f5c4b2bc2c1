// SPDX-License-Identifier: MIT
#include "oracles/trial/witness_set.hpp"

#include <algorithm>

namespace cyl {

WitnessSet::WitnessSet(std::span<const std::unique_ptr<Method>> methods) {
  auto ours = certifying_method();
  const auto is_ours = [&](const auto& method) { return method->name() == ours->name(); };
  if (std::none_of(methods.begin(), methods.end(), is_ours)) ours_ = std::move(ours);
}

std::span<const MethodAnswer> WitnessSet::with_own_witness(const Pair& pair,
                                                           std::span<const MethodAnswer> said) {
  if (!ours_) return said;
  all_.assign(said.begin(), said.end());
  all_.push_back(ours_->ask(pair));
  return all_;
}

}  // namespace cyl
