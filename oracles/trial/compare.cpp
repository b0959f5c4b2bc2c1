// SPDX-License-Identifier: MIT
#include "oracles/trial/compare.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <iterator>
#include <limits>

#include "corpus/pairs/pair_io.hpp"
#include "corpus/pairs/random_stream.hpp"
#include "oracles/referee/witness_miss.hpp"
#include "oracles/trial/decidable_margin.hpp"
#include "oracles/trial/trial.hpp"

namespace cyl {
namespace {

/// The relative widths that enclosures are asked for, in this order. A lower bound that has not reached the
/// claim at the last width counts as within the claim.
constexpr double widths[] = {1e-6, 1e-9, 1e-12, 1e-15, 1e-18};
constexpr double widest = widths[0], narrowest = widths[std::size(widths) - 1];
/// Relative. Covers the rounding of size_of (3 sums), of a claim (2 operations) and of a quotient, 2^-53
/// each.
constexpr double rounding_error = 0x1p-50;

Enclosure magnitude(const Enclosure& d) {
  if (d.lo > 0) return d;
  if (d.hi < 0) return {-d.hi, -d.lo};
  return {0, std::max(-d.lo, d.hi)};
}

/// size_of() stops at the largest double. The size is then less than the sum of six such numbers.
constexpr double size_at_most = 6;

Enclosure relative_to(double size, const Enclosure& length) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const double factor = size == std::numeric_limits<double>::max() ? size_at_most : 1;
  if (size == 0) return {length.lo > 0 ? infinity : 0, length.hi > 0 ? infinity : 0};
  const double hi = length.hi / size * (1 + rounding_error);
  return {length.lo / size / factor * (1 - rounding_error), std::isnan(hi) ? infinity : hi};
}

/// Returns the pair's own margin, for faults that do not depend on it. Returns nothing if nothing is proved.
std::optional<Enclosure> margin_of(Trial& trial) {
  if (!trial.decided()) return {};
  if (trial.truth.verdict == Verdict::touching) return Enclosure{0, 0};
  return relative_to(size_of(trial.pair), magnitude(trial.distance_at(widest)));
}

Finding refuted(FindingKind kind, Trial& trial, const Claim& claim) {
  const double size = size_of(trial.pair), promised_from = reach(claim, size);
  const Enclosure gap = magnitude_against(promised_from, trial);
  return {kind, gap.lo >= promised_from ? Severity::contract : Severity::resolution, relative_to(size, gap)};
}

std::optional<Finding> compare_verdict(Trial& trial, const Claim& claim, Verdict said) {
  const Verdict truth = trial.truth.verdict;
  const bool disjoint = truth == Verdict::disjoint;
  switch (said) {
    case Verdict::undecided:
      if (!must_decide(claim.decides, trial)) return {};
      return Finding{FindingKind::left_undecided, Severity::contract, margin_of(trial)};
    case Verdict::invalid:
      return Finding{FindingKind::wrong_invalid, Severity::contract, margin_of(trial)};
    case Verdict::disjoint:
      if (disjoint) return {};
      return refuted(FindingKind::wrong_disjoint, trial, claim);
    case Verdict::intersecting:
      if (!disjoint) return {};
      return refuted(FindingKind::wrong_intersecting, trial, claim);
    case Verdict::touching:
      if (disjoint) return refuted(FindingKind::wrong_intersecting, trial, claim);
      if (truth == Verdict::touching || trial.distance_at(widest).hi >= 0) return {};
      return refuted(FindingKind::wrong_touching, trial, claim);
  }
  return {};
}

/// Returns the least and the greatest error of `said` over all distances in `real`.
Enclosure error_of(double said, const Enclosure& real) {
  return {std::max({0.0, real.lo - said, said - real.hi}), std::max(real.hi - said, said - real.lo)};
}

/// Returns the error of a lower bound: by how much the distance is less than it.
Enclosure shortfall_of(double said, const Enclosure& real) {
  return {std::max(0.0, said - real.hi), std::max(0.0, said - real.lo)};
}

// If an enclosure proves the distance neither right nor wrong, the narrowest one is asked for. So a finding
// never depends on how narrow earlier questions made the enclosure. If one is much wider than asked for, it
// ended at the rounding of doubles or at its cap on cells, and would do so again.
std::optional<Finding> compare_distance(Trial& trial, const Claim& claim, const MethodAnswer& answer) {
  const double said = answer.distance, size = size_of(trial.pair), allowed = reach(claim, size);
  // If both parts of the claim are 0, it promises a rounded number. So one unit in the last place of the
  // larger length is allowed.
  const double last_place = std::max(std::abs(said), size) * rounding_error;
  const double most = std::max(allowed, last_place);
  const double finest = answer.error_bound > 0 ? std::min(most, answer.error_bound) : most;
  const double part = size > 0 ? std::clamp(finest / 8 / size, narrowest, widest) : widest;
  for (const double width : {part, narrowest}) {
    const bool touching = trial.truth.verdict == Verdict::touching;
    const Enclosure real = touching ? Enclosure{0, 0} : trial.distance_at(width);
    const Enclosure off = answer.at_least ? shortfall_of(said, real) : error_of(said, real);
    if (off.lo > most) {
      // Some libraries return the largest double, or its negative, if they found no distance.
      const bool is_number = std::abs(said) < std::numeric_limits<double>::max();
      return Finding{is_number ? FindingKind::distance_outside : FindingKind::non_finite, Severity::contract,
                     is_number ? relative_to(size, off) : margin_of(trial)};
    }
    const bool as_narrow_as_it_gets = real.hi - real.lo > 4 * width * size;
    if (off.hi <= most || as_narrow_as_it_gets) break;
  }
  const bool touching = trial.truth.verdict == Verdict::touching;
  const Enclosure off = error_bound_of(touching ? Enclosure{0, 0} : trial.distance, answer);
  if (answer.error_bound > 0 && off.lo > answer.error_bound)
    return Finding{FindingKind::distance_outside, Severity::contract, relative_to(size, off)};
  return {};
}

bool same_bits(const double* x, const double* y) { return std::memcmp(x, y, 3 * sizeof *x) == 0; }

bool same_hulls(const Hull* x, const Hull* y) { return x[0] == y[0] && x[1] == y[1]; }

/// Returns whether the truth's certificate is this answer's own witness, which then needs no second check.
bool is_certificate(const Truth& truth, const MethodAnswer& answer) {
  const ExactVector &v = truth.certificate.vector, &other = truth.certificate.second;
  return truth.certificate.kind == answer.witness && v.in_doubles() &&
         same_bits(v.head.data(), answer.head) && same_bits(v.tail.data(), answer.tail) &&
         other.in_doubles() && same_bits(other.head.data(), answer.other_head) &&
         same_bits(other.tail.data(), answer.other_tail) &&
         same_hulls(truth.certificate.hulls.data(), answer.hulls);
}

/// Returns whether the witness, if any, proves the verdict. A direction proves nothing about touching.
bool witness_holds(const Pair& pair, const Truth& truth, const MethodAnswer& answer) {
  if (answer.witness == CertificateKind::none || answer.verdict == Verdict::undecided) return true;
  if (answer.verdict == Verdict::touching && answer.witness == CertificateKind::direction)
    return std::any_of(std::begin(answer.head), std::end(answer.head), [](double x) { return x != 0; });
  const Verdict said = answer.verdict == Verdict::touching ? Verdict::intersecting : answer.verdict;
  return (said == truth.verdict && is_certificate(truth, answer)) || check_witness(pair, answer) == said;
}

/// The largest distance of two points of a solid.
double diameter_of(const Solid& c) {
  const auto& [x, y, z] = c.edges;
  return (is_box(c) ? std::hypot(x, y, z) : std::hypot(2 * c.radius, c.height)) + 2 * c.rounding;
}

// The claim of a length t may explain a witness that proves nothing.
//
// A point may lie outside a solid by t.
//
// A direction is the difference of two nearest points. Errors of t in both move that difference, whose length
// is the gap g, by at most 2t. So they turn it by an angle with a sine of at most s = 2t/g, or by any angle
// if 2t >= g. Let n be the true unit direction, and m a unit vector square to it.
// Then D is n cos + m sin.
// f(D) is the greatest D.z over the differences z = x - y of a point x of a and a point y of b.
// All of them have n.z <= -g, and -g n is one of them. So z = -g n + w, with |w| at most the sum W of both
// diameters, and
//     D.z = n.z cos + m.w sin <= -g cos + W sin <= W s - g sqrt(1 - s^2).
// So a D with a larger f(D) is farther off than the claim explains. A claim of 0 explains nothing.
bool explains(const Claim& claim, Trial& trial, const MethodAnswer& answer) {
  const Pair& pair = trial.pair;
  const double allowed = reach(claim, size_of(pair));
  const std::optional<double> miss = witness_miss(pair, answer);
  if (!miss || allowed == 0) return false;
  if (answer.witness != CertificateKind::direction) return *miss <= allowed * (1 + rounding_error);
  if (answer.verdict != Verdict::disjoint) return false;
  const double gap = magnitude_against(2 * allowed, trial).lo;
  if (gap <= 2 * allowed) return true;
  const double sine = 2 * allowed / gap, width = diameter_of(pair.a) + diameter_of(pair.b);
  const double bound = width * sine - gap * std::sqrt((1 - sine) * (1 + sine));
  // The terms are rounded some ten times.
  return *miss <= bound + (width * sine + gap) * 16 * rounding_error;
}

}  // namespace

