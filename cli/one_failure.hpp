// SPDX-License-Identifier: MIT
// One method's failure on one pair, which can be explained and sent to who maintains the method.
#pragma once

#include <string>

#include "cli/guests.hpp"
#include "oracles/trial/compare.hpp"

namespace cyl {

struct OneFailure {
  std::string method;
  FindingKind kind;
  Pair pair;
};

/// Throws UsageError where the word is no kind of finding.
FindingKind kind_of_word(const std::string& word);

/// Writes what make_export() gives into the folder, and says on standard output what it wrote.
void export_failure(const Company& company, const OneFailure& failure, const std::string& folder);

}  // namespace cyl
