// SPDX-License-Identifier: MIT
#include "corpus/store/case_files.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <set>

#include "base/error_of_test.hpp"
#include "base/scratch_test.hpp"

namespace cyl {
namespace {

const std::string committed = std::string(DAYLIGHT_SOURCE_DIR) + "/corpus/cases";

class CaseFiles : public testing::Test, protected Scratch {
 protected:
  std::string error() const {
    return error_of<std::exception>([&] { read_case_folder(folder.string()); });
  }
};

std::string line_with_id(const std::string& id) {
  Case c;
  c.id = id;
  return format_case(c) + "\n";
}

TEST_F(CaseFiles, AreReadInTheOrderOfTheirNames) {
  write("b.jsonl", line_with_id("3"));
  write("a.jsonl", line_with_id("1") + "\n" + line_with_id("2"));
  write("c.json", "not read");
  std::filesystem::create_directory(folder / "d");
  std::string ids;
  for (const Case& c : read_case_folder(folder.string())) ids += c.id;
  EXPECT_EQ(ids, "123");
}

TEST_F(CaseFiles, NameTheFaultAndItsPlace) {
  write("a.jsonl", line_with_id("1") + "{\"a\":1}\n");
  EXPECT_EQ(error(), (folder / "a.jsonl").string() + ": line 2, column 6: a is a number, expected an object");
  std::filesystem::remove(folder / "a.jsonl");
  EXPECT_EQ(error(), "nothing thrown");
  std::filesystem::create_directory(folder / "e.jsonl");
  EXPECT_EQ(error(), (folder / "e.jsonl").string() + ": cannot be read");
  std::filesystem::remove_all(folder);
  EXPECT_EQ(error(), folder.string() + ": No such file or directory");
}

TEST(CommittedCases, HaveUniqueIdsAndASource) {
  std::set<std::string> ids;
  for (const Case& c : read_case_folder(committed)) {
    EXPECT_TRUE(ids.insert(c.id).second) << c.id;
    EXPECT_FALSE(c.id.empty());
    EXPECT_FALSE(c.source.empty()) << c.id;
    EXPECT_TRUE(c.truth == Verdict::disjoint || c.truth == Verdict::intersecting ||
                c.truth == Verdict::touching)
        << c.id;
  }
  EXPECT_GE(ids.size(), 140u + 47u);
}

TEST(CommittedCases, AreWrittenAsTheWriterWrites) {
  for (const char* name : {"hand_made.jsonl", "reported.jsonl"}) {
    std::ifstream in(committed + "/" + name);
    std::size_t line = 0;
    for (std::string text; std::getline(in, text);) {
      const CaseLine read = parse_case(text, ++line);
      ASSERT_EQ(read.error, "") << name;
      EXPECT_EQ(format_case(*read.value), text) << name;
    }
    EXPECT_GT(line, 40u) << name;
  }
}

}  // namespace
}  // namespace cyl