FindingKind finding_of(Failure failure) {
  switch (failure) {
    case Failure::hang:
      return FindingKind::hang;
    case Failure::non_finite:
      return FindingKind::non_finite;
    case Failure::malformed:
      return FindingKind::malformed;
    case Failure::exception:
      return FindingKind::exception;
    case Failure::reported:
      return FindingKind::reported;
    case Failure::crash:
    case Failure::none:
      return FindingKind::crash;
  }
  return FindingKind::crash;
}

// No method can keep an absolute length for solids so large that the rounding of their coordinates exceeds
// it. So the relative part is then at least claim_floor.
double reach(const Claim& claim, double size) {
  const double relative = claim.absolute > 0 ? std::max(claim.relative, claim_floor) : claim.relative;
  if (relative == 0 || size == 0) return claim.absolute;
  // For subnormal solids the product may vanish, and each of some operations rounds to 2^-1074.
  constexpr double subnormal_error = 0x1p-1071;
  const double relative_part = std::max(relative * size, subnormal_error);
  return (relative_part + claim.absolute) * (1 + rounding_error);
}

double allowed_error(const Claim& claim, const Pair& pair) {
  const double length = size_of(pair) + length_of(pair.b.center - pair.a.center);
  return claim.relative == 0 && claim.absolute == 0 ? length : reach(claim, length);
}

