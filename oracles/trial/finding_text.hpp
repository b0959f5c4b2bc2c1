// SPDX-License-Identifier: MIT
// What a finding holds as JSON, in words for people. Never throws on content: what cannot be read is left
// out.
#pragma once

#include <string>
#include <string_view>

namespace cyl {

struct TruthWords {
  std::string verdict;      ///< "disjoint", ...
  std::string certificate;  ///< "A plane with normal (1, 0, 0) separates them ..."
};

/// From the JSON object of a proved truth: {"verdict":"disjoint","direction":[x,y,z],...}.
TruthWords describe_truth(std::string_view json);

}  // namespace cyl
