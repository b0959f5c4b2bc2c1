// SPDX-License-Identifier: MIT
// Three numbers of any kind (double, Interval, MpFloat, MpInterval, mpq_class) as a vector.
#pragma once

namespace cyl {

template <class R>
struct Vec3 {
  R x, y, z;
};

template <class R>
Vec3<R> operator+(const Vec3<R>& a, const Vec3<R>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class R>
Vec3<R> operator-(const Vec3<R>& a, const Vec3<R>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class R>
Vec3<R> operator*(const R& s, const Vec3<R>& a) {
  return {s * a.x, s * a.y, s * a.z};
}
template <class R>
Vec3<R> operator/(const Vec3<R>& a, const R& s) {
  return {a.x / s, a.y / s, a.z / s};
}
template <class R>
R dot(const Vec3<R>& a, const Vec3<R>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class R>
Vec3<R> cross(const Vec3<R>& a, const Vec3<R>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

}  // namespace cyl
