// SPDX-License-Identifier: MIT
// What the page shows of the stability of answers where methods fail.
#pragma once

#include <filesystem>
#include <memory>
#include <span>

#include "oracles/methods/method.hpp"
#include "reports/run/run_data.hpp"

namespace cyl {

/// Asks the methods along paths and next to touching, and sets "paths", "backward" (of that sample and of the
/// findings that the run has kept) and "builds" (from a file like bench/stability/builds.jsonl; empty without
/// it) as set_charts() does. Foreign methods are contained.
void write_stability(RunData& run, std::span<const std::unique_ptr<Method>> methods,
                     const std::filesystem::path& builds);

}  // namespace cyl
