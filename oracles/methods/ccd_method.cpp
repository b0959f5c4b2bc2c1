// SPDX-License-Identifier: MIT
#include <ccd/ccd.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "corpus/pairs/pair_numbers.hpp"
#include "oracles/methods/adapter.hpp"
#include "oracles/methods/method.hpp"

namespace cyl {
namespace {

// The header is the same for both precisions.
static_assert(sizeof(ccd_real_t) == 8);

/// Values of mpr_tolerance, a length: the default of CCD_INIT, and one for users who need more precision.
constexpr double default_tol = 1e-4;
constexpr double fine_tol = 1e-10;
/// libccd takes two points nearer than this length as one. It is the square root of its threshold for zero.
constexpr double zero_tol = 0x1p-26;
/// The cap on steps of GJK, which may go in circles. FCL and ODE use it too. CCD_INIT sets no cap.
constexpr unsigned long gjk_cap = 500;

constexpr std::string_view mpr_source = "ccd/ccd.h: mpr_tolerance, Boundary tolerance for MPR algorithm";
constexpr std::string_view gjk_source =
    "ccd/vec3.h: ccdIsZero, below CCD_EPS 2.2e-16, asked of squared lengths; GJK reads no tolerance";

// This text is part of the programs that `daylight export` writes, so both give libccd the same bits.
#include "oracles/methods/ccd_support.inc"

/// The same point, summed in another order: y, z and x in the place of x, y and z.
void support_of_other_sums(const void* object, const ccd_vec3_t* direction, ccd_vec3_t* point) {
  CcdSolid turned = *static_cast<const CcdSolid*>(object);
  std::rotate(turned.center, turned.center + 1, turned.center + 3);
  std::rotate(turned.axis, turned.axis + 1, turned.axis + 3);
  for (auto& edge : turned.edges) std::rotate(edge, edge + 1, edge + 3);
  ccd_vec3_t d = *direction;
  std::rotate(d.v, d.v + 1, d.v + 3);
  support(&turned, &d, point);
  std::rotate(point->v, point->v + 2, point->v + 3);
}

CcdSolid solid_of(const Solid& c) {
  CcdSolid s{{c.center.x(), c.center.y(), c.center.z()}, {}, c.radius, c.height / 2, c.rounding, {}, {}};
  const Eigen::Matrix3d rotation = rotation_of(c);
  std::copy_n(rotation.data(), is_box(c) ? 9 : 0, s.edges[0]);  // its columns
  std::copy_n(rotation.data() + 6, is_box(c) ? 0 : 3, s.axis);
  for (std::size_t k = 0; k < 3; ++k) s.halves[k] = c.edges[k] / 2;
  return s;
}

struct ReadySolid : CcdSolid {
  explicit ReadySolid(const Solid& c) : CcdSolid(solid_of(c)) {}
};

void direction_of_centers(const void* a, const void* b, ccd_vec3_t* direction) {
  ccd_vec3_t center_a, center_b;
  center_of(a, &center_a);
  center_of(b, &center_b);
  ccdVec3Sub2(direction, &center_b, &center_a);
  const double* d = direction->v;
  if (d[0] == 0 && d[1] == 0 && d[2] == 0) ccdVec3Set(direction, 1, 0, 0);
}

using Intersect = int(const void*, const void*, const ccd_t*);

/// Returns yes or no from one of libccd's two algorithms.
class Ccd final : public VerdictMethod<ReadySolid> {
 public:
  Ccd(MethodName name, Intersect* intersect, const ccd_t& settings, const Claim& claim)
      : VerdictMethod(std::move(name)), intersect_(intersect), settings_(settings), claim_(claim) {}
  std::string_view version() const override { return DAYLIGHT_CCD_VERSION; }
  bool supports(SolidKind kind) const override { return kind != SolidKind::half_space; }
  Claim claim() const override { return claim_; }

 private:
  Verdict collide(const ReadySolid& a, const ReadySolid& b) override {
    return intersect_(&a, &b, &settings_) != 0 ? Verdict::intersecting : Verdict::disjoint;
  }

  Intersect* const intersect_;
  const ccd_t settings_;
  const Claim claim_;
};

ccd_t default_settings(ccd_support_fn supported) {
  ccd_t settings;
  CCD_INIT(&settings);
  settings.support1 = settings.support2 = supported;
  settings.center1 = settings.center2 = center_of;
  settings.max_iterations = gjk_cap;
  return settings;
}

std::unique_ptr<Method> gjk(MethodName name, ccd_first_dir_fn first_direction, ccd_support_fn supported) {
  ccd_t settings = default_settings(supported);
  settings.first_dir = first_direction;
  const Claim claim{.absolute = zero_tol, .source = gjk_source, .assumed = true};
  return std::make_unique<Ccd>(std::move(name), ccdGJKIntersect, settings, claim);
}

std::unique_ptr<Method> mpr(MethodName name, double tolerance, ccd_support_fn supported = support) {
  ccd_t settings = default_settings(supported);
  settings.mpr_tolerance = tolerance;
  const Claim claim{.absolute = tolerance, .source = mpr_source};
  return std::make_unique<Ccd>(std::move(name), ccdMPRIntersect, settings, claim);
}

std::vector<std::unique_ptr<Method>> methods_with(ccd_support_fn supported) {
  std::vector<std::unique_ptr<Method>> methods;
  methods.push_back(gjk({"libccd", "gjk"}, ccdFirstDirDefault, supported));
  methods.push_back(gjk({"libccd", "gjk", "centers"}, direction_of_centers, supported));
  methods.push_back(mpr({"libccd", "mpr"}, default_tol, supported));
  methods.push_back(mpr({"libccd", "mpr", "tol1e-10"}, fine_tol, supported));
  return methods;
}

}  // namespace

std::vector<std::unique_ptr<Method>> ccd_methods() { return methods_with(support); }

std::vector<std::unique_ptr<Method>> ccd_methods_of_other_sums() {
  return methods_with(support_of_other_sums);
}

std::vector<std::unique_ptr<Method>> ccd_settings() {
  std::vector<std::unique_ptr<Method>> methods;
  for (const auto& [setting, tolerance] : {std::pair("tol1e-2", 1e-2), std::pair("tol1e-6", 1e-6),
                                           std::pair("tol1e-8", 1e-8), std::pair("tol1e-12", 1e-12)})
    methods.push_back(mpr({"libccd", "mpr", setting}, tolerance));
  return methods;
}

}  // namespace cyl
