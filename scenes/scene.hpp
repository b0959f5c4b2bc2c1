// SPDX-License-Identifier: MIT
// A scene: cylinders, capsules, spheres, boxes and half-spaces, and bounds of meshes. They move with the
// links of a mechanism, or stand still. Files of every format become a Scene.
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "solver/solid.hpp"

namespace cyl {

using Pose = Eigen::Isometry3d;

enum class Motion : unsigned char { fixed, turn, slide };

/// The value of a joint that mimics another's: multiplier * value + offset.
struct Follow {
  std::size_t link;  ///< whose joint it mimics
  double multiplier = 1, offset = 0;
};

/// A link with the joint that carries it.
struct Link {
  std::string name;
  std::string joint;                  ///< its name; empty if no joint carries the link
  std::optional<std::size_t> parent;  ///< comes before this link
  Pose origin = Pose::Identity();     ///< of the joint, in the parent's frame
  Motion motion = Motion::fixed;
  bool held = false;      ///< fixed only here: its joint moves in a way that nothing draws
  bool floats = false;    ///< `held`: in truth it goes everywhere, by a free joint of MJCF or a floating one
  bool split = false;     ///< the next link is another part of the same body of MJCF
  bool stands = false;    ///< on a parent that is there to be hit, and so not adjacent to it
  bool endless = false;   ///< turns without limits; [low, high] is a common period with its followers
  bool in_part = false;   ///< it follows an endless joint and does not repeat: only a part of it is drawn
  Vector3 axis{0, 0, 1};  ///< unit, in the joint's frame
  double low = 0, high = 0;  ///< what may be drawn: rad of a turn, the scene's length unit of a slide
  std::optional<Follow> follow;
  std::size_t shapes = 0;  ///< collision shapes, cylinders or not
};

/// The box of a mesh or an ellipsoid.
struct BoxShape {
  std::string shape;  ///< "mesh", "ellipsoid"
  Pose pose;          ///< in the link's frame
  Vector3 size;
};

struct Body {
  std::string name;
  std::size_t link;
  Solid solid;  ///< in the link's frame
  /// MJCF checks two bodies if the type of one and the affinity of the other share a bit.
  unsigned type = 1, affinity = 1;
  /// The shape that the solid bounds. A body that is clear of the solid is clear of it; if near, nothing is
  /// known.
  std::optional<BoxShape> box = std::nullopt;
  /// A capsule in that shape, with the centre and axis of the solid, if one is known. A solid that meets it
  /// meets the shape.
  std::optional<Solid> inner = std::nullopt;
  double excess = 0;  ///< how far the solid may reach beyond the shapes that it stands for
  /// Bodies that the file asks to check against it, regardless of other rules.
  std::vector<std::string> paired = {};
};

/// A collision shape that was not examined: it is not a solid of ours, and does not have a bound.
struct LeftOut {
  std::string shape, link;  ///< "mesh", "base_link"
  bool operator==(const LeftOut&) const = default;
};

/// Two links that an SRDF excludes from checks, and its reason: "Never", "Adjacent", "Always", "Default",
/// "User".
struct Exemption {
  std::size_t a, b;
  std::string reason;
};

struct Scene {
  std::string name;    ///< of the robot, if it has one
  bool welds = false;  ///< as in MuJoCo, links that fixed joints join have the same neighbours
  std::vector<Link> links;
  std::vector<Body> bodies;
  std::vector<LeftOut> left_out;
  std::size_t folded = 0;          ///< capsules that the file writes as a cylinder and two spheres
  std::vector<std::string> notes;  ///< what else was not taken as written, a sentence each
  std::vector<std::pair<std::size_t, std::size_t>> disabled;  ///< links that the files exclude from checks
  std::string srdf;                                           ///< the SRDF file, or empty
  std::vector<Exemption> exemptions;                          ///< its entries
};

/// The pairs of bodies that are checked. Pairs of one rigid body (a link and the links fixed to it), of
/// adjacent links, of links that the description disables, and of two half-spaces are not. Nor are pairs with
/// a link that floats between them, because they can always meet, unless the file names them. A link is
/// adjacent to the link that carries it, also through links without shapes. As in MoveIt, a link is not
/// adjacent to a link that is only fixed to its neighbour, unless the scene welds.
class PairRule {
 public:
  enum class Reason : unsigned char { checked, same_body, adjacent, disabled, floating };
  explicit PairRule(const Scene& scene);
  Reason reason(const Body& a, const Body& b) const;

 private:
  std::vector<std::size_t> rigid_;     ///< by link: the first link of its rigid body
  std::vector<std::size_t> group_;     ///< by link: the first link with the same neighbours
  std::vector<std::size_t> floating_;  ///< by link: the nearest link that carries it and floats, or the root
  std::vector<std::pair<std::size_t, std::size_t>> adjacent_, disabled_;  ///< lower first, sorted
};

/// Returns whether the types and affinities of two bodies let them collide.
bool may_collide(const Body& a, const Body& b);
/// Returns whether one of two links carries the other, with no third between them, by joints or fixed; false
/// if one of them is there to be hit.
bool carries_directly(const Scene& scene, std::size_t a, std::size_t b);

/// Lets endless joints turn as often as their followers need to repeat; marks those that never do. Throws
/// std::runtime_error if joints mimic each other in a circle.
void turn_leaders_round(Scene& scene);
/// Returns whether the values drawn for a link's joint are all that it may take: not if it is held, or
/// follows one that is.
bool drawn_in_full(const Scene& scene, std::size_t link);

/// Draws a value for the joint of every link, within its limits, as a pure function of (seed, index); mimics
/// follow.
std::vector<double> draw_joints(const Scene& scene, std::uint64_t seed, std::uint64_t index);
/// Returns the joints at 0, or at the limit nearest to it; those named at the values given. Throws UsageError
/// on a name that no free joint has, and on a value beyond the limits of its joint.
std::vector<double> joints_at(const Scene& scene,
                              std::span<const std::pair<std::string, double>> values = {});
/// Sets the joints that mimic others. Throws std::runtime_error if they mimic in a circle.
void let_follow(const Scene& scene, std::vector<double>& joints);
/// Returns whether anything moves.
bool moves(const Scene& scene);

/// Returns a box around the middle of a pose, with edges of these lengths along its axes.
Solid box_at(const Pose& pose, const Vector3& edges);

/// Forward kinematics: the pose of every link, and the bodies in the root's frame.
std::vector<Pose> pose_links(const Scene& scene, std::span<const double> joints);
/// Returns the inner solid of a body that has one, or its solid, if the solid is placed so.
Solid inner_at(const Body& body, const Solid& placed);
void place(const Scene& scene, std::span<const Pose> poses, std::vector<Solid>& placed);
std::vector<Solid> place(const Scene& scene, std::span<const double> joints);
/// Returns two of these bodies, the same doubles.
Pair place_pair(const Scene& scene, std::span<const double> joints, std::size_t a, std::size_t b);

}  // namespace cyl
