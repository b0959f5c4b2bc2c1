// SPDX-License-Identifier: MIT
// A finding as a test in the maintainers' own framework.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "oracles/trial/trial.hpp"

namespace cyl {

/// gtest, doctest, catch2, boost, pytest and node.
const std::vector<std::string>& test_frameworks();

/// Returns daylight_test.cpp, test_daylight.py or daylight.test.mjs.
std::string framework_test_name(std::string_view framework);

/// Returns a test of `bool collide(a, b)`, or of `double signed_distance(a, b)` if the distance is what was
/// wrong, with the proof of the truth in its comment. `asked` is of decided truth, and has a finding.
std::string framework_test(std::string_view framework, const Trial& asked, const Method& method);

}  // namespace cyl
