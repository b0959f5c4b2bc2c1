// SPDX-License-Identifier: MIT
#include "props/laws.hpp"

#include <gtest/gtest.h>
// After gtest.h.
#include <rapidcheck/gtest.h>

#include <cmath>
#include <functional>
#include <memory>
#include <ostream>
#include <vector>

#include "corpus/families.hpp"
#include "corpus/pair_io.hpp"

namespace cyl {

/// How RapidCheck prints a counterexample: as a line of a case file.
void showValue(const Pair& pair, std::ostream& out) { out << format_pair(pair); }

namespace {

/// Pairs of each family, beside those that RapidCheck draws.
constexpr std::uint64_t pairs_per_family = 200;
constexpr std::uint64_t family_seed = 20261121;

/// n/64 with least <= n <= 256: exact in sums and products, often touching; shrinks to small numbers.
rc::Gen<double> on_grid(int least) {
  return rc::gen::map(rc::gen::inRange(least, 257), [](int n) { return n / 64.0; });
}

template <typename Coordinate>
rc::Gen<Vector3> vector_of(const rc::Gen<Coordinate>& x) {
  return rc::gen::map(rc::gen::tuple(x, x, x),
                      [](const auto& v) { return Vector3(std::get<0>(v), std::get<1>(v), std::get<2>(v)); });
}

/// Half the axes have coordinates -2..2, so that parallel and perpendicular ones are common.
rc::Gen<Vector3> grid_axis() {
  return rc::gen::suchThat(rc::gen::oneOf(vector_of(rc::gen::inRange(-2, 3)), vector_of(on_grid(-256))),
                           [](const Vector3& v) { return v != Vector3::Zero(); });
}

rc::Gen<Cylinder> grid_cylinder() {
  return rc::gen::map(rc::gen::tuple(vector_of(on_grid(-256)), grid_axis(), on_grid(0), on_grid(0)),
                      [](const auto& c) {
                        return Cylinder{std::get<0>(c), std::get<1>(c), std::get<2>(c), std::get<3>(c)};
                      });
}

rc::Gen<Pair> grid_pair() {
  return rc::gen::map(rc::gen::pair(grid_cylinder(), grid_cylinder()), [](const auto& p) {
    return Pair{p.first, p.second};
  });
}

rc::Gen<Pair> family_pair() {
  return rc::gen::map(
      rc::gen::tuple(rc::gen::inRange<std::size_t>(0, families().size()), rc::gen::arbitrary<std::uint64_t>(),
                     rc::gen::arbitrary<std::uint64_t>()),
      [](const auto& drawn) {
        const auto& [family, seed, index] = drawn;
        return families()[family].generate(seed, index);
      });
}

/// What our own methods break on this pair, or empty.
std::string broken_by_ours(const Pair& pair) {
  for (const auto& method : own_methods()) {
    for (const Law& law : all_laws()) {
      const auto broken = broken_by(*method, law, pair);
      if (broken && broken->severity == Severity::contract)
        return std::string(method->name()) + ", " + std::string(law.name) + ": " + broken->what;
    }
  }
  return {};
}

RC_GTEST_PROP(ExactLaws, HoldOnTheGrid, ()) {
  const std::string broken = broken_by_ours(*grid_pair());
  if (!broken.empty()) RC_FAIL(broken);
}

RC_GTEST_PROP(ExactLaws, HoldOnDrawnPairs, ()) {
  const std::string broken = broken_by_ours(*family_pair());
  if (!broken.empty()) RC_FAIL(broken);
}

class FamilyLaws : public testing::TestWithParam<std::size_t> {};

TEST_P(FamilyLaws, HoldOnTheFirstPairs) {
  for (std::uint64_t index = 0; index < pairs_per_family; ++index) {
    const Pair pair = families()[GetParam()].generate(family_seed, index);
    ASSERT_EQ(broken_by_ours(pair), "") << format_pair(pair);
  }
}

INSTANTIATE_TEST_SUITE_P(ExactLaws, FamilyLaws, testing::Range<std::size_t>(0, families().size()),
                         [](const auto& info) { return std::string(families()[info.param].name); });

using Ask = std::function<MethodAnswer(const Pair&)>;

/// Under the name of a method that promises every bit, or of one that promises verdicts.
class Planted : public Method {
 public:
  Planted(std::string_view name, Ask ask) : name_(name), ask_(std::move(ask)) {}
  std::string_view name() const override { return name_; }
  std::string_view version() const override { return "0"; }
  Claim claim() const override { return {}; }
  MethodAnswer ask(const Pair& pair) override { return ask_(pair); }

