// SPDX-License-Identifier: MIT
#include <BulletCollision/BroadphaseCollision/btDbvtBroadphase.h>
#include <BulletCollision/CollisionDispatch/btBoxBoxDetector.h>
#include <BulletCollision/CollisionDispatch/btCollisionDispatcher.h>
#include <BulletCollision/CollisionDispatch/btCollisionWorld.h>
#include <BulletCollision/CollisionDispatch/btDefaultCollisionConfiguration.h>
#include <BulletCollision/CollisionShapes/btBoxShape.h>
#include <BulletCollision/CollisionShapes/btCapsuleShape.h>
#include <BulletCollision/CollisionShapes/btConvexHullShape.h>
#include <BulletCollision/CollisionShapes/btCylinderShape.h>
#include <BulletCollision/CollisionShapes/btSphereShape.h>
#include <BulletCollision/CollisionShapes/btStaticPlaneShape.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkEpa2.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkEpaPenetrationDepthSolver.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkPairDetector.h>
#include <BulletCollision/NarrowPhaseCollision/btVoronoiSimplexSolver.h>

#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "corpus/pairs/pair_numbers.hpp"
#include "oracles/methods/adapter.hpp"
#include "oracles/methods/method.hpp"

namespace cyl {
namespace {

// The headers of both precisions are the same. This build links the library of double precision.
static_assert(sizeof(btScalar) == 8);

/// Bullet takes two vertices nearer than this length as one. It is the square root of Bullet's threshold.
constexpr double vertex_tol = 1e-6;
constexpr std::string_view vertex_source =
    "btVoronoiSimplexSolver.h: VORONOI_DEFAULT_EQUAL_VERTEX_THRESHOLD 1e-12f, a squared length";

/// Relative rounding of a vertex of a prism: cosine, quotient and product, less than 4 ulp.
constexpr double vertex_error = 0x1p-50;

constexpr double no_distance = std::numeric_limits<double>::quiet_NaN();

std::string version_of_bullet() {
  return std::to_string(btGetVersion() / 100) + '.' + std::to_string(btGetVersion() % 100);
}

btVector3 to_bullet(const Vector3& v) { return {v.x(), v.y(), v.z()}; }

btTransform pose_of(const Solid& c) {
  const Eigen::Matrix3d m = rotation_of(c);
  return btTransform({m(0, 0), m(0, 1), m(0, 2), m(1, 0), m(1, 1), m(1, 2), m(2, 0), m(2, 1), m(2, 2)},
                     to_bullet(c.center));
}

/// The shape of the edges of a cylinder or box without rounding.
enum class Rims : unsigned char {
  by_margin,  ///< as the constructor of Bullet's shape leaves them: a margin shrinks and rounds them
  sharp
};

/// A box with rounding is replaced by its hull, the sharp box around it.
btVector3 half_extents_of(const Solid& c) {
  return btVector3{c.edges[0] / 2, c.edges[1] / 2, c.edges[2] / 2} +
         btVector3{c.rounding, c.rounding, c.rounding};
}

/// Null for a half-space, which is not convex in Bullet's sense. A margin is Bullet's form of a rounding.
/// Spheres and capsules are a point and a segment with a margin.
std::unique_ptr<btConvexShape> shape_of(const Solid& c, Rims rims) {
  const double rounding = c.rounding;
  std::unique_ptr<btConvexShape> shape;
  switch (kind_of(c)) {
    case SolidKind::sphere:
      return std::make_unique<btSphereShape>(rounding);
    case SolidKind::capsule:
      return std::make_unique<btCapsuleShapeZ>(rounding, c.height);
    case SolidKind::half_space:
      return nullptr;
    case SolidKind::box:
    case SolidKind::rounded_box:
      shape = std::make_unique<btBoxShape>(half_extents_of(c));
      break;
    case SolidKind::cylinder:
    case SolidKind::rounded:
      shape = std::make_unique<btCylinderShapeZ>(
          btVector3{c.radius + rounding, c.radius + rounding, c.height / 2 + rounding});
  }
  if (rounding > 0 || rims == Rims::sharp) shape->setMargin(rounding);
  return shape;
}

template <Rims rims>
struct BulletSolid {
  explicit BulletSolid(const Solid& c) : shape(shape_of(c, rims)), pose(pose_of(c)) {}

