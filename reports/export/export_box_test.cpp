// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <fstream>
#include <stdexcept>
#include <string>

#include "base/safe_text.hpp"
#include "base/scratch_test.hpp"
#include "reports/export/export_check.hpp"
#include "reports/export/export_program.hpp"
#include "reports/export/pair_in_words.hpp"

namespace cyl {
namespace {

/// Two solids, the first a box, apart by 0.15 along its shortest edge, which is (-10, 10, 5) / 15. The other
/// edges are long, so a transposed rotation or swapped edges would make them meet.
Pair apart(const Solid& second, double extent) {
  Pair pair{{.shape = Shape::box, .edges = {1.1, 2.3, 3.7}, .quaternion = {1, 2, 3, 4}}, second};
  pair.b.center = (0.55 + extent + 0.15) / 15 * Vector3(-10, 10, 5);
  return pair;
}
const Pair boxes = apart({.shape = Shape::box, .edges = {0.7, 3.1, 1.9}, .quaternion = {1, 2, 3, 4}}, 0.35);
const Pair box_and_cylinder = apart({.axis = {-10, 10, 5}, .radius = 1.3, .height = 0.6}, 0.3);

/// Returns the program that asks the method about two disjoint solids.
std::string program_about(const Pair& pair, const Method& method) {
  Truth truth;
  truth.verdict = Verdict::disjoint;
  Trial asked(pair, truth);
  asked.distance = {0.1, 0.2};
  asked.answers.resize(1);
  asked.answers[0].status = Status::answered;
  asked.answers[0].verdict = Verdict::intersecting;
  asked.findings = {Finding{FindingKind::wrong_intersecting, Severity::contract, {}}};
  return reproducing_program(*find_library_call(method.name()), asked, method);
}

/// Builds a program and runs it, and returns its exit code.
int run(const LibraryCall& call, const std::string& program) {
  const Scratch scratch;
  std::ofstream(scratch.folder / "reproduce.cpp") << program;
  const std::string command = "cd " + shell_quoted(scratch.folder.string()) + " && c++ " +
                              std::string(compiler_options) + " reproduce.cpp -o reproduce " + call.flags +
                              " && ./reproduce >printed";
  const int status = std::system(command.c_str());
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128;
}

TEST(ExportOfBoxes, EachProgramAsksAboutTheBoxes) {
  std::size_t asked = 0;
  const auto methods = all_methods();
  for (const char* name : {"fcl-indep", "fcl-distance-libccd", "bullet-cylinder-margin0", "bullet-gjkepa2",
                           "bullet-hull-16", "bullet-box", "libccd-gjk", "ode", "mujoco"}) {
    const auto& method = find_method(methods, name);
    const LibraryCall& call = *find_library_call(method->name());
    for (const Pair& pair : {boxes, box_and_cylinder}) {
      if (!method->supports(pair)) continue;
      ASSERT_TRUE(program_takes(call.library, pair)) << method->name();
      ASSERT_EQ(method->ask(pair).verdict, Verdict::disjoint) << method->name();
      const std::string program = program_about(pair, *method);
      EXPECT_EQ(run(call, program), 0) << method->name() << '\n' << program;
      ++asked;
    }
  }
  EXPECT_EQ(asked, 17u);
}

// A direction separates these boxes by 1e-17 only, and the library gets rounded rotations.
TEST(ExportOfBoxes, ALibraryIsNotBlamedForRoundedRotations) {
  Trial asked;
  asked.pair = boxes;
  asked.truth.verdict = Verdict::disjoint;
  asked.findings.resize(1);
  asked.distance = {1e-17, 2e-17};
  EXPECT_THROW(exact_check(asked, {}), std::runtime_error);
}

TEST(ExportOfBoxes, ABoxIsSaidInWords) {
  Pair pair = boxes;
  EXPECT_EQ(solids_in_words(pair), "two boxes");
  pair.b.rounding = 0.25;
  EXPECT_EQ(solids_in_words(pair), "a box and a rounded box");
  const std::string question = question_of(pair);
  for (const char* part : {"| a | (0, 0, 0) | quaternion (1, 2, 3, 4) | edges (1.1, 2.3, 3.7) |",
                           "edges (0.7, 3.1, 1.9), rounding 0.25 |", "full lengths"})
    EXPECT_NE(question.find(part), std::string::npos) << part << " is not in\n" << question;
  EXPECT_NE(question_of(box_and_cylinder).find("| axis (-10, 10, 5) | radius 1.3, height 0.6 |"),
            std::string::npos);
}

}  // namespace
}  // namespace cyl
