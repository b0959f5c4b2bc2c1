// SPDX-License-Identifier: MIT
#include <ode/ode.h>

#include <stdexcept>
#include <utility>
#include <vector>

#include "corpus/pairs/pair_numbers.hpp"
#include "oracles/methods/adapter.hpp"
#include "oracles/methods/method.hpp"

namespace cyl {
namespace {

static_assert(sizeof(dReal) == 8);

/// The tolerance that ODE passes to the algorithm of libccd. Its users cannot change it.
constexpr double mpr_tol = 1e-6;
constexpr std::string_view mpr_source =
    "ode/src/collision_libccd.cpp: ccd.mpr_tolerance = (ccd_real_t)1E-6; ode/collision.h says nothing";

/// ODE never returns more contacts of two cylinders than this.
constexpr int contacts_cap = 8;

/// Throws std::runtime_error. ODE is never closed, because a Call may hold solids until the process ends.
void initialise_once() {
  static const bool ready =
      dInitODE2(0) != 0 && dAllocateODEDataForThread(static_cast<unsigned>(dAllocateMaskAll)) != 0;
  if (!ready) throw std::runtime_error("ODE does not initialise");
}

dGeomID geom_of(const Solid& c) {
  switch (kind_of(c)) {
    case SolidKind::half_space: {
      const Vector3 n = unit_axis(c.axis);
      return dCreatePlane(nullptr, n.x(), n.y(), n.z(), n.dot(c.center));
    }
    case SolidKind::sphere:
      return dCreateSphere(nullptr, c.rounding);
    case SolidKind::capsule:
      return dCreateCapsule(nullptr, c.rounding, c.height);
    case SolidKind::box:
      return dCreateBox(nullptr, c.edges[0], c.edges[1], c.edges[2]);
    case SolidKind::cylinder:
    case SolidKind::rounded:
    case SolidKind::rounded_box:
      break;
  }
  return dCreateCylinder(nullptr, c.radius, c.height);
}

/// A solid as ODE keeps it, in no space and on no body. dCollide() has a function for each pair of kinds.
class OdeSolid {
 public:
  explicit OdeSolid(const Solid& c) : geom_(geom_of(c)) {
    if (is_half_space(c)) return;
    const Eigen::Matrix3d m = rotation_of(c);
    const dMatrix3 rotation = {m(0, 0), m(0, 1), m(0, 2), 0,       m(1, 0), m(1, 1),
                               m(1, 2), 0,       m(2, 0), m(2, 1), m(2, 2), 0};
    dGeomSetRotation(geom_, rotation);
    dGeomSetPosition(geom_, c.center.x(), c.center.y(), c.center.z());
  }
  ~OdeSolid() {
    if (geom_ != nullptr) dGeomDestroy(geom_);
  }
  OdeSolid(OdeSolid&& other) noexcept : geom_(std::exchange(other.geom_, nullptr)) {}
  OdeSolid& operator=(OdeSolid&&) = delete;

  dGeomID geom() const { return geom_; }

 private:
  dGeomID geom_;
};

/// Calls dCollide() and returns whether it makes a contact.
class Ode final : public VerdictMethod<OdeSolid> {
 public:
  /// `flags` holds the number of contacts to find, and CONTACTS_UNIMPORTANT.
  Ode(MethodName name, unsigned flags) : VerdictMethod(std::move(name)), flags_(static_cast<int>(flags)) {
    initialise_once();
  }
  std::string_view version() const override { return dODE_VERSION; }
  bool recovers() const override { return true; }  // solids are made for each call, in no space
  bool supports(SolidKind kind) const override {
    return kind != SolidKind::rounded && kind != SolidKind::rounded_box;
  }
  Claim claim() const override { return {.absolute = mpr_tol, .source = mpr_source, .assumed = true}; }

  MethodAnswer answer(const Pair& pair) override {
    const auto flat = [](const Solid& c) { return kind_of(c) == SolidKind::cylinder && c.height == 0; };
    if (flat(pair.a) || flat(pair.b))
      return declined_answer("height 0: ODE calls it an invalid cylinder and aborts");
    return VerdictMethod::answer(pair);
  }

 private:
  Verdict collide(const OdeSolid& a, const OdeSolid& b) override {
    dContactGeom contacts[contacts_cap];
    const int count = dCollide(a.geom(), b.geom(), flags_, contacts, sizeof contacts[0]);
    return count > 0 ? Verdict::intersecting : Verdict::disjoint;
  }

  const int flags_;
};

}  // namespace

std::vector<std::unique_ptr<Method>> ode_methods() {
  std::vector<std::unique_ptr<Method>> methods;
  methods.push_back(std::make_unique<Ode>(MethodName{"ode"}, 1));
  methods.push_back(std::make_unique<Ode>(MethodName{"ode", "", "unrefined"}, 1 | CONTACTS_UNIMPORTANT));
  methods.push_back(std::make_unique<Ode>(MethodName{"ode", "", "contacts-8"}, contacts_cap));
  return methods;
}

}  // namespace cyl
