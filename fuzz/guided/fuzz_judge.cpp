// SPDX-License-Identifier: MIT
#include "fuzz/guided/fuzz_judge.hpp"

#include "corpus/pairs/pair_numbers.hpp"
#include "fuzz/guided/counters.hpp"
#include "oracles/methods/own_answers.hpp"
#include "oracles/referee/shown_distance.hpp"
#include "oracles/trial/decidable_margin.hpp"

namespace cyl {
namespace {

/// Like the shares of fuzz_judge.hpp. A witness other than the truth's own is checked in the referee's
/// widest arithmetic if double does not prove it. This takes 0.1 ms.
constexpr std::size_t witness_share = 16;

RandomStream draws_of(const Pair& pair) {
  const auto numbers = numbers_of(pair);
  return {{reinterpret_cast<const char*>(numbers.data()), sizeof numbers}, 0, 0};
}

}  // namespace

FuzzJudge::FuzzJudge(const Pair& pair, std::span<const MethodAnswer> offered, bool must, FindingSink& sink,
                     bool finely)
    : trial_(pair, Truth{}), draws_(draws_of(pair)), sink_(sink) {
  trial_.truth = prove_in_double(trial_.pair, offered);
  if (trial_.truth.verdict == Verdict::invalid) return;
  if (trial_.truth.verdict == Verdict::undecided && (drawn(wide_share) || must))
    trial_.truth = prove_exactly(trial_.pair, offered, wide_bits_cap);
  measured_ = approximate_distance(trial_.pair);
  const Stratum stratum = count_geometry(trial_.pair, measured_, finely);
  if (trial_.truth.verdict == Verdict::undecided) sink_.add_undecided(trial_.pair, stratum);
  enclose_ = drawn(enclosed_share);
}

void FuzzJudge::record(const Method& method, MethodAnswer answer) {
  if (answer.status == Status::declined) return;
  if (answer.status == Status::answered &&
      (answer.verdict == Verdict::invalid) != (trial_.truth.verdict == Verdict::invalid)) {
    sink_.add_finding(trial_.pair, method.name(), "wrong_invalid", "the referee disagrees about `invalid`");
    return;
  }
  if (trial_.truth.verdict == Verdict::invalid) return;
  const bool promised = method.claim().decides != DecisionScope::not_promised;
  if (promised && answer.verdict == Verdict::undecided) return check_undecided(method, answer);
  if (answer.error_bound > 0) check_error_bound(method, answer);
  if (!enclose_) {
    answer.has_distance = false;
    if (std::fabs(measured_.value) < reach(method.claim(), size_of(trial_.pair))) return;
  }
  if (!drawn(witness_share)) answer.witness = CertificateKind::none;
  const auto finding = compare(trial_, method.claim(), answer);
  if (finding && finding->severity == Severity::contract)
    sink_.add_finding(trial_.pair, method.name(), to_string(finding->kind), "beyond its claim");
}

void FuzzJudge::check_undecided(const Method& method, const MethodAnswer& answer) {
  const double slack = estimated_margin(trial_.pair);
  count_badness(Badness::undecided, slack);
  if (slack < resolved_margin) return;
  if (trial_.truth.verdict == Verdict::undecided)
    trial_.truth = prove_exactly(trial_.pair, {}, wide_bits_cap);
  if (const auto finding = compare(trial_, method.claim(), answer))
    sink_.add_finding(trial_.pair, method.name(), to_string(finding->kind), "beyond its claim");
}

void FuzzJudge::check_error_bound(const Method& method, const MethodAnswer& answer) {
  const Pair& pair = trial_.pair;
  const Enclosure shown = shown_distance(pair, measured_of(distance(pair.a, pair.b)));
  if (!std::isfinite(shown.lo)) return;
  const Enclosure off = error_bound_of(shown, answer);
  count_badness(Badness::error, off.hi / answer.error_bound);
  if (answer.verdict == Verdict::disjoint)
    count_badness(Badness::bound, answer.error_bound / allowed_error(method.claim(), trial_.pair));
  if (off.hi > answer.error_bound)
    sink_.add_finding(trial_.pair, method.name(), to_string(FindingKind::distance_outside),
                      "points and direction do not prove the distance within the returned error");
}

}  // namespace cyl