  std::unique_ptr<btConvexShape> shape;
  btTransform pose;
};

/// The last contact that a detector makes.
struct Contact final : btDiscreteCollisionDetectorInterface::Result {
  std::optional<double> distance;
  void setShapeIdentifiersA(int, int) override {}
  void setShapeIdentifiersB(int, int) override {}
  void addContactPoint(const btVector3&, const btVector3&, btScalar d) override { distance = d; }
};

btDiscreteCollisionDetectorInterface::ClosestPointInput input_of(const btTransform& pose_a,
                                                                 const btTransform& pose_b) {
  btDiscreteCollisionDetectorInterface::ClosestPointInput input;
  input.m_transformA = pose_a;
  input.m_transformB = pose_b;
  return input;
}

/// Returns the signed distance that Bullet's dispatch finds between two convex shapes, unless both are boxes:
/// GJK, then EPA if they overlap. Returns nothing if it makes no contact. Then the bodies pass through each
/// other.
std::optional<double> detect(const btConvexShape& a, const btTransform& pose_a, const btConvexShape& b,
                             const btTransform& pose_b) {
  btVoronoiSimplexSolver simplex;
  btGjkEpaPenetrationDepthSolver depth;
  btGjkPairDetector detector(&a, &b, &simplex, &depth);
  Contact contact;
  detector.getClosestPoints(input_of(pose_a, pose_b), contact, nullptr);
  return contact.distance;
}

/// The same for a plane: Bullet's dispatch compares the deepest vertex with it.
std::optional<double> detect_plane(btConvexShape* a, const btTransform& pose_a, btConvexShape* b,
                                   const btTransform& pose_b) {
  struct Contact final : btCollisionWorld::ContactResultCallback {
    std::optional<double> distance;
    btScalar addSingleResult(btManifoldPoint& point, const btCollisionObjectWrapper*, int, int,
                             const btCollisionObjectWrapper*, int, int) override {
      distance = point.getDistance();
      return 0;
    }
  } contact;
  struct World {  // costly to make
    btDefaultCollisionConfiguration settings;
    btCollisionDispatcher dispatcher{&settings};
    btDbvtBroadphase near;
    btCollisionWorld world{&dispatcher, &near, &settings};
  };
  thread_local World made;
  btStaticPlaneShape plane({0, 0, 1}, 0);
  btCollisionObject first, second;
  first.setCollisionShape(a ? static_cast<btCollisionShape*>(a) : &plane);
  second.setCollisionShape(b ? static_cast<btCollisionShape*>(b) : &plane);
  first.setWorldTransform(pose_a);
  second.setWorldTransform(pose_b);
  made.world.contactPairTest(&first, &second, contact);
  return contact.distance;
}

Verdict verdict_of(std::optional<double> distance) {
  return distance && !(*distance > 0) ? Verdict::intersecting : Verdict::disjoint;
}

MethodAnswer answer_of(std::optional<double> distance) {
  MethodAnswer answer = answered(verdict_of(distance));
  answer.has_distance = distance.has_value();
  answer.distance = distance.value_or(0);
  return answer;
}

/// The common part of all methods of Bullet, with the base that they need.
template <class Base>
class BulletOf : public Base {
 public:
  using Base::Base;
  std::string_view version() const override { return version_; }
  bool supports(SolidKind) const override { return true; }
  Claim claim() const override { return {.absolute = vertex_tol, .source = vertex_source, .assumed = true}; }

