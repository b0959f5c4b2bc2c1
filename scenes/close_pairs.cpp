// SPDX-License-Identifier: MIT
#include "scenes/close_pairs.hpp"

#include <algorithm>
#include <ctime>

#include "scenes/broad_phase.hpp"

namespace cyl {
namespace {

/// Returns the CPU time of this thread: what others do on the machine is not in it.
double cpu_ms() {
  timespec t;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) * 1e3 + static_cast<double>(t.tv_nsec) * 1e-6;
}

using BodyPair = std::pair<std::uint32_t, std::uint32_t>;

/// Asks the referee about all candidates; `within` is sorted.
Verification verify_answers(std::span<const Cylinder> cylinders, double clearance,
                            std::span<const BodyPair> candidates, std::span<const BodyPair> within) {
  Verification v;
  for (const BodyPair& pair : candidates) {
    const auto truth = referee_within({cylinders[pair.first], cylinders[pair.second]}, clearance);
    ++v.asked;
    if (!truth)
      ++v.undecided;
    else if (*truth != std::binary_search(within.begin(), within.end(), pair))
      ++v.wrong;
  }
  return v;
}

}  // namespace

ClosePairs find_close_pairs(std::span<const Cylinder> cylinders, double clearance, bool verify) {
  ClosePairs s;
  s.bodies = cylinders.size();
  double began = cpu_ms();
  std::vector<ProxyModels> models;
  std::vector<Box> boxes;
  models.reserve(cylinders.size());
  boxes.reserve(cylinders.size());
  for (const Cylinder& c : cylinders) {
    models.push_back(make_models(c, clearance));
    boxes.push_back(box_around(models.back().solid, clearance));
  }
  s.prepare_ms = cpu_ms() - began;
  began = cpu_ms();
  const auto candidates = near_pairs(boxes);
  s.candidates = candidates.size();
  s.tree_ms = cpu_ms() - began;
  began = cpu_ms();
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
  s.cascade_ms = cpu_ms() - began;
  std::sort(s.within.begin(), s.within.end());
  if (verify) s.verification = verify_answers(cylinders, clearance, candidates, s.within);
  return s;
}

}  // namespace cyl