Enclosure magnitude_against(double length, Trial& trial) {
  Enclosure gap{0, 0};
  if (trial.truth.verdict == Verdict::touching) return gap;
  for (const double width : widths) {
    gap = magnitude(trial.distance_at(width));
    if (gap.lo >= length || gap.hi < length) break;
  }
  return gap;
}

Enclosure error_bound_of(const Enclosure& real, const MethodAnswer& answer) {
  if (answer.distance > 0) return error_of(answer.distance, real);
  return shortfall_of(answer.distance, real);
}

namespace {

// The claim may excuse a verdict, and not the distance beside it. So the first finding beyond the claim is
// returned, and only without one the first within it.
std::optional<Finding> compare_said(Trial& trial, const Claim& claim, const MethodAnswer& said) {
  if (said.status == Status::declined) return {};
  const MethodAnswer answer = checked(said);
  if (answer.status == Status::failed)
    return Finding{finding_of(answer.failure), Severity::contract, margin_of(trial)};
  if (!trial.decided()) return {};
  const auto verdict = compare_verdict(trial, claim, answer.verdict);
  if (verdict && verdict->severity == Severity::contract) return verdict;
  if (answer.states_distance())
    if (auto wrong = compare_distance(trial, claim, answer)) return wrong;
  // A witness of a wrong verdict proves nothing, and a second finding about one error adds nothing.
  if (verdict || witness_holds(trial.pair, trial.truth, answer)) return verdict;
  Finding wrong = refuted(FindingKind::bad_witness, trial, claim);
  wrong.severity = explains(claim, trial, answer) ? Severity::resolution : Severity::contract;
  return wrong;
}

/// A method may leave threads that wait for the next call. They are reported nevertheless.
Severity severity_of(SideEffect effect) {
  return effect == SideEffect::thread ? Severity::resolution : Severity::contract;
}

}  // namespace

std::optional<Finding> compare(Trial& trial, const Claim& claim, const MethodAnswer& answer) {
  if (auto wrong = compare_said(trial, claim, answer)) return wrong;
  if (answer.side_effect == SideEffect::none) return {};
  return Finding{FindingKind::side_effect, severity_of(answer.side_effect), margin_of(trial)};
}

std::optional<Finding> compare_statement(Trial& trial, Verdict stated) {
  return compare(trial, Claim{}, answered(stated));
}

bool same_answer(const MethodAnswer& x, const MethodAnswer& y) {
  if (x.failure == Failure::hang || y.failure == Failure::hang) return true;
  if (x.status != y.status || x.failure != y.failure) return false;
  if (x.status != Status::answered) return true;
  if (x.verdict != y.verdict || x.has_distance != y.has_distance || x.witness != y.witness) return false;
  if (x.at_least != y.at_least) return false;
  if (x.states_distance() && std::memcmp(&x.distance, &y.distance, sizeof x.distance) != 0) return false;
  return x.witness == CertificateKind::none ||
         (same_bits(x.head, y.head) && same_bits(x.tail, y.tail) && same_bits(x.other_head, y.other_head) &&
          same_bits(x.other_tail, y.other_tail) && same_hulls(x.hulls, y.hulls));
}

}  // namespace cyl
