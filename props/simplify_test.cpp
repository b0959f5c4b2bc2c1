// SPDX-License-Identifier: MIT
#include "props/simplify.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <cstdio>
#include <string>

#include "corpus/families.hpp"
#include "corpus/pair_io.hpp"
#include "oracles/referee.hpp"

namespace cyl {
namespace {

constexpr std::uint64_t seed = 20261121;

using Fails = std::function<bool(const Pair&)>;

/// Asks one after the other and counts.
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

/// The pairs of a family that fail.
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
bool apart(const Pair& p) { return judge(p).verdict == Verdict::disjoint; }
bool long_axes(const Pair& p) { return p.a.axis.stableNorm() > 1e40; }

struct Planted {
  const char* name;
  const char* family;
  bool (*fails)(const Pair&);
  int digits;             // at most, of the simplest
  std::size_t questions;  // at most
};

void PrintTo(const Planted& p, std::ostream* out) { *out << p.name; }

constexpr Planted planted[] = {
    {"parallel", "axes_nearly_parallel", nearly_parallel, 2, 1000},
    {"nearly_parallel", "axes_nearly_parallel", nearly_parallel_not_quite, 3, 1000},
    {"fat", "random", fat, 3, 1000},
    {"far_out", "far", far_out, 3, 1000},
    {"tiny_gap", "random", tiny_gap, 20, 2000},
    {"tiny_gap_side_side", "touching_side_side", tiny_gap, 20, 2000},
    {"tiny_gap_rim_rim", "touching_rim_rim", tiny_gap, 20, 2000},
    {"oblique_tiny_gap", "touching_rim_rim", oblique_tiny_gap, 20, 2000},
    {"tiny_overlap", "touching_side_rim", tiny_overlap, 20, 2000},
    {"apart", "random", apart, 3, 1000},
    {"long_axes", "raw_axes", long_axes, 3, 1000},
};

class Simplify : public testing::TestWithParam<Planted> {};

TEST_P(Simplify, EndsSimpleAndKeepsItsLaws) {
  const Planted& fault = GetParam();
  for (const Pair& pair : failing(fault.family, fault.fails, 3)) {
    Asker asker{fault.fails};
    const Simplified s = simplify(pair, std::ref(asker));
    std::printf("%4zu questions, %3d digits: %s\n", s.questions, complexity(s.pair).digits,
                format_pair(s.pair).c_str());
    EXPECT_TRUE(fault.fails(s.pair));
    EXPECT_LE(complexity(s.pair), complexity(pair));
    EXPECT_LE(complexity(s.pair).digits, fault.digits) << format_pair(pair);
    EXPECT_LE(s.questions, fault.questions);
    EXPECT_FALSE(s.at_cap);
    EXPECT_EQ(s.questions, asker.asked);
    EXPECT_EQ(asker.illegal, 0u);
    // Deterministic, and at an end.
    EXPECT_EQ(format_pair(simplify_by(pair, fault.fails).pair), format_pair(s.pair));
    EXPECT_EQ(format_pair(simplify_by(s.pair, fault.fails).pair), format_pair(s.pair));
  }
}

INSTANTIATE_TEST_SUITE_P(Planted, Simplify, testing::ValuesIn(planted),
                         [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace cyl
