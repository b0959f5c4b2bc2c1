// SPDX-License-Identifier: MIT
#include <fcl/config.h>
#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/capsule.h>
#include <fcl/geometry/shape/cylinder.h>
#include <fcl/geometry/shape/sphere.h>
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/distance.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include "oracles/methods/adapter.hpp"
#include "oracles/methods/method.hpp"

namespace cyl {
namespace {

constexpr std::string_view collide_source =
    "fcl/narrowphase/collision_request.h: gjk_tolerance{1e-6}, Numerical tolerance to use in the GJK "
    "algorithm";
constexpr std::string_view distance_source =
    "fcl/narrowphase/distance_request.h: distance_tolerance = 1e-6, the threshold used in GJK algorithm to "
    "stop distance iteration";

/// FCL's default tolerance, and one for users who need more precision.
constexpr double default_tol = 1e-6;
constexpr double fine_tol = 1e-10;

std::unique_ptr<fcl::CollisionGeometryd> shape_of(const Solid& c) {
  switch (kind_of(c)) {
    case SolidKind::sphere:
      return std::make_unique<fcl::Sphered>(c.rounding);
    case SolidKind::capsule:
      return std::make_unique<fcl::Capsuled>(c.rounding, c.height);
    case SolidKind::half_space:
      return std::make_unique<fcl::Halfspaced>(Vector3::UnitZ(), 0);
    case SolidKind::box:
      return std::make_unique<fcl::Boxd>(c.edges[0], c.edges[1], c.edges[2]);
    case SolidKind::cylinder:
    case SolidKind::rounded:
    case SolidKind::rounded_box:
      break;
  }
  return std::make_unique<fcl::Cylinderd>(c.radius, c.height);
}

/// A solid as FCL keeps it. FCL selects a formula or GJK by the kinds of both solids.
struct FclSolid {
  explicit FclSolid(const Solid& c) : shape(shape_of(c)) {
    pose.linear() = rotation_of(c);
    pose.translation() = c.center;
  }

  std::unique_ptr<fcl::CollisionGeometryd> shape;
  fcl::Transform3d pose = fcl::Transform3d::Identity();
};

/// Calls fcl::collide without contacts, which returns yes or no.
class Collide final : public VerdictMethod<FclSolid> {
 public:
  Collide(MethodName name, fcl::GJKSolverType solver, double tolerance) : VerdictMethod(std::move(name)) {
    request_.gjk_solver_type = solver;
    request_.gjk_tolerance = tolerance;
  }
  std::string_view version() const override { return FCL_VERSION; }
  bool recovers() const override { return true; }  // shapes, requests and results are made for each call
  bool supports(SolidKind kind) const override {
    return kind != SolidKind::rounded && kind != SolidKind::rounded_box;
  }
  Claim claim() const override { return {.absolute = request_.gjk_tolerance, .source = collide_source}; }

 private:
  Verdict collide(const FclSolid& a, const FclSolid& b) override {
    fcl::CollisionResultd result;
    const bool hit = fcl::collide(a.shape.get(), a.pose, b.shape.get(), b.pose, request_, result) > 0;
    return hit ? Verdict::intersecting : Verdict::disjoint;
  }

  fcl::CollisionRequestd request_;
};

/// Calls fcl::distance with nearest points, never with signed distance. Debian's build has its assertions
/// on, and with signed distance it aborts on overlapping pairs.
class Distance final : public Method {
 public:
  Distance(MethodName name, double tolerance) : Method(std::move(name)) {
    request_.enable_nearest_points = true;
    request_.gjk_solver_type = fcl::GST_LIBCCD;
    request_.distance_tolerance = tolerance;
  }
  std::string_view version() const override { return FCL_VERSION; }
  bool recovers() const override { return true; }  // shapes, requests and results are made for each call
  // FCL has no distance to a half-space: its support function is missing.
  bool supports(SolidKind kind) const override { return kind < SolidKind::rounded || kind == SolidKind::box; }
  Claim claim() const override {
    return {.absolute = request_.distance_tolerance, .source = distance_source};
  }

  // The nearest points are the witness, because they are the ends of a separating direction.
  MethodAnswer answer(const Pair& pair) override {
    if (const auto declined = decline_invalid(pair)) return *declined;
    fcl::DistanceResultd result;
    const double distance = measure(FclSolid(pair.a), FclSolid(pair.b), result);
    if (!(distance > 0)) return answered(Verdict::intersecting);
    MethodAnswer answer = answered(Verdict::disjoint);
    answer.has_distance = true;
    answer.distance = distance;
    const Vector3 direction = result.nearest_points[1] - result.nearest_points[0];
    if (!direction.isZero(0)) answer.set_direction(direction);
    return answer;
  }
  DistanceCall prepare_distances(std::span<const Pair> pairs) override {
    return [this, solids = shared_solids_of<FclSolid>(pairs)](std::size_t i) {
      fcl::DistanceResultd result;
      const double distance = measure((*solids)[i].first, (*solids)[i].second, result);
      return distance > 0 ? distance : std::numeric_limits<double>::quiet_NaN();
    };
  }

 private:
  // If FCL finds no distance, it returns -1, which means an overlap of unknown depth. If it gives up, it
  // leaves the nearest points uninitialised, and they differ each time.
  double measure(const FclSolid& a, const FclSolid& b, fcl::DistanceResultd& result) const {
    for (Vector3& point : result.nearest_points) point.setZero();
    return fcl::distance(a.shape.get(), a.pose, b.shape.get(), b.pose, request_, result);
  }

  fcl::DistanceRequestd request_;
};

}  // namespace

std::vector<std::unique_ptr<Method>> fcl_methods() {
  std::vector<std::unique_ptr<Method>> methods;
  methods.push_back(std::make_unique<Collide>(MethodName{"fcl", "libccd"}, fcl::GST_LIBCCD, default_tol));
  methods.push_back(
      std::make_unique<Collide>(MethodName{"fcl", "libccd", "tol1e-10"}, fcl::GST_LIBCCD, fine_tol));
  methods.push_back(std::make_unique<Collide>(MethodName{"fcl", "indep"}, fcl::GST_INDEP, default_tol));
  methods.push_back(std::make_unique<Distance>(MethodName{"fcl", "distance-libccd"}, default_tol));
  methods.push_back(std::make_unique<Distance>(MethodName{"fcl", "distance-libccd", "tol1e-10"}, fine_tol));
  return methods;
}

std::vector<std::unique_ptr<Method>> fcl_settings() {
  std::vector<std::unique_ptr<Method>> methods;
  for (const auto& [setting, tol] :
       {std::pair("tol1e-4", 1e-4), std::pair("tol1e-8", 1e-8), std::pair("tol1e-12", 1e-12)}) {
    methods.push_back(std::make_unique<Collide>(MethodName{"fcl", "libccd", setting}, fcl::GST_LIBCCD, tol));
    methods.push_back(std::make_unique<Collide>(MethodName{"fcl", "indep", setting}, fcl::GST_INDEP, tol));
    methods.push_back(std::make_unique<Distance>(MethodName{"fcl", "distance-libccd", setting}, tol));
  }
  methods.push_back(
      std::make_unique<Collide>(MethodName{"fcl", "indep", "tol1e-10"}, fcl::GST_INDEP, fine_tol));
  return methods;
}

}  // namespace cyl
