// SPDX-License-Identifier: MIT
#include "scenes/read/mesh_files.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "base/error_of_test.hpp"

namespace cyl {
namespace {

std::string why(const std::string& name, const std::string& bytes) {
  return error_of([&] { read_mesh(name, bytes); });
}

/// Returns a binary STL of one triangle, little-endian.
std::string triangle(const std::array<float, 9>& corners) {
  std::string bytes(80, ' ');
  bytes.replace(0, 5, "solid");  // as some programs write it
  bytes += {'\1', '\0', '\0', '\0'};
  bytes += std::string(12, '\0');
  for (const float x : corners) {
    std::array<char, 4> raw{};
    std::memcpy(raw.data(), &x, 4);
    bytes.append(raw.data(), 4);
  }
  return bytes + std::string(2, '\0');
}

const std::vector<Vector3> expected{{1, 2.5, -3}, {0, 0, 1e-3f}, {4, 5, 6}};

TEST(Meshes, BinaryStl) {
  const std::string bytes = triangle({1, 2.5, -3, 0, 0, 1e-3f, 4, 5, 6});
  EXPECT_EQ(read_mesh("a.STL", bytes), expected);
  EXPECT_EQ(read_mesh("a.stl", "other" + bytes.substr(5) + "and a note"), expected);
}

TEST(Meshes, AsciiStl) {
  const std::vector<Vector3> read =
      read_mesh("a.stl",
                "solid a\n facet normal 0 0 1\n  outer loop\n   vertex 1 2.5 -3\n"
                "   vertex 0 +0 1e-3\r\n   vertex 4 5 6\n  endloop\n"
                " endfacet\nendsolid a\n");
  ASSERT_EQ(read.size(), 3u);
  EXPECT_EQ(read[0], expected[0]);
  EXPECT_EQ(read[1], Vector3(0, 0, 1e-3));
  EXPECT_EQ(read[2], expected[2]);
}

TEST(Meshes, Obj) {
  const std::vector<Vector3> read =
      read_mesh("a.obj", "# v 9 9 9\nv 1 2.5 -3 1\nvn 0 0 1\n\tv 4 5 6\nvt 0 0\nf 1//1 2//1 1//1\n");
  EXPECT_EQ(read, (std::vector<Vector3>{expected[0], expected[2]}));
}

TEST(Meshes, WhyOneCannotBeRead) {
  EXPECT_EQ(why("a.dae", "<COLLADA/>"), "'.dae' is neither .stl nor .obj");
  EXPECT_EQ(why("a.obj", "vn 0 0 1\n"), "it has no vertices");
  EXPECT_EQ(why("a.obj", "\nv 1 2\n"), "line 2: fewer than 3 numbers");
  EXPECT_EQ(why("a.obj", "v 1 2 x\r\n"), "line 1 is '1 2 x', no numbers");
  EXPECT_EQ(why("a.obj", "v 1 2 inf\n"), "line 1 is '1 2 inf', no numbers");
  EXPECT_EQ(why("a.stl", triangle({0, 0, 0, 1, 0, 0, 0, INFINITY, 0})), "a vertex is not finite");
  EXPECT_EQ(why("a.stl", triangle({}).substr(0, 100)), "an STL that is cut short");
  EXPECT_EQ(why("b.stl", "P6"), "an STL that is cut short, or none");
  EXPECT_EQ(why("c.stl", "solid a\nvertex 1 2 3\n"), "an STL that is cut short");
  EXPECT_EQ(why("c.stl", ""), "it is empty");
}

}  // namespace
}  // namespace cyl
