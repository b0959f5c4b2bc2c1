// SPDX-License-Identifier: MIT
#include "bench/paths.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/json.hpp"
#include "oracles/methods/fake_method_test.hpp"
#include "oracles/referee/referee.hpp"

namespace cyl {
namespace {

MethodAnswer right_answer(const PathStep& step) {
  MethodAnswer a;
  a.status = Status::answered;
  a.verdict = step.distance > 0 ? Verdict::disjoint : Verdict::intersecting;
  a.has_distance = true;
  a.distance = step.distance;
  a.set_direction(Vector3(0, 0, 2));
  return a;
}

std::vector<MethodAnswer> right_answers(const Path& path) {
  std::vector<MethodAnswer> answers;
  for (const PathStep& step : path.steps) answers.push_back(right_answer(step));
  return answers;
}

const std::vector<Path>& paths() {
  static const std::vector<Path> made = make_paths(1);
  return made;
}

TEST(Paths, TheProvedVerdictFlipsAsOftenAsThePathSays) {
  for (const std::uint64_t seed : {1u, 2u}) {
    for (const Path& path : make_paths(seed)) {
      std::size_t flips = 0;
      bool before = false;
      for (std::size_t i = 0; i < path.steps.size(); ++i) {
        const bool apart = judge_verdict(path.steps[i].pair).verdict == Verdict::disjoint;
        ASSERT_EQ(apart, path.steps[i].distance > 0) << path.name << " at " << path.steps[i].at;
        flips += i > 0 && apart != before;
        before = apart;
      }
      EXPECT_EQ(flips, path.flips) << path.name;
    }
  }
}

TEST(Paths, TheProvedDistanceIsThatOfTheStep) {
  for (const Path& path : paths()) {
    for (std::size_t i = 0; i < path.steps.size(); i += 20) {
      const PathStep& step = path.steps[i];
      const double width = 1e-11;
      const Enclosure proved = enclose_distance(step.pair, judge(step.pair), width);
      const double tol = 1.2 * width * size_of(step.pair);
      EXPECT_NEAR(proved.lo, step.distance, tol) << path.name << " at " << step.at;
      EXPECT_NEAR(proved.hi, step.distance, tol) << path.name << " at " << step.at;
    }
  }
}

TEST(Paths, TheDirectionIsOneAndTheSameAllTheWay) {
  for (const Path& path : paths()) {
    Vector3 first(0, 0, 0);
    for (const std::size_t i : {std::size_t{0}, path.steps.size() / 2, path.steps.size() - 1}) {
      const PathStep& step = path.steps[i];
      const auto found = attain_distance(step.pair, judge(step.pair), 1e-13);
      const Vector3 direction(found.direction[0], found.direction[1], found.direction[2]);
      if (i == 0) first = direction;
      EXPECT_LT((direction - first).norm(), 1e-2) << path.name << " at " << step.at;
    }
  }
}

TEST(Stability, OfRightAnswersIsWhole) {
  for (const Path& path : paths()) {
    const PathStability s = stability_along(path, "right", right_answers(path));
    EXPECT_EQ(s.flips, path.flips);
    EXPECT_EQ(s.said, s.steps);
    EXPECT_EQ(s.distance_jump, 0);
    EXPECT_EQ(s.direction_jump_degrees, 0);
  }
}

TEST(Stability, SeesAVerdictThatFlipsTwiceMore) {
  for (const Path& path : paths()) {
    std::vector<MethodAnswer> answers = right_answers(path);
    const std::size_t at = path.steps.size() / 4;
    Verdict& one = answers[at].verdict;
    one = one == Verdict::disjoint ? Verdict::touching : Verdict::disjoint;
    const PathStability s = stability_along(path, "flips", answers);
    EXPECT_EQ(s.flips, path.flips + 2) << path.name;
  }
}

TEST(Stability, PassesOverWhatIsNotSaid) {
  std::vector<MethodAnswer> answers = right_answers(paths()[0]);
  answers[3].verdict = Verdict::undecided;
  answers[4].status = Status::declined;
  answers[5].status = Status::failed;
  const PathStability s = stability_along(paths()[0], "some", answers);
  EXPECT_EQ(s.flips, 1u);
  EXPECT_EQ(s.said, s.steps - 3);
}

TEST(Stability, SeesADistanceThatJumps) {
  for (const Path& path : paths()) {
    std::vector<MethodAnswer> answers = right_answers(path);
    const std::size_t at = path.steps.size() / 2 + 3;
    answers[at].distance += 0.25 * size_of(path.steps[at].pair);
    answers[2].distance = std::nan("");  // counts as no distance, not as a jump
    const PathStability s = stability_along(path, "jumps", answers);
    ASSERT_TRUE(s.distance_jump);
    EXPECT_NEAR(*s.distance_jump, 0.25, 1e-3) << path.name;
    EXPECT_EQ(s.flips, path.flips);
  }
}

TEST(Stability, SeesADirectionThatTurns) {
  std::vector<MethodAnswer> answers = right_answers(paths()[0]);
  answers[7].set_direction(Vector3(5, 0, 5));
  const PathStability s = stability_along(paths()[0], "turns", answers);
  ASSERT_TRUE(s.direction_jump_degrees);
  EXPECT_NEAR(*s.direction_jump_degrees, 45, 1e-9);
}

TEST(Stability, OfMethodsIsByPathAndWithoutThoseThatSayNothing) {
  std::vector<std::unique_ptr<Method>> methods = select_methods(own_methods(), "decide");
  methods.push_back(fake_method("moody", [asked = 0](const Pair&) mutable {
    return answered(asked++ % 3 == 0 ? Verdict::disjoint : Verdict::intersecting);
  }));
  methods.push_back(fake_method("silent", [](const Pair&) { return MethodAnswer(); }));
  const std::vector<PathStability> all = path_stability(methods, 1);
  ASSERT_EQ(all.size(), 2 * paths().size());
  for (std::size_t p = 0; p < paths().size(); ++p) {
    EXPECT_EQ(all[p].method, "decide");
    EXPECT_LE(all[p].flips, paths()[p].flips) << all[p].path;  // it is never wrong
    EXPECT_GT(all[p].said, 0u);
    const PathStability& moody = all[paths().size() + p];
    EXPECT_EQ(moody.path, paths()[p].name);
    EXPECT_GT(moody.flips, moody.steps / 2);
    EXPECT_FALSE(moody.distance_jump);
  }
  const nlohmann::json reported = paths_json(all);
  const nlohmann::json& last = reported.back();
  EXPECT_EQ(last["method"], "moody");
  EXPECT_EQ(last["path"], "coaxial overlap");
  EXPECT_EQ(last["steps"], all.back().steps);
  EXPECT_EQ(last["flips"], all.back().flips);
  EXPECT_TRUE(last["distance_jump"].is_null());
  EXPECT_TRUE(last["direction_jump_degrees"].is_null());
}

}  // namespace
}  // namespace cyl
