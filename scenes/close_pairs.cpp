// SPDX-License-Identifier: MIT
#include "scenes/close_pairs.hpp"

#include <algorithm>

#include "base/stopwatch.hpp"
#include "scenes/broad_phase.hpp"

namespace cyl {

ClosePairs find_close_pairs(std::span<const Cylinder> cylinders, double clearance, bool verify) {
  ClosePairs s;
  s.bodies = cylinders.size();
  double began = processor_ns();
  std::vector<ProxyModels> models;
  std::vector<Box> boxes;
  models.reserve(cylinders.size());
  boxes.reserve(cylinders.size());
  for (const Cylinder& c : cylinders) {
    models.push_back(make_models(c));
    boxes.push_back(box_around(models.back().solid, clearance));
  }
  s.prepare_ms = 1e-6 * (processor_ns() - began);
  began = processor_ns();
  const auto candidates = near_pairs(boxes);
  s.candidates = candidates.size();
  s.tree_ms = 1e-6 * (processor_ns() - began);
  began = processor_ns();
  for (const auto& pair : candidates) {
    Proximity seen = Proximity::unclear;
    for (const Level level : crowd_levels) {
      seen = proximity(level, models[pair.first], models[pair.second], clearance);
      if (seen == Proximity::unclear) continue;
      ++s.decided[index_of(level)];
      break;
    }
    if (seen == Proximity::apart) continue;
    s.undecided += seen == Proximity::unclear;
    s.within.push_back(pair);
  }
  s.cascade_ms = 1e-6 * (processor_ns() - began);
  std::sort(s.within.begin(), s.within.end());
  if (!verify) return s;
  Verification& v = s.verification.emplace();
  for (const auto& pair : candidates)
    v.add({cylinders[pair.first], cylinders[pair.second]}, clearance, 0,
          std::binary_search(s.within.begin(), s.within.end(), pair));
  return s;
}

}  // namespace cyl
