// SPDX-License-Identifier: MIT
#include <console_bridge/console.h>
#include <fmt/format.h>
#include <urdf_parser/urdf_parser.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <initializer_list>
#include <iterator>
#include <map>
#include <numbers>
#include <optional>
#include <pugixml.hpp>
#include <span>
#include <sstream>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "base/safe_text.hpp"
#include "corpus/pairs/solid_kind.hpp"
#include "scenes/read/bounding_solid.hpp"
#include "scenes/read/mesh_files.hpp"
#include "scenes/read/named_files.hpp"
#include "scenes/read/number_list.hpp"
#include "scenes/read/scene_files.hpp"

namespace cyl {
namespace {

/// Collects the messages that the parser would print.
class Messages final : public console_bridge::OutputHandler {
 public:
  Messages() { console_bridge::useOutputHandler(this); }
  ~Messages() override { console_bridge::restorePreviousOutputHandler(); }
  void log(const std::string& text, console_bridge::LogLevel level, const char*, int) override {
    if (level >= console_bridge::CONSOLE_BRIDGE_LOG_ERROR) all_ += (all_.empty() ? "" : "; ") + text;
  }
  const std::string& all() const { return all_; }

 private:
  std::string all_;
};

void remove_all(pugi::xml_node parent, std::initializer_list<std::string_view> names) {
  for (pugi::xml_node next, child = parent.first_child(); child; child = next) {
    next = child.next_sibling();
    if (std::ranges::find(names, std::string_view(child.name())) != names.end()) parent.remove_child(child);
  }
}

/// A collision shape as the file has it. If urdfdom does not know the shape, or would drop it because it
/// cannot read it, it gets a sphere or cylinder instead.
struct KeptShape {
  std::string kind, numbers, file;  ///< numbers: the size of a box, the scale of a mesh
  auto operator<=>(const KeptShape&) const = default;
};
using KeptShapes = std::map<std::string, std::vector<KeptShape>>;  // by link

/// urdfdom refuses a robot that has a joint of three turns, or a joint of an invented type. Such joints pass
/// as planar joints, which are held too.
void pass_joints(pugi::xml_node robot) {
  constexpr std::array known{"fixed", "floating", "planar", "revolute", "continuous", "prismatic"};
  for (pugi::xml_node joint : robot.children("joint")) {
    if (std::ranges::find(known, std::string(joint.attribute("type").value())) != known.end()) continue;
    joint.remove_attribute("type");
    joint.append_attribute("type") = "planar";
  }
}

/// Newer readers turn an origin by a quaternion. Our reader would not turn it, so this refuses the file.
void refuse_quaternions(const pugi::xml_node& element, const std::string& text) {
  if (element.attribute("quat_xyzw"))
    throw std::runtime_error(
        fmt::format("line {}: an origin by quat_xyzw is not read: give it as rpy",
                    1 + std::count(text.begin(), text.begin() + element.offset_debug(), '\n')));
  for (const pugi::xml_node& child : element.children())
    if (std::string_view(child.name()) != "inertial") refuse_quaternions(child, text);
}

/// Throws std::runtime_error with the command that expands a file of macros, whose robot is not there yet.
void refuse_macros(const pugi::xml_node& document, const std::filesystem::path& file) {
  const auto is_macro = [](const pugi::xml_node& node) {
    return std::string_view(node.name()).starts_with("xacro:");
  };
  if (file.extension() != ".xacro" && !document.find_node(is_macro)) return;
  throw std::runtime_error(
      fmt::format("it has macros, so expand it first: xacro {} > {}", shell_quoted(file.string()),
                  shell_quoted(std::filesystem::path(file).replace_filename("expanded.urdf").string())));
}

/// urdfdom refuses a whole robot if a material is named twice or a shape is unknown. Neither matters here.
/// This removes the parts that are not needed, and notes each shape that is unknown here too.
KeptShapes keep_shapes(pugi::xml_node robot, Scene& scene, std::map<std::string, std::size_t>& shapes) {
  constexpr std::array known{"cylinder", "sphere", "capsule", "box", "mesh"};
  KeptShapes kept;
  remove_all(robot, {"material", "transmission", "gazebo", "mujoco", "sensor"});
  for (pugi::xml_node link : robot.children("link")) {
    remove_all(link, {"visual"});
    const std::string name = link.attribute("name").value();
    for (pugi::xml_node next, collision = link.child("collision"); collision; collision = next) {
      next = collision.next_sibling("collision");
      ++shapes[name];
      pugi::xml_node shape = collision.child("geometry").find_child([](const pugi::xml_node& node) {
        return node.type() == pugi::node_element;
      });
      const std::string kind = shape ? shape.name() : "nothing";
      if (std::ranges::find(known, kind) == known.end()) {
        scene.left_out.push_back({kind, name});
        link.remove_child(collision);
        continue;
      }
      kept[name].push_back({kind, shape.attribute(kind == "box" ? "size" : "scale").value(),
                            shape.attribute("filename").value()});
      if (kind == "capsule") shape.set_name("cylinder");
      if (kind != "box" && kind != "mesh") continue;
      shape.set_name("sphere");
      shape.remove_attribute("radius");
      shape.append_attribute("radius") = "1";
    }
  }
  return kept;
}

Vector3 urdf_vector(const urdf::Vector3& v) { return {v.x, v.y, v.z}; }

Pose urdf_pose(const urdf::Pose& p) {
  const urdf::Rotation& q = p.rotation;
  return Pose(Eigen::Translation3d(urdf_vector(p.position)) * Eigen::Quaterniond(q.w, q.x, q.y, q.z));
}

void set_motion(Link& link, const urdf::Joint& joint, Scene& scene) {
  switch (joint.type) {
    case urdf::Joint::CONTINUOUS:
      link.motion = Motion::turn;
      link.endless = true;
      link.low = -std::numbers::pi;
      link.high = std::numbers::pi;
      break;
    case urdf::Joint::REVOLUTE:
    case urdf::Joint::PRISMATIC:
      link.motion = joint.type == urdf::Joint::REVOLUTE ? Motion::turn : Motion::slide;
      link.low = joint.limits->lower;
      link.high = joint.limits->upper;
      if (link.low > link.high) {
        std::swap(link.low, link.high);
        scene.notes.push_back("The limits of joint " + joint.name + " are the wrong way round: exchanged.");
      }
      break;
    case urdf::Joint::FLOATING:
    case urdf::Joint::PLANAR:
      scene.notes.push_back("Joint " + joint.name +
                            " is neither a hinge nor a slide: it stays in the place that the file gives.");
      link.held = true;
      link.floats = joint.type == urdf::Joint::FLOATING;
      return;
    default:
      return;
  }
  const double length = urdf_vector(joint.axis).stableNorm();
  if (!(length > 0) || std::isinf(length)) throw std::runtime_error("joint " + joint.name + " has no axis");
  link.axis = urdf_vector(joint.axis) / length;
}

/// Returns the solid of a cylinder, sphere or capsule. The length of a capsule is that of its cylinder.
Solid solid_of(const urdf::Geometry& geometry, const Pose& pose, bool capsule) {
  Solid solid{pose.translation(), pose.linear().col(2), 0, 0, 0};
  if (const auto* sphere = dynamic_cast<const urdf::Sphere*>(&geometry)) solid.rounding = sphere->radius;
  if (const auto* cylinder = dynamic_cast<const urdf::Cylinder*>(&geometry)) {
    solid.height = cylinder->length;
    (capsule ? solid.rounding : solid.radius) = cylinder->radius;
  }
  return solid;
}

/// Relative to the radius of the cylinder: how far its spheres may be from its ends, and how far their radii
/// may differ from it. The decimals of a file leave such differences between equal values.
constexpr double decimals_tol = 1e-9;

/// Returns the sphere that ends a cylinder there. If several are near enough, returns the nearest.
std::optional<std::size_t> sphere_at(std::span<const Body> bodies, const Solid& wall, const Vector3& end) {
  std::optional<std::size_t> best;
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    const Solid& s = bodies[k].solid;
    const auto off = [&](std::size_t i) { return (bodies[i].solid.center - end).norm(); };
    if (!bodies[k].box && kind_of(s) == SolidKind::sphere && off(k) <= decimals_tol * wall.radius &&
        std::fabs(s.rounding - wall.radius) <= decimals_tol * wall.radius && (!best || off(k) < off(*best)))
      best = k;
  }
  return best;
}

/// URDF writes a capsule as a cylinder and a sphere at each end. If they fit within the decimals of the
/// file, they become one body: a capsule that is wide enough to hold all three.
void fold_capsules(Scene& scene, std::size_t first) {
  auto& bodies = scene.bodies;
  for (std::size_t i = first; i < bodies.size(); ++i) {
    const Solid wall = bodies[i].solid;
    if (bodies[i].box || kind_of(wall) != SolidKind::cylinder || wall.radius == 0) continue;
    const Vector3 reach = 0.5 * wall.height * wall.axis, low = wall.center - reach,
                  high = wall.center + reach;
    const std::span<const Body> own = std::span(bodies).subspan(first);
    const auto at_low = sphere_at(own, wall, low), at_high = sphere_at(own, wall, high);
    if (!at_low || !at_high || at_low == at_high) continue;
    double wide = wall.radius, least = wall.radius;  // the most and the least that the shapes reach
    for (const auto& [k, end] : {std::pair(*at_low, low), std::pair(*at_high, high)}) {
      const Solid& sphere = own[k].solid;
      const double off = (sphere.center - end).norm();
      wide = std::max(wide, sphere.rounding + off);
      least = std::min(least, sphere.rounding - off);
    }
    bodies[i].solid.radius = 0;
    bodies[i].solid.rounding = wide;
    bodies[i].excess = wide - least;
    ++scene.folded;
    for (const std::size_t k : {std::max(*at_low, *at_high), std::min(*at_low, *at_high)}) {
      bodies.erase(bodies.begin() + static_cast<std::ptrdiff_t>(first + k));
      if (first + k < i) --i;
    }
  }
}

/// Returns the size of a box, or the scale of a mesh. Throws std::runtime_error with the reason if none.
Vector3 size_or_scale(const KeptShape& shape) {
  std::vector<double> x = parse_numbers(shape.numbers, shape.kind == "box" ? "its size" : "its scale");
  if (x.empty() && shape.kind == "mesh") x = {1, 1, 1};
  if (x.size() != 3) throw std::runtime_error("'" + shape.numbers + "' is not 3 numbers");
  return {x[0], x[1], x[2]};
}

std::vector<Vector3> points_of(const KeptShape& shape, NamedFiles& files) {
  const Vector3 by = size_or_scale(shape);
  std::vector<Vector3> points;
  try {
    points = read_mesh(shape.file, files.read(files.find(shape.file), NamedBy::file));
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(shape.file + ": " + error.what());
  }
  for (Vector3& p : points) p = p.cwiseProduct(by);
  return points;
}

class UrdfBuilder {
 public:
  UrdfBuilder(Scene& scene, const std::map<std::string, std::size_t>& shapes, const KeptShapes& kept,
              NamedFiles& files)
      : scene_(scene), shapes_(shapes), kept_(kept), files_(files) {}

