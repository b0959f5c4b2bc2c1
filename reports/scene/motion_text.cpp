// SPDX-License-Identifier: MIT
#include "reports/scene/motion_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/safe_text.hpp"
#include "base/statistics.hpp"

namespace cyl {
namespace {

using Counts = std::array<std::size_t, enum_words<MotionVerdict>.size()>;

template <class Proofs>
Counts count_verdicts(const Proofs& proofs) {
  Counts counts{};
  for (const auto& proof : proofs) ++counts[static_cast<std::size_t>(proof.verdict)];
  return counts;
}

/// Returns why pairs are open: ": 2 after up to 100,000 boxes, 1 with a joint that is held".
std::string why_open(const std::vector<MotionProof>& proofs) {
  std::size_t bounded = 0, held = 0, late = 0, left = 0, boxes = 0;
  for (const MotionProof& proof : proofs) {
    if (proof.verdict != MotionVerdict::open || proof.contradicted) continue;
    std::size_t& count = proof.bounded ? bounded : proof.held ? held : proof.out_of_time ? late : left;
    ++count;
    if (&count == &left) boxes = std::max(boxes, proof.boxes);
  }
  std::vector<std::string> reasons;
  if (left > 0) reasons.push_back(fmt::format("{} after up to {}", left, counted(boxes, "box")));
  if (bounded > 0) reasons.push_back(fmt::format("{} near a bounding solid of a mesh or ellipsoid", bounded));
  if (held > 0) reasons.push_back(fmt::format("{} with a joint that is held", held));
  if (late > 0) reasons.push_back(fmt::format("{} because no time was left", late));
  return reasons.empty() ? "" : fmt::format(": {}", fmt::join(reasons, ", "));
}

/// Rounds down to three digits, so that the text does not claim more than is proved.
std::string rounded_down(double x) {
  if (!(x > 0)) return fmt::format("{:.3g}", x);
  const double unit = std::pow(10, std::floor(std::log10(x)) - 2);
  return fmt::format("{:.3g}", std::floor(x / unit) * unit);
}

/// Returns " --at shoulder=0.5 elbow=1", to paste behind the command.
std::string joints_text(const Scene& scene, const MotionProof& proof) {
  std::vector<std::string> values;
  for (std::size_t i = 0; i < proof.between.size(); ++i)
    values.push_back(
        fmt::format("{}={}", shell_quoted(scene.links[proof.between[i]].joint), proof.joints[i]));
  return values.empty() ? " as it stands" : fmt::format(" --at {}", fmt::join(values, " "));
}

}  // namespace

std::string proof_text(const Scene& scene, const MotionProof& proof) {
  switch (proof.verdict) {
    case MotionVerdict::never:
      return fmt::format("at least {} over all configurations, {:.3g} seen", rounded_down(proof.bound),
                         proof.least);
    case MotionVerdict::refuted:
      return fmt::format("{}distance {}{:.3g}{}", proof.always ? "in every configuration, " : "",
                         scene.bodies[proof.a].box || scene.bodies[proof.b].box ? "at most " : "",
                         proof.least, joints_text(scene, proof));
    case MotionVerdict::within:
      return fmt::format(
          "comes within the clearance: distance {:.3g}{}{}", proof.least, joints_text(scene, proof),
          proof.bound > 0
              ? fmt::format(", but never touches (proved: at least {})", rounded_down(proof.bound))
              : "");
    case MotionVerdict::open:
      break;
  }
  if (proof.contradicted)
    return fmt::format("a configuration is nearer than proved ({:.3g}), which is a fault of daylight",
                       proof.least);
  if (proof.bounded)
    return fmt::format("only the bounding solid of a mesh or ellipsoid comes near: {:.3g}{}", proof.least,
                       joints_text(scene, proof));
  if (proof.held)
    return fmt::format("a joint between them can move farther than it does here ({:.3g} seen)", proof.least);
  if (proof.out_of_time) return fmt::format("no time was left ({:.3g} seen)", proof.least);
  return fmt::format("nothing proved for {:.3g} % of the range of their {} joints ({:.3g} seen)",
                     100 * proof.open_share, proof.between.size(), proof.least);
}

std::pair<MotionVerdict, double> risk_of(const MotionProof& proof) {
  switch (proof.verdict) {
    case MotionVerdict::refuted:
    case MotionVerdict::within:
      return {proof.verdict, proof.least};
    case MotionVerdict::open:
      return {proof.verdict, -proof.open_share};
    case MotionVerdict::never:
      break;
  }
  return {proof.verdict, proof.bound};
}

std::string exemption_text(const Scene& scene, const ExemptionProof& exemption) {
  std::string text;
  if (!exemption.bodies.empty())
    text = proof_text(scene, *std::ranges::min_element(exemption.bodies, {}, risk_of));
  else if (!exemption.not_looked_at)
    text = "a link has no shape";
  if (exemption.not_looked_at) text += std::string(text.empty() ? "" : "; ") + "some shapes were not tested";
  return text;
}

std::string rate_text(std::size_t draws) {
  const double percent = 100 * error_rate_bound(draws, 0);
  const double unit = std::pow(10, std::floor(std::log10(percent)) - 1);
  return fmt::format("{:.3g} %", std::ceil(percent / unit * (1 - 1e-12)) * unit);
}

std::vector<std::string> verdict_lines(const SceneOptions& q, const SceneStudy& s) {
  const Counts pairs = count_verdicts(s.motions->pairs), exempt = count_verdicts(s.motions->exemptions);
  const auto count = [](const Counts& counts, MotionVerdict verdict) {
    return counts[static_cast<std::size_t>(verdict)];
  };
  std::vector<std::string> lines{
      fmt::format("never    {} of {}, proved over all motions to be farther apart than {} ({:.1f} s)",
                  count(pairs, MotionVerdict::never) + s.far, counted(s.pairs.size() + s.far, "pair"),
                  q.clearance, s.motions->ms / 1000),
      fmt::format("refuted  {}, each by a configuration in which they overlap or touch",
                  count(pairs, MotionVerdict::refuted))};
  if (q.clearance > 0)
    lines.push_back(fmt::format("within   {} come within the clearance, and no contact was found",
                                count(pairs, MotionVerdict::within)));
  lines.push_back(
      fmt::format("open     {}{}", count(pairs, MotionVerdict::open), why_open(s.motions->pairs)));
  if (s.motions->contradicted > 0)
    lines.push_back(
        fmt::format("NEARER THAN PROVED: {}, which is a fault of daylight. Nothing is claimed of these pairs",
                    s.motions->contradicted));
  if (!s.motions->exemptions.empty()) {
    const std::size_t near = count(exempt, MotionVerdict::within);
    lines.push_back(fmt::format(
        "\"Never\" in the SRDF, {}: {} proved{}, {} REFUTED, {} open",
        counted(s.motions->exemptions.size(), "link pair"), count(exempt, MotionVerdict::never) + near,
        near > 0 ? fmt::format(" ({} come within the clearance, but never touch)", near) : "",
        count(exempt, MotionVerdict::refuted), count(exempt, MotionVerdict::open)));
  }
  return lines;
}

std::vector<std::string> proof_lines(const Scene& scene, const SceneStudy& s, bool all) {
  std::vector<std::string> lines;
  if (!s.motions) return lines;
  std::vector<const ExemptionProof*> exemptions;
  for (const ExemptionProof& e : s.motions->exemptions)
    if (all || e.verdict == MotionVerdict::refuted || e.verdict == MotionVerdict::open)
      exemptions.push_back(&e);
  std::ranges::stable_sort(exemptions, {}, &ExemptionProof::verdict);
  for (const ExemptionProof* e : exemptions) {
    const Exemption& said = scene.exemptions[e->exemption];
    lines.push_back(fmt::format("  {:<8} {} - {}, \"Never\" in the SRDF: {}", to_string(e->verdict),
                                scene.links[said.a].name, scene.links[said.b].name,
                                exemption_text(scene, *e)));
  }
  std::vector<const MotionProof*> pairs;
  for (const MotionProof& proof : s.motions->pairs)
    if (all || proof.verdict != MotionVerdict::never) pairs.push_back(&proof);
  std::ranges::stable_sort(pairs, {}, [](const MotionProof* proof) { return risk_of(*proof); });
  for (const MotionProof* proof : pairs)
    lines.push_back(fmt::format("  {:<8} {} - {}: {}", to_string(proof->verdict), scene.bodies[proof->a].name,
                                scene.bodies[proof->b].name, proof_text(scene, *proof)));
  return lines;
}

}  // namespace cyl
