// SPDX-License-Identifier: MIT
// Explains why one method fails on one pair. Names the ranges of the pair's properties in which it fails.
// Names the changes of the pair, or of the method's settings, that make it right.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "oracles/trial/compare.hpp"
#include "reports/explain/failing_region.hpp"

namespace cyl {

/// Returns the parameters on which the failure depends, and the ranges in which it lies, as in "angle 0.0093
/// to 0.045". An end of a range is given only if several samples inside fail and several beyond are right.
std::vector<std::string> supported_ranges(const std::vector<FailingRegion>& regions);

/// Returns a table of the ranges and a text with the cause that triage finds. Asks the method, contained,
/// about some 1,000 pairs. This takes a second, more for a slow method. A hang costs its limit of CPU time a
/// question, so a hang has neither. The same arguments give the same text. Throws UsageError if no method has
/// that name, or if it does not fail in this way on this pair now.
std::string explain(std::span<const std::unique_ptr<Method>> methods, std::string_view method,
                    FindingKind kind, const Pair& pair);

}  // namespace cyl
