// SPDX-License-Identifier: MIT
// What a study says of proofs over motions, and of draws without a hit.
#pragma once

#include <cstddef>
#include <string>
#include <utility>

#include "scenes/scene_study.hpp"

namespace cyl {

/// "at least 0.012 over all configurations, 0.0157 seen": what a proof says, or where it is refuted, or how
/// much is open.
std::string proof_text(const Scene& scene, const MotionProof& proof);
std::string exemption_text(const Scene& scene, const ExemptionProof& exemption);
/// Sorts what is worst first: refuted, by distance; open, by share; proved, by bound.
std::pair<MotionVerdict, double> risk_of(const MotionProof& proof);

/// "0.75 %": the rate that so many draws of which none failed leave possible at 95 %, rounded up.
std::string rate_text(std::size_t draws);

/// Returns how many pairs are proved, and how many pairs of links that an SRDF says never meet; empty where
/// no proof was asked for.
std::string motions_words(const SceneOptions& question, const SceneStudy& study);
/// Returns a line for each pair of links that an SRDF says never meet, and one for each pair, worst first.
/// Without `every_pair`, pairs that are proved to stay clear are counted in one line.
std::string motions_text(const Scene& scene, const SceneStudy& study, bool every_pair);

}  // namespace cyl
