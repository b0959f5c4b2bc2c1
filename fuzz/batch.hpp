// SPDX-License-Identifier: MIT
// One batch of a campaign: a stretch of indices, asked, judged and compared. A pure function of its
// arguments, times and kind `hang` excepted; where a campaign is cut into batches does not show in what it
// finds.
#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "corpus/families.hpp"
#include "corpus/pair_io.hpp"
#include "corpus/store.hpp"
#include "oracles/method.hpp"

namespace cyl {

/// Who is asked, and about what. Index i of a run is case i while there are cases; then the families take
/// turns.
struct Subjects {
  std::span<const std::unique_ptr<Method>> methods;
  std::span<const Family> families;
  std::span<const Case> cases;
};

/// Rows of the tally and the findings that are no method's: the cases' own statements of truth, the judge.
inline constexpr const char* corpus_row = "corpus";
inline constexpr const char* referee_row = "referee";
/// The family name of the cases.
inline constexpr const char* cases_family = "cases";

/// Our methods are asked twice on every index divisible by this: often enough to catch a method that keeps
/// state, at 2 % of the cost.
inline constexpr std::uint64_t repeat_share = 64;

/// Own methods are asked in this process, foreign ones contained. A costly method (share() > 1) is asked on
/// the indices divisible by its share and wherever the others' verdicts differ among themselves or from the
/// truth.
BatchRecord run_batch(const Subjects& subjects, std::uint64_t seed, std::uint64_t first, std::uint64_t next);

}  // namespace cyl
