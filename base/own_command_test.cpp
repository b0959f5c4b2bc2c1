// SPDX-License-Identifier: MIT
#include "base/own_command.hpp"

#include <gtest/gtest.h>

#include <cstdlib>

namespace cyl {
namespace {

TEST(OwnCommand, IsWhatTheLauncherSays) {
  unsetenv("DAYLIGHT_COMMAND");
  EXPECT_EQ(own_command(), "daylight");
  setenv("DAYLIGHT_COMMAND", "../my tools/daylight", 1);
  EXPECT_EQ(own_command(), "'../my tools/daylight'");
  unsetenv("DAYLIGHT_COMMAND");
}

}  // namespace
}  // namespace cyl
