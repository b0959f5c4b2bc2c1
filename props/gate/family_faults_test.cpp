// SPDX-License-Identifier: MIT
// For each family of rounded solids, half-spaces and boxes: a fault of a guest that the gate finds by this
// family alone. (Close contacts with capsules instead of cylinders, and strata, may show it too.)
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <functional>
#include <memory>
#include <string_view>
#include <vector>

#include "corpus/pairs/families.hpp"
#include "corpus/pairs/pair_numbers.hpp"
#include "oracles/methods/fake_method_test.hpp"
#include "oracles/referee/decide_exactly.hpp"
#include "oracles/referee/referee.hpp"
#include "oracles/trial/contact.hpp"
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

bool is_thin(const Solid& c) {
  const auto [least, most] = std::ranges::minmax(c.edges);
  return is_box(c) && least <= 1e-2 * most;
}
bool alike(const Pair& pair) {
  const Eigen::Vector4d a(pair.a.quaternion.data()), b(pair.b.quaternion.data());
  return is_box(pair.a) && is_box(pair.b) && (a == b || a == -b);
}
/// Returns whether the coordinates of the centres are multiples of the unit, up to the next double.
bool on_grid(const Pair& pair, double unit) {
  return std::ranges::all_of(std::array{pair.a.center, pair.b.center}, [&](const Vector3& x) {
    return (x / unit - Vector3((x / unit).array().round())).cwiseAbs().maxCoeff() < 1e-9;
  });
}

/// Takes deep overlaps of two kinds for gaps, and with a box also wide gaps for overlaps. Other families,
/// except tilted planes, thin boxes, boxes turned alike and lattices, have margins of 0.1 at most.
Fault deep(SolidKind one, SolidKind other) {
  return [=](const Pair& pair) {
    const SolidKind a = kind_of(pair.a), b = kind_of(pair.b);
    if (!((a == one && b == other) || (a == other && b == one))) return false;
    if (!has_box(pair))
      return depth_part(pair) > 0.15 && (!has_half_space(pair) || tilt_of(pair) > least_tilt);
    return std::fabs(depth_part(pair)) > 0.11 && !is_thin(pair.a) && !is_thin(pair.b) && !alike(pair) &&
           !on_grid(pair, 0.5);
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

/// Takes a small gap for none if two edges, or an edge and an axis, are nearly parallel. A facet is at the
/// gap, or is not.
Fault nearly_parallel(bool at_facet) {
  return [=](const Pair& pair) {
    const AxesAngle angle = axes_angle(pair);
    if (angle.sine > least_tilt || angle.sine < 1e-14 || angle.parallel || on_grid(pair, 0.5)) return false;
    const double depth = depth_part(pair);
    if (depth > 0 || depth < -1e-2) return false;
    const auto feature = contact_feature(pair);
    return feature && (*feature >= ContactFeature::cap_side) == at_facet;
  };
}

bool nested(const Pair& pair) {
  return kind_of(pair.a) == box && kind_of(pair.b) == box && !is_thin(pair.a) && !is_thin(pair.b) &&
         unequal(pair);
}

bool off_grid_plate(const Pair& pair) {
  return !on_grid(pair, 0.5) && std::ranges::any_of(std::array{pair.a, pair.b}, [](const Solid& c) {
    return is_box(c) && std::ranges::count(c.edges, 0) > 0;
  });
}

bool far_box(const Pair& pair) {
  const double reach = pair.a.center.stableNorm();
  return reach > 50 && reach > 50 * size_of(pair);
}

bool long_quaternion(const Pair& pair) {
  const double length = Eigen::Vector4d((is_box(pair.a) ? pair.a : pair.b).quaternion.data()).stableNorm();
  return length > 1e10 || length < 1e-10;
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
    {"box_sphere", deep(box, sphere)},
    {"box_capsule", deep(box, capsule)},
    {"box_cylinder", deep(box, cylinder)},
    {"box_rounded", deep(box, rounded)},
    {"box_half_space", deep(box, half_space)},
    {"box_box", deep(box, box)},
    {"rounded_box", deep(rounded_box, sphere)},
    {"box_edges", nearly_parallel(false)},
    {"box_flush", nearly_parallel(true)},
    {"box_stacked", [](const Pair& pair) { return alike(pair) && !on_grid(pair, 0.5); }},
    {"box_nested", nested},
    {"box_thin", off_grid_plate},
    {"box_lattice", [](const Pair& pair) { return on_grid(pair, 0.5) && !on_grid(pair, 1) && !alike(pair); }},
    {"box_far", far_box},
    {"box_quaternion", long_quaternion},
};

struct Guest : FakeMethod {
  Guest(const Fault& fault, bool of_boxes)
      : FakeMethod("guest",
                   [fault, of_boxes](const Pair& pair) {
                     const Verdict truth = decide_exactly(pair.a, pair.b).verdict;
                     if (has_box(pair) != of_boxes || !fault(pair)) return answered(truth);
                     return answered(truth == Verdict::disjoint ? Verdict::intersecting : Verdict::disjoint);
                   },
                   {.claim = Claim{.source = "planted"}, .foreign = false, .guest = true}) {}
  using FakeMethod::supports;
  bool supports(SolidKind) const override { return true; }
};

TEST(GateFamilies, EachFindsAFaultAlone) {
  std::vector<std::string_view> names;
  for (const FamilyFault& it : faults) names.push_back(it.family);
  for (const Family& family : campaign_families().subspan(families().size()))
    EXPECT_TRUE(std::ranges::count(names, family.name)) << family.name << " has no fault";
  for (const auto& [name, fault] : faults) {
    std::vector<std::unique_ptr<Method>> methods;
    methods.push_back(
        std::make_unique<Guest>(fault, std::ranges::count(box_families(), name, &Family::name)));
    GateAmount amount;
    amount.rounded_rounds = 2;
    const GateReport report = run_gate(methods, {}, {.amount = amount, .as_found = true});
    EXPECT_EQ(exit_code(report), 2) << name;
    for (const GateFailure& failure : report.failures)
      EXPECT_TRUE(failure.origin.starts_with(name) || failure.origin.starts_with("as capsules") ||
                  failure.origin.starts_with("stratum"))
          << name << ": " << failure.origin;
    EXPECT_TRUE(std::ranges::any_of(report.failures, [&](const GateFailure& failure) {
      return failure.origin.starts_with(name);
    })) << name;
  }
}

}  // namespace
}  // namespace cyl
