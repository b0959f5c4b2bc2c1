// SPDX-License-Identifier: MIT
// The mutants: this program with one fault planted, chosen at run time, to measure whether the harness
// catches faults. They are listed in props/mutants/mutants.jsonl; props/mutants/make_mutants.py writes the
// mutated copies of the sources that daylight-mutants is made of, and the table behind all_mutants(). The
// sources themselves, and so `daylight`, know nothing of it.
#pragma once

#include <span>
#include <string_view>

namespace cyl {

struct Mutant {
  int number;                   ///< > 0, kept for good
  std::string_view file;        ///< that holds the fault
  std::string_view what;        ///< the fault in words
  std::string_view like;        ///< its kind: operator class, or the code that had such a fault
  std::string_view asks;        ///< names of the methods that may betray it, as select_methods() takes them
  std::string_view tests;       ///< filter of the unit tests that may detect it; none if empty
  std::string_view equivalent;  ///< why no test can detect it; empty if a test can
};

/// Returns all mutants by number. Only daylight-mutants and its kin have it.
std::span<const Mutant> all_mutants();

/// Makes this process run the mutant of that number from here on; 0, the program as it is. At start it is the
/// number in the environment variable DAYLIGHT_MUTANT.
void select_mutant(int number) noexcept;

}  // namespace cyl
