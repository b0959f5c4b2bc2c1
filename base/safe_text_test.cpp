// SPDX-License-Identifier: MIT
#include "base/safe_text.hpp"

#include <gtest/gtest.h>

#include "base/json.hpp"
#include "base/usage_error.hpp"

namespace cyl {
namespace {

TEST(ShellQuoted, LeavesPlainWordsAlone) {
  EXPECT_EQ(shell_quoted("runs/2026-11-21_a.b:12"), "runs/2026-11-21_a.b:12");
}

TEST(ShellQuoted, QuotesAllElse) {
  EXPECT_EQ(shell_quoted(""), "''");
  EXPECT_EQ(shell_quoted("a run"), "'a run'");
  EXPECT_EQ(shell_quoted("$(id)`id`\"\\"), "'$(id)`id`\"\\'");
  EXPECT_EQ(shell_quoted("it's"), "'it'\\''s'");
  EXPECT_EQ(shell_quoted("~x"), "'~x'");
  EXPECT_EQ(shell_quoted("caf\xc3\xa9"), "'caf\xc3\xa9'");
}

TEST(EscapedControls, LeavesOneLineThatShowsAsItIsWritten) {
  EXPECT_EQ(escaped_controls("a\nb\tc\rd"), "a\\nb\\tc\\rd");
  EXPECT_EQ(escaped_controls("\x1b[2J\x7f\u009b1m\u202e"), "\\u001b[2J\\u007f\\u009b1m\\u202e");
  EXPECT_EQ(escaped_controls(std::string_view("\0", 1)), "\\u0000");
  EXPECT_EQ(escaped_controls("caf\u00e9 \u2026 \\n"), "caf\u00e9 \u2026 \\n");
  EXPECT_EQ(escaped_controls("\xc2"), "\xc2");
  EXPECT_EQ(escaped_controls("a\n\tb\x1b", "\n\t"), "a\n\tb\\u001b") << "what is kept";
  EXPECT_EQ(escaped_controls(escaped_controls("a\n\x1b\u202e")), escaped_controls("a\n\x1b\u202e"));
}

TEST(ForeignJson, HasNoControlCharactersAndABoundedDepth) {
  EXPECT_EQ(parse_foreign_json(R"({"a":["\u001b[2J\n",1,{"b":"caf\u00e9"}]})"),
            parse_json(R"({"a":["\\u001b[2J\\n",1,{"b":"caf\u00e9"}]})"));
  EXPECT_NO_THROW(parse_foreign_json(std::string(100, '[') + std::string(100, ']')));
  EXPECT_FALSE(is_too_deep("[\"\\\"" + std::string(101, '[') + "\"]")) << "a string";
  EXPECT_THROW(parse_foreign_json(std::string(1'000'000, '[')), InputError);
}

TEST(EscapedControls, KnowAllNineThatReorderAndNoOther) {
  for (unsigned code = 0x2000; code < 0x2080; ++code) {
    const std::string text{'\xe2', static_cast<char>(0x80 | (code >> 6 & 0x3f)),
                           static_cast<char>(0x80 | (code & 0x3f))};
    const bool control = (code >= 0x202a && code <= 0x202e) || (code >= 0x2066 && code <= 0x2069);
    EXPECT_EQ(escaped_controls(text + "x") != text + "x", control) << code;
  }
  EXPECT_EQ(escaped_controls("\xe2\x80"), "\xe2\x80");
}

TEST(Counted, HasOneAndMany) {
  EXPECT_EQ(counted(1, "pair"), "1 pair");
  EXPECT_EQ(counted(1234, "pair"), "1,234 pairs");
  EXPECT_EQ(counted(2, "box"), "2 boxes");
  EXPECT_EQ(counted(0, "mesh"), "0 meshes");
}

}  // namespace
}  // namespace cyl
