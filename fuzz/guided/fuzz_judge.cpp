// SPDX-License-Identifier: MIT
#include "fuzz/guided/fuzz_judge.hpp"

#include "fuzz/guided/counters.hpp"
#include "fuzz/guided/visited.hpp"

namespace cyl {
namespace {

/// As the shares of brief.hpp: a witness that is not the truth's own, looked at in the referee's widest
/// arithmetic where double does not prove it. 0.1 ms.
constexpr std::size_t witness_share = 16;

std::string_view text(const Record& record) {
  return {reinterpret_cast<const char*>(record.data()), record.size()};
}

}  // namespace

Brief::Brief(const Record& record, std::span<const MethodAnswer> offered, bool must, Ledger& ledger,
             const Distance* measured)
    : pair_(decode_record(record)),
      draws_(text(record), 0, 0),
      ledger_(ledger),
      truth_(judge(pair_, offered, filter_bits_cap)),
      enclosed_([this](double width) { return enclose_distance(pair_, truth_, width); }) {
  ++visited().executions;
  if (truth_.verdict == Verdict::invalid) return;
  if (truth_.verdict == Verdict::undecided && (drawn(wide_share) || must))
    truth_ = judge(pair_, offered, wide_bits_cap);
  measured_ = measured ? *measured : distance(pair_.a, pair_.b);
  const Stratum stratum = count_geometry(pair_, measured_);
  count_stage(truth_);
  if (truth_.verdict == Verdict::undecided) ledger_.add_undecided(pair_, stratum);
  enclose_ = drawn(enclosed_share);
}

void Brief::hold(const Method& method, MethodAnswer answer) {
  if (answer.status == Status::answered &&
      (answer.verdict == Verdict::invalid) != (truth_.verdict == Verdict::invalid)) {
    ledger_.add_finding(pair_, method.name(), "wrong_invalid", "the referee disagrees about `invalid`");
    return;
  }
  if (truth_.verdict == Verdict::invalid) return;
  if (!enclose_) {
    answer.has_distance = false;
    if (std::fabs(measured_.value) < reach(method.claim(), size_of(pair_))) return;
  }
  if (!drawn(witness_share)) answer.witness = WitnessKind::none;
  const auto finding = compare(pair_, truth_, enclosed_, method.claim(), answer);
  if (finding && finding->severity == Severity::contract)
    ledger_.add_finding(pair_, method.name(), to_string(finding->kind), "beyond its claim");
}

}  // namespace cyl
