// SPDX-License-Identifier: MIT
#include "base/process/child.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <stdexcept>

#include "base/process/process.hpp"

namespace cyl {
namespace {

using Command = std::vector<std::string>;

TEST(Child, HandsOverWhatAFunctionReturns) {
  const std::string megabyte(1 << 20, '\0');  // many times what a pipe holds
  Child child([&] { return megabyte; });
  EXPECT_EQ(child.wait(), 0);
  EXPECT_EQ(child.bytes(), megabyte);
  EXPECT_EQ(child.wait(), 0) << "and once more";
}

TEST(Child, HandsOverWhatAProgramPrints) {
  Child child(Command{"tr", "a-z", "A-Z"}, {.input = "read"});
  EXPECT_EQ(child.wait(), 0);
  EXPECT_EQ(child.bytes(), "READ");
}

TEST(Child, EndsWithOneWhereItThrowsOrIsNoProgram) {
  testing::internal::CaptureStderr();
  Child throws([]() -> std::string { throw std::runtime_error("why"); }, {.failure = "this failed"});
  EXPECT_EQ(how_it_ended(throws.wait()), "exit code 1");
  Child none(Command{"/nowhere/at/all"});
  EXPECT_EQ(how_it_ended(none.wait()), "exit code 1");
  const std::string said = testing::internal::GetCapturedStderr();
  EXPECT_NE(said.find("daylight: this failed: why\n"), said.npos) << said;
  EXPECT_NE(said.find("/nowhere/at/all"), said.npos) << said;
}

TEST(Child, ItsDeathIsReportedWhoeverHoldsThePipe) {
  Child child(
      []() -> std::string {
        if (fork_with_retry() == 0) pause(), _exit(0);
        raise(SIGKILL);
        return {};
      },
      {.own_group = true});
  EXPECT_EQ(how_it_ended(child.wait()), "killed by signal 9 (Killed)");
  // The other process is in its group, and ends with it. Then no process holds the pipe open.
  char none;
  ssize_t got = -1;
  while (got < 0) got = read(child.output(), &none, 1);
  EXPECT_EQ(got, 0);
}

TEST(Child, IsKilledWithWhoeverHasIt) {
  int alive[2];
  ASSERT_EQ(pipe(alive), 0);
  {
    Child child([]() -> std::string {
      pause();
      return {};
    });
    close(alive[1]);
  }
  char none;
  EXPECT_EQ(read(alive[0], &none, 1), 0) << "it holds the pipe open";
  close(alive[0]);
}

TEST(LastLine, IsTheEndWithoutWhiteSpaceOnOneLine) {
  char name[] = "/tmp/daylight_last_line_XXXXXX";
  const int file = mkstemp(name);
  unlink(name);
  ASSERT_EQ(write(file, "one\ntwo\n \n", 10), 10);
  EXPECT_EQ(last_line(file, 100), "one two");
  EXPECT_EQ(last_line(file, 6), "two");
  close(file);
}

}  // namespace
}  // namespace cyl
