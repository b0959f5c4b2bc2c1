// SPDX-License-Identifier: MIT
// For each family of rounded solids and of half-spaces: a fault of a guest that the gate finds by this family
// alone. (Close contacts with capsules instead of cylinders, which are not a family, may show it too.)
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <string_view>
#include <vector>

#include "corpus/pairs/families.hpp"
#include "corpus/pairs/pair_numbers.hpp"
#include "oracles/methods/fake_method_test.hpp"
#include "oracles/referee/decide_exactly.hpp"
#include "oracles/referee/referee.hpp"
#include "props/gate/gate.hpp"

namespace cyl {
namespace {

using enum SolidKind;
/// Returns whether the guest gives the opposite of the truth.
using Fault = std::function<bool(const Pair&)>;

double depth_part(const Pair& pair) { return -approximate_distance(pair).value / size_of(pair); }

/// The sine of the angle by which the axes miss being parallel or square to each other.
double tilt_of(const Pair& pair) {
  const Vector3 v = pair.a.axis.stableNormalized(), w = pair.b.axis.stableNormalized();
  return std::min(v.cross(w).norm(), std::fabs(v.dot(w)));
}
/// Families that know nothing of tilts seldom have a smaller one.
constexpr double least_tilt = 1.1e-3;

/// Misses deep overlaps of two kinds. Other families, except tilted planes, overlap by 0.1 of the size at
/// most.
Fault deep(SolidKind one, SolidKind other) {
  return [=](const Pair& pair) {
    const SolidKind a = kind_of(pair.a), b = kind_of(pair.b);
    return ((a == one && b == other) || (a == other && b == one)) && depth_part(pair) > 0.15 &&
           (!has_half_space(pair) || tilt_of(pair) > least_tilt);
  };
}

bool unequal(const Pair& pair) {
  const double a = size_of({pair.a, {}}), b = size_of({pair.b, {}});
  return !has_half_space(pair) && std::max(a, b) > 100 * std::min(a, b) && std::fabs(depth_part(pair)) < 1e-3;
}

bool tilted(const Pair& pair) {
  const double tilt = tilt_of(pair);
  return has_half_space(pair) && tilt > 1e-14 && tilt < least_tilt && depth_part(pair) < 0.15;
}

bool flat(const Pair& pair) {
  return has_half_space(pair) && std::ranges::any_of(std::array{pair.a, pair.b}, [](const Solid& c) {
           return kind_of(c) == cylinder && (c.radius == 0 || c.height == 0);
         });
}

bool far(const Pair& pair) { return has_half_space(pair) && pair.a.center.stableNorm() > 50 * size_of(pair); }

bool long_normal(const Pair& pair) {
  const double length = (is_half_space(pair.a) ? pair.a : pair.b).axis.stableNorm();
  return has_half_space(pair) && (length > 1e10 || length < 1e-10);
}

struct FamilyFault {
  std::string_view family;
  Fault fault;
};
const FamilyFault faults[] = {
    {"sphere_sphere", deep(sphere, sphere)},
    {"sphere_capsule", deep(sphere, capsule)},
    {"sphere_cylinder", deep(sphere, cylinder)},
    {"sphere_rounded", deep(sphere, rounded)},
    {"capsule_capsule", deep(capsule, capsule)},
    {"capsule_cylinder", deep(capsule, cylinder)},
    {"capsule_rounded", deep(capsule, rounded)},
    {"cylinder_rounded", deep(cylinder, rounded)},
    {"rounded_rounded", deep(rounded, rounded)},
    {"rounded_unequal", unequal},
    {"half_space_sphere", deep(half_space, sphere)},
    {"half_space_capsule", deep(half_space, capsule)},
    {"half_space_cylinder", deep(half_space, cylinder)},
    {"half_space_rounded", deep(half_space, rounded)},
    {"half_space_tilted", tilted},
    {"half_space_thin", flat},
    {"half_space_far", far},
    {"half_space_normal", long_normal},
};

struct Guest : FakeMethod {
  explicit Guest(const Fault& fault)
      : FakeMethod("guest",
                   [fault](const Pair& pair) {
                     const Verdict truth = decide_exactly(pair.a, pair.b).verdict;
                     if (has_box(pair) || !fault(pair)) return answered(truth);
                     return answered(truth == Verdict::disjoint ? Verdict::intersecting : Verdict::disjoint);
                   },
                   {.claim = Claim{.source = "planted"}, .foreign = false, .guest = true}) {}
  using FakeMethod::supports;
  bool supports(SolidKind) const override { return true; }
};

TEST(GateFamilies, EachFindsAFaultAlone) {
  std::vector<std::string_view> names;
  for (const FamilyFault& it : faults) names.push_back(it.family);
  for (const auto& some : {rounded_families(), half_space_families()})
    for (const Family& family : some)
      EXPECT_TRUE(std::ranges::count(names, family.name)) << family.name << " has no fault";
  for (const auto& [name, fault] : faults) {
    std::vector<std::unique_ptr<Method>> methods;
    methods.push_back(std::make_unique<Guest>(fault));
    GateAmount amount;
    amount.rounded_rounds = 2;
    const GateReport report = run_gate(methods, {}, {.amount = amount, .as_found = true});
    EXPECT_EQ(exit_code(report), 2) << name;
    for (const GateFailure& failure : report.failures)
      EXPECT_TRUE(failure.origin.starts_with(name) || failure.origin.starts_with("as capsules"))
          << name << ": " << failure.origin;
    EXPECT_TRUE(std::ranges::any_of(report.failures, [&](const GateFailure& failure) {
      return failure.origin.starts_with(name);
    })) << name;
  }
}

}  // namespace
}  // namespace cyl
