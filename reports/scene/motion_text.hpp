// SPDX-License-Identifier: MIT
// The text of proofs over motions, and of draws without a hit.
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "scenes/study/scene_study.hpp"

namespace cyl {

/// Returns "at least 0.012 over all configurations, 0.0157 seen": the result of a proof, the configuration
/// that refutes it, or the part that is open.
std::string proof_text(const Scene& scene, const MotionProof& proof);
std::string exemption_text(const Scene& scene, const ExemptionProof& exemption);
/// Sorts the worst first. That is refuted, by distance, then open, by share, then proved, by bound.
std::pair<MotionVerdict, double> risk_of(const MotionProof& proof);

/// Returns "0.75 %": the upper bound at 95 % of a rate if none of these draws failed, rounded up.
std::string rate_text(std::size_t draws);

/// Returns how many pairs are never near, refuted and open, a line each, and the same of the link pairs that
/// the SRDF calls "Never". The study has proofs.
std::vector<std::string> verdict_lines(const SceneOptions& question, const SceneStudy& study);
/// Returns a line for each link pair that the SRDF calls "Never", then one for each pair, the worst first.
/// Proved pairs are among them if `all`.
std::vector<std::string> proof_lines(const Scene& scene, const SceneStudy& study, bool all);

}  // namespace cyl
