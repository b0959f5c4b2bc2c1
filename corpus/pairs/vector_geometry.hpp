// SPDX-License-Identifier: MIT
// The geometry of test vectors (docs/vectors.md): lower ends of distances, classes of pairs, and other
// forms of solids. A published vector never changes, so its numbers must stay the same to the bit.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "corpus/pairs/stratum.hpp"
#include "solver/solid.hpp"

namespace cyl {

using Wide3 = Eigen::Matrix<long double, 3, 1>;

/// Returns the sum of all lengths that rounding errors are relative to.
long double scale_of(const Pair& pair);
/// Returns the lower end of the distance that a direction proves.
double proved_below(const Pair& pair, const Vector3& direction);
/// Returns a direction whose gap is exactly 0, if its numbers have rational roots.
std::optional<Vector3> touching_direction(const Pair& pair);

/// Returns the pair with each number rounded to a float.
Pair in_floats(const Pair& pair);
/// Returns whether each number is a normal float or 0.
bool is_float(const Pair& pair);
bool is_everyday(const Pair& pair);
/// Returns the flags of vectors/v1/flags.json, which explains each and lists who met it.
std::string flags_of(const Pair& pair, Verdict result, std::optional<ContactFeature> feature,
                     AngleClass angle, double margin);

/// A rotation that takes z to the axis of a solid, as a quaternion of length 1 within rounding.
struct AxisTurn {
  double w, x, y, z;
  long double off;  ///< the most that a point of the solid is off its place by the axis
};
AxisTurn turn_of(const Solid& solid, bool in_floats);
/// Returns the corners of a prism with so many sides, inside or around the core.
std::vector<Vector3> prism(const Solid& solid, int sides, bool around);

/// A change that rounds no number. Scaling a pair also scales its distance.
struct ExactChange {
  const char* name;
  Pair (*of)(Pair);
};
std::span<const ExactChange> exact_changes();

}  // namespace cyl
