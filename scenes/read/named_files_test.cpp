// SPDX-License-Identifier: MIT
#include "scenes/read/named_files.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "base/scratch_test.hpp"
#include "scenes/read/scene_files.hpp"

namespace cyl {
namespace {

namespace fs = std::filesystem;

/// The folders of a workspace with a ROS package, and files outside the workspace.
class NamedFilesTest : public testing::Test, protected Scratch {
 protected:
  NamedFilesTest() {
    for (const char* name : {"ws/src/arm/urdf", "ws/src/arm/meshes", "ws/src/other/meshes", "bare/urdf"})
      fs::create_directories(folder / name);
    write("ws/src/arm/package.xml", "<package format='3'><name>arm_description</name></package>");
    write("ws/src/other/package.xml", "<package><name>hand_description</name></package>");
    for (const char* name : {"ws/src/arm/meshes/a.obj", "ws/src/arm/urdf/a.obj", "ws/src/other/meshes/a.obj",
                             "bare/a.obj", "secret"})
      write(name, "v 1 2 3\n");
  }
  /// Returns the path at which a robot's file finds a name, from `folder`, or the reason if there is none.
  std::string found(const std::string& name, const std::string& robot = "ws/src/arm/urdf/arm.urdf",
                    const std::vector<std::string>& permitted = {}) const {
    try {
      return fs::canonical(NamedFiles(folder / robot, permitted).find(name)).lexically_relative(folder);
    } catch (const std::runtime_error& error) {
      return error.what();
    }
  }
};

TEST_F(NamedFilesTest, AreInTheFolderOrInThePackage) {
  EXPECT_EQ(found("a.obj"), "ws/src/arm/urdf/a.obj");
  EXPECT_EQ(found("../meshes/a.obj"), "ws/src/arm/meshes/a.obj");
  EXPECT_EQ(found("file://" + (folder / "ws/src/arm/meshes/a.obj").string()), "ws/src/arm/meshes/a.obj");
  EXPECT_EQ(found("package://arm/meshes/a.obj"), "ws/src/arm/meshes/a.obj") << "the folder's name";
  EXPECT_EQ(found("package://arm_description/meshes/a.obj"), "ws/src/arm/meshes/a.obj") << "in package.xml";
  EXPECT_EQ(found("package://arm/meshes"), "it is not a regular file");
  EXPECT_EQ(found("package://arm/meshes/none.obj"), "it is not there");
}

TEST_F(NamedFilesTest, OutsideOnlyWhereTheUserPermitsIt) {
  const std::string outside =
      "it is outside " + (folder / "ws/src/arm/urdf").string() + " (--files-from DIR permits a folder)";
  const std::string mesh = "package://hand_description/meshes/a.obj", sibling = "ws/src/other/meshes/a.obj",
                    robot = "ws/src/arm/urdf/arm.urdf";
  EXPECT_EQ(found("/etc/passwd"), outside);
  EXPECT_EQ(found("file:///etc/passwd"), outside);
  EXPECT_EQ(found("../../other/meshes/a.obj"), outside);
  EXPECT_EQ(found("package://../../../../secret"), outside);
  EXPECT_EQ(found("package://other/meshes/a.obj"), outside);
  EXPECT_EQ(found("../a.obj", "bare/urdf/arm.urdf"),
            "it is outside " + (folder / "bare/urdf").string() + " (--files-from DIR permits a folder)");
  EXPECT_EQ(found("../a.obj", "bare/urdf/arm.urdf", {folder / "bare"}), "bare/a.obj");
  EXPECT_EQ(found(mesh, robot, {folder / "ws/src/other/"}), sibling);
  for (const char* name : {"package://other/meshes/a.obj", "package://hand_description/meshes/a.obj"})
    EXPECT_EQ(found(name, robot, {folder / "ws/src"}), sibling)
        << "the folder's name, and that in package.xml";
  EXPECT_EQ(found("/etc/passwd", robot, {folder / "ws/src"}), outside);
}

TEST_F(NamedFilesTest, LinksAreFollowedFirst) {
  fs::create_symlink(folder / "secret", folder / "ws/src/arm/urdf/link.obj");
  fs::create_symlink("../meshes/a.obj", folder / "ws/src/arm/urdf/own.obj");
  fs::create_directory_symlink(folder / "bare", folder / "ws/src/arm/urdf/away");
  EXPECT_TRUE(found("link.obj").starts_with("it is outside "));
  EXPECT_TRUE(found("away/a.obj").starts_with("it is outside "));
  EXPECT_EQ(found("own.obj"), "ws/src/arm/meshes/a.obj");
  write("ws/src/arm/urdf/arm.urdf", "<robot/>");
  fs::create_directories(folder / "install");
  fs::create_symlink(folder / "ws/src/arm/urdf/arm.urdf", folder / "install/arm.urdf");
  EXPECT_EQ(found("package://arm_description/meshes/a.obj", "install/arm.urdf"), "ws/src/arm/meshes/a.obj")
      << "as an installed package links to its sources";
  write("ws/src/arm/urdf/outside.srdf", "<robot/>");
  fs::rename(folder / "ws/src/arm/urdf/outside.srdf", folder / "outside.srdf");
  const std::string robot = write("ws/src/arm/urdf/one.urdf", "<robot name='r'><link name='l'/></robot>");
  fs::create_symlink(folder / "outside.srdf", folder / "ws/src/arm/urdf/one.srdf");
  EXPECT_THROW(read_scene(robot), std::runtime_error) << "the SRDF beside it is outside";
  EXPECT_EQ(read_scene(robot, folder / "outside.srdf").links.size(), 1u) << "the user names it";
}

// Eighteen copies of this mesh would be more than all files of a scene may be.
TEST(NamedFiles, AMeshIsReadOnceForAllThatNameIt) {
  const Scratch scratch;
  scratch.write("wide.obj", "v 0 0 0\nv 1 1 1\n" + std::string(std::size_t{60} << 20, '#'));
  std::string urdf = "<robot name='r'><link name='l'>",
              mjcf = "<mujoco><asset><mesh name='m' file='wide.obj'/></asset><worldbody>";
  for (int i = 0; i < 18; ++i) {
    urdf += "<collision><geometry><mesh filename='wide.obj'/></geometry></collision>";
    mjcf += "<geom type='mesh' mesh='m'/>";
  }
  for (const std::string& file : {scratch.write("many.urdf", urdf + "</link></robot>"),
                                  scratch.write("many.xml", mjcf + "</worldbody></mujoco>")})
    EXPECT_EQ(read_scene(file).bodies.size(), 18u) << file;
}

}  // namespace
}  // namespace cyl
