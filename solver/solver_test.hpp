// SPDX-License-Identifier: MIT
// Shared by the tests of solver/. It replaces operator new, weakly: several files of a program may include
// it.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <new>

#include "solver/solid.hpp"

// Counts allocations, so that a test can require none. Not inlined, because gcc would report a mismatch of
// malloc and free through new and delete.
inline std::atomic<long> allocations{0};
[[gnu::noinline, gnu::weak]] void* operator new(std::size_t n) {
  ++allocations;
  if (void* p = std::malloc(n)) return p;
  throw std::bad_alloc();
}
[[gnu::noinline, gnu::weak]] void operator delete(void* p) noexcept { std::free(p); }
[[gnu::noinline, gnu::weak]] void operator delete(void* p, std::size_t) noexcept { std::free(p); }

namespace cyl {

// A fixed stream of numbers in [0, 1).
class Numbers {
 public:
  explicit Numbers(std::uint64_t seed) : state_(seed) {}
  double unit() {
    state_ = state_ * 6364136223846793005u + 1442695040888963407u;
    return static_cast<double>(state_ >> 11) * 0x1p-53;
  }
  // In [-1, 1).
  double either_sign() {
    unit();
    return static_cast<double>(static_cast<std::int64_t>(state_) >> 11) * 0x1p-52;
  }
  // Each coordinate in [-1, 1), drawn in order.
  Vector3 vector() {
    const double x = either_sign(), y = either_sign(), z = either_sign();
    return {x, y, z};
  }
  double between(double lo, double hi) { return lo + (hi - lo) * unit(); }

 private:
  std::uint64_t state_;
};

using Wide = Eigen::Matrix<long double, 3, 1>;

inline Solid upright(double x, double y, double z, double radius, double height) {
  return {Vector3(x, y, z), Vector3(0, 0, 1), radius, height};
}

inline double reach_of(const Pair& p) {
  return p.a.radius + p.a.height + p.b.radius + p.b.height + (p.b.center - p.a.center).norm();
}

// f at a direction, the slow way.
inline double support_gap(const Pair& p, const Vector3& direction) {
  const Wide d = direction.cast<long double>();
  long double f = -std::fabs(d.dot(p.b.center.cast<long double>() - p.a.center.cast<long double>()));
  for (const Solid* c : {&p.a, &p.b}) {
    const Wide w = c->axis.cast<long double>().normalized();
    f += c->radius * d.cross(w).norm() + c->height / 2 * std::fabs(d.dot(w));
  }
  return static_cast<double>(f / d.norm());
}

// How far a point, from the solid's centre, is outside: 0 within.
inline double outside(const Solid& c, const Vector3& offset) {
  const Wide x = offset.cast<long double>(), w = c.axis.cast<long double>().normalized();
  const long double along = std::fabs(x.dot(w)) - c.height / 2, across = x.cross(w).norm() - c.radius;
  return static_cast<double>(std::max(0.0L, std::max(along, across)));
}

}  // namespace cyl
