// SPDX-License-Identifier: MIT
// The core target: our solver, its laws and the referee on one record, and no foreign code but the exact
// arithmetic. A run is to cost microseconds: what is dear is asked on a share of the records, drawn by the
// record itself, and what stays unproved is kept for those who have time.
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "corpus/random_stream.hpp"
#include "fuzz/counters.hpp"
#include "fuzz/ledger.hpp"
#include "fuzz/record.hpp"
#include "oracles/compare.hpp"
#include "oracles/method.hpp"
#include "oracles/referee.hpp"
#include "props/laws.hpp"
#include "solver/decide.hpp"
#include "solver/distance.hpp"

namespace cyl {
namespace {

/// Once in how many records the dear questions are asked: set so that each costs less than the cheap ones
/// together.
constexpr std::size_t law_share = 4;            ///< one law of one method, needing no proof: 10 us
constexpr std::size_t unaided_share = 16;       ///< the referee without a witness, in double: 5 us
constexpr std::size_t wide_share = 128;         ///< the referee beyond double: 0.3 ms
constexpr std::size_t enclosed_share = 1024;    ///< the distance, enclosed: 1 ms, at the worst 100
constexpr std::size_t proved_law_share = 4096;  ///< a law that needs proofs: as many enclosures as it asks

/// Precisions at which the referee stops: in double, and after one round of MPFI.
constexpr int filter_bits_cap = 53, wide_bits_cap = 128;

constexpr std::size_t method_count = 3;
using Methods = std::vector<std::unique_ptr<Method>>;
using Answers = std::array<MethodAnswer, method_count>;

class Core {
 public:
  Core() : methods_(own_methods()), ledger_("fuzz_core") {
    std::erase_if(methods_,
                  [](const auto& method) { return method->name() == "exact"; });  // the referee again
    for (const Law& law : all_laws()) {
      const bool cheap = law.kind == LawKind::exact || law.kind == LawKind::one_sided;
      (cheap ? cheap_laws_ : proved_laws_).push_back(&law);
    }
  }

  void run(const Record& record) {
    const Pair pair = decode_record(record);
    RandomStream draws(std::string_view(reinterpret_cast<const char*>(record.data()), record.size()), 0, 0);
    const auto drawn = [&](std::size_t share) { return draws.below(share) == 0; };

    Answers answers;
    for (std::size_t m = 0; m < methods_.size(); ++m) answers[m] = methods_[m]->ask(pair);

    Truth truth = judge(pair, answers, filter_bits_cap);
    for (std::size_t m = 0; m < methods_.size(); ++m)
      if ((answers[m].verdict == Verdict::invalid) != (truth.verdict == Verdict::invalid))
        report(pair, m, "wrong_invalid", "the referee disagrees about `invalid`");
    if (truth.verdict == Verdict::invalid) return;

    const Distance measured = distance(pair.a, pair.b);
    count_geometry(pair, measured);
    count_iterations(decide(pair.a, pair.b).iterations);

    // What `decide` says is a proof by its own word: it is held to it always.
    if (truth.verdict == Verdict::undecided &&
        (answers[1].verdict != Verdict::undecided || drawn(wide_share)))
      truth = judge(pair, answers, wide_bits_cap);
    count_stage(truth);
    if (truth.verdict == Verdict::undecided) ledger_.add_undecided(pair, stratum_of(pair, measured));

    // Two proofs of one pair, one from the solver's certificate, one from the referee's own search.
    if (drawn(unaided_share)) {
      const Truth unaided = judge(pair, {}, filter_bits_cap);
      if (unaided.verdict != truth.verdict && unaided.verdict != Verdict::undecided &&
          truth.verdict != Verdict::undecided &&
          (truth.verdict == Verdict::disjoint || unaided.verdict == Verdict::disjoint))
        ledger_.add_finding(
            pair, "referee", "contradiction",
            std::string("proves ") + to_string(truth.verdict) + " and " + to_string(unaided.verdict));
    }

    const bool enclose = drawn(enclosed_share);
    LazyDistance enclosed([&](double width) { return enclose_distance(pair, truth, width); });
    for (std::size_t m = 0; m < methods_.size(); ++m) {
      MethodAnswer& answer = answers[m];
      if (!enclose) {
        answer.has_distance = false;
        // Whether a wrong verdict is within the claim takes an enclosure; here the measured distance says it.
        if (std::fabs(measured.value) < reach(methods_[m]->claim(), size_of(pair))) continue;
      }
      const auto finding = compare(pair, truth, enclosed, methods_[m]->claim(), answer);
      if (finding && finding->severity == Severity::contract)
        report(pair, m, to_string(finding->kind), "beyond its claim");
    }

    if (drawn(law_share)) hold(pair, cheap_laws_, draws);
    if (drawn(proved_law_share)) hold(pair, proved_laws_, draws);
  }

 private:
  void hold(const Pair& pair, const std::vector<const Law*>& laws, RandomStream& draws) {
    if (laws.empty()) return;
    const Law& law = *laws[draws.below(laws.size())];
    const std::size_t m = draws.below(methods_.size());
    const auto broken = broken_by(*methods_[m], law, pair);
    if (broken && broken->severity == Severity::contract) report(pair, m, law.name, broken->what);
  }

  void report(const Pair& pair, std::size_t m, std::string_view failure, std::string_view what) {
    ledger_.add_finding(pair, methods_[m]->name(), failure, what);
  }

  Methods methods_;
  std::vector<const Law*> cheap_laws_, proved_laws_;
  Ledger ledger_;
};

}  // namespace
}  // namespace cyl

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size != cyl::record_size) return -1;  // newer engines keep no such input
  static cyl::Core core;
  cyl::Record record;
  std::copy_n(data, size, record.begin());
  core.run(record);
  return 0;
}