  /// Adds a link and all that it carries, without recursion: a stranger's chain of links may be long.
  void add_all(const urdf::Link& root) {
    std::vector<std::pair<const urdf::Link*, std::optional<std::size_t>>> waiting{{&root, std::nullopt}};
    while (!waiting.empty()) {
      const auto [link, parent] = waiting.back();
      waiting.pop_back();
      const std::size_t index = scene_.links.size();
      add(*link, parent);
      for (auto child = link->child_links.rbegin(); child != link->child_links.rend(); ++child)
        waiting.emplace_back(child->get(), index);
    }
  }

  void follow() {
    for (const auto& [index, mimic] : mimics_) {
      const auto leader = joint_index_.find(mimic->joint_name);
      if (leader == joint_index_.end())
        throw std::runtime_error("joint " + scene_.links[index].joint + " mimics '" + mimic->joint_name +
                                 "', which is none");
      scene_.links[index].follow = Follow{leader->second, mimic->multiplier, mimic->offset};
      if (scene_.links[leader->second].motion == Motion::fixed && !scene_.links[leader->second].held) {
        scene_.links[index].held = true;
        scene_.notes.push_back("Joint " + scene_.links[index].joint + " mimics the fixed joint " +
                               mimic->joint_name +
                               ": it is held at its offset, but MoveIt ignores the mimic and moves it.");
      }
    }
    turn_leaders_round(scene_);
  }

