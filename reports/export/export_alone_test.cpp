// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

#include "base/safe_text.hpp"
#include "base/scratch_test.hpp"
#include "reports/export/export.hpp"

namespace cyl {
namespace {

TEST(Export, AProgramThatInstallsItsLibraryNeedsNoDaylight) {
  const Scratch scratch;
  const std::string folder = scratch.folder.string(), sent = folder + "/sent";
  std::ofstream(folder + "/mine.sh")
      << "echo '{\"name\":\"mine\",\"call\":\"Engine.meet\",\"install\":\"touch "
         "engine@3\",\"files\":[\"more.sh\"]}'\n"
         "while read -r q; do . \"$(dirname \"$0\")/more.sh\"; done\n";
  std::ofstream(folder + "/more.sh") << "echo '{\"verdict\":\"disjoint\"}'\n";
  OpenedGuest opened =
      std::move(open_guest({GuestKind::command, "mine", "sh " + folder + "/mine.sh", folder})[0]);
  std::vector<std::unique_ptr<Method>> methods;
  methods.push_back(std::move(opened.method));
  const Pair equal{{{0, 0, 0}, {0, 0, 1}, 1, 2}, {{0, 0, 0}, {0, 0, 1}, 1, 2}};
  const Export files = make_export(methods, "mine", FindingKind::wrong_disjoint, equal, &opened.guest);
  const std::string& issue = files.at("issue.md");
  EXPECT_TRUE(issue.starts_with("# Engine.meet misses two cylinders that overlap by ")) << issue;
  EXPECT_NE(issue.find("`Engine.meet` of engine@3, called by `sh mine.sh`"), issue.npos) << issue;
  EXPECT_EQ(issue.find("daylight"), issue.npos) << issue;
  write_export(files, sent);
  const auto run = [&](const std::string& command) {
    return WEXITSTATUS(std::system(("cd " + shell_quoted(sent) + " && " + command).c_str()));
  };
  EXPECT_EQ(run("sh reproduce.sh | tr '\n' ' ' | grep -qx '{\"verdict\":\"disjoint\"} WRONG '"), 0);
  EXPECT_EQ(run("sh reproduce.sh >printed"), 1);
  EXPECT_EQ(run("sed -i s/disjoint/intersecting/ more.sh && sh reproduce.sh >printed && test -e engine@3"),
            0);
  std::ofstream(folder + "/more.sh") << "echo '{\"verdict\":\"intersecting\",\"distance\":-2.25}'\n";
  write_export(make_export(methods, "mine", FindingKind::distance_outside, equal, &opened.guest), sent);
  EXPECT_EQ(run("sh reproduce.sh >printed"), 1);
  EXPECT_EQ(run("sed -i s/2.25/2.0/ more.sh && sh reproduce.sh >printed"), 0);
}

}  // namespace
}  // namespace cyl
