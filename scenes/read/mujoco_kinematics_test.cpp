// SPDX-License-Identifier: MIT
// If MuJoCo's own loader reads a file, it has the same shapes in the same places.
#ifdef DAYLIGHT_WITH_MUJOCO
#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <memory>
#include <set>
#include <span>
#include <string>
#include <utility>

#include "base/scratch_test.hpp"
#include "corpus/pairs/pair_numbers.hpp"
#include "corpus/pairs/solid_kind.hpp"
#include "corpus/pairs/support.hpp"
#include "scenes/read/scene_files.hpp"

namespace cyl {
namespace {

const std::string folder = DAYLIGHT_SOURCE_DIR "/corpus/scenes/";

struct DeleteModel {
  void operator()(mjModel* model) const { mj_deleteModel(model); }
};
struct DeleteData {
  void operator()(mjData* data) const { mj_deleteData(data); }
};

using Columns = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;

/// Whether the shape of the body is that geom, in that place.
bool same_shape(const Body& body, const Solid& c, const Pose& link, const mjModel& model, const mjData& data,
                int g) {
  const int type = model.geom_type[g];
  const mjtNum* size = model.geom_size + 3 * g;
  const Vector3 center(data.geom_xpos[3 * g], data.geom_xpos[3 * g + 1], data.geom_xpos[3 * g + 2]);
  const Columns turn = Eigen::Map<const Columns>(data.geom_xmat + 9 * g);
  if (type == mjGEOM_PLANE)
    return is_half_space(c) && (c.center - center).norm() < 1e-12 && (c.axis - turn.col(2)).norm() < 1e-12;
  if (type == mjGEOM_BOX) {
    if (kind_of(c) != SolidKind::box || (c.center - center).norm() >= 1e-12) return false;
    const auto edges = edge_directions<double>(c.quaternion);
    for (int k = 0; k < 3; ++k) {
      const auto& [x, y, z] = edges[static_cast<std::size_t>(k)];
      if ((Vector3(x, y, z) - turn.col(k)).norm() >= 1e-12 ||
          std::fabs(c.edges[static_cast<std::size_t>(k)] - 2 * size[k]) >= 1e-15)
        return false;
    }
    return true;
  }
  if (type == mjGEOM_ELLIPSOID) {
    if (!body.box || body.box->shape != "ellipsoid") return false;
    const Pose box = link * body.box->pose;
    return (body.box->size - 2 * Vector3(size[0], size[1], size[2])).norm() < 1e-15 &&
           (box.translation() - center).norm() < 1e-12 && (box.linear() - turn).norm() < 1e-12;
  }
  const SolidKind kind = type == mjGEOM_CYLINDER  ? SolidKind::cylinder
                         : type == mjGEOM_CAPSULE ? SolidKind::capsule
                                                  : SolidKind::sphere;
  const double height = kind == SolidKind::sphere ? 0 : 2 * size[1];
  return !body.box && kind_of(c) == kind && std::fabs(c.radius + c.rounding - size[0]) < 1e-15 &&
         std::fabs(c.height - height) < 1e-15 && (c.center - center).norm() < 1e-12 &&
         (c.axis - turn.col(2)).norm() < 1e-12;
}

/// Compares MuJoCo's own kinematics with ours, also for URDF. Geoms are found by name, or by size and place
/// if the file does not name shapes.
void expect_like_mujoco(const std::string& file, bool geom_names) {
  const Scene scene = read_scene(file);
  char error[1000] = "";
  const std::unique_ptr<mjModel, DeleteModel> model(mj_loadXML(file.c_str(), nullptr, error, sizeof error));
  ASSERT_TRUE(model) << error;
  const std::unique_ptr<mjData, DeleteData> data(mj_makeData(model.get()));
  int coupled = 0;
  for (std::uint64_t k = 0; k < 20; ++k) {
    const std::vector<double> joints = draw_joints(scene, 1, k);
    for (std::size_t i = 0; i < joints.size(); ++i) {
      const int joint = scene.links[i].joint.empty() || scene.links[i].held
                            ? -1
                            : mj_name2id(model.get(), mjOBJ_JOINT, scene.links[i].joint.c_str());
      if (joint < 0) continue;
      data->qpos[model->jnt_qposadr[joint]] = joints[i];
      if (model->jnt_limited[joint] == 0) continue;
      EXPECT_NEAR(scene.links[i].low, model->jnt_range[2 * joint], 1e-15);
      EXPECT_NEAR(scene.links[i].high, model->jnt_range[2 * joint + 1], 1e-15);
    }
    mj_fwdPosition(model.get(), data.get());
    for (int row = 0; row < data->nefc; ++row) {
      if (data->efc_type[row] == mjCNSTR_EQUALITY) {
        EXPECT_NEAR(data->efc_pos[row], 0, 1e-12) << "joints that are coupled";
        ++coupled;
      }
    }
    const std::vector<Pose> poses = pose_links(scene, joints);
    std::vector<Solid> placed;
    place(scene, poses, placed);
    std::size_t met = 0;
    for (int g = 0; g < model->ngeom; ++g) {
      if (model->geom_contype[g] == 0) continue;
      const char* const given = mj_id2name(model.get(), mjOBJ_GEOM, g);
      const std::string name = given ? given : "geom " + std::to_string(g);
      std::size_t found = 0;
      for (std::size_t i = 0; i < placed.size(); ++i) {
        const Body& body = scene.bodies[i];
        found += (!geom_names || body.name.ends_with("/" + name)) &&
                 same_shape(body, placed[i], poses[body.link], *model, *data, g);
      }
      EXPECT_EQ(found, 1u) << file << ", configuration " << k << ", " << name;
      ++met;
    }
    EXPECT_EQ(met, placed.size());
  }
  EXPECT_EQ(coupled, 20 * model->neq);
}

/// Compares MuJoCo's own filter of pairs with ours. With a margin beyond everything, MuJoCo reports each
/// pair that it checks.
void expect_pairs_like_mujoco(const std::string& file) {
  const Scene scene = read_scene(file);
  const std::unique_ptr<mjModel, DeleteModel> model(mj_loadXML(file.c_str(), nullptr, nullptr, 0));
  ASSERT_TRUE(model) << file;
  std::fill_n(model->geom_margin, model->ngeom, 100);
  model->nconmax = 5000;
  const std::unique_ptr<mjData, DeleteData> data(mj_makeData(model.get()));
  mj_fwdPosition(model.get(), data.get());
  ASSERT_LT(data->ncon, model->nconmax);
  std::set<std::pair<std::string, std::string>> theirs, ours;
  const auto name_of = [&](int g) {
    const char* const given = mj_id2name(model.get(), mjOBJ_GEOM, g);
    return given ? std::string(given) : "geom " + std::to_string(g);
  };
  for (const mjContact& contact : std::span(data->contact, static_cast<std::size_t>(data->ncon)))
    theirs.insert(std::minmax(name_of(contact.geom1), name_of(contact.geom2)));
  const PairRule rule(scene);
  const auto last = [](const Body& body) { return body.name.substr(body.name.find('/') + 1); };
  for (const Body& a : scene.bodies)
    for (const Body& b : scene.bodies)
      if (const auto reason = rule.reason(a, b);
          &a < &b && (reason == PairRule::Reason::checked || reason == PairRule::Reason::floating))
        ours.insert(std::minmax(last(a), last(b)));
  EXPECT_EQ(ours, theirs) << file;
  EXPECT_GT(ours.size(), 5u);
}

TEST(Kinematics, OfUrdfAsMujocoHasThem) {
  expect_like_mujoco(folder + "crane.urdf", false);
  expect_like_mujoco(folder + "twenty.urdf", false);
}

// Boxes that are turned, on links that are turned.
TEST(Kinematics, OfBoxesInUrdfAsMujocoHasThem) {
  const Scratch scratch;
  const std::string file = scratch.write(
      "boxes.urdf", R"(<robot name="boxes"><link name="a"><collision><geometry><box size="1 2 3"/></geometry>
    <origin xyz="1 0 2" rpy="0.1 0.2 0.3"/></collision></link>
    <link name="b"><collision><geometry><box size="0.5 1 0.2"/></geometry>
    <origin xyz="0 1 0" rpy="-1 0.5 2"/></collision>
    <inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial></link>
    <joint name="j" type="revolute"><parent link="a"/><child link="b"/><origin xyz="0 0 1" rpy="0.4 -0.3 0.2"/>
    <axis xyz="0.1 1 0"/><limit lower="-2" upper="2" effort="1" velocity="1"/></joint></robot>)");
  expect_like_mujoco(file, false);
}

TEST(Kinematics, OfMjcfAsMujocoHasThem) {
  expect_like_mujoco(folder + "crane.xml", true);
  expect_like_mujoco(folder + "walker.xml", true);
}

TEST(Pairs, OfMjcfAsMujocoChecksThem) {
  expect_pairs_like_mujoco(folder + "crane.xml");
  expect_pairs_like_mujoco(folder + "walker.xml");
}

// MuJoCo 2 loads the hand only without the lines marked "today". With them, we read the same.
TEST(Kinematics, OfAHandAsMujocoHasThem) {
  std::ifstream in(folder + "hand.xml");
  std::string older;
  for (std::string line; std::getline(in, line);)
    if (line.find("<!-- today -->") == line.npos) older += line + "\n";
  const Scratch scratch;
  const std::string file = scratch.write("hand.xml", older);
  expect_like_mujoco(file, true);
  expect_pairs_like_mujoco(file);
  const Scene scene = read_scene(folder + "hand.xml"), without = read_scene(file);
  EXPECT_EQ(scene.bodies.size(), without.bodies.size() + 3);
  EXPECT_EQ(scene.left_out, (std::vector<LeftOut>{{"mesh", "palm"}}));
}

// All ways to turn, both kinds of Euler angles, radians and degrees, successive joints, and references.
TEST(Kinematics, OfEveryWayToTurnAsMujocoHasThem) {
  const std::array kinds{R"(<compiler angle="radian" eulerseq="XyZ"/>)", R"(<compiler eulerseq="zyx"/>)",
                         R"(<compiler angle="radian"/><compiler eulerseq="ZXY"/>)"};
  for (const char* compiler : kinds) {
    const Scratch scratch;
    const std::string file =
        scratch.write("model.xml", std::string("<mujoco>") + compiler + R"(<default><default class="b">
      <geom size="0.1 0.2 0.3" type="box"/><default class="e"><geom euler="0.3 0.2 0.1"/>
      </default></default></default>
      <worldbody><body childclass="b"><geom quat="1 2 3 4"/><geom axisangle="1 1 0 0.7"/><geom xyaxes="1 1 0 0 1 1"/>
      <geom zaxis="0 0 -1"/><geom zaxis="1 -2 0.5"/><geom class="e"/><geom fromto="1 2 3 0 0 1" type="box"/>
      <geom type="ellipsoid" fromto="1 2 3 3 2 1"/><geom class="main" type="capsule" size="0.1"
      fromto="0 0 0 0 0 -1"/>
      <body euler="0.4 0.5 -0.6"><joint name="s" type="slide" axis="1 1 1" range="0 1" limited="true" ref="0.2"/>
      <joint name="j" axis="0 3 1" pos="0.1 0.2 0.3" ref="0.1"/><joint name="h" axis="1 0 0" pos="0 0 1"/>
      <geom class="e" pos="0 1 0"/>
      <body pos="0 0 1" zaxis="1 0 0"><geom/><geom type="capsule" size="0.1 0.2"/></body></body></body></worldbody>
      </mujoco>)");
    expect_like_mujoco(file, true);
  }
}

}  // namespace
}  // namespace cyl
#endif
