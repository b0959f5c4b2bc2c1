// SPDX-License-Identifier: MIT
// The core target: our solver, its laws and the referee on one pair, and no foreign code but the exact
// arithmetic.
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "fuzz/guided/fuzz_judge.hpp"
#include "fuzz/guided/record.hpp"
#include "props/laws/laws.hpp"

namespace cyl {
namespace {

/// Pairs for one in which a question is asked, as in fuzz_judge.hpp.
constexpr std::size_t law_share = 4;            ///< one law of one method, needing no proof: 10 us
constexpr std::size_t unaided_share = 16;       ///< the referee without a witness, in double: 5 us
constexpr std::size_t proved_law_share = 4096;  ///< a law that needs proofs: as many enclosures as it asks

class Core {
 public:
  Core() : methods_(own_methods()) {
    std::erase_if(methods_,
                  [](const auto& m) { return m->claim().decides == DecisionScope::all; });  // the referee
    for (const Law& law : all_laws()) {
      const bool cheap = law.kind == LawKind::exact || law.kind == LawKind::one_sided;
      (cheap ? cheap_laws_ : proved_laws_).push_back(&law);
    }
    answers_.resize(methods_.size());
  }

  void run(const Pair& pair) {
    bool promised = false;  // a verdict by a method that promises to be right everywhere is looked into
    for (std::size_t m = 0; m < methods_.size(); ++m) {
      answers_[m] = methods_[m]->ask(pair);
      const Claim claim = methods_[m]->claim();
      promised |= claim.relative == 0 && claim.absolute == 0 && answers_[m].verdict != Verdict::undecided;
    }
    FuzzJudge fuzz_judge(pair, answers_, promised, sink_);
    for (std::size_t m = 0; m < methods_.size(); ++m) fuzz_judge.record(*methods_[m], answers_[m]);
    if (fuzz_judge.truth().verdict == Verdict::invalid) return;
    if (fuzz_judge.drawn(unaided_share)) judge_unaided(fuzz_judge);
    if (fuzz_judge.drawn(law_share)) check_law(fuzz_judge, cheap_laws_);
    if (fuzz_judge.drawn(proved_law_share)) check_law(fuzz_judge, proved_laws_);
  }

 private:
  // Proofs of one pair: from the solver's certificate, and from the referee's own search, in double and now
  // and then exactly.
  void judge_unaided(FuzzJudge& fuzz_judge) {
    const Verdict known = fuzz_judge.truth().verdict;
    check_agree(fuzz_judge.pair(), known, prove_in_double(fuzz_judge.pair()).verdict);
    if (fuzz_judge.drawn(wide_share / unaided_share))
      check_agree(fuzz_judge.pair(), known, prove_exactly(fuzz_judge.pair(), {}, wide_bits_cap).verdict);
  }

  void check_agree(const Pair& pair, Verdict one, Verdict other) {
    if (one == other || one == Verdict::undecided || other == Verdict::undecided) return;
    if (one != Verdict::disjoint && other != Verdict::disjoint) return;
    sink_.add_broken(pair, "referee", "contradiction",
                     std::string("proves ") + to_string(one) + " and " + to_string(other));
  }

  void check_law(FuzzJudge& fuzz_judge, const std::vector<const Law*>& laws) {
    if (laws.empty()) return;
    const Law& law = *laws[fuzz_judge.draws().below(laws.size())];
    Method& method = *methods_[fuzz_judge.draws().below(methods_.size())];
    const auto broken = violation_of(method, law, fuzz_judge.pair());
    if (broken && broken->severity == Severity::contract)
      sink_.add_broken(fuzz_judge.pair(), method.name(), law.name, broken->what);
  }

  std::vector<std::unique_ptr<Method>> methods_;
  std::vector<const Law*> cheap_laws_, proved_laws_;
  std::vector<MethodAnswer> answers_;
  FindingSink sink_;
};

}  // namespace
}  // namespace cyl

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto pair = cyl::decode_record({data, size});
  if (!pair) return -1;  // newer engines keep no such input
  static cyl::Core core;
  core.run(*pair);
  return 0;
}
