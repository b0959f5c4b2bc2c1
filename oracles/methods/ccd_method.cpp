// SPDX-License-Identifier: MIT
#include <ccd/ccd.h>

#include <cmath>
#include <utility>
#include <vector>

#include "oracles/methods/adapter.hpp"
#include "oracles/methods/method.hpp"

namespace cyl {
namespace {

// The header is the same for both precisions.
static_assert(sizeof(ccd_real_t) == 8);

/// Mpr_tolerance: a length. What CCD_INIT sets, and what users choose who need more.
constexpr double default_tol = 1e-4;
constexpr double fine_tol = 1e-10;
/// Two points nearer than this, a length, are one to libccd: the square root of what it takes for zero.
constexpr double zero_tol = 0x1p-26;
/// Sine of an angle: a direction and an axis closer than this are parallel but for their rounding.
constexpr double parallel_tol = 0x1p-50;
/// Steps of GJK, which may go in circles: what FCL and ODE give it. CCD_INIT leaves them without bound.
constexpr unsigned long gjk_cap = 500;

constexpr std::string_view mpr_source = "ccd/ccd.h: mpr_tolerance, Boundary tolerance for MPR algorithm";
constexpr std::string_view gjk_source =
    "ccd/vec3.h: ccdIsZero, below CCD_EPS 2.2e-16, asked of squared lengths; GJK reads no tolerance";

struct Solid {
  explicit Solid(const Cylinder& c)
      : center(c.center),
        axis(unit_axis(c.axis)),
        radius(c.radius),
        half_height(c.height / 2),
        rounding(c.rounding) {}

  Vector3 center, axis;
  double radius, half_height, rounding;
};

const Solid& solid_of(const void* object) { return *static_cast<const Solid*>(object); }

void copy_to(ccd_vec3_t* to, const Vector3& v) { ccdVec3Set(to, v.x(), v.y(), v.z()); }

void center_of(const void* object, ccd_vec3_t* center) { copy_to(center, solid_of(object).center); }

/// d without common factors of its coordinates that make their squares vanish or overflow.
Vector3 rescaled(Vector3 d) {
  const double largest = d.cwiseAbs().maxCoeff();
  if (!(largest > 0) || !std::isfinite(largest)) return d;
  for (double& x : d) x = std::scalbn(x, -std::ilogb(largest));
  return d;
}

/// The point of the solid farthest along a direction of any length. Along the axis the middle of a cap, as in
/// libccd's own examples: MPR misses coaxial overlaps where it gets a point of the rim.
void support(const void* object, const ccd_vec3_t* direction, ccd_vec3_t* point) {
  const Solid& s = solid_of(object);
  Vector3 d(direction->v);
  double squared = d.squaredNorm();
  if (!(squared > 0x1p-900 && squared < 0x1p900)) {
    d = rescaled(d);
    squared = d.squaredNorm();
  }
  const double along = d.dot(s.axis);
  const Vector3 across = d - along * s.axis;
  const double across_squared = across.squaredNorm();
  Vector3 farthest = s.center + std::copysign(s.half_height, along) * s.axis;
  if (across_squared > parallel_tol * parallel_tol * squared)
    farthest += s.radius / std::sqrt(across_squared) * across;
  if (s.rounding > 0 && squared > 0) farthest += s.rounding / std::sqrt(squared) * d;
  copy_to(point, farthest);
}

void direction_of_centers(const void* a, const void* b, ccd_vec3_t* direction) {
  const Vector3 offset = solid_of(b).center - solid_of(a).center;
  copy_to(direction, offset.isZero(0) ? Vector3::UnitX() : offset);
}

using Intersect = int(const void*, const void*, const ccd_t*);

/// Yes or no of one of libccd's two algorithms.
class Ccd final : public Method {
 public:
  Ccd(std::string_view name, Intersect* intersect, const ccd_t& settings, const Claim& claim)
      : name_(name), intersect_(intersect), settings_(settings), claim_(claim) {}
  std::string_view name() const override { return name_; }
  std::string_view version() const override { return DAYLIGHT_CCD_VERSION; }
  bool takes(SolidKind) const override { return true; }
  Claim claim() const override { return claim_; }

  MethodAnswer answer(const Pair& pair) override {
    if (const auto declined = decline_invalid(pair)) return *declined;
    MethodAnswer answer;
    answer.status = Status::answered;
    answer.verdict = collide(Solid(pair.a), Solid(pair.b));
    return answer;
  }
  Call prepare_all(std::span<const Pair> pairs) override {
    return [this, solids = solids_of<Solid>(pairs)](std::size_t i) {
      return collide(solids[i].first, solids[i].second);
    };
  }

 private:
  Verdict collide(const Solid& a, const Solid& b) const {
    return intersect_(&a, &b, &settings_) != 0 ? Verdict::intersecting : Verdict::disjoint;
  }

  const std::string_view name_;
  Intersect* const intersect_;
  const ccd_t settings_;
  const Claim claim_;
};

ccd_t default_settings() {
  ccd_t settings;
  CCD_INIT(&settings);
  settings.support1 = settings.support2 = support;
  settings.center1 = settings.center2 = center_of;
  settings.max_iterations = gjk_cap;
  return settings;
}

std::unique_ptr<Method> gjk(std::string_view name, ccd_first_dir_fn first_direction) {
  ccd_t settings = default_settings();
  settings.first_dir = first_direction;
  const Claim claim{.absolute = zero_tol, .source = gjk_source, .assumed = true};
  return std::make_unique<Ccd>(name, ccdGJKIntersect, settings, claim);
}

std::unique_ptr<Method> mpr(std::string_view name, double tolerance) {
  ccd_t settings = default_settings();
  settings.mpr_tolerance = tolerance;
  const Claim claim{.absolute = tolerance, .source = mpr_source};
  return std::make_unique<Ccd>(name, ccdMPRIntersect, settings, claim);
}

}  // namespace

std::vector<std::unique_ptr<Method>> ccd_methods() {
  std::vector<std::unique_ptr<Method>> methods;
  methods.push_back(gjk("libccd-gjk", ccdFirstDirDefault));
  methods.push_back(gjk("libccd-gjk-centers", direction_of_centers));
  methods.push_back(mpr("libccd-mpr", default_tol));
  methods.push_back(mpr("libccd-mpr-tol1e-10", fine_tol));
  return methods;
}

std::vector<std::unique_ptr<Method>> ccd_settings() {
  std::vector<std::unique_ptr<Method>> methods;
  methods.push_back(mpr("libccd-mpr-tol1e-2", 1e-2));
  methods.push_back(mpr("libccd-mpr-tol1e-6", 1e-6));
  methods.push_back(mpr("libccd-mpr-tol1e-8", 1e-8));
  methods.push_back(mpr("libccd-mpr-tol1e-12", 1e-12));
  return methods;
}

}  // namespace cyl
