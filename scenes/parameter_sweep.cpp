// SPDX-License-Identifier: MIT
#include "scenes/parameter_sweep.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <ctime>

#include "base/json.hpp"
#include "scenes/broad_phase.hpp"

namespace cyl {
namespace {

/// Of this thread: what others do on the machine is not in it.
double cpu_ms() {
  timespec t;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) * 1e3 + static_cast<double>(t.tv_nsec) * 1e-6;
}

/// The rungs that save more than they cost in a crowd of close pairs (a capsule costs more than the
/// cylinder).
constexpr std::array<Rung, 4> asked{Rung::sphere, Rung::cylinder, Rung::distance, Rung::certified};

using BodyPair = std::pair<std::uint32_t, std::uint32_t>;

/// `within` is sorted.
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

SceneSweep sweep_scene(std::span<const Cylinder> cylinders, double clearance, bool verify) {
  SceneSweep s;
  s.bodies = cylinders.size();
  double began = cpu_ms();
  std::vector<Models> models;
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
    Look seen = Look::closer;
    for (const Rung rung : asked) {
      seen = look(rung, models[pair.first], models[pair.second], clearance);
      if (seen == Look::closer) continue;
      ++s.decided[static_cast<std::size_t>(rung)];
      break;
    }
    if (seen == Look::apart) continue;
    s.undecided += seen == Look::closer;
    s.within.push_back(pair);
  }
  s.ladder_ms = cpu_ms() - began;
  std::sort(s.within.begin(), s.within.end());
  if (verify) s.verification = verify_answers(cylinders, clearance, candidates, s.within);
  return s;
}

std::string sweep_head() {
  return fmt::format("{:>10} {:>12} {:>10} {:>10} {:>10} {:>10} {:>10} {:>11} {:>10} {:>11}\n", "cylinders",
                     "boxes meet", "sphere", "cylinder", "distance", "undecided", "within", "prepare ms",
                     "tree ms", "ladder ms");
}

std::string sweep_line(const SceneSweep& s) {
  return fmt::format("{:>10} {:>12} {:>10} {:>10} {:>10} {:>10} {:>10} {:>11.2f} {:>10.2f} {:>11.2f}\n",
                     s.bodies, s.candidates, s.decided[0], s.decided[3], s.decided[4] + s.decided[5],
                     s.undecided, s.within.size(), s.prepare_ms, s.tree_ms, s.ladder_ms);
}

std::string sweep_json(const SceneSweep& s) {
  nlohmann::ordered_json decided;
  for (const Rung rung : asked) decided[to_string(rung)] = s.decided[static_cast<std::size_t>(rung)];
  return nlohmann::ordered_json{
             {"cylinders", s.bodies},
             {"candidates", s.candidates},
             {"decided", std::move(decided)},
             {"undecided", s.undecided},
             {"cpu_ms", {{"prepare", s.prepare_ms}, {"tree", s.tree_ms}, {"ladder", s.ladder_ms}}},
             {"within", s.within}}
             .dump() +
         '\n';
}

}  // namespace cyl
