// SPDX-License-Identifier: MIT
// Functions that the adapters of methods share. They use none of the solver's arithmetic.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "oracles/methods/method.hpp"
#include "solver/solid.hpp"

namespace cyl {

/// Returns an answer that declines, with the reason, if a solid of the pair is not a valid cylinder. Else
/// returns nothing.
std::optional<MethodAnswer> decline_invalid(const Pair& pair);

/// Returns both solids of every pair in a library's own type, made once for many questions.
template <class Guest>
std::vector<std::pair<Guest, Guest>> solids_of(
    std::span<const Pair> pairs, Guest (*make)(const Solid&) = [](const Solid& c) { return Guest(c); }) {
  std::vector<std::pair<Guest, Guest>> solids;
  solids.reserve(pairs.size());
  for (const Pair& pair : pairs) solids.emplace_back(make(pair.a), make(pair.b));
  return solids;
}

/// The same for solids that cannot be copied, for calls that are copied.
template <class Guest>
std::shared_ptr<const std::vector<std::pair<Guest, Guest>>> shared_solids_of(std::span<const Pair> pairs) {
  return std::make_shared<const std::vector<std::pair<Guest, Guest>>>(solids_of<Guest>(pairs));
}

/// A method that asks its library about two solids of the library's own type.
template <class Guest>
class VerdictMethod : public Method {
 public:
  using Method::Method;
  MethodAnswer answer(const Pair& pair) override {
    if (const auto declined = decline_invalid(pair)) return *declined;
    return answered(collide(Guest(pair.a), Guest(pair.b)));
  }
  Call prepare_all(std::span<const Pair> pairs) override {
    return [this, solids = shared_solids_of<Guest>(pairs)](std::size_t i) {
      return collide((*solids)[i].first, (*solids)[i].second);
    };
  }

 private:
  virtual Verdict collide(const Guest& a, const Guest& b) = 0;
};

/// Returns the cylinder or box with its edges rounded inwards by `rounding`. Returns it unchanged if it is
/// too thin for that, or rounded already.
Solid with_rounded_rims(Solid c, double rounding) noexcept;

/// Returns axis/|axis| for any finite axis but 0. Each coordinate is right within 2^-51.
Vector3 unit_axis(const Vector3& axis) noexcept;

/// Returns a rotation that takes z to the unit vector u. It is orthonormal to a few roundings. Its third
/// column is u exactly.
Eigen::Matrix3d rotation_to(const Vector3& u) noexcept;

/// Returns the rotation of a valid solid as it lies in a library's own frame: a box along the axes, all
/// others along z. Each element of the rotation of a box is right within 2^-50.
Eigen::Matrix3d rotation_of(const Solid& c) noexcept;

}  // namespace cyl