 private:
  const std::string version_ = version_of_bullet();
};
using Bullet = BulletOf<Method>;

/// The detector on shapes of one kind.
template <Rims rims>
class Detector final : public Bullet {
 public:
  using Bullet::Bullet;
  Claim claim() const override {
    if (rims == Rims::sharp) return Bullet::claim();
    return {.absolute = 2 * CONVEX_DISTANCE_MARGIN,
            .source = "btCollisionMargin.h: CONVEX_DISTANCE_MARGIN btScalar(0.04), of each shape"};
  }
  Pair modelled(const Pair& pair) const override {
    const auto model = [&](const Solid& c) {
      const bool sharp = is_half_space(c) || (is_box(c) && has_half_space(pair));
      return sharp ? c : with_rounded_rims(c, shape_of(c, rims)->getMargin());
    };
    return {model(pair.a), model(pair.b)};
  }
  MethodAnswer answer(const Pair& pair) override {
    if (const auto declined = decline_invalid(pair)) return *declined;
    if (const Solid& other = is_half_space(pair.a) ? pair.b : pair.a;
        has_half_space(pair) && kind_of(other) == SolidKind::rounded_box)
      return declined_answer(
          "Bullet asks a box for its vertices, so a plane meets the sharp box around a rounded one");
    return answer_of(measure(BulletSolid<rims>(pair.a), BulletSolid<rims>(pair.b)));
  }
  Call prepare_all(std::span<const Pair> pairs) override {
    return [solids = shared_solids_of<BulletSolid<rims>>(pairs)](std::size_t i) {
      return verdict_of(measure((*solids)[i].first, (*solids)[i].second));
    };
  }
  DistanceCall prepare_distances(std::span<const Pair> pairs) override {
    return [solids = shared_solids_of<BulletSolid<rims>>(pairs)](std::size_t i) {
      return measure((*solids)[i].first, (*solids)[i].second).value_or(no_distance);
    };
  }

 private:
  static std::optional<double> measure(const BulletSolid<rims>& a, const BulletSolid<rims>& b) {
    if (!a.shape || !b.shape) return detect_plane(a.shape.get(), a.pose, b.shape.get(), b.pose);
    return detect(*a.shape, a.pose, *b.shape, b.pose);
  }
};

/// Asks the solver under the detector directly. That solver ignores margins, which are Bullet's form of
/// roundings.
class GjkEpa2 final : public Bullet {
 public:
  using Bullet::Bullet;
  bool supports(SolidKind kind) const override {
    return kind == SolidKind::cylinder || kind == SolidKind::box;
  }
  Claim claim() const override {
    return {.absolute = vertex_tol,
            .source = "btGjkEpa2.cpp: GJK_DUPLICATED_EPS 1e-12, a squared length; btGjkEpa2.h says nothing",
            .assumed = true};
  }

  // EPA starts after GJK has found the origin inside. So if EPA fails, the solids still meet, and only the
  // depth is lost.
  MethodAnswer answer(const Pair& pair) override {
    if (const auto declined = decline_invalid(pair)) return *declined;
    btGjkEpaSolver2::sResults result;
    if (measure(BulletSolid<Rims::sharp>(pair.a), BulletSolid<Rims::sharp>(pair.b), result))
      return answer_of(result.distance);
    if (result.status == btGjkEpaSolver2::sResults::EPA_Failed) return answered(Verdict::intersecting);
    return declined_answer("GJK_Failed: shapes are probably just 'touching' (btGjkEpa2.h)");
  }
  Call prepare_all(std::span<const Pair> pairs) override {
    return [solids = shared_solids_of<BulletSolid<Rims::sharp>>(pairs)](std::size_t i) {
      btGjkEpaSolver2::sResults result;
      if (measure((*solids)[i].first, (*solids)[i].second, result)) return verdict_of(result.distance);
      return result.status == result.EPA_Failed ? Verdict::intersecting : Verdict::undecided;
    };
  }
  DistanceCall prepare_distances(std::span<const Pair> pairs) override {
    return [solids = shared_solids_of<BulletSolid<Rims::sharp>>(pairs)](std::size_t i) {
      btGjkEpaSolver2::sResults result;
      const bool found = measure((*solids)[i].first, (*solids)[i].second, result);
      return found ? result.distance : no_distance;
    };
  }

 private:
  static bool measure(const BulletSolid<Rims::sharp>& a, const BulletSolid<Rims::sharp>& b,
                      btGjkEpaSolver2::sResults& result) {
    const btVector3 guess = a.pose.getOrigin() - b.pose.getOrigin();
    return btGjkEpaSolver2::SignedDistance(a.shape.get(), a.pose, b.shape.get(), b.pose, guess, result);
  }
};

/// Asks the test that Bullet's dispatch has for two boxes. It takes them with their margins as sharp boxes.
/// Its depths are not used, because it prefers facets to edges by 5 %.
class BoxBox final : public BulletOf<VerdictMethod<BulletSolid<Rims::by_margin>>> {
 public:
  using BulletOf::BulletOf;
  bool supports(SolidKind kind) const override { return kind == SolidKind::box; }
  Claim claim() const override {
    return {.relative = 1e-5,
            .absolute = SIMD_EPSILON,
            .source =
                "btBoxBoxDetector.cpp: fudge2(1.0e-5f), added to each cosine before edges are compared, "
                "with s2 > SIMD_EPSILON",
            .assumed = true};
  }

