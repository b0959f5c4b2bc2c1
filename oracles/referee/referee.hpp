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

/// Proves the verdict of a pair: first from the witnesses offered, else by a search of its own.
/// Deterministic. Never throws; an invalid pair gives `invalid`. What it proves is written as a direction, a
/// point (of a witness in hulls: the rational point that it stands for) or `near`. `undecided` only at the
/// cap on precision: a tangency for which algebra was offered no rational direction, or a gap or depth too
/// small for that many bits to show. Cost: below 1 us with a witness and about that without, 20 us with one
/// in hulls, 0.1 ms where double does not reach, below 1 ms for exact ties, rounded or not, 1 to 2 ms for
/// rounded solids within rounding of touching, 17 ms at most among 330,000; of axes or lengths with
/// components hundreds of decades apart 0.4 ms in the mean, above 20 ms for 1 in 240, 31 ms at most. A cap
/// below 128 bits: in double alone, witnesses too.
Truth judge(const Pair& pair, std::span<const MethodAnswer> offered = {}, int bits_cap = precision_cap);

/// The verdict of judge(), proved as well, without the certificate where a cheaper proof leaves none to write
/// down: in long double, by a witness in hulls, of flat solids, whose common points are rarely doubles, or,
/// at a simple point or in a simple direction, by algebra before the wide search. Cost: that of judge() with
/// 1 us for flat solids and for witnesses in hulls, 5 us where double does not reach (15 us for rounded
/// solids), 50 us for most exact ties and for gaps too small for long double.
Truth judge_verdict(const Pair& pair, std::span<const MethodAnswer> offered = {});

/// Widths asked of an enclosure, relative to the pair's size: apart the problem is convex, penetrating it is
/// not.
inline constexpr double gap_width_tol = 1e-12;
inline constexpr double depth_width_tol = 1e-9;

/// Cells looked at before an enclosure is returned as wide as it is. One cell costs about 0.3 us.
inline constexpr std::size_t cell_cap = 40000;

/// A certified enclosure of the signed distance, about as narrow as the tolerances above; wider where the
/// centres are so far apart that doubles do not resolve it, or where the cap on cells ends the search (many
/// equal depths: rods along each other). Touching gives [0, 0]. Cost: 4 us apart, 10 to 50 us overlapping, up
/// to 40 ms at the cap.
Enclosure enclose_distance(const Pair& pair, const Truth& truth);
/// The same at a width of the caller's choice, relative to the pair's size; a few us, and one end 0, where
/// one guess shows the distance to be less than that.
Enclosure enclose_distance(const Pair& pair, const Truth& truth, double relative_width);

/// The enclosure (perhaps another one where nearer to touching than the width) and the unit direction from a
/// to b at which it was found: f there is minus its lower end, within rounding, unless the verdict has cut
/// that end off at 0 (of rounded solids: that of the cores). One of several where several do.
struct AttainedDistance {
  Enclosure distance;
  std::array<double, 3> direction{0, 0, 0};  ///< 0 of an invalid pair
  std::size_t cells = 0;                     ///< that were looked at; 0 where a formula has it
};
/// At no more cost than the enclosure; touching pairs are searched too.
AttainedDistance attain_distance(const Pair& pair, const Truth& truth, double relative_width);

/// Whether a witness proves a verdict: `disjoint`, `intersecting`, or `undecided` where it proves nothing (as
/// a point does whose hulls have none in common).
Verdict check_witness(const Pair& pair, const MethodAnswer& answer);

}  // namespace cyl
