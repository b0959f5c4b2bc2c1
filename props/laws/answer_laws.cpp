// SPDX-License-Identifier: MIT
// Laws 30 and on, about one answer by itself. If a law needs a proof, it uses the referee's.
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <initializer_list>

#include "corpus/pairs/pair_io.hpp"
#include "corpus/pairs/pair_numbers.hpp"
#include "corpus/pairs/truth_io.hpp"
#include "oracles/trial/decidable_margin.hpp"
#include "oracles/trial/finding_text.hpp"
#include "props/laws/law_groups.hpp"
#include "solver/decide.hpp"

namespace cyl {
namespace {

/// Returns the fault of one of these kinds that compare() finds in an answer to the pair.
std::optional<Violation> refuted(const LawCase& c, const MethodAnswer& answer,
                                 std::initializer_list<FindingKind> kinds) {
  Trial& proved = c.proofs.of(c.pair);
  Claim claim = c.method.claim();
  claim.decides = DecisionScope::not_promised;  // that is a law of its own
  const auto finding = compare(proved, claim, answer);
  if (!finding || std::find(kinds.begin(), kinds.end(), finding->kind) == kinds.end()) return {};
  std::string what = to_string(finding->kind);
  const std::string miss =
      finding->kind == FindingKind::bad_witness ? miss_in_words(c.pair, answer) : std::string();
  if (!miss.empty())
    what += ": " + miss;
  else if (finding->margin && finding->kind == FindingKind::distance_outside)
    what += fmt::format(", error {:.3g}", finding->margin->lo);
  else if (finding->margin)
    what += ", " + margin_in_words({finding->margin->lo, finding->margin->lo});
  Violation violation{std::move(what), finding->severity, finding->kind};
  const double size = size_of(c.pair);
  if (size > 0 && finding->margin && !is_failure(finding->kind) && miss.empty())
    violation.excess = finding->margin->lo - reach(claim, size) / size;
  return violation;
}

std::optional<Violation> break_answers(const LawCase& c) {
  if (c.first.status != Status::failed) return {};
  auto violation = refuted(c, c.first,
                           {FindingKind::exception, FindingKind::crash, FindingKind::hang,
                            FindingKind::non_finite, FindingKind::malformed, FindingKind::reported});
  if (violation) {
    const bool reported = violation->kind == FindingKind::reported;
    violation->what = fmt::format("{}: {}", reported ? "failed" : violation->what, c.first.reason);
    violation->reason = c.first.reason;
  }
  return violation;
}

// The verdict, the witness and the distance are laws of their own. So a fault in one hides no other. The
// proof of a distance is costly, and it is not asked for twice.

std::optional<Violation> break_verdict(const LawCase& c) {
  if (c.first.status != Status::answered) return {};
  MethodAnswer verdict = c.first;
  verdict.forget_distance();
  verdict.witness = CertificateKind::none;
  return refuted(c, verdict,
                 {FindingKind::wrong_disjoint, FindingKind::wrong_intersecting, FindingKind::wrong_touching,
                  FindingKind::wrong_invalid});
}

std::optional<Violation> break_certificate(const LawCase& c) {
  if (c.first.status != Status::answered || c.first.witness == CertificateKind::none) return {};
  MethodAnswer certificate = c.first;
  certificate.forget_distance();
  return refuted(c, certificate, {FindingKind::bad_witness});
}

std::optional<Violation> break_distance(const LawCase& c) {
  if (c.first.status != Status::answered || !c.first.states_distance()) return {};
  MethodAnswer distance = c.first;
  distance.verdict = Verdict::undecided;
  distance.witness = CertificateKind::none;
  return refuted(c, distance, {FindingKind::distance_outside, FindingKind::non_finite});
}

// A reported distance is off by the allowance at most, so its sign is known beyond the allowance. If it
// exceeds the allowance by the reach of the claim, the verdict is promised.
std::optional<Violation> break_sign(const LawCase& c) {
  if (!is_decided(c.first) || !c.first.has_distance) return {};
  const double apart = says_meet(c.first) ? c.first.distance : -c.first.distance;
  const double beyond = apart - distance_allowance(c, c.pair, c.first.distance);
  if (!(beyond > 0)) return {};
  return Violation{
      fmt::format("answers {} with the distance {}", to_string(c.first.verdict),
                  format_double(c.first.distance)),
      beyond >= reach(c.method.claim(), size_of(c.pair)) ? Severity::contract : Severity::resolution};
}

std::vector<LawQuery> again(const Method&, const Pair& pair, const MethodAnswer&) { return {{pair}, {pair}}; }

/// A thread costs more than all other laws. So one pair of this many is asked from a thread, drawn by its
/// digits.
constexpr std::uint64_t thread_share = 16;

std::vector<LawQuery> from_another_thread(const Method&, const Pair& pair, const MethodAnswer&) {
  std::uint64_t digits = 0;
  for (const double x : numbers_of(pair))
    digits = (digits ^ std::bit_cast<std::uint64_t>(x)) * 0x9e3779b97f4a7c15;
  if ((digits >> 32) % thread_share != 0) return {};
  return {{pair, CallMode::other_thread}};
}

/// A method that is no longer asked after many hangs declines. Such an answer shows nothing.
std::optional<Violation> break_sameness(const LawCase& c) {
  for (const MethodAnswer& second : c.answers) {
    if (second.status == Status::declined || same_answer(c.first, second)) continue;
    return Violation{
        fmt::format("first {}, then {}", format_method_answer(c.first), format_method_answer(second))};
  }
  return {};
}

std::vector<LawQuery> in_other_ways(const Method&, const Pair& pair, const MethodAnswer&) {
  return {{pair, CallMode::prepared}, {pair, CallMode::batch}};
}

std::optional<Violation> break_other_ways(const LawCase& c) {
  for (std::size_t i = 0; i < c.answers.size(); ++i) {
    const MethodAnswer& second = c.answers[i];
    if (second.status != Status::answered || second.verdict == c.first.verdict) continue;
    if (says_meet(second) && says_meet(c.first)) continue;
    return Violation{fmt::format("asked singly {}, {} {}", to_string(c.first.verdict),
                                 c.asked[i].mode == CallMode::batch ? "in a batch" : "prepared",
                                 to_string(second.verdict))};
  }
  return {};
}

std::optional<Violation> break_cap(const LawCase& c) {
  if (c.first.status != Status::answered || c.first.step_cap == 0 || c.first.steps <= c.first.step_cap)
    return {};
  return Violation{fmt::format("{} steps, at most {} are allowed", c.first.steps, c.first.step_cap)};
}

std::optional<Violation> break_resolution(const LawCase& c) {
  const DecisionScope promised = c.method.claim().decides;
  if (promised == DecisionScope::not_promised || c.first.status != Status::answered ||
      c.first.verdict != Verdict::undecided)
    return {};
  Trial& proved = c.proofs.of(c.pair);
  if (!must_decide(promised, proved)) return {};
  if (promised == DecisionScope::all)
    return Violation{fmt::format("undecided, but proved {}", to_string(proved.truth.verdict))};
  const double least = resolved_margin * size_of(c.pair);
  return Violation{
      proved.meets() ? fmt::format("undecided, but a ball of radius {:.3g} lies in both solids", least)
                     : fmt::format("undecided, but the gap is {:.3g}", magnitude_against(least, proved).lo)};
}

// Applies if the referee's proof is a direction, its own or one that a method offered.
std::optional<Violation> break_shown(const LawCase& c) {
  if (!is_decided(c.first) || !c.first.has_distance || !is_in_range(c.pair)) return {};
  const Certificate& proof = c.proofs.of(c.pair).truth.certificate;
  if (proof.kind != CertificateKind::direction || !proof.vector.in_doubles()) return {};
  const Vector3 u =
      (Vector3::Map(proof.vector.head.data()) + Vector3::Map(proof.vector.tail.data())).stableNormalized();
  const double shown = shown_by(c.pair, u);
  if (!(c.first.distance < shown - distance_allowance(c, c.pair, c.first.distance))) return {};
  return Violation{fmt::format("returns the distance {}, but a direction proves {}",
                               format_double(c.first.distance), format_double(shown))};
}

// Asked of methods whose witnesses settle most verdicts. The referee settles the rest by itself.
std::optional<Violation> break_proof(const LawCase& c) {
  if (!c.method.claim().certified || c.first.status != Status::answered ||
      c.first.witness == CertificateKind::none)
    return {};
  const Verdict with = c.proofs.of(c.pair).truth.verdict;
  for (const Verdict without : {judge(c.pair).verdict, judge_verdict(c.pair).verdict})
    if (with != without)
      return Violation{fmt::format("the referee proves {} with the returned witnesses, and {} without them",
                                   to_string(with), to_string(without))};
  return {};
}

/// The relative error of a product of two vectors, which takes three products and two sums, on either side.
constexpr double along_error = 16 * 0x1p-53;

std::optional<Violation> break_orientation(const LawCase& c) {
  if (!c.method.claim().from_a_to_b || c.first.status != Status::answered ||
      c.first.witness != CertificateKind::direction)
    return {};
  // In halves, since the centres may be far apart.
  const Vector3 delta = c.pair.b.center / 2 - c.pair.a.center / 2;
  const double along =
      delta.x() * c.first.head[0] + delta.y() * c.first.head[1] + delta.z() * c.first.head[2];
  const double length = Vector3::Map(c.first.head).norm() * delta.norm();
  if (!is_in_range(c.pair) || !(along < -along_error * length)) return {};
  return Violation{"the direction points from b to a"};
}

std::vector<LawQuery> spoilt(const Method& method, const Pair& pair, const MethodAnswer&) {
  if (!method.claim().reports_invalid) return {};
  std::vector<LawQuery> asked(2, LawQuery{pair});
  asked[0].pair.a.radius = -1;
  asked[1].pair.b.radius = -1;
  return asked;
}

std::optional<Violation> break_validity(const LawCase& c) {
  for (std::size_t i = 0; i < c.answers.size(); ++i)
    if (c.answers[i].status == Status::answered && c.answers[i].verdict != Verdict::invalid)
      return Violation{fmt::format("{}, although the radius of {} is -1", to_string(c.answers[i].verdict),
                                   i == 0 ? "a" : "b")};
  return {};
}

}  // namespace

std::vector<Law> answer_laws() {
  return {
      {30, LawKind::answer, "answers",
       "the method answers without a crash, exception, hang, NaN or meaningless value", "always", needs_none,
       break_answers},
      {31, LawKind::answer, "verdict", "no certificate refutes the verdict", "if the truth is proved",
       needs_none, break_verdict},
      {32, LawKind::answer, "certificate", "the returned direction or point proves the verdict",
       "if the method returns one and the truth is proved; beyond the claim if it claims never to be wrong",
       needs_none, break_certificate},
      {33, LawKind::answer, "distance", "the distance is within the proved bounds, up to the claim",
       "for methods with distances, if the truth is proved", needs_none, break_distance},
      {34, LawKind::answer, "sign", "the sign of the distance agrees with the verdict",
       "for methods with distances, if the distance is beyond the claim", needs_none, break_sign},
      {35, LawKind::answer, "again", "a second call returns the same answer, bit for bit", "always", again,
       break_sameness},
      {36, LawKind::answer, "thread", "a call from another thread returns the same answer, bit for bit",
       "on one pair of 16, selected by a hash of its digits", from_another_thread, break_sameness},
      {37, LawKind::answer, "ways", "prepared solids and a batch have the verdict of a single call",
       "for methods with such calls", in_other_ways, break_other_ways},
      {38, LawKind::answer, "cap", "the searches take at most their maximum number of steps",
       "for methods that report their steps (decide, distance)", needs_none, break_cap},
      {39, LawKind::answer, "resolves", "the answer is not undecided",
       "for intersect, decide and distance if the gap is at least 1e-13 of the size, or if a ball of that "
       "radius (for flat solids a disk or segment) lies in both; for exact if the referee proves a verdict",
       needs_none, break_resolution},
      {40, LawKind::answer, "orientation", "the returned direction points from a to b", "for our methods",
       needs_none, break_orientation},
      {41, LawKind::answer, "validity", "a negative radius of either solid makes the pair invalid",
       "for our methods", spoilt, break_validity},
      {42, LawKind::answer, "shown", "the distance is at least the gap that a certified direction proves",
       "for methods with distances, if the certificate is a direction; lengths from 2^-200 to 2^200",
       needs_none, break_shown},
      {43, LawKind::answer, "proof",
       "the referee proves the same verdict with and without the returned witnesses",
       "for methods that claim a proof of every verdict, if the method returns a witness", needs_none,
       break_proof},
  };
}

}  // namespace cyl
