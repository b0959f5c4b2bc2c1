// SPDX-License-Identifier: MIT
// Studies which models a scene needs: which model answers each pair, at what cost, and how often a
// cheaper model alone is wrong. It uses sampled configurations, and checks the answers against
// proofs.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "scenes/scene.hpp"
#include "scenes/study/model_hierarchy.hpp"
#include "scenes/study/motion_proof.hpp"
#include "scenes/study/reach.hpp"
#include "scenes/study/verification.hpp"

namespace cyl {

struct SceneOptions {
  std::string file;      ///< the file of the scene, for the report
  double clearance = 0;  ///< is any pair this near or nearer? In the scene's unit
  double tolerated = 0;  ///< false alarms of pairs at most this much beyond the clearance are harmless
  std::size_t configurations = 1000;  ///< drawn; one if nothing moves or `at` is not empty
  std::uint64_t seed = 1;
  bool prove = false;         ///< over all motions, whether the pairs come within the clearance
  bool prove_others = false;  ///< also pairs that are not checked and not adjacent, for an SRDF
  Workforce workforce = {};   ///< a deadline leaves half of the time to proofs
  std::vector<std::pair<std::string, double>> at;  ///< joints of the one configuration
};

/// The most recommended answers that the referee judges, evenly spread: about 0.03 s.
inline constexpr std::size_t verified_cap = 10'000;

/// An accepted model on the samples of a pair.
struct Score {
  std::size_t wrong = 0;  ///< of the samples
  double alarm = 0;       ///< how far the farthest pair that it calls within is beyond the clearance
  double missed = 0;      ///< how far the deepest pair that it calls apart is below the clearance
};

/// One pair over all configurations.
struct PairStudy {
  std::size_t a = 0, b = 0;        ///< bodies
  std::size_t samples = 0;         ///< the study's configurations
  std::size_t within = 0;          ///< samples that are within the clearance
  std::size_t met = 0;             ///< of these, those that hold for the shapes, not only for bounding solids
  double least = 0, greatest = 0;  ///< distance
  std::array<Score, level_count> alone{};
  std::array<std::size_t, level_count> decided{};  ///< samples that a level is the first to decide
  std::array<std::size_t, 8> outcomes{};  ///< samples by the set of {sphere, outer, inner} that decide them
  Cascade cascade;
  std::size_t cascade_wrong = 0;  ///< samples that the cascade answers wrong: false alarms that are tolerated
};

/// The sample whose distance is nearest to the clearance: how exact an answer must be.
struct ClosestCall {
  std::size_t a = 0, b = 0, configuration = 0;
  double distance = 0;
  double size = 0;  ///< radii and heights of the pair together
};

struct SceneStudy {
  std::size_t bodies = 0, configurations = 0;
  bool drawn = false;                            ///< more than one configuration, so rates have bounds
  std::array<std::size_t, 5> pairs_by_reason{};  ///< by PairRule::Reason
  std::vector<PairStudy> pairs;
  /// By body, what it may reach, if more than listed_cap pairs are checked. Then those far apart are only
  /// counted.
  std::vector<Box> reaches;
  std::size_t far = 0;  ///< checked pairs that are not listed: farther apart than the clearance for ever
  std::size_t asked_referee = 0;  ///< samples that no level decides
  std::size_t undecided = 0;      ///< samples without a proof of the referee; they count as within
  std::optional<ClosestCall> closest;
  // For one configuration, in ns.
  double kinematics_ns = 0, models_ns = 0, cascade_ns = 0;
  std::array<double, level_count> alone_ns{};
  Verification verification;
  std::optional<MotionStudy> motions;  ///< its pairs are those above
};

/// Throws UsageError if `at` names no joint, and InputError if more than near_cap pairs are near each other.
SceneStudy study_scene(const Scene& scene, const SceneOptions& question);
/// If more pairs are checked, a broad phase drops those that never come near. A report lists all others.
inline constexpr std::size_t listed_cap = 20'000;
/// A pair takes some 600 bytes.
inline constexpr std::size_t near_cap = 1'000'000;

/// Returns whether what two bodies may reach is proved to be farther apart than the clearance, and the pair
/// is not listed for this reason.
bool is_far(const SceneStudy& study, std::size_t a, std::size_t b, double clearance);

/// Returns whether the samples describe the pair itself. They do not if one body is a bound of a mesh or
/// ellipsoid that comes within the clearance, while a solid in the shape does not.
inline bool is_known(const PairStudy& pair) { return pair.met == pair.within; }
/// Returns whether it is not known if the shapes come within the clearance in any sample.
inline bool is_open(const PairStudy& pair) { return pair.within > 0 && pair.met == 0; }

/// Returns the links whose joints are held here, move in truth and lie between the two.
std::vector<std::size_t> joints_held_between(const Scene& scene, const PairStudy& pair);

/// Returns the joints that are held and stand between the bodies of a checked pair: of how such a pair moves
/// nothing is known.
std::vector<std::string> joints_held_between(const Scene& scene, const SceneStudy& study);

/// A model over all pairs. It suffices only for a pair that is known.
struct Total {
  std::size_t decided = 0, suffices = 0, wrong = 0, wrong_pairs = 0;
  double alarm = 0, missed = 0;
};
Total total_of(const SceneStudy& study, Level level, double tolerated);

/// Returns the joints of one of the study's configurations.
std::vector<double> joints_of(const Scene& scene, const SceneOptions& question, std::size_t configuration);

/// Returns whether an accepted model answers all samples right, except for tolerated false alarms.
bool suffices(const PairStudy& pair, Level level, double tolerated);

/// Returns whether what is recommended is known from samples alone, not from what the model is: of a ball or
/// a capsule that it raises no false alarm.
bool is_statistical(const PairStudy& pair);

/// Returns the simplest model that answers all samples of a pair right: sphere, capsule, cylinder, distance,
/// proof. `recommend` finds the cheapest.
Level needed(const PairStudy& pair, double tolerated);

/// Returns the cheapest model that answers all samples of a pair right (but for tolerated alarms), and before
/// it those that save more than they cost, by `level_weight`.
Cascade recommend(const PairStudy& pair, double tolerated);

/// ns of each level, measured on random pairs of rods with overlapping balls, half of them capsules, at touch
/// and at a clearance. Only the ratios matter. They are constant, so that a seed gives the same cascade on
/// every machine.
inline constexpr std::array<double, level_count> level_weight{2.8, 14, 14, 24, 270, 87};

}  // namespace cyl
