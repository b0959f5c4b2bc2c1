// SPDX-License-Identifier: MIT
// The joints between two bodies of a scene, and how far the bodies can move against each other while these
// stay within a box.
#pragma once

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "scenes/scene.hpp"
#include "solver/decide.hpp"

namespace cyl {

/// Rounding errors in the positions of two bodies and in their travel. They are at most this times (links +
/// 1) (moving joints + 1) and times the length of everything between them. joint_path.cpp derives it.
inline constexpr double motion_error = 2048 * unit_roundoff_error;
/// Bound of rounding in half of a joint's range, relative to the values in it.
inline constexpr double range_error = 8 * unit_roundoff_error;

/// The range of a joint: [low, high].
struct Range {
  double low = 0, high = 0;
};
/// By the free joints of a path.
using JointBox = std::vector<Range>;

/// How much the bodies may come nearer to each other.
struct Travel {
  double length = 0;
  std::vector<double> shares;  ///< of each free joint
};

class JointPath {
 public:
  /// The scene must outlive it.
  JointPath(const Scene& scene, std::size_t a, std::size_t b);

  /// The links of the joints that are free and move the bodies against each other, by mimics too.
  const std::vector<std::size_t>& free_joints() const { return free_; }
  /// All that the free joints may take.
  JointBox limits() const;
  /// Whether a joint between the bodies is held here, or drawn only in part, and moves farther in truth.
  bool held() const { return held_; }

  /// Puts the free joints in the middle of a box and returns the bodies there.
  const Pair& place_middle(const JointBox& box);
  /// Returns how much less than there the bodies' gap along a unit direction from a to b can be anywhere in
  /// the box, all rounding included.
  Travel travel(const Vector3& direction);
  /// Returns the greatest gap there along the axis of a joint that turns, and this direction from a to b. It
  /// is not above 0 if no axis separates the bodies. Along parallel axes, no turn changes a gap.
  std::pair<double, Vector3> gap_along_axes() const;
  /// Returns how far a point of b, or of a, can be anywhere in the box from its place there in the other
  /// body, all rounding included.
  Travel travel_of(const Vector3& point) const;

 private:
  static constexpr std::size_t ends_cap = 8;
  /// A solid: the hull of some points, grown by a disk and a ball. The points are the ends of its axis, the
  /// corners of a box, or a point of the plane of a half-space.
  struct Side {
    Vector3 unit{0, 0, 1};
    std::size_t count = 2;
    std::array<Vector3, ends_cap> ends;
    double radius = 0;
    bool still = false;  ///< a half-space: nothing bounds how far it may reach, so the other moves
  };
  /// A solid as a turning joint has it.
  struct Seen {
    std::array<double, ends_cap> reach{};  ///< of its ends from the axis of the joint
    double tilt = 0;                       ///< largest change of the tilt of its disk per radian
  };
  /// The most that a joint adds to the reach of a solid.
  struct Step {
    std::array<double, ends_cap> ends{};
    double disk = 0;
    double tilt = 0;  ///< of a direction, by the joint itself
  };
  /// A joint that moves, as it stands in the middle of the box.
  struct Move {
    std::size_t link = 0;  ///< of `own_`
    bool turns = false;
    std::size_t variable = 0;
    double half = 0;  ///< of its range: rad, or a length
    Vector3 at{0, 0, 0}, axis{0, 0, 1};
    Seen a, b;
  };
  struct Value {
    double middle = 0, half = 0;
    std::size_t variable = 0;
  };
  static Side side_of(const Solid& solid);
  static Seen see(const Move& move, const Side& side);
  Step step_of(const Move& move, const Side& side, const Seen& seen, const Vector3& n, double tilted) const;
  /// How much farther a body may reach along n, towards the other; of a the joints before s, of b the others.
  double advance(bool of_b, std::size_t s, const Vector3& n, std::vector<double>& parts);
  void add_chain(const std::vector<std::size_t>& links);
  Value value_of(std::size_t link, const JointBox& box) const;

  const Scene& scene_;
  Scene own_;                      ///< the path alone; link 0 joins the chains of both bodies
  std::vector<std::size_t> of_;    ///< by link of `own_`: the scene's
  std::vector<std::size_t> free_;  ///< the scene's links
  std::vector<Move> moves_;        ///< from a to b
  bool held_ = false;
  double slack_ = 0, axis_error_ = 0;  ///< all rounding, and that of the direction of an axis
  std::vector<double> values_;
  std::vector<Solid> solids_;
  Pair placed_;
  Side a_, b_;
  std::vector<Step> steps_;
};

}  // namespace cyl
