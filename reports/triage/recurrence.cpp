// SPDX-License-Identifier: MIT
#include "reports/triage/recurrence.hpp"

#include <algorithm>

#include "base/statistics.hpp"

namespace cyl {

// If the rate is the same everywhere, all meetings fall among n of N pairs with probability (n/N)^count. The
// other pairs are those in which the cause is missed.
RecurrenceOf recurrence_of(const Observation& here, std::span<const Observation> earlier,
                           std::size_t compared) {
  if (here.asked == 0) return {};
  Observation before, since;  // up to the last run that met it, and after that run
  bool looked_for = false, met_in_last = false;
  for (const Observation& run : earlier) {
    if (run.asked == 0) continue;
    looked_for = true;
    met_in_last = run.count > 0;
    since.asked += run.asked;
    if (!met_in_last) continue;
    before.count += run.count;
    before.asked += since.asked;
    since.asked = 0;
  }
  const auto chance_of = [&](std::uint64_t count, std::uint64_t met, std::uint64_t missed) {
    return std::min(1.0, static_cast<double>(compared) * chance_of_all_in(count, met, met + missed));
  };
  if (here.count == 0) {
    if (!met_in_last) return {};
    const double chance = chance_of(before.count, before.asked, here.asked);
    return {chance < chance_margin ? Recurrence::gone : Recurrence::rare, chance};
  }
  if (!looked_for) return {Recurrence::fresh, {}};
  if (met_in_last) return {Recurrence::known, {}};
  if (before.count == 0) {
    const double chance = chance_of(here.count, here.asked, since.asked);
    return {chance < chance_margin ? Recurrence::fresh : Recurrence::rare, chance};
  }
  const double chance = chance_of(before.count + here.count, before.asked + here.asked, since.asked);
  if (chance < chance_margin) return {Recurrence::back, chance};
  return {Recurrence::known, {}};
}

}  // namespace cyl
