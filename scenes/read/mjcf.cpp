// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <map>
#include <numbers>
#include <set>
#include <stdexcept>

#include "scenes/read/bounding_solid.hpp"
#include "scenes/read/mesh_files.hpp"
#include "scenes/read/mjcf_document.hpp"
#include "scenes/read/scene_files.hpp"

namespace cyl {
namespace {

/// An element of a body, or of a frame in a body.
struct Part {
  MjcfElement element;
  Pose frame;  ///< in the frame of the body
  std::string childclass;
};

struct Parts {
  std::vector<Part> joints, geoms, bodies;
};

/// A body becomes a link. Before it comes one link without shapes for each joint.
class MjcfBuilder {
 public:
  explicit MjcfBuilder(const MjcfDocument& document) : d_(document) {
    for (const pugi::xml_node& pair : d_.entries("contact", "pair"))
      for (const char* side : {"geom1", "geom2"}) paired_.insert(pair.attribute(side).as_string());
  }

  Scene build() {
    scene_.welds = true;
    Link world;
    world.name = "world";
    scene_.links.push_back(world);
    link_of_["world"] = 0;
    names_.emplace("body", "world");
    bodies_ = 1;
    Parts parts;
    for (const pugi::xml_node& node : d_.sections("worldbody"))
      gather(node, Pose::Identity(), node.attribute("childclass").as_string(), "world", parts);
    for (const Part& geom : parts.geoms) add_geom(geom, 0);
    for (const Part& body : parts.bodies) add(body, 0, true);
    for (const pugi::xml_node& node : d_.entries("contact", "exclude")) exclude(node);
    for (const pugi::xml_node& node : d_.entries("contact", "pair")) check_pair(node);
    if (scene_.bodies.empty() && seen_only_ > 0)
      scene_.notes.push_back(
          fmt::format("contype and conaffinity are 0 for all {} geoms: nothing collides.", seen_only_));
    for (const pugi::xml_node& node : d_.sections("equality"))
      for (const pugi::xml_node& one : node.children()) couple(one);
    for (const pugi::xml_node& flex : d_.entries("deformable", "flex"))
      scene_.left_out.push_back({flex.name(), "world"});
    name_what_is_skipped();
    turn_leaders_round(scene_);
    return std::move(scene_);
  }

 private:
  /// Collects the parts of a body, also those in frames. Unknown parts may hold shapes: they are left out.
  void gather(pugi::xml_node node, const Pose& frame, const std::string& childclass, const std::string& link,
              Parts& parts) {
    constexpr std::array harmless{"inertial", "site", "camera", "light", "plugin"};
    for (const pugi::xml_node& child : node.children()) {
      const std::string kind = child.name();
      if (child.type() != pugi::node_element || std::ranges::find(harmless, kind) != harmless.end()) continue;
      const std::string inner = child.attribute("childclass").as_string(childclass.c_str());
      if (kind == "frame")
        gather(child, frame * MjcfElement(d_, child, "").pose(), inner, link, parts);
      else if (kind == "joint" || kind == "freejoint")
        parts.joints.push_back({MjcfElement(d_, child, childclass), frame, childclass});
      else if (kind == "geom")
        parts.geoms.push_back({MjcfElement(d_, child, childclass), frame, childclass});
      else if (kind == "body")
        parts.bodies.push_back({MjcfElement(d_, child, inner), frame, inner});
      else
        scene_.left_out.push_back({kind, link});
    }
  }

  /// Returns the name, or the number under which MuJoCo would count the element.
  std::string name_of(const pugi::xml_node& node, const char* what, std::size_t id) {
    std::string name = node.attribute("name").as_string();
    if (name.empty()) name = fmt::format("{} {}", what, id);
    if (!names_.emplace(what, name).second)
      throw std::runtime_error(fmt::format("{} '{}' is there twice: rename one", what, name));
    return name;
  }

