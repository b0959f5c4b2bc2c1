// SPDX-License-Identifier: MIT
// The parts that all_laws() is put together from, a file a kind; and what they share. For the files of props/
// alone.
#pragma once

#include <optional>
#include <vector>

#include "props/laws.hpp"

namespace cyl {

std::vector<Law> exact_laws();
std::vector<Law> one_sided_laws();
std::vector<Law> approximate_laws();
std::vector<Law> answer_laws();

/// contract where the method promises its verdict on the pair and on all that was asked beside it, by proof;
/// else resolution.
Severity severity_of(const LawCase& c);

}  // namespace cyl
