// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "base/scratch_test.hpp"
#include "scenes/read/scene_files.hpp"

namespace cyl {
namespace {

const std::string crane = DAYLIGHT_SOURCE_DIR "/corpus/scenes/crane.urdf";

TEST(Srdf, TheOneBesideOrTheOneNamed) {
  const Scene beside = read_scene(crane);
  EXPECT_TRUE(beside.srdf.ends_with("crane.srdf"));
  ASSERT_EQ(beside.exemptions.size(), 1u);
  EXPECT_EQ(beside.links[beside.exemptions[0].a].name, "hook");
  EXPECT_EQ(beside.exemptions[0].reason, "Never");
  const Scratch scratch;
  const std::string own =
      scratch.write("own.srdf",
                    "<robot name='crane'><disable_collisions link1='tower' link2='trolley' reason='User'/>"
                    "<disable_collisions link1='jib' link2='hook'/><disable_collisions link1='hook' "
                    "link2='winch'/></robot>");
  const Scene named = read_scene(crane, own);
  EXPECT_EQ(named.srdf, own);
  ASSERT_EQ(named.exemptions.size(), 1u);
  EXPECT_EQ(named.exemptions[0].reason, "User");
  EXPECT_EQ(named.disabled.size(), 1u);
  ASSERT_EQ(named.notes.size(), beside.notes.size() + 1);
  EXPECT_NE(named.notes.back().find("names links that are not there: jib, winch."), std::string::npos);
}

TEST(Srdf, WhatCannotBeReadIsSaid) {
  EXPECT_THROW(read_scene(crane, "none.srdf"), std::runtime_error);
  const Scratch scratch;
  for (const char* text : {"<robot><disable_collisions", "<sdf/>"})
    EXPECT_THROW(read_scene(crane, scratch.write("bad.srdf", text)), std::runtime_error);
}

}  // namespace
}  // namespace cyl