  void add(const Part& body, std::size_t parent, bool parent_stands) {
    if (scene_.links.size() > link_cap)
      throw std::runtime_error(fmt::format("its bodies and joints are more than {}", link_cap));
    const pugi::xml_node& node = body.element.node();
    Link link;
    link.name = name_of(node, "body", bodies_++);
    link.parent = parent;
    const std::string name = link.name;
    Parts parts;
    gather(node, Pose::Identity(), body.childclass, name, parts);
    const bool carried = node.attribute("mocap").as_bool();
    const bool stands = parent_stands && parts.joints.empty() && !carried;
    // A body that moves on the world, or on a body welded to it, is not adjacent to it: it may hit a floor.
    link.stands = (parent_stands && !stands) || (!d_.filters_parents() && !parts.joints.empty());
    if (carried) hold(link, name, "is carried from outside (mocap)");
    link.floats = carried;
    Pose origin = body.frame * body.element.pose();
    for (const Part& joint : parts.joints) add_joint(joint, link, origin);
    link.origin = origin;
    const std::size_t own = scene_.links.size();
    link_of_[name] = own;
    scene_.links.push_back(link);
    for (const Part& geom : parts.geoms) add_geom(geom, own);
    for (const Part& child : parts.bodies) add(child, own, stands);
  }

  void hold(Link& link, const std::string& joint, const std::string& why) {
    link.joint = joint;
    link.held = true;
    scene_.notes.push_back("Joint " + joint + " " + why + ": it stays in the place that the file gives.");
  }

  /// Stores `link` as a link without shapes, and begins the link that it carries, at `origin` from it.
  void carry(Link& link, Pose& origin, const Pose& next) {
    const std::size_t carrier = scene_.links.size();
    link.split = true;
    scene_.links.push_back(link);
    link = Link{};
    link.name = scene_.links[carrier].name;
    link.parent = carrier;
    origin = next;
  }

  /// A joint moves all that comes after it, so it gets a link of its own with its frame at `origin`.
  void add_joint(const Part& part, Link& link, Pose& origin) {
    const MjcfElement& joint = part.element;
    const std::string name = name_of(joint.node(), "joint", joints_++);
    const bool is_free = joint.node().name() == std::string("freejoint");
    const std::string type = is_free ? "free" : joint.text("type", "hinge");
    if (type != "hinge" && type != "slide") {
      hold(link, name, "is a " + type + " joint");
      link.floats = type == "free";
      link.origin = origin;
      return carry(link, origin, Pose::Identity());
    }
    const bool turns = type == "hinge";
    const std::vector<double> ref = joint.numbers("ref");
    const double reference = ref.empty() ? 0 : turns ? d_.angle(ref[0]) : ref[0];
    const Vector3 anchor = part.frame * joint.vector("pos", Vector3::Zero());
    link.axis = part.frame.linear() * joint.vector("axis", Vector3::UnitZ()).normalized();
    if (!(link.axis.norm() > 0)) throw std::runtime_error("joint " + name + ": its axis is zero");
    link.joint = name;
    link.motion = turns ? Motion::turn : Motion::slide;
    set_limits(joint, link, reference);
    link.origin = origin * Eigen::Translation3d(anchor);
    if (turns)
      link.origin.rotate(Eigen::AngleAxisd(-reference, link.axis));
    else
      link.origin.translate(-reference * link.axis);
    moved_[name] = {scene_.links.size(), reference};
    carry(link, origin, Pose(Eigen::Translation3d(-anchor)));
  }

  void set_limits(const MjcfElement& joint, Link& link, double reference) {
    const bool turns = link.motion == Motion::turn;
    const std::vector<double> range = joint.numbers("range");
    const std::string limited = joint.text("limited", "auto");
    const bool ranged = range.size() == 2 && !(range[0] == 0 && range[1] == 0);
    if (ranged && range[0] > range[1])
      throw std::runtime_error("joint " + link.joint + ": its range is none");
    const bool by_range = limited == "auto" && d_.autolimits() && ranged && range[0] < range[1];
    if (d_.limits() && ranged && (limited == "true" || by_range)) {
      link.low = turns ? d_.angle(range[0]) : range[0];
      link.high = turns ? d_.angle(range[1]) : range[1];
    } else if (turns) {
      link.endless = true;
      link.low = -std::numbers::pi;
      link.high = std::numbers::pi;
    } else {
      link.low = link.high = reference;
      hold(link, link.joint, "slides without limits");
    }
  }

  void add_geom(const Part& part, std::size_t index) {
    const MjcfElement& geom = part.element;
    const auto bits = [&](const char* name) {
      const std::vector<double> x = geom.numbers(name);
      return x.empty() ? 1U : static_cast<unsigned>(static_cast<int>(x[0]));
    };
    const std::string name = name_of(geom.node(), "geom", geoms_++);
    const unsigned type = bits("contype"), affinity = bits("conaffinity");
    const std::string shape = geom.text("type", "sphere");
    Link& link = scene_.links[index];
    if (type == 0 && affinity == 0 && !paired_.contains(name)) {
      ++seen_only_;
      return;
    }
    ++link.shapes;
    std::optional<Body> body;
    try {
      body = body_of_geom(geom, shape, part.frame, {link.name + "/" + name, index, {}, type, affinity});
    } catch (const std::runtime_error& error) {
      throw std::runtime_error(fmt::format("geom {} of {}: {}", name, link.name, error.what()));
    }
    if (body) {
      body_of_[name] = scene_.bodies.size();
      scene_.bodies.push_back(*body);
    } else {
      scene_.left_out.push_back({shape, link.name});
    }
  }