 private:
  std::string_view name_;
  Ask ask_;
};

/// Keeps every exact law: two cubes, one around each centre.
MethodAnswer cubes(const Pair& pair) {
  const Vector3 delta = pair.b.center - pair.a.center;
  MethodAnswer answer;
  answer.status = Status::answered;
  answer.verdict = Verdict::intersecting;
  for (int i = 0; i < 3; ++i) {
    if (std::fabs(delta[i]) <= pair.a.radius + pair.b.radius) continue;
    answer.verdict = Verdict::disjoint;
    answer.witness = WitnessKind::direction;
    answer.head[i] = delta[i] > 0 ? 1 : -1;
  }
  return answer;
}

/// The numbers of the laws that the first pairs of `random` show broken.
std::vector<int> laws_broken_by(const Ask& ask, std::string_view name = "intersect") {
  Planted method(name, ask);
  std::vector<int> numbers;
  for (const Law& law : all_laws()) {
    if (law.kind != LawKind::exact) continue;
    for (std::uint64_t index = 0; index < pairs_per_family; ++index) {
      const Pair pair = find_family("random")->generate(family_seed, index);
      if (!broken_by(method, law, pair)) continue;
      numbers.push_back(law.number);
      break;
    }
  }
  return numbers;
}

TEST(ExactLaws, AreKeptByAMethodThatKeepsThem) { EXPECT_EQ(laws_broken_by(cubes), std::vector<int>{}); }

TEST(ExactLaws, CatchAVerdictThatFavoursOneRoleWhereOnlyVerdictsMustAgree) {
  const auto favours = [](const Pair& pair) {
    MethodAnswer answer = cubes(pair);
    if (pair.a.radius < pair.b.radius) answer.verdict = Verdict::undecided;
    answer.head[0] = pair.a.axis.x();
    return answer;
  };
  EXPECT_EQ(laws_broken_by(favours, "planted"), std::vector<int>{1});
}

TEST(ExactLaws, CatchAVerdictThatFavoursOneRole) {
  EXPECT_EQ(laws_broken_by([](const Pair& pair) {
              MethodAnswer answer = cubes(pair);
              if (pair.a.radius < pair.b.radius) answer.verdict = Verdict::undecided;
              return answer;
            }),
            std::vector<int>{1});
}

TEST(ExactLaws, CatchADirectionThatAlwaysPointsUp) {
  EXPECT_EQ(laws_broken_by([](const Pair& pair) {
              MethodAnswer answer = cubes(pair);
              for (double& x : answer.head) x = std::fabs(x);
              return answer;
            }),
            std::vector<int>{1});
}

TEST(ExactLaws, CatchAnAbsoluteTolerance) {
  EXPECT_EQ(laws_broken_by([](const Pair& pair) {
              MethodAnswer answer = cubes(pair);
              if ((pair.b.center - pair.a.center).lpNorm<Eigen::Infinity>() < 1e-6)
                answer.verdict = Verdict::undecided;
              return answer;
            }),
            std::vector<int>{2});
}

TEST(ExactLaws, CatchADistanceThatDoesNotScale) {
  EXPECT_EQ(laws_broken_by([](const Pair&) {
              MethodAnswer answer;
              answer.status = Status::answered;
              answer.has_distance = true;
              answer.distance = 1;
              return answer;
            }),
            std::vector<int>{2});
}

TEST(ExactLaws, CatchAnAnswerThatLooksAtTheSenseOfAnAxis) {
  EXPECT_EQ(laws_broken_by([](const Pair& pair) {
              MethodAnswer answer = cubes(pair);
              if (pair.a.axis.dot(pair.b.axis) < 0) answer.verdict = Verdict::undecided;
              return answer;
            }),
            std::vector<int>{3});
}

}  // namespace
}  // namespace cyl