 private:
  void add(const urdf::Link& link, std::optional<std::size_t> parent) {
    const std::size_t index = scene_.links.size();
    Link own;
    own.name = link.name;
    own.parent = parent;
    if (const auto shapes = shapes_.find(link.name); shapes != shapes_.end()) own.shapes = shapes->second;
    if (const auto& joint = link.parent_joint) {
      own.joint = joint->name;
      joint_index_[joint->name] = index;
      own.origin = urdf_pose(joint->parent_to_joint_origin_transform);
      set_motion(own, *joint, scene_);
      if (joint->mimic && own.motion != Motion::fixed) mimics_.emplace_back(index, joint->mimic);
      // A link that slides or floats on the world is not a part of it, so it may hit all that stands there.
      own.stands = (own.held || own.motion == Motion::slide) && is_world_[*parent];
    }
    is_world_.push_back(!parent || (own.motion == Motion::fixed && !own.held && is_world_[*parent]));
    scene_.links.push_back(std::move(own));
    const auto kept = kept_.find(link.name);
    add_bodies(index, link, kept == kept_.end() ? std::vector<KeptShape>() : kept->second);
  }

  /// Returns a shape as a body, with its bound if it is a mesh. If it fails, a note states the reason.
  std::optional<Body> body_of(const urdf::Collision& collision, const KeptShape& shape, Body body) {
    const Pose pose = urdf_pose(collision.origin);
    if (shape.kind != "box" && shape.kind != "mesh") {
      body.solid = solid_of(*collision.geometry, pose, shape.kind == "capsule");
      return body;
    }
    try {
      if (shape.kind == "box") {
        body.solid = box_at(pose, size_or_scale(shape));
        if (const Defect defect = find_defect(body.solid); defect != Defect::none)
          throw std::runtime_error(to_string(defect));
        return body;
      }
      auto bound = bounds_.find(shape);
      if (bound == bounds_.end()) bound = bounds_.emplace(shape, bound_of(points_of(shape, files_))).first;
      return bounded_body(body.name, body.link, shape.kind, bound->second, pose);
    } catch (const std::runtime_error& error) {
      const std::string& link = scene_.links[body.link].name;
      scene_.left_out.push_back({shape.kind, link});
      scene_.notes.push_back(fmt::format("A {} of {} cannot be read: {}.", shape.kind, link, error.what()));
      return std::nullopt;
    }
  }

