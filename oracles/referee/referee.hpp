// SPDX-License-Identifier: MIT
// The referee proves a verdict. It takes no vote and is not a method. It uses the types of
// solver/solid.hpp, but none of the solver's arithmetic.
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "corpus/pairs/certificate.hpp"
#include "corpus/pairs/method_answer.hpp"
#include "corpus/pairs/pair_numbers.hpp"
#include "solver/solid.hpp"

namespace cyl {

/// Bits of the widest search. A pair that needs more is `undecided`.
inline constexpr int precision_cap = 4096;

/// Proves the verdict of a pair: first by the offered witnesses, else by its own search.
/// 1. Deterministic. Throws nothing.
/// 2. An invalid pair gives `invalid`.
/// 3. `undecided` only at the cap on precision. Then the pair touches in a direction that is not rational, or
///    its gap or depth is too small for that many bits.
/// 4. CertificateKind lists the forms of the certificate. A witness may be a point and the hulls of flat
///    solids (Hull). If it proves the verdict, the certificate is the rational point, in both hulls, that is
///    nearest to it.
/// Cost:
/// * about 1 us, with or without a witness; 20 us if a witness has hulls
/// * 0.1 ms if double is not enough, below 1 ms for pairs that touch exactly
/// * 1 to 2 ms for rounded solids whose gap is as small as a floating-point error; at most 17 ms in 330,000
///   pairs
/// * 0.4 ms in the mean if components of axes or lengths are hundreds of decades apart. 1 in 240 of these
///   takes more than 20 ms, the slowest 31 ms.
Truth judge(const Pair& pair, std::span<const MethodAnswer> offered = {});

/// The stages of judge() and judge_verdict(), each alone. A pair that a stage leaves open is `undecided`.
/// In double with bounds of rounding: the offered witnesses, then one search. Cost: 1 us.
Truth prove_in_double(const Pair& pair, std::span<const MethodAnswer> offered = {});
/// In rationals and MPFR: the offered witnesses, then searches with 128 bits and twice as many each time.
Truth prove_exactly(const Pair& pair, std::span<const MethodAnswer> offered = {},
                    int bits_cap = precision_cap);

/// Returns the same proved verdict as judge(). Leaves out the certificate if a cheaper proof has none:
/// 1. a witness in hulls for flat solids, whose common points are rarely doubles,
/// 2. the search in sums of two doubles,
/// 3. algebra at a simple point or in a simple direction. It is tried before the search with many bits.
/// Cost: that of judge(), with these differences. 1 us for flat solids and for witnesses in hulls. 20 us for
/// most gaps and depths too small for double. 80 us for most pairs that touch exactly.
Truth judge_verdict(const Pair& pair, std::span<const MethodAnswer> offered = {});

/// Widths of an enclosure, relative to the pair's size. The one for gaps is narrower, because that problem is
/// convex and the depth is not.
inline constexpr double gap_width_tol = 1e-12;
inline constexpr double depth_width_tol = 1e-9;

/// The search computes bounds for at most this many cells of directions, then returns the enclosure as it is.
/// One cell costs about 0.3 us.
inline constexpr std::size_t cell_cap = 40000;

/// Returns a certified enclosure of the signed distance, about as narrow as the tolerances above. It is wider
/// 1. if the centres are so far apart that doubles do not resolve the distance, or
/// 2. if the cap on cells ends the search. That happens if many directions have the same depth,
///    as for rods along each other.
/// Touching gives [0, 0]. Cost: 4 us for disjoint pairs, 10 to 50 us for overlapping ones, up to 40 ms at the
/// cap.
Enclosure enclose_distance(const Pair& pair, const Truth& truth);
/// The same at a width of the caller's choice, relative to the pair's size. If a first estimate shows
/// that the distance is below that width, one end is 0, and the cost is a few us.
Enclosure enclose_distance(const Pair& pair, const Truth& truth, double relative_width);

/// The enclosure, and the unit direction from a to b at which it was found. Along it, the
/// extents of the solids overlap by minus the lower end, up to rounding errors.
/// 1. So the verdict does not raise the lower end. It only lowers the upper one to 0.
/// 2. If the distance is smaller than the width, the enclosure may differ from that of enclose_distance().
/// 3. If several directions attain the distance, it is one of them.
struct AttainedDistance {
  Enclosure distance;
  std::array<double, 3> direction{0, 0, 0};  ///< 0 for an invalid pair
  std::size_t cells = 0;                     ///< cells that were bounded; 0 if a formula gives the distance
};
/// Costs as much as the enclosure. Touching pairs are searched too.
AttainedDistance attain_distance(const Pair& pair, const Truth& truth, double relative_width);

/// The harness sorts, shrinks, mutates and searches by this. It is not proved, and it is independent of
/// the solver under test.
struct MeasuredDistance {
  double value = 0;                      ///< the gap, or minus a depth that may not be the least
  Vector3 direction{0, 0, 0};            ///< of length 1, from a to b; 0 for an invalid pair
  Vector3 on_a{0, 0, 0}, on_b{0, 0, 0};  ///< the points that face each other, from the centre of their solid
};
/// Leaves the points 0. Cost: 8 us.
MeasuredDistance approximate_distance(const Pair& pair);
/// The same with the points. Cost: 12 us.
MeasuredDistance measure_with_points(const Pair& pair);

/// Returns the verdict that a witness proves: `disjoint`, `intersecting`, or `undecided` if it proves
/// nothing. A witness in hulls proves nothing if its two hulls have no common point.
Verdict check_witness(const Pair& pair, const MethodAnswer& answer);

}  // namespace cyl
