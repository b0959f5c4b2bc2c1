// SPDX-License-Identifier: MIT
// The referee: proves a verdict. Not a vote and not a method. It shares the words of solver/cylinder.hpp with
// the solver and none of its arithmetic.
#pragma once

#include <array>
#include <span>
#include <string>

#include "corpus/pairs/method_answer.hpp"
#include "solver/cylinder.hpp"

namespace cyl {

/// The arithmetic that settled a question.
enum class Stage : unsigned char {
  filter,  ///< double, or long double, with outward rounding
  wide,    ///< MPFI
  exact    ///< rationals
};

/// The words used in files and on screens: "filter", "wide", "exact".
const char* to_string(Stage s) noexcept;

enum class CertificateKind : unsigned char { none, direction, point, near };

/// One vector of a certificate, exactly head + tail, or, where `exact` is not empty, the rationals written
/// there as "n/d" (or "n").
struct ExactVector {
  std::array<double, 3> head{0, 0, 0};
  std::array<double, 3> tail{0, 0, 0};
  std::array<std::string, 3> exact;
};

/// direction: D with f(D) < 0. point: in both solids. near: `vector` a point within 2^-200 size of both
/// solids, `second` a direction with |f| <= 2^-200 size |direction| (touching without a rational point).
struct Certificate {
  CertificateKind kind = CertificateKind::none;
  ExactVector vector;
  ExactVector second;
};

struct Truth {
  Verdict verdict = Verdict::undecided;  ///< disjoint, intersecting, touching, undecided or invalid
  Certificate certificate;
  Stage stage = Stage::filter;
  int bits = 53;           ///< the widest precision that was used
  bool witnessed = false;  ///< settled by a witness that an answer offered
};

/// A closed interval [lo, hi] that certainly holds the signed distance: > 0 the gap, < 0 minus the
/// penetration depth; in the scene's unit (of a Finding's margin: in sizes).
struct Enclosure {
  double lo = 0, hi = 0;
};

/// Bits of the widest search. Reaching it is `undecided`.
inline constexpr int precision_cap = 4096;

/// Proves the verdict of a pair: first from the witnesses offered, else by a search of its own.
/// Deterministic. Never throws; an invalid pair gives `invalid`. `undecided` only at the cap on precision: a
/// tangency that could not be proved, or a gap too small for that many bits to show. Cost: below 1 us with a
/// witness and about that without, 0.1 ms where double does not reach, some ms for exact ties, 0.2 s for
/// lengths hundreds of decades apart. A cap below 128 bits: in double alone, witnesses too.
Truth judge(const Pair& pair, std::span<const MethodAnswer> offered = {}, int bits_cap = precision_cap);

/// The verdict of judge(), proved as well, without the certificate where a cheaper proof leaves none to write
/// down (in long double, or of flat solids, whose common points are rarely doubles). Cost: that of judge()
/// with less than 1 us for flat solids and 5 us where double does not reach; exact ties as before.
Truth judge_verdict(const Pair& pair, std::span<const MethodAnswer> offered = {});

/// Widths asked of an enclosure, relative to the pair's size: apart the problem is convex, penetrating it is
/// not.
inline constexpr double gap_width_tol = 1e-12;
inline constexpr double depth_width_tol = 1e-9;

/// A certified enclosure of the signed distance, about as narrow as the tolerances above; wider where the
/// centres are so far apart that doubles do not resolve it, or where the cap on cells ends the search (many
/// equal depths: rods along each other). Touching gives [0, 0]. Cost: 20 to 100 us, up to 40 ms at the cap.
Enclosure enclose_distance(const Pair& pair, const Truth& truth);
/// The same at a width of the caller's choice, in units of the pair's size; a few us, and one end 0, where
/// one guess shows the distance to be less than that.
Enclosure enclose_distance(const Pair& pair, const Truth& truth, double relative_width);

/// The enclosure (perhaps another one where nearer to touching than the width) and the unit direction from a
/// to b at which it was found: f there is minus its lower end, within rounding. One of several where several
/// do.
struct AttainedDistance {
  Enclosure distance;
  std::array<double, 3> direction{0, 0, 0};  ///< 0 of an invalid pair
};
/// At no more cost than the enclosure; touching pairs are searched too.
AttainedDistance attain_distance(const Pair& pair, const Truth& truth, double relative_width);

/// Whether a witness proves a verdict: `disjoint`, `intersecting`, or `undecided` where it proves nothing.
Verdict check_witness(const Pair& pair, const MethodAnswer& answer);

/// radius a + height a + radius b + height b, rounded, at most the largest double (the unit of margins).
double size_of(const Pair& pair);

/// One JSON object: {"verdict":"disjoint","direction":[x,y,z],"stage":"filter"} and so on; `distance` may be
/// null.
std::string format_truth(const Truth& truth, const Enclosure* distance = nullptr);
/// The certificate alone, e.g. {"point":[[0,1e-3],0,"1/3"]}; {} where there is none.
std::string format_certificate(const Certificate& certificate);

}  // namespace cyl
