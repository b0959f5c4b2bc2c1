// SPDX-License-Identifier: MIT
#include "corpus/store/suppressions.hpp"

#include <gtest/gtest.h>

#include <sstream>
#include <stdexcept>

#include "base/usage_error.hpp"

namespace cyl {
namespace {

const std::string good = R"({"bucket":"fcl-libccd/hang","reason":"reported","link":"https://example.org/1",)"
                         R"("owner":"ada","expires":"2027-02-28"})";

std::vector<Suppression> read(const std::string& text) {
  std::istringstream in(text);
  return read_suppressions(in);
}

std::string error_of(const std::string& text) {
  try {
    read(text);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "none";
}

/// Returns `good` with the first `from` replaced.
std::string with(const std::string& from, const std::string& to) {
  std::string text = good;
  return text.replace(text.find(from), from.size(), to);
}

TEST(Suppressions, ReadsEveryField) {
  const auto all = read("\n" + good + "\r\n");
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].cause, "fcl-libccd/hang");
  EXPECT_EQ(all[0].reason, "reported");
  EXPECT_EQ(all[0].link, "https://example.org/1");
  EXPECT_EQ(all[0].owner, "ada");
  EXPECT_EQ(all[0].expires, "2027-02-28");
  EXPECT_EQ(all[0].line, 2u);
}

TEST(Suppressions, NamesLineAndColumnOfWhatIsWrong) {
  EXPECT_EQ(error_of(good + "\n{\"bucket\":]"), "line 2, column 11: no JSON");
  EXPECT_EQ(error_of("[]"), "line 1, column 1: no object");
  EXPECT_EQ(error_of(with("\"owner\"", "\"boss\"")), "line 1, column 80: 'boss' is not a field");
  EXPECT_EQ(error_of(with("\"ada\"", "7")), "line 1, column 88: owner is not a text");
  EXPECT_EQ(error_of(with(",\"owner\":\"ada\"", "")), "line 1, column 1: owner is missing");
  EXPECT_EQ(error_of(with("2027-02-28", "2027-02-29")),
            "line 1, column 104: expires is not a day YYYY-MM-DD");
  EXPECT_EQ(error_of(with("2027-02-28", "27-2-28")), "line 1, column 104: expires is not a day YYYY-MM-DD");
  EXPECT_EQ(error_of(good + "\n" + good), "line 2, column 11: the cause has line 1 already");
}

TEST(Suppressions, HoldToTheEndOfTheirLastDay) {
  const auto all = read(good);
  EXPECT_FALSE(is_expired(all[0], "2027-02-28"));
  EXPECT_TRUE(is_expired(all[0], "2027-03-01"));
  EXPECT_EQ(find_suppression(all, "fcl-libccd/hang", "2026-12-31"), &all[0]);
  EXPECT_EQ(find_suppression(all, "fcl-libccd/hang", "2027-03-01"), nullptr);
  EXPECT_EQ(find_suppression(all, "fcl-libccd", "2026-12-31"), nullptr);
}

TEST(Suppressions, OfAFileThatIsNotThereAreNone) {
  EXPECT_TRUE(read_suppressions(std::nullopt, "no-such-file.jsonl").empty());
  EXPECT_TRUE(read_suppressions("", "no-such-file.jsonl").empty());
  EXPECT_THROW(read_suppressions("no-such-file.jsonl", ""), UsageError);
}

}  // namespace
}  // namespace cyl
