// SPDX-License-Identifier: MIT
// What the adapters of methods share. Nothing of the solver's arithmetic is in it.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "oracles/methods/method.hpp"
#include "solver/cylinder.hpp"

namespace cyl {

/// An answer that declines, with the reason, where a solid of the pair is no cylinder; else nothing.
std::optional<MethodAnswer> decline_invalid(const Pair& pair);

/// Both solids of every pair as a library keeps them, made once for many questions.
template <class Solid>
std::vector<std::pair<Solid, Solid>> solids_of(
    std::span<const Pair> pairs,
    Solid (*make)(const Cylinder&) = [](const Cylinder& c) { return Solid(c); }) {
  std::vector<std::pair<Solid, Solid>> solids;
  solids.reserve(pairs.size());
  for (const Pair& pair : pairs) solids.emplace_back(make(pair.a), make(pair.b));
  return solids;
}

/// The same, of solids that cannot be copied, for calls that are.
template <class Solid>
std::shared_ptr<const std::vector<std::pair<Solid, Solid>>> shared_solids_of(std::span<const Pair> pairs) {
  return std::make_shared<const std::vector<std::pair<Solid, Solid>>>(solids_of<Solid>(pairs));
}

/// The cylinder with its rims rounded inwards by so much; as it is where that leaves nothing, and if it is
/// rounded.
Cylinder with_rounded_rims(Cylinder c, double rounding) noexcept;

/// axis/|axis|, each coordinate within 2^-51 of it, for any finite non-zero axis.
Vector3 unit_axis(const Vector3& axis) noexcept;

/// A rotation that takes z to the unit vector u: orthonormal to a few roundings, its third column exactly u.
Eigen::Matrix3d rotation_to(const Vector3& u) noexcept;

}  // namespace cyl
