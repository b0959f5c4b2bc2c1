// SPDX-License-Identifier: MIT
// Asks each packaged library about boxes, in poses whose truth is known by construction.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "base/enum_words.hpp"
#include "corpus/pairs/pair_io.hpp"
#include "corpus/pairs/pair_numbers.hpp"
#include "corpus/pairs/solid_kind.hpp"
#include "corpus/pairs/support.hpp"
#include "oracles/methods/adapter.hpp"
#include "oracles/methods/method.hpp"

namespace cyl {
namespace {

using enum SolidKind;

constexpr std::array<double, 4> quarter_turn_about_z{1, 0, 0, 1}, turn{1, 2, 3, 4};

/// The columns of the rotation of `turn`, times 15.
const std::array<Vector3, 3> turned_columns{Vector3(-10, 10, 5), Vector3(2, -5, 14), Vector3(11, 10, 2)};

/// All lengths differ, so that a transposed rotation or swapped edges are seen.
Solid make_box(const std::array<double, 3>& edges, const std::array<double, 4>& quaternion,
               double rounding = 0) {
  return {.rounding = rounding, .shape = Shape::box, .edges = edges, .quaternion = quaternion};
}

/// A solid of each kind, with lengths that all differ. A cylinder lies along `axis`.
Solid make(SolidKind kind, const Vector3& axis, const std::array<double, 4>& quaternion) {
  switch (kind) {
    case sphere:
      return {.rounding = 0.7};
    case capsule:
      return {.axis = axis, .height = 1.6, .rounding = 0.5};
    case cylinder:
      return {.axis = axis, .radius = 0.6, .height = 2.2};
    case rounded:
      return {.axis = axis, .radius = 0.4, .height = 1.5, .rounding = 0.3};
    case half_space:
      return {.axis = axis, .shape = Shape::half_space};
    case box:
      return make_box({0.7, 1.9, 1.3}, quaternion);
    case rounded_box:
      return make_box({0.6, 1.8, 1.2}, quaternion, 0.2);
  }
  return {};
}

struct Known {
  Pair pair;
  bool meet;
};

Vector3 eigen(const Vec3<double>& v) { return {v.x, v.y, v.z}; }

/// Moves b along the unit vector d until a plane square to d lies in the middle of a gap. Then moves it
/// so far that a point deep in a is one deep in b.
void add_apart_and_overlapping(std::vector<Known>& known, Pair pair, const Vector3& d, double gap) {
  const Vec3<double> along = lifted<double>(d), back = lifted<double>(Vector3(-d));
  const auto a = terms_of<double>(pair.a), b = terms_of<double>(pair.b);
  pair.b.center = pair.a.center + (support(a, along) + support(b, back) + gap) * d;
  known.push_back({pair, false});
  pair.b.center = pair.a.center + 0.6 * (eigen(farthest(a, along)) - eigen(farthest(b, back)));
  known.push_back({pair, true});
}

/// Returns pairs of a box and a solid of that kind, the box first.
std::vector<Known> pairs_with_box(SolidKind box_kind, SolidKind kind) {
  std::vector<Known> known;
  // Facet on facet, side or cap: the faces are square to the edges of the box.
  for (const auto& quaternion : {quarter_turn_about_z, turn}) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Vector3 edge = quaternion == turn ? Vector3(turned_columns[k] / 15)
                           : k == 0           ? Vector3(0, 1, 0)
                           : k == 1           ? Vector3(-1, 0, 0)
                                              : Vector3(0, 0, 1);
      Solid first = make_box({1.1, 2.3, 3.7}, quaternion, box_kind == rounded_box ? 0.1 : 0);
      first.center = {0.1, -0.2, 0.3};
      const double half = first.edges[k] / 2 + first.rounding;
      Solid second = make(kind, edge, quaternion);
      const double extent = kind == half_space           ? 0
                            : kind_of(second) == box     ? second.edges[k] / 2
                            : second.shape == Shape::box ? second.edges[k] / 2 + second.rounding
                                                         : second.height / 2 + second.rounding;
      for (const double gap : {5.0, 0.15, -0.15}) {
        second.center = first.center + (half + extent + gap) * edge;
        if (kind == half_space) second.axis = -edge;
        known.push_back({{first, second}, gap < 0});
      }
    }
  }
  if (kind == half_space) return known;
  // Anywhere: vertices, edges and rims.
  const std::array directions{Vector3(1, 0.1, 0.2), Vector3(0.1, -1, 0.7), Vector3(-0.3, 0.4, 1.1),
                              Vector3(-2, -1, 0.4)};
  for (const auto& quaternion : {std::array{1.0, 0.0, 0.0, 0.0}, turn, std::array{0.9, -0.3, 0.2, 0.1}})
    for (const Vector3& d : directions)
      add_apart_and_overlapping(known,
                                {make_box({1.1, 2.3, 3.7}, quaternion, box_kind == rounded_box ? 0.1 : 0),
                                 make(kind, {-1, 0.5, 0.1}, {0.2, 0.4, -0.3, 0.8})},
                                d.normalized(), 0.15);
  return known;
}

