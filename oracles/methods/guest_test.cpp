// SPDX-License-Identifier: MIT
#include "oracles/methods/guest.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <stdexcept>

#include "base/scratch_test.hpp"
#include "oracles/methods/contained.hpp"
#include "oracles/methods/fake_method_test.hpp"
#include "oracles/plugin.h"

namespace cyl {
namespace {

namespace fs = std::filesystem;
using std::chrono::milliseconds;

constexpr const char* apart = R"({"verdict":"disjoint","distance":0.5,"direction":[1,0,0]})";

/// Returns a shell program that runs `body` for each line. $q is the line, and $n is the number of lines.
std::string each_line(const std::string& body) {
  return "n=0; while read -r q; do n=$((n+1)); " + body + "; done";
}
std::string say(const std::string& line) { return "echo '" + line + "'"; }

std::vector<Pair> numbered_pairs(std::size_t count) {
  std::vector<Pair> pairs(count, {{{0, 0, 0}, {0, 0, 1}, 1, 2}, {{5, 0, 0}, {0, 0, 1}, 1, 2}});
  for (std::size_t i = 0; i < count; ++i) pairs[i].a.radius = static_cast<double>(i + 1);
  return pairs;
}

std::unique_ptr<Method> command(const std::string& text) {
  return std::move(open_guest(read_guest(GuestKind::command, "test=" + text)).front().method);
}

/// Returns the method's answers to `count` pairs, which have the first radius 1, 2 and so on.
std::vector<MethodAnswer> ask(std::unique_ptr<Method> method, std::size_t count,
                              CallMode mode = CallMode::usual) {
  std::vector<std::unique_ptr<Method>> methods;
  methods.push_back(std::move(method));
  std::vector<Question> questions;
  for (std::size_t i = 0; i < count; ++i) questions.push_back({0, i, mode});
  std::vector<MethodAnswer> answers;
  for (const ContainedAnswer& said : ask_contained(methods, numbered_pairs(count), questions))
    answers.push_back(said.answer);
  return answers;
}

/// Asks a program that runs `body` if the first radius is 2, and is right otherwise.
std::vector<MethodAnswer> ask_with_trouble(const std::string& body) {
  const std::string trouble =
      "case $q in *'\"radius\":2,\"height\":2},\"b\"'*) " + body + ";; *) " + say(apart) + ";; esac";
  const auto answers = ask(command(each_line(trouble)), 4);
  for (const std::size_t i : {0u, 2u, 3u}) {
    EXPECT_EQ(answers[i].status, Status::answered) << i << ": " << answers[i].reason;
    EXPECT_EQ(answers[i].verdict, Verdict::disjoint);
  }
  return answers;
}

TEST(GuestCommand, AnswersWithAllItSays) {
  const auto answers = ask(command(each_line(say(apart))), 3);
  for (const MethodAnswer& answer : answers) {
    EXPECT_EQ(answer.status, Status::answered) << answer.reason;
    EXPECT_EQ(answer.verdict, Verdict::disjoint);
    EXPECT_TRUE(answer.has_distance);
    EXPECT_EQ(answer.distance, 0.5);
    EXPECT_EQ(answer.witness, CertificateKind::direction);
    EXPECT_EQ(answer.head[0], 1);
  }
}

TEST(GuestCommand, TheHelloGivesNameVersionAndClaim) {
  const std::string hello = R"({"name":"polite","version":"3","claim":{"relative":1e-6,"source":"p. 7"}})";
  const auto opened = open_guest(read_guest(GuestKind::command, say(hello) + "; " + each_line(say(apart))));
  const auto& method = opened.front().method;
  EXPECT_EQ(opened.front().guest.name, "polite");
  EXPECT_EQ(method->name(), "polite");
  EXPECT_EQ(method->version(), "3");
  EXPECT_EQ(method->claim().relative, 1e-6);
  EXPECT_EQ(method->claim().source, "p. 7");
  EXPECT_EQ(method->ask(numbered_pairs(1)[0]).status, Status::answered);
}

TEST(GuestCommand, AProgramThatWasChangedIsAnotherVersion) {
  const Scratch scratch;
  const auto version_of = [&](const std::string& program) {
    Guest guest = read_guest(GuestKind::command, "test=sh -e " + scratch.write("guest.sh", program + '\n'));
    guest.folder = "/";
    return std::string(open_guest(guest).front().method->version());
  };
  const std::string before = version_of(each_line(say(apart)));
  EXPECT_TRUE(before.starts_with("unversioned (")) << before;
  EXPECT_EQ(version_of(each_line(say(apart))), before);
  EXPECT_NE(version_of(each_line("true; " + say(apart))), before);
}

TEST(GuestCommand, AskedFromAThreadThatEndsItGoesOn) {
  const auto method = command(each_line("echo \"{\\\"verdict\\\":\\\"disjoint\\\",\\\"distance\\\":$n}\""));
  for (int i = 1; i <= 3; ++i) {
    const MethodAnswer answer = call(*method, numbered_pairs(1)[0], CallMode::other_thread);
    EXPECT_EQ(answer.distance, i + 1) << answer.reason;  // of one process, which the opening asked once
  }
}

TEST(GuestCommand, ADeathIsACrashAndItIsStartedAgain) {
  const auto answers = ask_with_trouble("echo 'no such shape' >&2; exit 3");
  EXPECT_EQ(answers[1].failure, Failure::crash);
  EXPECT_STREQ(answers[1].reason, "ended with status 3, after printing: no such shape");
  EXPECT_STREQ(ask_with_trouble("kill -SEGV $$")[1].reason, "SIGSEGV");
  EXPECT_STREQ(
      ask_with_trouble(
          "printf 'RangeError: no shape\\n    at f (/x/mine.js:3:9)\\n\\nNode.js v20\\n' >&2; exit 1")[1]
          .reason,
      "ended with status 1, after printing: RangeError: no shape");
}

TEST(GuestCommand, AHangIsEnded) {
  const auto answers = ask_with_trouble("while :; do :; done");
  EXPECT_EQ(answers[1].failure, Failure::hang);
  EXPECT_STREQ(answers[1].reason, "no answer within 1000 ms of CPU time");
}

TEST(GuestCommand, TheTimeOfWhatItStartedCountsAsItsOwn) {
  const auto answers = ask_with_trouble("yes >/dev/null");
  EXPECT_STREQ(answers[1].reason, "no answer within 1000 ms of CPU time");
}

/// A method reports that a program of its own hung.
TEST(GuestCommand, ItsHangsCountAsAnyMethods) {
  std::vector<std::unique_ptr<Method>> methods;
  methods.push_back(fake_method("sleeper",
                                [](const Pair&) {
                                  MethodAnswer answer;
                                  answer.status = Status::failed;
                                  answer.failure = Failure::hang;
                                  return answer;
                                },
                                {.is_out_of_process = true}));
  const std::vector<Question> questions{{0, 0}, {0, 0}, {0, 0}};
  const auto said = ask_contained(methods, numbered_pairs(1), questions, {.hangs = 2});
  EXPECT_EQ(said[1].answer.failure, Failure::hang);
  EXPECT_EQ(said[2].answer.status, Status::declined) << said[2].answer.reason;
}

TEST(GuestCommand, LinesTooLongAreMalformed) {
  for (const char* long_line : {"head -c 300000 /dev/zero | tr '\\0' ' '; echo", "yes | tr -d '\\n'"}) {
    const auto answers = ask_with_trouble(long_line);
    EXPECT_EQ(answers[1].failure, Failure::malformed);
    EXPECT_STREQ(answers[1].reason, "a line of more than 65536 bytes");
  }
}

TEST(GuestCommand, WhoSaysTwoLinesToOneQuestionIsNotBelieved) {
  const std::string twice = std::string("printf '%s\\n%s\\n' '") + apart + "' '" + apart + "'";
  int malformed = 0;
  for (const MethodAnswer& answer : ask(command(each_line(twice)), 4)) {
    if (answer.failure != Failure::malformed) continue;
    ++malformed;
    EXPECT_STREQ(answer.reason, "said more than one line to a question");
  }
  EXPECT_EQ(malformed, 4);
}

TEST(GuestCommand, ManyLinesAreUnderWay) {
  // It answers by fours. A caller that waits for each answer before it sends the next pair waits for ever.
  const auto answers =
      ask(command("read -r q; " + say(apart) +
                  "; while read -r q && read -r q && read -r q && read -r q; do for i in 1 2 3 4; do " +
                  say(apart) + "; done; done"),
          64);
  for (const MethodAnswer& answer : answers) EXPECT_EQ(answer.status, Status::answered) << answer.reason;
}

TEST(GuestCommand, ADeathInTheStreamIsThatOfThePairThatKills) {
  const std::string trouble =
      "case $q in *'\"radius\":40,\"height\":2},\"b\"'*) exit 3;; *) " + say(apart) + ";; esac";
  const auto answers = ask(command(each_line(trouble)), 64);
  for (std::size_t i = 0; i < answers.size(); ++i)
    EXPECT_EQ(answers[i].failure, i == 39 ? Failure::crash : Failure::none) << i << answers[i].reason;
}

TEST(GuestCommand, NothingOfItOutlivesIt) {
  const Scratch scratch;
  const fs::path file = scratch.folder / "pipe";
  // A process that the guest starts, in its own session, holds the pipe open as long as it lives.
  ASSERT_EQ(mkfifo(file.c_str(), 0600), 0);
  const int pipe = open(file.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
  const std::string orphan = "setsid sh -c 'exec 9>" + file.string() + "; echo here >&9; sleep 1000' & ";
  const auto answers = ask(command(each_line(orphan + "sleep 0.1; " + say(apart))), 2);
  EXPECT_EQ(answers[1].status, Status::answered) << answers[1].reason;
  pollfd ended{pipe, POLLIN, 0};
  EXPECT_EQ(poll(&ended, 1, 0), 1) << "it was never there";
  char text[256];
  while (read(pipe, text, sizeof text) > 0) {
  }
  EXPECT_EQ(read(pipe, text, sizeof text), 0) << "an orphan lives on";  // 0 is the end, -1 an empty pipe
  close(pipe);
}

TEST(GuestCommand, WhatCannotBeAskedIsRefusedAtOnce) {
  const auto refusal = [](const std::string& text) -> std::string {
    try {
      command(text);
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "not refused";
  };
  EXPECT_NE(refusal("/nowhere/at/all").find("ended with status 127, after printing: "), std::string::npos);
  EXPECT_NE(refusal("echo hello").find("not JSON"), std::string::npos);
  EXPECT_NE(refusal("cat").find("neither a verdict"), std::string::npos);
}

TEST(GuestRotation, IsThatOfTheAxisOrQuaternion) {
  using Rotation = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;
  Rotation rotation;
  for (const Vector3& axis :
       {Vector3(0, 0, 1), Vector3(0, 0, -1), Vector3(1e-9, 0, -1), Vector3(0, -3e200, 4e200),
        Vector3(1, 1e-200, -0.0), Vector3(5e-324, -5e-324, 0)})
    for (int along = 0; along < 3; ++along) {
      daylight_rotation(axis.data(), along, rotation.data());
      EXPECT_LE((rotation.col(along) - Vector3(axis / axis.cwiseAbs().maxCoeff()).normalized()).norm(),
                4e-16);
      EXPECT_LE((rotation * rotation.transpose() - Rotation::Identity()).norm(), 4e-15);
      EXPECT_GT(rotation.determinant(), 0) << "a reflection";
    }
  for (const double length : {1.0, 1e-300, 1e307}) {
    const DaylightSolid box{.shape = DAYLIGHT_ROUNDED_BOX,
                            .center = {},
                            .axis = {},
                            .quaternion = {-3 * length, 4 * length, length, 2 * length},
                            .lengths = {},
                            .rounding = 0};
    daylight_solid_rotation(&box, rotation.data());
    const Eigen::Quaterniond unit = Eigen::Quaterniond(-3, 4, 1, 2).normalized();
    EXPECT_LE((rotation - unit.toRotationMatrix()).norm(), 2e-15) << length;
  }
  const DaylightSolid plane{.shape = DAYLIGHT_HALF_SPACE,
                            .center = {},
                            .axis = {0, -3e200, 4e200},
                            .quaternion = {},
                            .lengths = {},
                            .rounding = 0};
  daylight_solid_rotation(&plane, rotation.data());
  EXPECT_LE((rotation.col(2) - Vector3(0, -0.6, 0.8)).norm(), 4e-16);
}

TEST(GuestCommand, ItsHelloLimitsPositionsAndDepths) {
  const auto method = command(say(R"({"name":"x","sizes":{"coordinate":4.5,"gap":1.5},"depth":"at_most"})") +
                              "; " + each_line(say(R"({"verdict":"intersecting","distance":-9})")));
  EXPECT_FALSE(method->supports(numbered_pairs(1)[0])) << "a center at 5";
  Pair pair = numbered_pairs(1)[0];
  pair.b.center.x() = 4;
  EXPECT_TRUE(method->supports(pair));
  EXPECT_TRUE(method->ask(pair).at_least);
  pair.a.center.x() = -1;
  EXPECT_FALSE(method->supports(pair)) << "a gap of 5 - sqrt 8";
  EXPECT_STREQ(method->ask(pair).reason, "it does not support these sizes or positions");
}

TEST(GuestCommand, OneOfBoxesAloneIsAskedAboutBoxes) {
  for (const char* kind : {"box", "rounded_box"}) {
    const std::string trouble = "case $q in *'\"shape\":\"box\"'*) " + say(apart) + ";; *) exit 1;; esac";
    const auto method =
        command(say(std::string(R"({"takes":[")") + kind + R"("]})") + "; " + each_line(trouble));
    EXPECT_EQ(method->ask(numbered_pairs(1)[0]).status, Status::declined);
    const Solid box{.rounding = *kind == 'r' ? 1.0 : 0.0, .shape = Shape::box, .edges = {1, 2, 0}};
    EXPECT_EQ(method->ask({box, box}).status, Status::answered) << kind;
    const Solid other{.rounding = 1 - box.rounding, .shape = Shape::box};
    EXPECT_EQ(method->ask({box, other}).status, Status::declined) << kind;
  }
}

TEST(GuestNames, GivenOrDerived) {
  const auto name = [](const std::string& text) {
    Guest guest = read_guest(GuestKind::command, text);
    return std::string(open_guest(guest).front().method->name());
  };
  EXPECT_EQ(read_guest(GuestKind::command, "mine=FOO=1 x").name, "mine");
  EXPECT_EQ(read_guest(GuestKind::command, "FOO=1 x").name, "");
  EXPECT_EQ(read_guest(GuestKind::command, "FOO=1 x").what, "FOO=1 x");
  const Scratch scratch;
  EXPECT_EQ(name("sh  -e " + scratch.write("script.sh", each_line(say(apart)) + '\n') + " --fast"), "script");
  EXPECT_THROW(read_guest(GuestKind::command, "a\tb"), std::invalid_argument);
  EXPECT_THROW(read_guest(GuestKind::plugin, ""), std::invalid_argument);
  EXPECT_THROW(name("test=" + say(R"({"name":"a,b"})")), std::runtime_error);
}

TEST(GuestNames, AreWrittenAndReadBack) {
  std::vector<Guest> guests{read_guest(GuestKind::plugin, "mine=lib x.so"),
                            read_guest(GuestKind::command, "other=python3  'a b.py' ="),
                            read_guest(GuestKind::plugin, "mine:fast=lib.so")};
  guests[2].claim = 1e-9;
  const auto again = parse_guests(format_guests(guests));
  ASSERT_EQ(again.size(), guests.size());
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(again[i].kind, guests[i].kind);
    EXPECT_EQ(again[i].name, guests[i].name);
    EXPECT_EQ(again[i].what, guests[i].what);
    EXPECT_EQ(again[i].folder, guests[i].folder);
    EXPECT_EQ(again[i].method, guests[i].method);
    EXPECT_EQ(again[i].claim, guests[i].claim);
  }
  EXPECT_TRUE(fs::path(again[0].what).is_absolute());
  EXPECT_TRUE(parse_guests("").empty());
  EXPECT_THROW(parse_guests("nonsense"), std::runtime_error);
}

}  // namespace
}  // namespace cyl