 private:
  using Box = BulletSolid<Rims::by_margin>;
  Verdict collide(const Box& a, const Box& b) override {
    Contact contact;
    btBoxBoxDetector(static_cast<const btBoxShape*>(a.shape.get()),
                     static_cast<const btBoxShape*>(b.shape.get()))
        .getClosestPoints(input_of(a.pose, b.pose), contact, nullptr);
    return verdict_of(contact.distance);
  }
};

/// Convex hulls of the prisms over the inscribed and the circumscribed regular polygon. The truth lies
/// between them. A box is the hull of its vertices.
class HullShape final : public Bullet {
 public:
  HullShape(int sides, unsigned share)
      : Bullet({"bullet", "hull", std::to_string(sides)}), sides_(sides), share_(share) {}
  unsigned share() const override { return share_; }
  bool supports(SolidKind kind) const override {
    return kind == SolidKind::cylinder || kind == SolidKind::box;
  }

  MethodAnswer answer(const Pair& pair) override {
    if (const auto declined = decline_invalid(pair)) return *declined;
    const double outward = (1 + vertex_error) / std::cos(std::numbers::pi / sides_);
    if (!meet(pair, outward)) return answered(Verdict::disjoint);
    if (meet(pair, 1 - vertex_error)) return answered(Verdict::intersecting);
    return declined_answer("the circumscribed prisms meet, the inscribed ones do not");
  }

 private:
  bool meet(const Pair& pair, double stretch) const {
    btConvexHullShape a, b;
    fill(a, pair.a, stretch);
    fill(b, pair.b, stretch);
    return verdict_of(detect(a, pose_of(pair.a), b, pose_of(pair.b))) == Verdict::intersecting;
  }

  void fill(btConvexHullShape& hull, const Solid& c, double stretch) const {
    hull.setMargin(0);
    for (int i = 0; i < (is_box(c) ? 8 : 0); ++i) {
      const auto half = [&](int k) {
        return std::copysign(c.edges[static_cast<std::size_t>(k)] / 2, (i >> k & 1) - 0.5);
      };
      hull.addPoint({half(0), half(1), half(2)}, false);
    }
    const double radius = c.radius * stretch;
    for (int i = 0; i < (is_box(c) ? 0 : sides_); ++i) {
      const double angle = 2 * std::numbers::pi * i / sides_;
      const double x = radius * std::cos(angle);
      const double y = radius * std::sin(angle);
      hull.addPoint({x, y, c.height / 2}, false);
      hull.addPoint({x, y, -c.height / 2}, false);
    }
    hull.recalcLocalAabb();
  }

  const int sides_;
  const unsigned share_;
};

}  // namespace

std::vector<std::unique_ptr<Method>> bullet_methods() {
  std::vector<std::unique_ptr<Method>> methods;
  methods.push_back(std::make_unique<Detector<Rims::by_margin>>(MethodName{"bullet", "cylinder"}));
  methods.push_back(std::make_unique<Detector<Rims::sharp>>(MethodName{"bullet", "cylinder", "margin0"}));
  methods.push_back(std::make_unique<GjkEpa2>(MethodName{"bullet", "gjkepa2"}));
  methods.push_back(std::make_unique<BoxBox>(MethodName{"bullet", "box"}));
  methods.push_back(std::make_unique<HullShape>(16, 1));
  methods.push_back(std::make_unique<HullShape>(64, 8));  // 40 us a pair, ten times the others
  return methods;
}

std::vector<std::unique_ptr<Method>> bullet_settings() {
  std::vector<std::unique_ptr<Method>> methods;
  for (const int sides : {8, 32, 128}) methods.push_back(std::make_unique<HullShape>(sides, 1));
  return methods;
}

}  // namespace cyl
