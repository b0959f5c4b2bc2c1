// SPDX-License-Identifier: MIT
// Exact tangency: whether two solids touch without overlapping, proved by algebra.
#pragma once

#include <optional>
#include <utility>

#include "oracles/referee/certificate_check.hpp"
#include "oracles/referee/root_sum.hpp"

namespace cyl {

/// A direction D with f(D) <= 0 exactly: a plane square to it has one solid on each closed side.
struct Tangency {
  Rational3 direction;
  bool
      meet;  ///< f(D) = 0, and the solids share a point of that plane, so they touch. Else they are disjoint.
};

/// Takes no boxes. Looks for D among the rational directions that the pair and the guessed points of a's and
/// of b's core suggest. Nothing found proves nothing: D may be irrational (a rim against a wall or a rim, in
/// general position).
std::optional<Tangency> prove_tangency(const Pair& pair, const Rational3& near_point,
                                       const Rational3& near_other, const Rational3& near_direction);

/// Takes no boxes. A point of a's core and one of b's at which solids touch whose tangency has this
/// direction, if it is rational. If they touch at many points it is one far from the ends of what the faces
/// share.
std::optional<std::pair<Rational3, Rational3>> contact_points(const Pair& pair, const Rational3& direction);

/// The middle of the face of the core that is farthest along the direction, if it is rational.
std::optional<Rational3> farthest_point(const Solid& c, const Rational3& direction);

/// The greatest direction.x of the core, relative to its centre.
RootSum exact_core_support(const Solid& c, const Rational3& direction);

/// The sign of f(direction), direction not 0, exactly. It is 1 if a half-space faces another direction.
int support_gap_sign(const Pair& pair, const Rational3& direction);

/// A simple rational within `tolerance` of x: the first convergent of its continued fraction that is.
mpq_class simplest_within(const mpq_class& x, const mpq_class& tolerance);

}  // namespace cyl
