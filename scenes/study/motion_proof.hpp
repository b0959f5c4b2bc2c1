// SPDX-License-Identifier: MIT
// Proofs over motions: are two bodies of a scene farther apart than a clearance in every configuration? It
// uses branch and bound over the box of the joints between them. The referee finds a direction that separates
// the bodies in the middle of a box. If no motion within the box can bring them that much nearer, the box is
// closed. Else it is cut in two.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "base/enum_words.hpp"
#include "scenes/scene.hpp"
#include "scenes/study/all_cores.hpp"

namespace cyl {

/// Worst first.
enum class MotionVerdict : unsigned char {
  refuted,  ///< the referee confirms a configuration in which they overlap or touch
  within,   ///< it confirms one within the clearance; none was found in which they overlap
  open,     ///< nothing is known, within the cap on boxes
  never     ///< proved: farther from each other than the clearance in all configurations
};
constexpr auto words_of(MotionVerdict) noexcept { return std::array{"refuted", "within", "open", "never"}; }

/// Boxes looked at for one pair, about 2 us each.
inline constexpr std::size_t motion_box_cap = 100'000;

struct MotionQuestion {
  double clearance = 0;
  std::size_t box_cap = motion_box_cap;
  std::size_t open_cap = motion_box_cap;  ///< boxes of a pair that is not proved by then: it is left open
  std::uint64_t seed = 1;                 ///< of the configurations from which a near one is looked for
  const std::vector<std::vector<double>>* drawn = nullptr;  ///< these; if null, they are drawn again
  Workforce workforce = {};
};
/// The configurations that are drawn before any proof.
inline constexpr std::size_t motion_draws_cap = 200;

/// The result for two bodies over all configurations.
struct MotionProof {
  std::size_t a = 0, b = 0;
  MotionVerdict verdict = MotionVerdict::open;
  double bound = 0;                  ///< proved, if above 0: their distance is greater in every configuration
  double least = 0;                  ///< the least distance seen; a negative value is a depth
  std::vector<std::size_t> between;  ///< links whose free joints move the bodies against each other
  std::vector<double> joints;        ///< their values at that; if `refuted` or `within`, confirmed there
  std::size_t boxes = 0;             ///< that were looked at
  double open_share = 0;             ///< of the joints' space, nothing is proved of so much
  bool bounded = false;  ///< `open`: within the clearance, but of a solid that only holds a mesh or ellipsoid
  bool held = false;     ///< a joint between them moves farther in truth than here: it is never `never`
  bool always = false;   ///< `refuted`: they are proved to overlap in every configuration
  bool out_of_time = false;   ///< `open`: the deadline came first
  bool contradicted = false;  ///< `open`: they were seen nearer than was proved, which is a fault of ours
};

/// Proves or refutes that two bodies stay farther from each other than the clearance. The configurations are
/// all values of the joints within their limits; mimics follow. A continuous joint turns as often as it and
/// its followers need to repeat. The robot is the scene's, each joint's origin taken for the rotation nearest
/// to its matrix.
MotionProof prove_motion(const Scene& scene, std::size_t a, std::size_t b, const MotionQuestion& question);

/// Returns all joints of the scene with these links' joints at these values. The others are as near to 0 as
/// they can be.
std::vector<double> set_joints(const Scene& scene, const std::vector<std::size_t>& links,
                               const std::vector<double>& values);

/// The result for a link pair that the SRDF calls "Never". `within`: they come within the clearance, and are
/// proved never to touch.
struct ExemptionProof {
  std::size_t exemption = 0;  ///< of the scene's
  MotionVerdict verdict = MotionVerdict::open;
  bool not_looked_at = false;       ///< a link has shapes that are not known: `open` or refuted
  std::vector<MotionProof> bodies;  ///< of each body of the one with each of the other
};

struct MotionStudy {
  std::vector<MotionProof> pairs;
  std::vector<ExemptionProof> exemptions;  ///< those whose reason is "Never"
  std::vector<MotionProof> others;         ///< of pairs that are not checked
  double ms = 0;                           ///< of CPU time
  std::size_t contradicted = 0;            ///< pairs of bodies with a proof that was withdrawn
};

using BodyPairs = std::vector<std::pair<std::size_t, std::size_t>>;
/// Does this for all these pairs of bodies, for those that the scene's SRDF disables, and for others, on all
/// cores. Pairs with few joints between them come first. A pair that needs many boxes waits for all others.
/// `seen` has the least distance of each of `pairs` that the caller has seen.
MotionStudy prove_motions(const Scene& scene, const BodyPairs& pairs, std::span<const double> seen,
                          const MotionQuestion& question, const BodyPairs& others = {});

/// Takes back what was proved of two bodies if they are seen nearer.
void contradict(MotionProof& proof, double seen);

/// Returns whether a link has shapes that were not looked at.
bool has_unknown_shapes(const Scene& scene, std::size_t link);

}  // namespace cyl
