// SPDX-License-Identifier: MIT
// The time of a method's call.
#pragma once

#include <memory>
#include <optional>

#include "oracles/methods/method.hpp"

namespace cyl {

/// In ns: CPU time of this process, and time in all, which counts what another process does for a guest.
double cpu_clock();
double wall_clock();

/// Returns a method that asks `method` a few times about each pair. Its distance is the least time of a call.
std::unique_ptr<Method> timed(Method& method, double (*clock)());

/// The method's usual time of a call: the median over pairs of family `random`, each the least of a few
/// calls. Nothing if it answers none.
std::optional<double> usual_ns(const std::unique_ptr<Method>& method, double (*clock)() = cpu_clock);

}  // namespace cyl
