// SPDX-License-Identifier: MIT
#include "props/shrink/simplify.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <ostream>
#include <string>

#include "corpus/pairs/families.hpp"
#include "corpus/pairs/pair_io.hpp"
#include "corpus/pairs/pair_numbers.hpp"
#include "corpus/pairs/strata.hpp"
#include "corpus/pairs/support.hpp"
#include "oracles/referee/referee.hpp"
#include "oracles/trial/contact.hpp"
#include "oracles/trial/failure_key.hpp"
#include "props/shrink/moves.hpp"

namespace cyl {
namespace {

constexpr std::uint64_t seed = 20261121;

using Fails = std::function<bool(const Pair&)>;

/// Asks about one pair after the other, and counts.
struct Asker {
  Fails fails;
  std::size_t asked = 0, illegal = 0;
  std::vector<bool> operator()(std::span<const Pair> pairs) {
    std::vector<bool> out;
    for (const Pair& p : pairs) {
      ++asked;
      illegal += find_defect(p.a) != Defect::none || find_defect(p.b) != Defect::none;
      out.push_back(fails(p));
    }
    return out;
  }
};

Simplified simplify_by(const Pair& pair, const Fails& fails, std::size_t cap = question_cap_default) {
  return simplify(pair, Asker{fails}, cap);
}

/// Returns pairs of a family that fail.
std::vector<Pair> failing(std::string_view family, const Fails& fails, std::size_t count,
                          std::uint64_t pairs = 20000) {
  std::vector<Pair> out;
  for (std::uint64_t i = 0; i < pairs && out.size() < count; ++i) {
    const Pair p = find_family(family)->generate(seed, i);
    if (fails(p)) out.push_back(p);
  }
  return out;
}

double sine(const Pair& p) { return p.a.axis.stableNormalized().cross(p.b.axis.stableNormalized()).norm(); }

// Planted faults.

bool nearly_parallel(const Pair& p) { return sine(p) < 1e-7; }
bool nearly_parallel_not_quite(const Pair& p) { return sine(p) > 0 && sine(p) < 1e-7; }
bool fat(const Pair& p) { return p.a.radius > 3; }
bool far_out(const Pair& p) { return p.a.center.norm() > 1e6; }
bool tiny_gap(const Pair& p) {
  const Truth truth = judge(p);
  return truth.verdict == Verdict::disjoint && enclose_distance(p, truth, 1e-14).hi < 1e-9 * size_of(p);
}
bool oblique_tiny_gap(const Pair& p) { return sine(p) > 0.1 && sine(p) < 0.9 && tiny_gap(p); }
bool tiny_overlap(const Pair& p) {
  const Truth truth = judge(p);
  return truth.verdict == Verdict::intersecting && enclose_distance(p, truth).lo > -1e-5 * size_of(p);
}
bool shallow(const Pair& p) {
  const Truth truth = judge(p);
  const Enclosure d = enclose_distance(p, truth);
  return truth.verdict == Verdict::intersecting && d.hi < 0 && d.lo > -1e-2 * size_of(p);
}
bool apart(const Pair& p) { return judge(p).verdict == Verdict::disjoint; }
bool long_axes(const Pair& p) { return p.a.axis.stableNorm() > 1e40; }

/// A fault that is only noise, for one pair in sixteen.
bool chaotic(const Pair& p) { return std::hash<std::string>{}(format_pair(p)) / 128 % 16 == 0; }

struct Planted {
  const char* name;
  const char* family;
  bool (*fails)(const Pair&);
  int digits;             ///< at most, of the simplest pair
  std::size_t questions;  ///< at most
};

void PrintTo(const Planted& p, std::ostream* out) { *out << p.name; }

constexpr Planted planted[] = {
    {"parallel", "axes_nearly_parallel", nearly_parallel, 6, 1000},
    {"nearly_parallel", "axes_nearly_parallel", nearly_parallel_not_quite, 7, 1000},
    {"fat", "random", fat, 7, 1000},
    {"far_out", "far", far_out, 7, 1000},
    {"shallow", "random", shallow, 12, 2000},
    {"tiny_gap_side_side", "touching_side_side", tiny_gap, 20, 2000},
    {"tiny_gap_rim_rim", "touching_rim_rim", tiny_gap, 20, 2000},
    {"oblique_tiny_gap", "touching_rim_rim", oblique_tiny_gap, 20, 2000},
    {"tiny_overlap", "touching_side_rim", tiny_overlap, 20, 2000},
    {"apart", "random", apart, 7, 1000},
    {"long_axes", "raw_axes", long_axes, 6, 1000},
    {"chaotic", "random", chaotic, 272, 4000},
};

class Simplify : public testing::TestWithParam<Planted> {};

TEST_P(Simplify, EndsSimpleAndKeepsItsLaws) {
  const Planted& fault = GetParam();
  const std::vector<Pair> found = failing(fault.family, fault.fails, 3);
  ASSERT_EQ(found.size(), 3u);
  for (const Pair& pair : found) {
    Asker asker{fault.fails};
    const Simplified s = simplify(pair, std::ref(asker));
    std::printf("%4zu questions, %2d digits: %s\n", s.questions, complexity(s.pair).digits,
                format_pair(s.pair).c_str());
    EXPECT_TRUE(fault.fails(s.pair));
    EXPECT_LE(complexity(s.pair), complexity(pair));
    EXPECT_LE(complexity(s.pair).digits, fault.digits) << format_pair(pair);
    EXPECT_LE(s.questions, fault.questions);
    EXPECT_FALSE(s.at_cap);
    EXPECT_EQ(s.questions, asker.asked);
    EXPECT_EQ(asker.illegal, 0u);
    // The search is deterministic, and it is at its end.
    EXPECT_EQ(format_pair(simplify_by(pair, fault.fails).pair), format_pair(s.pair));
    EXPECT_EQ(format_pair(simplify_by(s.pair, fault.fails).pair), format_pair(s.pair));
  }
}

INSTANTIATE_TEST_SUITE_P(Planted, Simplify, testing::ValuesIn(planted),
                         [](const auto& info) { return std::string(info.param.name); });

TEST(SimplifyTo, TheObviousPair) {
  const auto simplest = [](const char* family, const Fails& fails) {
    return format_pair(simplify_by(failing(family, fails, 1).at(0), fails).pair);
  };
  EXPECT_EQ(simplest("axes_nearly_parallel", nearly_parallel),
            R"({"a":{"center":[0,0,0],"axis":[0,0,1],"radius":1,"height":1},)"
            R"("b":{"center":[0,0,0],"axis":[0,0,1],"radius":1,"height":1}})");
  EXPECT_EQ(simplest("axes_nearly_parallel", nearly_parallel_not_quite),
            R"({"a":{"center":[0,0,0],"axis":[0,0,1],"radius":1,"height":1},)"
            R"("b":{"center":[0,0,0],"axis":[0,1e-07,1],"radius":1,"height":1}})");
  EXPECT_EQ(simplest("random", fat), R"({"a":{"center":[0,0,0],"axis":[0,0,1],"radius":4,"height":1},)"
                                     R"("b":{"center":[0,0,0],"axis":[0,0,1],"radius":1,"height":1}})");
  EXPECT_EQ(simplest("far", far_out), R"({"a":{"center":[0,0,2e+06],"axis":[0,0,1],"radius":1,"height":1},)"
                                      R"("b":{"center":[0,0,0],"axis":[0,0,1],"radius":1,"height":1}})");
  EXPECT_EQ(simplest("capsule_rounded", apart),
            R"({"a":{"center":[0,0,0],"axis":[0,0,1],"radius":0,"height":1},)"
            R"("b":{"center":[0,0,2],"axis":[0,0,1],"radius":1,"height":1}})")
      << "without roundings";
  EXPECT_EQ(simplest("capsule_rounded", [](const Pair& p) { return p.b.rounding > 0 && p.b.height > 2; }),
            R"({"a":{"center":[0,0,0],"axis":[0,0,1],"radius":0,"height":1},)"
            R"("b":{"center":[0,0,0],"axis":[0,0,1],"radius":1,"height":4,"rounding":1}})");
  EXPECT_EQ(simplest("random", apart), R"({"a":{"center":[0,0,0],"axis":[0,0,1],"radius":1,"height":1},)"
                                       R"("b":{"center":[0,0,2],"axis":[0,0,1],"radius":1,"height":1}})");
  EXPECT_EQ(simplest("flat_disks", apart), R"({"a":{"center":[0,0,0],"axis":[0,0,1],"radius":1,"height":0},)"
                                           R"("b":{"center":[0,0,1],"axis":[0,0,1],"radius":1,"height":0}})")
      << "flat as they were found";
}

TEST(SimplifyTo, TheObviousPairWithABox) {
  const std::string plain = R"({"shape":"box","center":[0,0,0],"edges":[1,1,1],"quaternion":[1,0,0,0]})";
  const auto simplest = [](const char* family, const Fails& fails) {
    return format_pair(simplify_by(failing(family, fails, 1).at(0), fails).pair);
  };
  EXPECT_EQ(simplest("box_box", [](const Pair&) { return true; }),
            R"({"a":)" + plain + R"(,"b":)" + plain + "}");
  EXPECT_EQ(simplest("box_quaternion", [](const Pair& p) { return is_box(p.a) && is_box(p.b); }),
            R"({"a":)" + plain + R"(,"b":)" + plain + "}")
      << "without roundings";
  const auto longest = [](const Solid& c) { return *std::ranges::max_element(c.edges); };
  EXPECT_EQ(
      simplest("box_box", [&](const Pair& p) { return longest(p.a) > 3; }),
      R"({"a":{"shape":"box","center":[0,0,0],"edges":[1,1,4],"quaternion":[1,0,0,0]},"b":)" + plain + "}");
  const auto turned = [](const Pair& p) {
    const double w = std::fabs(p.a.quaternion[0]), v = Vector3(&p.a.quaternion[1]).norm();
    const bool solid = std::ranges::count(p.b.edges, 0.0) == 0;
    return is_box(p.a) && is_box(p.b) && solid && v > 0 && v <= 1e-7 * w;
  };
  EXPECT_EQ(simplest("box_lattice", turned),
            R"({"a":{"shape":"box","center":[0,0,0],"edges":[1,1,1],"quaternion":[1,0,0,1e-07]},"b":)" +
                plain + "}");
  EXPECT_EQ(simplest("box_thin",
                     [](const Pair& p) {
                       return is_box(p.a) && std::ranges::count(p.a.edges, 0.0) == 1 && is_half_space(p.b);
                     }),
            R"({"a":{"shape":"box","center":[0,0,0],"edges":[1,1,0],"quaternion":[1,0,0,0]},)"
            R"("b":{"shape":"half_space","point":[0,0,0],"normal":[0,0,1]}})")
      << "flat as it was found";
}

// Turned, mirrored and with its edges in another order, a box extends as far in the same directions.
TEST(Moves, SymmetriesAndOrdersOfEdgesKeepTheExtentsOfBoxes) {
  const auto gap_of = [](const Pair& p) {
    const Terms<double> a = terms_of<double>(p.a), b = terms_of<double>(p.b);
    const Vector3 delta = p.b.center - p.a.center;
    return support_gap(a, b, lifted<double>(delta), lifted<double>(delta));
  };
  for (std::uint64_t i = 0; i < 40; ++i) {
    const Pair pair = find_family(i % 2 == 0 ? "box_cylinder" : "box_stacked")->generate(seed, i / 2 * 4);
    for (const Pair& p : moves::symmetries(pair))
      ASSERT_NEAR(gap_of(p), gap_of(pair), 1e-12 * size_of(pair) * size_of(pair)) << format_pair(p);
    int reordered = 0;
    for (const Pair& p : moves::axes(pair)) {
      const bool same = p.a.edges == pair.a.edges && p.b.edges == pair.b.edges;
      if (same) continue;
      ++reordered;
      ASSERT_NEAR(gap_of(p), gap_of(pair), 1e-12 * size_of(pair) * size_of(pair)) << format_pair(p);
    }
    EXPECT_GE(reordered, 9);
  }
}

// A division by a length of 0 is another fault. The failure as found does not slide into it.
TEST(SimplifyTo, TheSameFaultBesideADivisionByZero) {
  const Fails both = [](const Pair& p) {
    const bool zero = p.a.radius == 0 || p.a.height == 0 || p.b.radius == 0 || p.b.height == 0;
    return zero || fat(p);
  };
  const Pair found = failing("random", fat, 1).at(0);
  EXPECT_TRUE(fat(simplify_by(found, both).pair));
}

TEST(SimplifyTo, TheOriginalWhereNothingElseFails) {
  for (const Family& family : families()) {
    const Pair pair = family.generate(seed, 0);
    const Simplified s =
        simplify_by(pair, [&](const Pair& p) { return format_pair(p) == format_pair(pair); });
    EXPECT_EQ(format_pair(s.pair), format_pair(pair));
    EXPECT_FALSE(s.at_cap);
    // Missing answers do not count as failures.
    EXPECT_EQ(format_pair(simplify(pair, [](std::span<const Pair>) { return std::vector<bool>{}; }).pair),
              format_pair(pair));
  }
}

TEST(SimplifyTo, WhatFailedWithinAnyCap) {
  const Pair pair = failing("touching_side_rim", tiny_gap, 1).at(0);
  Complexity before = complexity(pair);
  for (const std::size_t cap : {0u, 1u, 31u, 32u, 33u, 100u, 200u, 4000u}) {
    Asker asker{tiny_gap};
    const Simplified s = simplify(pair, std::ref(asker), cap);
    EXPECT_LE(asker.asked, cap);
    EXPECT_EQ(s.questions, asker.asked);
    EXPECT_EQ(s.at_cap, cap < 4000);
    EXPECT_TRUE(tiny_gap(s.pair));
    EXPECT_LE(complexity(s.pair), before);  // more questions, no worse
    before = complexity(s.pair);
  }
}

TEST(SimplifyTo, ItselfWhereThePairIsIllegal) {
  Pair pair = find_family("random")->generate(seed, 0);
  pair.a.radius = -1;
  const Simplified s = simplify_by(pair, [](const Pair&) { return true; });
  EXPECT_EQ(s.questions, 0u);
  EXPECT_EQ(format_pair(s.pair), format_pair(pair));
}

// At the ends of the range of numbers, nothing overflows into an illegal question.
TEST(SimplifyTo, SomethingLegalFromAnyLengths) {
  for (const double length : {0.0, 5e-324, 1e-310, 1e-200, 1e200, 1.7e308}) {
    Pair pair = find_family("random")->generate(seed, 1);
    for (Solid* c : {&pair.a, &pair.b}) {
      c->center = Vector3(length, -length, length / 3);
      c->axis = length == 0 ? Vector3(5e-324, 0, -5e-324) : Vector3(length, length / 7, -length);
      c->radius = c->height = length;
    }
    for (const bool answer : {true, false}) {
      Asker asker{[&](const Pair&) { return answer; }};
      const Simplified s = simplify(pair, std::ref(asker));
      EXPECT_EQ(asker.illegal, 0u);
      EXPECT_FALSE(s.at_cap);
      EXPECT_TRUE(!answer || complexity(s.pair).digits == (length == 0 ? 2 : 6)) << format_pair(s.pair);
    }
  }
}

}  // namespace
}  // namespace cyl
