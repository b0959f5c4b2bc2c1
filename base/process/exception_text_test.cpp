// SPDX-License-Identifier: MIT
#include "base/process/exception_text.hpp"

#include <gtest/gtest.h>

namespace cyl {
namespace {

constexpr std::size_t cap = 90;

TEST(ExceptionText, IsPythonsLastLineWithThePlace) {
  EXPECT_EQ(exception_text("loading\n"
                           "Traceback (most recent call last):\n"
                           "  File \"/x/mine.py\", line 40, in <module>\n"
                           "    main()\n"
                           "  File \"/x/lib/gjk.py\", line 12, in solve\n"
                           "    raise Degenerate('simplex')\n"
                           "gjk.Degenerate: simplex\n",
                           cap),
            "gjk.Degenerate: simplex (gjk.py:12)");
}

TEST(ExceptionText, IsNodesLineWithThePlace) {
  const std::string rest =
      "TypeError: A.setGjkMargin is not a function\n"
      "    at file:///x/oimo.mjs:29:5\n"
      "    at process.processTicksAndRejections (node:internal/process/task_queues:95:5)\n\n"
      "Node.js v20.19.2\n";
  const std::string said = "TypeError: A.setGjkMargin is not a function (oimo.mjs:29)";
  EXPECT_EQ(exception_text("file:///x/oimo.mjs:29\n  A.setGjkMargin(0);\n    ^\n\n" + rest, cap), said);
  EXPECT_EQ(exception_text(rest, cap), said);
  EXPECT_EQ(
      exception_text("Error [ERR_MODULE_NOT_FOUND]: Cannot find package 'oimo'\n    at f (node:x:1)\n", cap),
      "Error [ERR_MODULE_NOT_FOUND]: Cannot find package 'oimo'");
}

TEST(ExceptionText, KeepsThePlaceOfALongOne) {
  const std::string text =
      exception_text("Traceback (most recent call last):\n  File \"a.py\", line 3, in f\nValueError: " +
                         std::string(200, 'x'),
                     cap);
  EXPECT_EQ(text.size(), cap);
  EXPECT_TRUE(text.ends_with("x (a.py:3)")) << text;
}

TEST(ExceptionText, IsNothingOfOtherOutput) {
  EXPECT_EQ(exception_text("no such shape\nan Error: happened\n", cap), "");
  EXPECT_EQ(exception_text("", cap), "");
}

}  // namespace
}  // namespace cyl