  /// Checks a pair that the file names, even if its geoms or bodies exclude it otherwise.
  void check_pair(const pugi::xml_node& pair) {
    const auto a = body_of_.find(pair.attribute("geom1").as_string()),
               b = body_of_.find(pair.attribute("geom2").as_string());
    if (a == body_of_.end() || b == body_of_.end()) return;
    scene_.bodies[a->second].paired.push_back(scene_.bodies[b->second].name);
    scene_.bodies[b->second].paired.push_back(scene_.bodies[a->second].name);
  }

  /// Returns half lengths. MuJoCo requires as many of them as the shape has.
  static std::vector<double> sizes(const MjcfElement& geom, std::size_t count) {
    std::vector<double> size = geom.numbers("size");
    size.resize(std::max(size.size(), count));
    if (std::ranges::any_of(std::span(size).first(count), [](double x) { return !(x > 0); }))
      throw std::runtime_error("sizes must be positive");
    return size;
  }

  std::optional<Body> body_of_geom(const MjcfElement& geom, const std::string& shape, const Pose& frame,
                                   Body body) {
    Pose pose = frame * geom.pose();
    if (shape == "mesh") return mesh_of(geom, pose, std::move(body));
    if (!geom.text("mesh").empty()) return std::nullopt;  // a primitive that MuJoCo fits to a mesh
    const bool round = shape == "capsule" || shape == "cylinder";
    if (shape == "plane") {  // without end, even if the file has a size
      body.solid = {.center = pose.translation(), .axis = pose.linear().col(2), .shape = Shape::half_space};
      return body;
    }
    if (!round && shape != "sphere" && shape != "box" && shape != "ellipsoid") return std::nullopt;
    std::vector<double> size;
    const std::vector<double> ends = geom.numbers("fromto");
    if (ends.size() == 6 && shape != "sphere") {
      const Vector3 from(ends[0], ends[1], ends[2]), to(ends[3], ends[4], ends[5]);
      const double half = (from - to).norm() / 2;
      size = sizes(geom, 1);
      size = round ? std::vector{size[0], half} : std::vector{size[0], size[0], half};
      pose = frame * Pose(Eigen::Translation3d((from + to) / 2) * turn_from_z(from - to));
    } else {
      size = sizes(geom, shape == "sphere" ? 1 : round ? 2 : 3);
    }
    size.resize(round ? 2 : shape == "sphere" ? 1 : 3);
    if (shape == "ellipsoid") {
      bound_ellipsoid(body, {size[0], size[1], size[2]}, pose);
    } else if (shape == "box") {
      body.solid = box_at(pose, 2 * Vector3(size[0], size[1], size[2]));
    } else {
      body.solid = {pose.translation(), pose.linear().col(2), 0, round ? 2 * size[1] : 0, 0};
      (shape == "cylinder" ? body.solid.radius : body.solid.rounding) = size[0];
    }
    if (const Defect defect = find_defect(body.solid); defect != Defect::none)
      throw std::runtime_error(to_string(defect));
    return body;
  }

  std::optional<Body> mesh_of(const MjcfElement& geom, const Pose& pose, const Body& body) {
    const std::string name = geom.text("mesh");
    try {
      auto bound = bounds_.find(name);
      if (bound == bounds_.end()) {
        const std::vector<Vector3> points = mesh_points(name);
        bound = bounds_.emplace(name, bound_of(points)).first;
        // MuJoCo takes the hull of a mesh, or a smaller one with so many vertices.
        if (meshes_.at(name).text("maxhullvert").empty())
          bound->second.inner = capsule_in_hull(points, bound->second);
      }
      Body held = bounded_body(body.name, body.link, "mesh", bound->second, pose);
      held.type = body.type;
      held.affinity = body.affinity;
      return held;
    } catch (const std::runtime_error& error) {
      scene_.notes.push_back(fmt::format("A mesh of {} cannot be read: {}: {}.", scene_.links[body.link].name,
                                         name, error.what()));
      return std::nullopt;
    }
  }

