// SPDX-License-Identifier: MIT
// The core target: our solver, its laws and the referee on one record, and no foreign code. What is wrong is
// printed as a line of a case file; then the target aborts.
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "corpus/pair_io.hpp"
#include "fuzz/record.hpp"
#include "oracles/compare.hpp"
#include "oracles/method.hpp"
#include "oracles/referee.hpp"
#include "props/laws.hpp"

namespace cyl {
namespace {

[[noreturn]] void stop(const Pair& pair, const std::string& wrong) {
  Case c;
  c.pair = pair;
  c.source = "fuzz_core";
  c.note = wrong;
  std::fprintf(stderr, "%s\n", format_case(c).c_str());
  std::abort();
}

void run(const Pair& pair) {
  // `exact` is the referee again.
  static const auto methods = [] {
    auto own = own_methods();
    std::erase_if(own, [](const auto& method) { return method->name() == "exact"; });
    return own;
  }();
  std::vector<MethodAnswer> answers;
  for (const auto& method : methods) answers.push_back(method->ask(pair));

  // Two proofs of one pair, one from the solver's certificate, one from the referee's own search.
  const Truth truth = judge(pair, answers), unaided = judge(pair);
  if (truth.verdict != unaided.verdict && truth.verdict != Verdict::undecided &&
      unaided.verdict != Verdict::undecided &&
      (truth.verdict == Verdict::disjoint || unaided.verdict == Verdict::disjoint)) {
    stop(pair, std::string("the referee proves ") + to_string(truth.verdict) + " and " +
                   to_string(unaided.verdict));
  }

  LazyDistance distance([&](double width) { return enclose_distance(pair, truth, width); });
  for (std::size_t i = 0; i < methods.size(); ++i) {
    const std::string name(methods[i]->name());
    if ((answers[i].verdict == Verdict::invalid) != (truth.verdict == Verdict::invalid)) {
      stop(pair, name + " and the referee disagree about `invalid`");
    }
    const auto finding = compare(pair, truth, distance, methods[i]->claim(), answers[i]);
    if (finding && finding->severity == Severity::contract)
      stop(pair, name + ": " + to_string(finding->kind));
    for (const Law& law : all_laws()) {
      if (law.kind != LawKind::exact) continue;
      const auto broken = broken_by(*methods[i], law, pair);
      if (broken && broken->severity == Severity::contract)
        stop(pair, name + ", " + std::string(law.name) + ": " + broken->what);
    }
  }
}

}  // namespace
}  // namespace cyl

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size != cyl::record_size) return -1;  // newer engines keep no such input
  cyl::run(cyl::decode_record(std::span<const std::uint8_t, cyl::record_size>(data, cyl::record_size)));
  return 0;
}
