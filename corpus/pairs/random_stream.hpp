// SPDX-License-Identifier: MIT
// Random numbers that are the same on every machine: a counter-based stream named by (name, seed, index), its
// own mapping of bits to doubles, and only + - x / sqrt after that.
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "base/fnv.hpp"
#include "solver/solid.hpp"

namespace cyl {

/// u . v, summed in this order on every machine.
inline double inner_product(const Vector3& u, const Vector3& v) {
  return u.x() * v.x() + u.y() * v.y() + u.z() * v.z();
}

/// Returns the length of a vector.
inline double length_of(const Vector3& v) { return std::sqrt(inner_product(v, v)); }
inline Vector3 normalise(const Vector3& v) { return v / std::sqrt(inner_product(v, v)); }

/// Draws one after the other; draw into names, because the order of evaluation of arguments differs between
/// compilers.
class RandomStream {
 public:
  RandomStream(std::string_view name, std::uint64_t seed, std::uint64_t index)
      : state_(mix(mix(fnv1a(name) ^ mix(seed)) ^ index)) {}

  std::uint64_t bits() { return mix(state_ += 0x9e3779b97f4a7c15); }
  /// In [0, 1), a multiple of 2^-53.
  double unit() { return static_cast<double>(bits() >> 11) * 0x1p-53; }
  double between(double low, double high) { return low + (high - low) * unit(); }
  /// In [0, n); n < 2^32.
  std::size_t below(std::size_t n) { return static_cast<std::size_t>(((bits() >> 32) * n) >> 32); }
  int integer(int low, int high) {
    return low + static_cast<int>(below(static_cast<std::size_t>(high - low + 1)));
  }
  bool coin() { return bits() >> 63 != 0; }
  double sign() { return coin() ? 1 : -1; }
  double pick(std::span<const double> table) { return table[below(table.size())]; }
  /// A decade of the table times [1, 10).
  double within_decades(std::span<const double> table) {
    const double decade = pick(table);
    return decade * between(1, 10);
  }

  /// Uniform on the unit sphere, by rejection from the cube.
  Vector3 unit_vector() {
    for (;;) {
      Vector3 v;
      for (int i = 0; i < 3; ++i) v[i] = between(-1, 1);
      const double square = inner_product(v, v);
      if (square <= 1 && square >= 1e-4) return v / std::sqrt(square);
    }
  }
  /// Uniform on the unit circle perpendicular to `w`, up to rounding.
  Vector3 perpendicular(const Vector3& w) {
    for (;;) {
      const Vector3 v = w.cross(unit_vector());
      if (const double square = inner_product(v, v); square >= 0.01 * inner_product(w, w))
        return v / std::sqrt(square);
    }
  }
  /// One of the six unit vectors along a coordinate axis.
  Vector3 coordinate_axis() {
    Vector3 v(0, 0, 0);
    const std::size_t i = below(3);
    v[static_cast<Eigen::Index>(i)] = sign();
    return v;
  }

 private:
  /// splitmix64's finalizer.
  static std::uint64_t mix(std::uint64_t x) {
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9;
    x = (x ^ (x >> 27)) * 0x94d049bb133111eb;
    return x ^ (x >> 31);
  }

  std::uint64_t state_;
};

}  // namespace cyl