  std::vector<Vector3> mesh_points(const std::string& name) {
    if (meshes_.empty()) {
      for (const pugi::xml_node& node : d_.entries("asset", "mesh")) {
        const MjcfElement mesh(d_, node, "");
        const std::filesystem::path file = mesh.text("file");
        meshes_.emplace(mesh.text("name", file.stem().string()), mesh);
      }
    }
    const auto found = meshes_.find(name);
    if (found == meshes_.end()) throw std::runtime_error("no such asset");
    const MjcfElement& mesh = found->second;
    const std::string file = mesh.text("file");
    if (file.empty() || !mesh.text("refpos").empty() || !mesh.text("refquat").empty())
      throw std::runtime_error("it is not a plain file");
    const Vector3 scale = mesh.vector("scale", Vector3::Ones());
    std::vector<Vector3> points = read_mesh(file, d_.read_file(file));
    for (Vector3& p : points) p = p.cwiseProduct(scale);
    return points;
  }

  void exclude(const pugi::xml_node& node) {
    const std::string one = node.attribute("body1").as_string(), other = node.attribute("body2").as_string();
    const auto a = link_of_.find(one), b = link_of_.find(other);
    if (a == link_of_.end() || b == link_of_.end())
      scene_.notes.push_back("Exclude " + one + ", " + other + ": no such bodies.");
    else
      scene_.disabled.emplace_back(a->second, b->second);
  }

  /// Couples q1 - q1 at rest = c0 + c1 (q2 - q2 at rest). Joints with higher powers are not followed.
  void couple(const pugi::xml_node& node) {
    const MjcfElement element(d_, node, "");
    const std::string kind = node.name();
    if (node.type() != pugi::node_element || !d_.equalities()) return;
    const auto* given = d_.defaults(node.attribute("class").as_string(), "equality");
    const bool off = given && given->contains("active") && given->at("active") == "false";
    if (std::string(node.attribute("active").as_string(off ? "false" : "true")) == "false") return;
    if (kind != "joint") {
      scene_.notes.push_back("Equality " + kind +
                             " is ignored: the bodies that it connects move independently.");
      return;
    }
    const std::string one = node.attribute("joint1").as_string(),
                      other = node.attribute("joint2").as_string();
    const auto moved = moved_.find(one), leader = moved_.find(other);
    std::vector<double> c{0, 1, 0, 0, 0};
    const std::vector<double> stated = element.numbers("polycoef");
    std::copy_n(stated.begin(), std::min(stated.size(), c.size()), c.begin());
    if (moved == moved_.end() || leader == moved_.end() || c[2] != 0 || c[3] != 0 || c[4] != 0) {
      scene_.notes.push_back("Joint " + one + " follows none, or not in proportion: drawn by itself.");
      return;
    }
    scene_.links[moved->second.link].follow =
        Follow{leader->second.link, c[1], c[0] + moved->second.rest - c[1] * leader->second.rest};
  }

  void name_what_is_skipped() {
    constexpr std::array read{"compiler", "default",  "asset",     "worldbody",
                              "contact",  "equality", "deformable"};
    std::set<std::string> skipped;
    for (const pugi::xml_node& node : d_.root().children())
      if (node.type() == pugi::node_element &&
          std::ranges::find(read, std::string(node.name())) == read.end())
        skipped.insert(node.name());
    if (!skipped.empty())
      scene_.notes.push_back(fmt::format("Not needed and not read: {}.", fmt::join(skipped, ", ")));
  }

  struct Moved {
    std::size_t link;
    double rest;
  };
  const MjcfDocument& d_;
  Scene scene_;
  std::size_t bodies_ = 0, joints_ = 0, geoms_ = 0;  ///< as MuJoCo counts them
  std::size_t seen_only_ = 0;                        ///< geoms that collide with nothing
  std::set<std::string> paired_;
  std::map<std::string, std::size_t> body_of_;           ///< by geom
  std::set<std::pair<std::string, std::string>> names_;  ///< names in use: of a body, joint or geom
  std::map<std::string, std::size_t> link_of_;
  std::map<std::string, Moved> moved_;
  std::map<std::string, MjcfElement> meshes_;  ///< the first of each name; filled when a mesh is needed
  std::map<std::string, Bound> bounds_;        ///< by mesh
};

}  // namespace

Scene read_mjcf(NamedFiles& files) {
  const MjcfDocument document(files);
  return MjcfBuilder(document).build();
}

}  // namespace cyl
