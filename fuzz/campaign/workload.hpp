// SPDX-License-Identifier: MIT
// What a campaign asks of whom, and what each of its indices stands for.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "corpus/pairs/families.hpp"
#include "corpus/pairs/pair_io.hpp"
#include "fuzz/campaign/schedule.hpp"
#include "oracles/methods/method.hpp"

namespace cyl {

/// Who is asked, and about what. Index i of a run is case i while there are cases; then the families take
/// turns (fuzz/campaign/schedule.hpp).
struct Workload {
  std::span<const std::unique_ptr<Method>> methods;
  std::span<const Family> families;
  std::span<const Case> cases;
  std::span<const unsigned> weights = {};  ///< of the families; none: all alike
};

/// Says what an index of a run stands for.
struct FamilyIndex {
  std::size_t family;   ///< 0: the cases; f: families[f - 1]
  std::uint64_t index;  ///< of the case, or of the family's own pairs
};
Schedule schedule_of(const Workload& workload);
FamilyIndex family_index_of(const Workload& workload, const Schedule& schedule, std::uint64_t index);
std::string family_name(const Workload& workload, std::size_t family);

/// Whether a method that is asked a share of the pairs, one in so many, is asked about that of an index:
/// drawn from seed and index, so that no family, and no turn of the families, is missed.
bool on_share(unsigned share, std::uint64_t seed, std::uint64_t index);

/// Returns whether a method is asked that is not ours.
bool any_foreign(const Workload& workload);

/// The family name of the cases.
inline constexpr const char* cases_family = "cases";

}  // namespace cyl
