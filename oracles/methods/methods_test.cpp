// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <numbers>
#include <set>

#include "base/scratch_test.hpp"
#include "corpus/pairs/pair_numbers.hpp"
#include "oracles/methods/adapter.hpp"
#include "oracles/methods/contained.hpp"
#include "oracles/methods/method.hpp"
#include "oracles/trial/compare.hpp"

namespace cyl {
namespace {

struct Known {
  Pair pair;
  Verdict verdict;
  double distance;  // exact up to rounding if disjoint
};

/// Returns the point of c farthest along the unit vector d.
Vector3 support(const Solid& c, const Vector3& d) {
  const Vector3 w = unit_axis(c.axis);
  const Vector3 side = w.cross(d).cross(w);
  return c.center + std::copysign(c.height / 2, d.dot(w)) * w + c.radius * side.normalized();
}

/// Moves b so that its point nearest along d is `gap` beyond a's point. Then `gap` is the distance, and d is
/// its direction.
Known apart(Pair p, Vector3 d, double gap) {
  d.normalize();
  p.b.center += support(p.a, d) + gap * d - support(p.b, -d);
  return {p, Verdict::disjoint, gap};
}

/// Returns pairs whose margin is 0.1 or more, at a length unit of `scale`. First they lie in generic poses,
/// apart and with one centre. Then they lie side by side and end to end, apart and overlapping.
std::vector<Known> easy_pairs(double scale = 1) {
  const Vector3 axes[] = {{0, 0, 1}, {0.3, -0.2, 1}, {1, 2, 3}, {-1, 0.5, 0.1}};
  const Vector3 directions[] = {{1, 0.1, 0.2}, {0.1, -1, 0.7}, {-0.3, 0.4, 1.1}};
  const double shapes[][2] = {{1, 2}, {0.3, 4}, {2, 0.5}};
  std::vector<Known> known;
  for (std::size_t i = 0; i < 24; ++i) {
    Pair p;
    p.a = {{0.1, -0.2, 0.3}, axes[i % 4], shapes[i % 3][0], shapes[i % 3][1]};
    p.b = {{0, 0, 0}, axes[(i / 3 + 1) % 4], shapes[(i / 2) % 3][0], shapes[(i / 2) % 3][1]};
    for_each_length(p, [&](double& x) { x *= scale; });
    known.push_back(apart(p, directions[i % 3], 0.1 * size_of(p)));
    p.b.center = p.a.center;
    known.push_back({p, Verdict::intersecting, 0});
  }
  const Vector3 w = unit_axis(axes[1]);
  const Vector3 side = w.unitOrthogonal();
  Pair p{{{0.1, -0.2, 0.3}, w, 1, 2}, {{0, 0, 0}, -w, 0.5, 3}};
  for_each_length(p, [&](double& x) { x *= scale; });
  for (double gap : {0.1 * size_of(p), -0.1 * size_of(p)}) {
    const Verdict verdict = gap > 0 ? Verdict::disjoint : Verdict::intersecting;
    p.b.center = p.a.center + (p.a.radius + p.b.radius + gap) * side;
    known.push_back({p, verdict, gap});
    p.b.center = p.a.center + (p.a.height / 2 + p.b.height / 2 + gap) * w;
    known.push_back({p, verdict, gap});
  }
  return known;
}

std::vector<std::unique_ptr<Method>> chosen(std::string_view spec) {
  auto methods = select_methods(all_methods(), spec);
  std::erase_if(methods, [](const auto& m) { return !m->supports(SolidKind::cylinder); });
  return methods;
}

Solid upright(const Vector3& center) { return {center, {0, 0, 1}, 1, 2}; }

TEST(Methods, EachSaysWhoItIsAndWhatItClaims) {
  std::set<std::string> names;
  bool foreign_seen = false;
  for (const auto& m : all_methods()) {
    EXPECT_TRUE(names.emplace(m->name()).second) << m->name() << " twice";
    EXPECT_FALSE(m->version().empty()) << m->name();
    EXPECT_FALSE(m->claim().source.empty()) << m->name();
    EXPECT_GE(m->share(), 1u);
    EXPECT_FALSE(foreign_seen && !m->foreign()) << m->name() << " is ours and comes late";
    foreign_seen |= m->foreign();
  }
  EXPECT_TRUE(foreign_seen);
}

TEST(Settings, AreMoreOfTheSameUnderNamesOfTheirOwn) {
  std::set<std::string> names;
  for (const auto& m : all_methods()) names.emplace(m->name());
  std::set<std::string> all = names;
  for (const auto& m : setting_methods()) {
    EXPECT_TRUE(all.emplace(m->name()).second) << m->name() << " twice";
    const std::string known(m->name().substr(0, m->name().find('-')));
    EXPECT_TRUE(std::any_of(names.begin(), names.end(), [&](const auto& n) { return n.starts_with(known); }))
        << m->name();
    for (const Known& k : easy_pairs()) EXPECT_EQ(m->ask(k.pair).verdict, k.verdict) << m->name();
  }
}

TEST(Methods, EachIsRightFarFromTouching) {
  for (const auto& m : all_methods()) {
    if (m->name().ends_with("-printed")) continue;  // a document with its faults
    if (!m->supports(SolidKind::cylinder)) continue;
    for (const Known& k : easy_pairs()) {
      const MethodAnswer answer = m->ask(k.pair);
      ASSERT_EQ(answer.status, Status::answered) << m->name() << ": " << answer.reason;
      EXPECT_EQ(answer.verdict, k.verdict) << m->name();
      if (!answer.has_distance) continue;
      if (k.verdict == Verdict::disjoint) {
        EXPECT_NEAR(answer.distance, k.distance, 2e-2 * size_of(k.pair)) << m->name();
      } else {
        EXPECT_LE(answer.distance, 0) << m->name();
      }
    }
  }
}

TEST(Methods, DirectionsSeparateAndPointFromAToB) {
  for (const auto& m : chosen("decide,exact,nlopt,fcl-distance-libccd")) {
    for (const Known& k : easy_pairs()) {
      const MethodAnswer answer = m->ask(k.pair);
      if (k.verdict != Verdict::disjoint) {
        EXPECT_NE(answer.witness, CertificateKind::direction) << m->name();
        continue;
      }
      ASSERT_EQ(answer.witness, CertificateKind::direction) << m->name();
      const Vector3 d = Vector3(answer.head).normalized();
      EXPECT_GT(d.dot(support(k.pair.b, -d) - support(k.pair.a, d)), 0) << m->name();
    }
  }
}

TEST(Methods, ForeignOnesDeclineWhatIsNoCylinder) {
  Pair p{upright({0, 0, 0}), upright({3, 0, 0})};
  p.b.axis = {0, 0, 0};
  for (const auto& m : chosen("nlopt,fcl,bullet,libccd,ode,mujoco")) {
    const MethodAnswer answer = m->ask(p);
    EXPECT_EQ(answer.status, Status::declined) << m->name();
    EXPECT_STREQ(answer.reason, "b: axis is zero");
  }
}

TEST(Methods, TheSamePairGivesTheSameAnswerInAnyOrder) {
  const auto known = easy_pairs();
  for (const auto& m : chosen("fcl,bullet,libccd,ode,mujoco")) {
    std::vector<MethodAnswer> answers;
    for (const Known& k : known) answers.push_back(m->ask(k.pair));
    for (std::size_t i = known.size(); i-- > 0;)
      EXPECT_TRUE(same_answer(m->ask(known[i].pair), answers[i])) << m->name();
  }
}

TEST(Methods, PreparedCallsSayWhatAskSays) {
  std::vector<Pair> pairs;
  for (const Known& k : easy_pairs()) pairs.push_back(k.pair);
  std::set<std::string> verdicts, distances;
  for (const auto& m : chosen("fcl,bullet,libccd,ode,mujoco")) {
    const auto verdict_of = m->prepare_all(pairs);
    const auto distance_of = m->prepare_distances(pairs);
    if (verdict_of) verdicts.emplace(m->name());
    if (distance_of) distances.emplace(m->name());
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const MethodAnswer answer = m->ask(pairs[i]);
      if (verdict_of) {
        EXPECT_EQ(verdict_of(i), answer.verdict) << m->name();
      }
      if (!distance_of) continue;
      const double distance = distance_of(i);
      EXPECT_EQ(std::isnan(distance), !answer.has_distance) << m->name();
      if (answer.has_distance) {
        EXPECT_EQ(distance, answer.distance) << m->name();
      }
    }
  }
  EXPECT_EQ(verdicts.size(), 15u);
  EXPECT_EQ(distances,
            (std::set<std::string>{"fcl-distance-libccd", "fcl-distance-libccd-tol1e-10", "bullet-cylinder",
                                   "bullet-cylinder-margin0", "bullet-gjkepa2"}));
}

TEST(Nlopt, FindsTheDistanceAtEveryScale) {
  for (const auto& m : chosen("nlopt-direct-600,nlopt-mlsl")) {
    for (double scale : {1e-300, 1.0, 1e150}) {
      for (const Known& k : easy_pairs(scale)) {
        const MethodAnswer answer = m->ask(k.pair);
        ASSERT_EQ(answer.verdict, k.verdict) << m->name() << " at " << scale;
        ASSERT_TRUE(answer.has_distance);
        if (k.verdict == Verdict::disjoint) {
          EXPECT_NEAR(answer.distance / size_of(k.pair), k.distance / size_of(k.pair), 1e-7) << m->name();
        }
      }
    }
  }
}

// Rim against rim. Neither an axis nor the cross product separates, so only a search finds the direction.
TEST(Nlopt, FindsANarrowSeparation) {
  const Pair p{{{0, 0, 0}, {1, 2, 3}, 1, 2}, {{0, 0, 0}, {-1, 0.5, 0.1}, 1, 2}};
  const Known k = apart(p, {0.2, 0.9, -0.4}, 1e-4 * size_of(p));
  for (const auto& m : chosen("nlopt")) {
    const MethodAnswer answer = m->ask(k.pair);
    EXPECT_EQ(answer.verdict, Verdict::disjoint) << m->name();
    EXPECT_EQ(answer.has_distance, m->name() != "nlopt-sign-600");
  }
}

TEST(BulletHull, DeclinesBetweenThePrisms) {
  // The polygon has a vertex towards angle 0 and the middle of a side towards pi/16.
  const double side_angle = std::numbers::pi / 16;
  const Vector3 to_side(std::cos(side_angle), std::sin(side_angle), 0);
  for (const auto& m : chosen("bullet-hull-16")) {
    const auto ask = [&](const Vector3& offset) { return m->ask({upright({0, 0, 0}), upright(offset)}); };
    EXPECT_EQ(ask({2.001, 0, 0}).status, Status::declined);
    EXPECT_EQ(ask(1.999 * to_side).status, Status::declined);
    EXPECT_EQ(ask({2.1, 0, 0}).verdict, Verdict::disjoint);
    EXPECT_EQ(ask(1.9 * to_side).verdict, Verdict::intersecting);
    EXPECT_EQ(ask({0, 0, 1.999}).verdict, Verdict::intersecting);
    EXPECT_EQ(ask({0, 0, 2.001}).verdict, Verdict::disjoint);
  }
}

TEST(Bullet, TheDefaultMarginRoundsTheRims) {
  // The rims cross by less than the margins round off, which is (sqrt(2) - 1) * 0.04 each.
  const Pair p{upright({0, 0, 0}), {{1.99, 0, 1.99}, {0, 0, 1}, 1, 2}};
  for (const auto& m : chosen("bullet-cylinder"))
    EXPECT_EQ(m->ask(p).verdict, m->name() == "bullet-cylinder" ? Verdict::disjoint : Verdict::intersecting);
}

TEST(Ode, AbortsOnTinyCylinders) {
  const auto methods = chosen("ode");
  const Pair pairs[] = {{{{0, 0, 0}, {0, 0, 1}, 1e-20, 1e-20}, upright({0, 0, 0})},
                        {upright({0, 0, 0}), upright({3, 0, 0})}};
  const Question questions[] = {{0, 0}, {0, 1}};
  const auto answers = ask_contained(methods, pairs, questions);
  EXPECT_EQ(answers[0].answer.failure, Failure::crash);
  EXPECT_NE(std::string(answers[0].answer.reason).find("Invalid cylinder"), std::string::npos);
  EXPECT_EQ(answers[1].answer.verdict, Verdict::disjoint);
}

TEST(Peers, DeclineSizesThatTheyDoNotTake) {
  for (const auto& m : chosen("ode,mujoco,libccd")) {
    const bool ode = m->name().starts_with("ode"), libccd = m->name().starts_with("libccd");
    const auto status_of = [&](double radius, double height) {
      return m->ask({{{0, 0, 0}, {0, 0, 1}, radius, height}, upright({3, 0, 0})}).status;
    };
    EXPECT_EQ(status_of(1, 0), libccd ? Status::answered : Status::declined) << m->name();
    EXPECT_EQ(status_of(0, 1), libccd || ode ? Status::answered : Status::declined) << m->name();
  }
}

TEST(Mujoco, SaysItsErrorsAndWritesNoLog) {
  const auto methods = chosen("mujoco");
  namespace fs = std::filesystem;
  const fs::path before = fs::current_path();
  const Scratch scratch;
  fs::current_path(scratch.folder);
  mju_warning("no trace of this");
  EXPECT_DEATH(mju_error("said of this"), "said of this");
  EXPECT_TRUE(fs::is_empty(scratch.folder));
  fs::current_path(before);
}

// The squares of their coordinates vanish.
TEST(OwnMethods, DistanceIsSureOfPointsVeryNearEachOther) {
  const Pair points{{{0, 0, 0}, {0, 0, 1}, 0, 0}, {{0x1p-600, 0, 0}, {0, 0, 1}, 0, 0}};
  const MethodAnswer answer = select_methods(own_methods(), "distance").front()->ask(points);
  EXPECT_TRUE(answer.has_distance);
  EXPECT_EQ(answer.distance, 0x1p-600);
}

// The plane's point is 1e12 away. The crumb is nearest at a vertex, in a direction nearly square to an edge.
TEST(OwnMethods, DistanceReturnsNoNumberThatItDoesNotPromise) {
  const Solid ball{{0, 225000000000.0, 900000000000.0}, {0, 0, 1}, 0, 0, 0.9},
      plane{.center = {0, 0.95459, 0}, .axis = {1, -4, 1}, .shape = Shape::half_space},
      box{.shape = Shape::box, .edges = {1, 1, 1}},
      crumb{.shape = Shape::box,
            .edges = {3.6130115758521194e-8, 6.38302526904352e-6, 8.858524460624854e-6},
            .quaternion = {1.910992153139412, -0.9286739806328015, -1.1158233265875891, 0.7052120560036716}};
  const Vector3 at(-0.006105129749752828, -0.010511459170868123, -0.006511328605873546),
      w(0.43997080750367235, 0.7567567108841752, 0.4690003796351363);
  const auto method = std::move(select_methods(own_methods(), "distance").front());
  for (const Pair& pair : {Pair{ball, plane}, Pair{box, {{0, 0, 0}, {0, 0, 1}, 1, 2}}})
    EXPECT_TRUE(method->ask(pair).verdict == Verdict::intersecting && !method->ask(pair).has_distance);
  EXPECT_EQ(method->ask({box, {.center = {0, 0, -1}, .shape = Shape::half_space}}).distance, 0.5);
  EXPECT_TRUE(method->ask({crumb, {at, w, 0, 0.03409198776164704, 4.035537999864008e-7}}).has_distance);
}

}  // namespace
}  // namespace cyl
