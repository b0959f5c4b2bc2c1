// SPDX-License-Identifier: MIT
// The data of the page about the stability of answers near failures.
#pragma once

#include <filesystem>
#include <memory>
#include <span>

#include "oracles/methods/method.hpp"
#include "reports/run/run_data.hpp"

namespace cyl {

/// Asks the methods along paths and near touching. Sets "paths", "backward" (of that sample and of the stored
/// findings of the run) and "builds" (from a file like bench/stability/builds.jsonl; empty without it) by
/// set_charts(). Foreign methods are contained.
void write_stability(RunData& run, std::span<const std::unique_ptr<Method>> methods,
                     const std::filesystem::path& builds);

}  // namespace cyl
