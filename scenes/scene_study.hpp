// SPDX-License-Identifier: MIT
// What a scene really needs: which model of its cylinders answers which pair, what that costs, and where a
// cheaper model alone would be wrong. Judged on sampled configurations; what answers on them is checked
// against proofs.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "scenes/model_hierarchy.hpp"
#include "scenes/scene.hpp"

namespace cyl {

struct SceneQuestion {
  std::string file;      ///< where the scene comes from, to be told
  double clearance = 0;  ///< is any pair this near or nearer? The scene's unit
  double tolerated =
      0;  ///< false alarms that nobody minds: of pairs farther than the clearance by up to this
  std::size_t configurations = 1000;  ///< drawn; one where nothing moves or `at` is not empty
  std::uint64_t seed = 1;
  bool all_pairs = false;
  bool verify = false;  ///< puts every recommended answer before the referee, up to verified_cap
  std::vector<std::pair<std::string, double>> at;  ///< joints of the one configuration
};

/// The most answers that --verify puts before the referee, evenly spread: about 10 s.
inline constexpr std::size_t verified_cap = 100'000;

/// A model trusted alone.
struct Score {
  std::size_t wrong = 0;                    ///< of the samples
  double alarm = 0;                         ///< the farthest beyond the clearance that it says within
  double missed = 0;                        ///< the deepest below the clearance that it says apart
  std::size_t alarm_in = 0, missed_in = 0;  ///< the configurations of those two
};

/// One pair over all configurations.
struct PairStudy {
  std::size_t a = 0, b = 0;  ///< bodies
  std::size_t samples = 0;
  std::size_t within = 0;          ///< samples that are within the clearance
  double least = 0, greatest = 0;  ///< distance
  std::array<Score, rung_count> alone{};
  std::array<std::size_t, rung_count> decided{};  ///< samples of which a rung is the first to decide
  std::array<std::size_t, 8> outcomes{};  ///< samples by the set of {sphere, outer, inner} that decide them
  Plan plan;
  std::size_t plan_wrong = 0;  ///< samples that the plan answers wrong: false alarms that are tolerated
};

/// The sample whose distance is nearest to the clearance: how exact an answer must be.
struct ClosestCall {
  std::size_t a = 0, b = 0, configuration = 0;
  double distance = 0;
  double size = 0;  ///< radii and heights of the pair together
};

struct Verification {
  std::size_t asked = 0, wrong = 0, tolerated = 0, undecided = 0;
};

struct SceneStudy {
  std::size_t bodies = 0, configurations = 0;
  std::array<std::size_t, 4> pairs_by_reason{};  ///< by PairRule::Reason
  std::vector<PairStudy> pairs;
  std::size_t asked_referee = 0;  ///< samples that no rung decides
  std::size_t undecided = 0;      ///< of those, what the referee does not prove either: taken for within
  std::optional<ClosestCall> closest;
  // Of one configuration, in ns.
  double kinematics_ns = 0, models_ns = 0, plan_ns = 0;
  std::array<double, rung_count> alone_ns{};
  std::optional<Verification> verification;
};

/// Throws UsageError where `at` names no joint, and where the scene has more than study_cap
/// bodies.
SceneStudy study_scene(const Scene& scene, const SceneQuestion& question);
/// All pairs of so many bodies are looked at one by one.
inline constexpr std::size_t study_cap = 1000;

/// A model over all pairs.
struct Total {
  std::size_t decided = 0, suffices = 0, wrong = 0, wrong_pairs = 0;
  double alarm = 0, missed = 0;
};
Total total_of(const SceneStudy& study, Rung rung, double tolerated);

/// The joints of one of the study's configurations.
std::vector<double> joints_of(const Scene& scene, const SceneQuestion& question, std::size_t configuration);

/// The referee's word on whether a pair is within the clearance; nothing where it has none.
std::optional<bool> referee_within(const Pair& pair, double clearance);

/// Whether a model alone answers all samples right, but for false alarms that are tolerated.
bool suffices(const PairStudy& pair, Rung rung, double tolerated);

/// The simplest model that alone answers all samples of a pair right: sphere, capsule, cylinder, distance,
/// proof. What is cheapest is another question: `recommend`.
Rung needed(const PairStudy& pair, double tolerated);

/// The cheapest model that answers all samples of a pair right (but for tolerated alarms), and before it
/// those that save more than they cost, by `rung_weight`.
Plan recommend(const PairStudy& pair, double tolerated);

/// ns of a rung, measured on random rods whose balls overlap. Only the ratios matter, and that they are the
/// same for everybody, so that a seed gives the same plan. Our yes or no about cylinders costs less than the
/// capsules' distance.
inline constexpr std::array<double, rung_count> rung_weight{2.3, 46, 47, 10.6, 195, 200};

}  // namespace cyl
