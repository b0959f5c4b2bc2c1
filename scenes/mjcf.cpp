// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <mujoco/mujoco.h>

#include <array>
#include <memory>
#include <numbers>
#include <stdexcept>

#include "scenes/scene_files.hpp"

namespace cyl {
namespace {

struct DeleteModel {
  void operator()(mjModel* model) const { mj_deleteModel(model); }
};
using Model = std::unique_ptr<mjModel, DeleteModel>;

Vector3 mjcf_vector(const mjtNum* v) { return {v[0], v[1], v[2]}; }

Pose mjcf_pose(const mjtNum* position, const mjtNum* q) {
  return Pose(Eigen::Translation3d(mjcf_vector(position)) *
              Eigen::Quaterniond(q[0], q[1], q[2], q[3]).normalized());
}

std::size_t to_size(int n) { return static_cast<std::size_t>(n); }

const char* shape_name(int type) {
  static_assert(mjGEOM_PLANE == 0 && mjGEOM_CYLINDER == 5 && mjGEOM_MESH == 7);
  constexpr std::array names{"plane",     "height field", "sphere", "capsule",
                             "ellipsoid", "cylinder",     "box",    "mesh"};
  return type >= 0 && to_size(type) < names.size() ? names[to_size(type)] : "geom of another kind";
}

/// A body becomes a link, and one more for each joint but its first; the links between have no shapes.
class MjcfBuilder {
 public:
  explicit MjcfBuilder(const mjModel& model)
      : m_(model), link_of_(to_size(model.nbody)), joint_link_(to_size(model.njnt)) {}

  Scene build() {
    for (int body = 0; body < m_.nbody; ++body) add(body);
    for (int i = 0; i < m_.nexclude; ++i) {
      const int signature = m_.exclude_signature[i];  // 2^16 (one + 1) + other + 1
      scene_.disabled.emplace_back(link_of_[to_size((signature >> 16) - 1)],
                                   link_of_[to_size((signature & 0xffff) - 1)]);
    }
    for (int i = 0; i < m_.neq; ++i) couple(i);
    joints_at(scene_);  // throws where they go in a circle
    return std::move(scene_);
  }

 private:
  std::string name(int kind, int id, const char* what) const {
    const char* given = mj_id2name(&m_, kind, id);
    return given && *given ? given : fmt::format("{} {}", what, id);
  }

  void add(int body) {
    Link link;
    link.name = name(mjOBJ_BODY, body, "body");
    if (body > 0) link.parent = link_of_[to_size(m_.body_parentid[body])];
    // What moves on the world, or on what is welded to it, is not adjacent to it: a floor is there to be hit.
    link.stands = m_.body_weldid[body] != 0 && m_.body_weldid[m_.body_parentid[body]] == 0;
    Pose origin = mjcf_pose(m_.body_pos + 3 * body, m_.body_quat + 4 * body);
    for (int k = 0; k < m_.body_jntnum[body]; ++k) {
      const int joint = m_.body_jntadr[body] + k;
      const Vector3 anchor = mjcf_vector(m_.jnt_pos + 3 * joint), axis = mjcf_vector(m_.jnt_axis + 3 * joint);
      const int type = m_.jnt_type[joint];
      link.joint = name(mjOBJ_JOINT, joint, "joint");
      if (type != mjJNT_HINGE && type != mjJNT_SLIDE) {
        scene_.notes.push_back("Joint " + link.joint +
                               " is a ball or free: it is held where the file puts it.");
        link.held = true;
        continue;
      }
      const bool turns = type == mjJNT_HINGE, limited = m_.jnt_limited[joint] != 0;
      const double reference = m_.qpos0[m_.jnt_qposadr[joint]];
      link.motion = turns ? Motion::turn : Motion::slide;
      link.axis = axis;
      link.low = limited ? m_.jnt_range[2 * joint] : turns ? -std::numbers::pi : reference;
      link.high = limited ? m_.jnt_range[2 * joint + 1] : turns ? std::numbers::pi : reference;
      if (!limited && !turns)
        scene_.notes.push_back("Joint " + link.joint + " slides without limits: it is held at " +
                               std::to_string(reference) + ".");
      link.origin = origin * Eigen::Translation3d(anchor);
      if (turns)
        link.origin.rotate(Eigen::AngleAxisd(-reference, axis));
      else
        link.origin.translate(-reference * axis);
      joint_link_[to_size(joint)] = scene_.links.size();
      const std::size_t carrier = scene_.links.size();
      scene_.links.push_back(link);
      link = Link{};
      link.name = scene_.links[carrier].name;
      link.parent = carrier;
      origin = Eigen::Translation3d(-anchor) * Pose::Identity();
    }
    link.origin = origin;
    link_of_[to_size(body)] = scene_.links.size();
    scene_.links.push_back(link);
    for (int k = 0; k < m_.body_geomnum[body]; ++k) add_geom(body, m_.body_geomadr[body] + k);
  }

