// SPDX-License-Identifier: MIT
// A study of a scene as people read it and as a page is drawn from it.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "scenes/study/scene_study.hpp"

namespace cyl {

/// Returns the study as text, with the seed first. Pairs that are proved to stay clear over all motions are
/// listed if `every_pair`, else counted.
std::string study_text(const Scene& scene, const SceneOptions& question, const SceneStudy& study,
                       bool every_pair = false);

/// The sentences of `study_text`, for the page. A sentence is empty if it does not apply.
struct StudyWords {
  std::string counts;                 ///< "2 capsules, 1 mesh (not tested); 20 links, .."
  std::vector<std::string> left_out;  ///< "17 box (base, ...)"
  std::string pairs;                  ///< how many are checked, and why others are not
  std::string configurations;
  std::string enough;                 ///< for how many pairs spheres and capsules suffice
  std::string recommended;            ///< "spheres for 112 pairs, .."
  std::vector<std::string> remarks;   ///< on it: what is not known, not moved, not tested
  std::string cost;                   ///< "0.54 us per configuration, instead of .."
  std::string forgiven;               ///< false alarms that are tolerated
  std::string capsules;               ///< whether they may stand in for every cylinder
  std::vector<std::string> rounding;  ///< what some roundings would cost and save
  std::string closest;                ///< the closest call, and how exact an answer must be
  std::string verified;
  std::string motions;  ///< how many pairs are proved never to be within the clearance
};
StudyWords words_of(const Scene& scene, const SceneOptions& question, const SceneStudy& study);

/// Returns an SRDF that disables link pairs with one link that carries the other ("Adjacent") and link pairs
/// that are proved never to touch ("Never"). A comment states each proof. Other pairs that are not checked,
/// that the scene's own SRDF disables, or that are not known, have a comment why they are not disabled. The
/// study has `prove` and `prove_others`.
std::string srdf_text(const Scene& scene, const SceneOptions& question, const SceneStudy& study);

/// Returns the study with its words and the shown configurations (scenes/study/shown_pairs.hpp), as
/// reports/schemas/scene.json describes it; a page is drawn from it alone.
std::string study_json(const Scene& scene, const SceneOptions& question, const SceneStudy& study);

}  // namespace cyl
