// SPDX-License-Identifier: MIT
#include "reports/export/linked_libraries.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

namespace cyl {
namespace {

constexpr const char* this_program = "/proc/self/exe";

std::string bytes_of(const char* file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

TEST(LinkedLibraries, NamesThoseThatAreNotLinkedAnyway) {
  // GoogleTest and the collision libraries are linked to this program.
  const std::string flags = ' ' + linked_libraries_of(this_program) + ' ';
  EXPECT_NE(flags.find(" -lccd "), flags.npos) << flags;
  EXPECT_EQ(flags.find(" -lm "), flags.npos) << flags;
  EXPECT_EQ(flags.find(" -lc "), flags.npos) << flags;
}

TEST(LinkedLibraries, BytesThatAreNoLibraryHaveNone) {
  const std::string own = bytes_of(this_program);
  EXPECT_EQ(linked_libraries(""), "");
  EXPECT_EQ(linked_libraries("#!/bin/sh"), "");
  for (const std::size_t end : {std::size_t{40}, std::size_t{1000}, std::size_t{100'000}})
    EXPECT_EQ(linked_libraries(own.substr(0, end)), "") << end;
  std::string wild = own.substr(0, 4096);
  for (std::size_t i = 32; i < wild.size(); ++i) wild[i] = static_cast<char>(i * 151);
  EXPECT_EQ(linked_libraries(wild), "");
}

}  // namespace
}  // namespace cyl