  void add_bodies(std::size_t index, const urdf::Link& link, const std::vector<KeptShape>& shapes) {
    const std::size_t first = scene_.bodies.size();
    if (first + shapes.size() > shape_cap)
      throw std::runtime_error(fmt::format("it has more than {} shapes", shape_cap));
    if (link.collision_array.size() != shapes.size()) {  // urdfdom dropped a shape, and it is unknown which
      for (const KeptShape& shape : shapes) scene_.left_out.push_back({shape.kind, link.name});
      return;
    }
    for (std::size_t i = 0; i < shapes.size(); ++i) {
      const auto& collision = link.collision_array[i];
      std::string name = link.name;
      if (!collision->name.empty())
        name += "/" + collision->name;
      else if (shapes.size() > 1)
        name += "/" + std::to_string(i + 1);
      const std::optional<Body> body = body_of(*collision, shapes[i], {name, index, {}, 1, 1});
      if (!body) continue;
      if (const Defect defect = find_defect(body->solid); defect != Defect::none)
        throw std::runtime_error("shape " + name + ": " + to_string(defect));
      scene_.bodies.push_back(*body);
    }
    fold_capsules(scene_, first);
    const bool alone = scene_.bodies.size() == first + 1;
    if (alone && std::ranges::all_of(link.collision_array, [](const auto& c) { return c->name.empty(); }))
      scene_.bodies[first].name = link.name;
  }

  Scene& scene_;
  const std::map<std::string, std::size_t>& shapes_;
  const KeptShapes& kept_;
  NamedFiles& files_;
  std::map<KeptShape, Bound> bounds_;  ///< of meshes, each found once
  std::vector<bool> is_world_;         ///< by link: whether it is the root, or fixed to it
  std::map<std::string, std::size_t> joint_index_;
  std::vector<std::pair<std::size_t, urdf::JointMimicSharedPtr>> mimics_;
};

}  // namespace

Scene read_urdf(NamedFiles& files) {
  pugi::xml_document document;
  const std::string text = files.load(document, files.first(), NamedBy::user);
  refuse_macros(document, files.first());
  pugi::xml_node robot = document.child("robot");
  if (!robot) throw std::runtime_error("no <robot>");
  const auto all = robot.children("link");
  if (static_cast<std::size_t>(std::distance(all.begin(), all.end())) > link_cap)
    throw std::runtime_error(fmt::format("it has more than {} links", link_cap));
  Scene scene;
  scene.name = robot.attribute("name").value();
  std::map<std::string, std::size_t> shapes;
  pass_joints(robot);
  const KeptShapes kept = keep_shapes(robot, scene, shapes);
  refuse_quaternions(robot, text);
  std::ostringstream plain;  // without what urdfdom's own reader of XML may stumble over
  document.save(plain, "", pugi::format_raw | pugi::format_no_declaration);

  Messages messages;
  const urdf::ModelInterfaceSharedPtr model = urdf::parseURDF(plain.str());
  if (!model) throw std::runtime_error(messages.all());
  if (!messages.all().empty()) scene.notes.push_back("urdfdom: " + messages.all() + ".");
  // urdfdom ensures that all links but one are carried. The links of a loop do not hang on that one.
  if (model->joints_.size() + 1 != model->links_.size())
    throw std::runtime_error("two joints carry the same link");
  UrdfBuilder builder(scene, shapes, kept, files);
  builder.add_all(*model->getRoot());
  if (scene.links.size() != model->links_.size())
    throw std::runtime_error("links carry each other in a loop");
  builder.follow();
  return scene;
}

}  // namespace cyl
