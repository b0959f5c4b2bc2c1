// SPDX-License-Identifier: MIT
// A study of a scene as text, as JSON and as SRDF.
#pragma once

#include <string>

#include "scenes/study/scene_study.hpp"

namespace cyl {

/// Returns the study as text: the verdict, the pairs that are refuted or open, then which models suffice. It
/// has at most 40 lines, unless `table` adds every pair and every model.
std::string study_text(const Scene& scene, const SceneOptions& question, const SceneStudy& study,
                       bool table = false);

/// Returns an SRDF that disables link pairs with one link that carries the other ("Adjacent"). It also
/// disables link pairs that are proved never to touch ("Never") or to overlap for ever ("Default", "Always").
/// A comment states each proof. Other pairs that are not checked, that the scene's own SRDF disables, or that
/// are not known, have a comment why they are not disabled. The study has `prove` and `prove_others`.
std::string srdf_text(const Scene& scene, const SceneOptions& question, const SceneStudy& study);

/// Returns the study as reports/schemas/scene.json describes it.
std::string study_json(const Scene& scene, const SceneOptions& question, const SceneStudy& study);

}  // namespace cyl