TEST(BoxMethods, AreRightWhereThatIsEasy) {
  std::map<std::string, std::size_t> answers;
  for (const auto& method : all_methods()) {
    if (method->share() > 64) continue;  // slow
    for (const SolidKind box_kind : {box, rounded_box}) {
      for (const SolidKind kind : enum_values<SolidKind>) {
        const std::vector<Known> known = pairs_with_box(box_kind, kind);
        std::vector<Pair> pairs;
        for (const Known& k : known) pairs.push_back(k.pair);
        const bool supported = method->supports(pairs[0]);
        const bool own_word = kind == half_space && box_kind == rounded_box;  // Bullet's plane declines
        const auto prepared =
            supported && method->foreign() && !own_word ? method->prepare_all(pairs) : Method::Call{};
        for (std::size_t i = 0; i < known.size(); ++i) {
          const MethodAnswer answer = method->ask(pairs[i]);
          if (!supported || (own_word && method->library() == "bullet")) {
            ASSERT_EQ(answer.status, Status::declined) << method->name();
            continue;
          }
          if (method->name() == "exact") continue;
          if (method->name() == "ode-unrefined" && kind == box) continue;  // see below
          ASSERT_EQ(answer.status, Status::answered) << method->name() << ' ' << format_pair(pairs[i]);
          EXPECT_EQ(answer.verdict != Verdict::disjoint, known[i].meet)
              << method->name() << ' ' << format_pair(pairs[i]);
          if (prepared) {
            EXPECT_EQ(prepared(i), answer.verdict) << method->name();
          }
          const MethodAnswer swapped = method->ask({pairs[i].b, pairs[i].a});
          EXPECT_EQ(swapped.verdict, answer.verdict) << method->name() << ' ' << format_pair(pairs[i]);
          Pair stretched = pairs[i];
          for (double& q : stretched.a.quaternion) q *= 0x1p-600;
          for (double& q : stretched.b.quaternion) q *= 0x1p600;
          EXPECT_EQ(method->ask(stretched).verdict, answer.verdict) << method->name();
          ++answers[std::string(method->name())];
        }
      }
    }
  }
  constexpr std::size_t aligned = 18, anywhere = 24;
  const auto count = [](std::size_t kinds, bool plane) {
    return kinds * (aligned + anywhere) + (plane ? aligned : 0);
  };
  EXPECT_EQ(answers["fcl-libccd"], count(4, true));
  EXPECT_EQ(answers["fcl-distance-libccd"], count(4, false));
  EXPECT_EQ(answers["ode"], count(4, true));
  EXPECT_EQ(answers["mujoco"], count(4, true));
  EXPECT_EQ(answers["bullet-cylinder"], count(12, true));
  EXPECT_EQ(answers["bullet-gjkepa2"], count(2, false));
  EXPECT_EQ(answers["bullet-hull-64"], count(2, false));
  EXPECT_EQ(answers["bullet-box"], count(1, false));
  EXPECT_EQ(answers["libccd-gjk"], count(12, false));
  EXPECT_EQ(answers["nlopt-direct-600"], count(12, false));
}

// A margin rounds the edges of Bullet's boxes, but not before a plane.
TEST(BoxMethods, ThatRoundEdgesNameTheirModel) {
  const Pair boxes{make_box({1, 2, 3}, turn), make_box({4, 2, 3}, turn)};
  const Pair plane{make_box({1, 2, 3}, turn), {.shape = Shape::half_space}};
  for (const auto& method : all_methods()) {
    const bool rounds = method->name() == "bullet-cylinder";
    EXPECT_EQ(is_rounded(method->modelled(boxes)), rounds) << method->name();
    EXPECT_FALSE(is_rounded(method->modelled(plane))) << method->name();
    if (!rounds) continue;
    const Solid model = method->modelled(boxes).a;
    for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(model.edges[k] + 2 * model.rounding, boxes.a.edges[k]);
  }
}

TEST(BoxMethods, OnlyMujocoDeclinesEdgesOfLengthZero) {
  const Pair flat{make_box({1, 0, 3}, turn), {.center = {9, 0, 0}, .radius = 1, .height = 2}};
  for (const auto& method : all_methods()) {
    if (!method->foreign() || !method->supports(flat)) continue;
    const MethodAnswer answer = method->ask(flat);
    if (method->library() == "mujoco") {
      EXPECT_EQ(answer.status, Status::declined) << method->name();
    } else {
      EXPECT_EQ(answer.verdict, Verdict::disjoint) << method->name();
    }
  }
}

// It makes contacts along the first direction that does not separate two boxes. There may be none.
TEST(BoxMethods, UnrefinedOdeMissesAnOverlap) {
  Pair pair{make_box({1.1, 2.3, 3.7}, {1, 0, 0, 0}), make_box({0.7, 1.9, 1.3}, {0.2, 0.4, -0.3, 0.8})};
  pair.b.center = {0.085, -1.351, 1.266};
  for (const auto& method : select_methods(all_methods(), "ode"))
    EXPECT_EQ(method->ask(pair).verdict != Verdict::disjoint, method->name() != "ode-unrefined");
}

}  // namespace
}  // namespace cyl
