// SPDX-License-Identifier: MIT
// The referee: proves a verdict. Not a vote and not a method. It shares the words of solver/cylinder.hpp with
// the solver and none of its arithmetic.
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "corpus/pairs/certificate.hpp"
#include "corpus/pairs/method_answer.hpp"
#include "corpus/pairs/pair_numbers.hpp"
#include "solver/cylinder.hpp"

namespace cyl {

/// Bits of the widest search. Reaching it is `undecided`.
inline constexpr int precision_cap = 4096;

/// Proves the verdict of a pair: first by the offered witnesses, else by its own search.
/// 1. Deterministic. Throws nothing.
/// 2. An invalid pair gives `invalid`.
/// 3. `undecided` only at the cap on precision. Then the pair is a tangency without a rational direction that
///    algebra could try, or its gap or depth is too small for that many bits.
/// 4. The certificate is a direction, a point or `near`. For a witness in hulls, it is the rational point
///    that the witness stands for.
/// 5. With a cap below 128 bits, only double is used, also for witnesses.
/// Cost:
/// * below 1 us with a witness, and about that without; 20 us with a witness in hulls
/// * 0.1 ms if double is not enough, below 1 ms for exact ties, rounded or not
/// * 1 to 2 ms for rounded solids within rounding of touching, at most 17 ms on 330,000
/// * 0.4 ms in the mean if components of axes or lengths are hundreds of decades apart. 1 in 240 of these
///   takes more than 20 ms, the slowest 31 ms.
Truth judge(const Pair& pair, std::span<const MethodAnswer> offered = {}, int bits_cap = precision_cap);

/// Returns the verdict of judge(), proved as well. Leaves out the certificate if a cheaper proof has none:
/// 1. a proof in long double,
/// 2. a witness in hulls for flat solids, whose common points are rarely doubles,
/// 3. algebra at a simple point or in a simple direction, which comes before the wide search.
/// Cost: that of judge(), with these differences. 1 us for flat solids and for witnesses in hulls. 5 us if
/// double is not enough, 15 us for rounded solids. 50 us for most exact ties and for gaps too small for long
/// double.
Truth judge_verdict(const Pair& pair, std::span<const MethodAnswer> offered = {});

/// Widths of an enclosure, relative to the pair's size. The one for gaps is narrower, because that problem is
/// convex and the depth is not.
inline constexpr double gap_width_tol = 1e-12;
inline constexpr double depth_width_tol = 1e-9;

/// Cells after which an enclosure is returned at its current width. One cell costs about 0.3 us.
inline constexpr std::size_t cell_cap = 40000;

/// Returns a certified enclosure of the signed distance, about as narrow as the tolerances above. It is wider
/// 1. if the centres are so far apart that doubles do not resolve the distance, or
/// 2. if the cap on cells ends the search. That happens for many equal depths, such as rods along each other.
/// Touching gives [0, 0]. Cost: 4 us apart, 10 to 50 us overlapping, up to 40 ms at the cap.
Enclosure enclose_distance(const Pair& pair, const Truth& truth);
/// The same at a width of the caller's choice, relative to the pair's size. If one guess shows that the
/// distance is below that width, one end is 0, and the cost is a few us.
Enclosure enclose_distance(const Pair& pair, const Truth& truth, double relative_width);

/// The enclosure, and the unit direction from a to b at which it was found. There f is minus the lower end,
/// within rounding. For rounded solids, f and the end are those of the cores. Exceptions:
/// 1. The verdict may have cut the lower end off at 0.
/// 2. Nearer to touching than the width, the enclosure may differ from that of enclose_distance().
/// 3. If several directions attain the distance, it is one of them.
struct AttainedDistance {
  Enclosure distance;
  std::array<double, 3> direction{0, 0, 0};  ///< 0 for an invalid pair
  std::size_t cells = 0;                     ///< cells that were bounded; 0 if a formula gives the distance
};
/// Costs as much as the enclosure. Touching pairs are searched too.
AttainedDistance attain_distance(const Pair& pair, const Truth& truth, double relative_width);

/// Returns the verdict that a witness proves: `disjoint`, `intersecting`, or `undecided` if it proves
/// nothing. A point whose hulls have no common point proves nothing.
Verdict check_witness(const Pair& pair, const MethodAnswer& answer);

}  // namespace cyl
