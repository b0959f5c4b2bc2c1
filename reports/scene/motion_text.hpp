// SPDX-License-Identifier: MIT
// The text of proofs over motions, and of draws without a hit.
#pragma once

#include <cstddef>
#include <string>
#include <utility>

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

/// Returns how many pairs are proved, and how many link pairs that the SRDF calls "Never". Empty if no proof
/// was wanted.
std::string motions_words(const SceneOptions& question, const SceneStudy& study);
/// Returns a line for each link pair that the SRDF calls "Never", and one for each pair, worst first. Without
/// `every_pair`, one line counts the pairs that are proved to stay clear.
std::string motions_text(const Scene& scene, const SceneStudy& study);

}  // namespace cyl