  void add_geom(int body, int geom) {
    const auto type = static_cast<unsigned>(m_.geom_contype[geom]);
    const auto affinity = static_cast<unsigned>(m_.geom_conaffinity[geom]);
    if (type == 0 && affinity == 0) return;  // to be seen only
    Link& link = scene_.links[link_of_[to_size(body)]];
    ++link.shapes;
    const mjtNum* size = m_.geom_size + 3 * geom;
    const Pose pose = mjcf_pose(m_.geom_pos + 3 * geom, m_.geom_quat + 4 * geom);
    Cylinder solid{pose.translation(), pose.linear().col(2), 0, 0, 0};
    switch (m_.geom_type[geom]) {
      case mjGEOM_SPHERE:
        solid.rounding = size[0];
        break;
      case mjGEOM_CAPSULE:
        solid.rounding = size[0];
        solid.height = 2 * size[1];
        break;
      case mjGEOM_CYLINDER:
        solid.radius = size[0];
        solid.height = 2 * size[1];
        break;
      default:
        scene_.left_out.push_back({shape_name(m_.geom_type[geom]), link.name});
        return;
    }
    scene_.bodies.push_back(
        {link.name + "/" + name(mjOBJ_GEOM, geom, "geom"), link_of_[to_size(body)], solid, type, affinity});
  }

  /// q1 - q1 at rest = c0 + c1 (q2 - q2 at rest) + higher powers, which we do not follow.
  void couple(int i) {
    if (m_.eq_type[i] != mjEQ_JOINT || m_.eq_active[i] == 0 || m_.eq_obj2id[i] < 0) return;
    const mjtNum* c = m_.eq_data + mjNEQDATA * i;
    const int one = m_.eq_obj1id[i], other = m_.eq_obj2id[i];
    if (c[2] != 0 || c[3] != 0 || c[4] != 0) {
      scene_.notes.push_back("Joint " + name(mjOBJ_JOINT, one, "joint") +
                             " follows another not in proportion: drawn by itself.");
      return;
    }
    const double rest_one = m_.qpos0[m_.jnt_qposadr[one]], rest_other = m_.qpos0[m_.jnt_qposadr[other]];
    scene_.links[joint_link_[to_size(one)]].follow =
        Follow{joint_link_[to_size(other)], c[1], c[0] + rest_one - c[1] * rest_other};
  }

  const mjModel& m_;
  Scene scene_;
  std::vector<std::size_t> link_of_, joint_link_;
};

}  // namespace

Scene read_mjcf(const std::string& file) {
  mju_user_warning = [](const char*) {};  // the default one writes into the working folder
  std::array<char, 1000> error{};
  const Model model(mj_loadXML(file.c_str(), nullptr, error.data(), static_cast<int>(error.size())));
  if (!model) throw std::runtime_error(file + ": " + error.data());
  return MjcfBuilder(*model).build();
}

}  // namespace cyl
