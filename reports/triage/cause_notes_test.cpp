// SPDX-License-Identifier: MIT
#include "reports/triage/cause_notes.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "base/usage_error.hpp"

namespace cyl {
namespace {

namespace fs = std::filesystem;

TEST(CauseNotes, AreKeptBesideTheRunsOneACause) {
  const fs::path folder = fs::temp_directory_path() / ("notes_test." + std::to_string(getpid()));
  fs::create_directories(folder / "night");
  const std::string file = notes_file_of((folder / "night").string());
  EXPECT_EQ(file, folder / "notes.jsonl");
  EXPECT_EQ(notes_file_of((folder / "night/").string()), file);
  EXPECT_EQ(notes_file_of("night"), "notes.jsonl");
  EXPECT_TRUE(read_notes(file).empty());
  write_note(file, "ode/hang", {"ada", "told them \"so\"\nand again"});
  write_note(file, "mujoco/rounding", {"", "wait"});
  write_note(file, "ode/hang", {"bob", "now his"});
  EXPECT_EQ(read_notes(file).size(), 2u);
  EXPECT_EQ(read_notes(file)["ode/hang"].owner, "bob");
  EXPECT_EQ(read_notes(file)["ode/hang"].note, "now his");
  write_note(file, "mujoco/rounding", {});
  EXPECT_EQ(read_notes(file).size(), 1u);
  std::ofstream(file, std::ios::app) << "{\"cause\":\"x\"}\n";
  EXPECT_THROW(write_note(file, "y", {"z", ""}), UsageError);
  EXPECT_THROW(read_notes(file), UsageError);
  fs::remove_all(folder);
}

}  // namespace
}  // namespace cyl
