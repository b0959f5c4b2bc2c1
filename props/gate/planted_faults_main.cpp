// SPDX-License-Identifier: MIT
// The test of the gate: it must fail for each planted fault, by the law that the fault breaks, and pass
// without a fault. Exits with 1 and names each fault that the gate does not see.
#include <fmt/format.h>

#include <set>
#include <vector>

#include "props/gate/gate.hpp"
#include "props/gate/planted_faults.hpp"

namespace {

using namespace cyl;

/// So many rounds that luck plays no part with these faults.
constexpr GateAmount amount{.law_rounds = 2, .sample_rounds = 1, .close_law_rounds = 1, .close_rounds = 1};

/// The numbers of the laws that a method breaks beyond its claim, with this fault.
std::set<int> broken_laws(int fault, std::span<const Case> cases) {
  planted_fault = fault;
  GateOptions options;
  options.amount = amount;
  options.as_found = true;
  std::set<int> laws;
  for (const GateFailure& f :
       run_gate(select_methods(all_methods(), "intersect,decide,distance,exact"), cases, options).failures)
    if (is_error(f)) laws.insert(f.law->number);
  return laws;
}

}  // namespace

int main() {
  const std::vector<Case> cases = read_case_folder(DAYLIGHT_SOURCE_DIR "/corpus/cases");
  std::set<LawKind> kinds;
  int missed = 0, number = 0;
  for (const PlantedFault& fault : planted_faults()) {
    const std::set<int> broken = broken_laws(++number, cases);
    if (broken.contains(fault.law)) {
      kinds.insert(law_numbered(fault.law).kind);
      continue;
    }
    ++missed;
    fmt::print("law {} does not see fault {} in {}: {}\n", fault.law, number, fault.file, fault.what);
  }
  // Last, so that nothing that a fault leaves behind is missed.
  const bool passes = broken_laws(0, cases).empty();
  if (!passes) fmt::print("the gate fails without a fault\n");
  if (kinds.size() != 4) fmt::print("a kind of laws sees no fault\n");
  fmt::print("{} of {} faults detected\n", number - missed, number);
  return missed != 0 || !passes || kinds.size() != 4;
}
