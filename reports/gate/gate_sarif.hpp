// SPDX-License-Identifier: MIT
// The gate's result as SARIF 2.1.0, the form in which code hosts take findings: a rule a law, a result a
// failure.
#pragma once

#include <string>
#include <string_view>

#include "props/gate/gate.hpp"

namespace cyl {

/// `version` is that of daylight; `compared`: there was a base (--against), so each result is new or
/// unchanged. Errors (contract, luck) have the level error, all others note. An invocation that did not ask
/// all has a notification a line of it, and is no success.
std::string gate_sarif(const GateReport& report, std::string_view version, bool compared);

}  // namespace cyl
