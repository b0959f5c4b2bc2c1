// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <string_view>

#include "reports/scene/motion_text.hpp"
#include "reports/scene/scene_report.hpp"

namespace cyl {
namespace {

using LinkPair = std::pair<std::size_t, std::size_t>;

std::string replaced(std::string text, std::string_view what, std::string_view with) {
  for (std::size_t at = text.find(what); at != text.npos; at = text.find(what, at + with.size()))
    text.replace(at, what.size(), with);
  return text;
}

/// Readers of XML turn a line break or a tab in an attribute into a space, which would change the name.
std::string attribute_text(std::string name) {
  for (const auto& [what, with] : {std::pair{"&", "&amp;"},
                                   {"<", "&lt;"},
                                   {"\"", "&quot;"},
                                   {"\n", "&#10;"},
                                   {"\r", "&#13;"},
                                   {"\t", "&#9;"}})
    name = replaced(name, what, with);
  return name;
}

/// A comment of XML must not contain two hyphens in a row. The first round leaves two if there are three.
std::string comment_text(const std::string& words) {
  const std::string plain = replaced(words, " --at ", " at ");
  return "<!-- " + replaced(replaced(plain, "--", "- -"), "--", "- -") + " -->";
}

class SrdfWriter {
 public:
  SrdfWriter(const Scene& scene, const SceneOptions& q, const SceneStudy& s)
      : scene_(scene), q_(q), rule_(scene) {
    for (const Exemption& e : scene.exemptions) exempt_[std::minmax(e.a, e.b)] = &e;
    for (const PairStudy& pair : s.pairs) checked_.insert(links_of(pair.a, pair.b));
    if (!s.motions) return;
    for (const MotionProof& proof : s.motions->pairs) proofs_[links_of(proof.a, proof.b)].push_back(&proof);
    for (const MotionProof& proof : s.motions->others) proofs_[links_of(proof.a, proof.b)].push_back(&proof);
    for (const ExemptionProof& e : s.motions->exemptions)
      for (const MotionProof& proof : e.bodies) proofs_[links_of(proof.a, proof.b)].push_back(&proof);
  }

  std::string text() const {
    std::string out = fmt::format(
        "<?xml version=\"1.0\"?>\n{}\n<robot name=\"{}\">\n",
        comment_text(fmt::format(
            "Pairs of links of {} that need no check, because one carries the other, or because they "
            "are proved to touch in no motion or in all motions. The clearance is {}.",
            q_.file, q_.clearance)),
        attribute_text(scene_.name.empty() ? "robot" : scene_.name));
    for (std::size_t b = 0; b < scene_.links.size(); ++b)
      for (std::size_t a = 0; a < b; ++a)
        if (scene_.links[a].shapes > 0 && scene_.links[b].shapes > 0) out += line({a, b});
    return out + "</robot>\n";
  }

 private:
  LinkPair links_of(std::size_t a, std::size_t b) const {
    return std::minmax(scene_.bodies[a].link, scene_.bodies[b].link);
  }

  /// Returns the proof of two shapes of the links that overlap in every configuration, or nullptr.
  const MotionProof* overlap_for_ever(const LinkPair& links) const {
    const auto found = proofs_.find(links);
    if (found == proofs_.end()) return nullptr;
    const auto always = std::ranges::find(found->second, true, &MotionProof::always);
    return always == found->second.end() ? nullptr : *always;
  }

  /// Returns the line that disables two links, or a comment why not. Empty if a checked pair meets.
  std::string line(const LinkPair& links) const {
    const bool wanted = are_paired(links);
    if (carries_directly(scene_, links.first, links.second) && !wanted)
      return disabled(links, "Adjacent", "one carries the other");
    const auto found = proofs_.find(links);
    if (const MotionProof* proof = overlap_for_ever(links); proof && !wanted) {
      const bool rigid =
          rule_.reason(scene_.bodies[proof->a], scene_.bodies[proof->b]) == PairRule::Reason::same_body;
      return disabled(links, rigid ? "Default" : "Always",
                      (rigid ? "proved: of one rigid body, " : "proved: ") + proof_text(scene_, *proof));
    }
    if (has_unknown_shapes(scene_, links.first) || has_unknown_shapes(scene_, links.second))
      return enabled(links, "some shapes were not tested");
    // Links are disabled only if each pair of their shapes has a proof.
    if (found == proofs_.end() || found->second.size() < bodies_on(links.first) * bodies_on(links.second))
      return enabled(links, "nothing is proved");
    const MotionProof& worst = **std::ranges::min_element(
        found->second, {}, [](const MotionProof* proof) { return risk_of(*proof); });
    const std::string words = proof_text(scene_, worst);
    if (std::ranges::all_of(found->second, [](const MotionProof* proof) { return proof->bound > 0; }))
      return disabled(links, "Never", "proved: " + words);
    if (worst.verdict <= MotionVerdict::within && checked_.contains(links)) return "";
    return enabled(links, fmt::format("{}: {}", to_string(worst.verdict), words));
  }

  /// Whether the file asks to check two of their shapes, even if the links are neighbours.
  bool are_paired(const LinkPair& links) const {
    return std::ranges::any_of(scene_.bodies, [&](const Body& a) {
      return a.link == links.first && std::ranges::any_of(scene_.bodies, [&](const Body& b) {
               return b.link == links.second && std::ranges::find(a.paired, b.name) != a.paired.end();
             });
    });
  }

  std::size_t bodies_on(std::size_t link) const {
    return static_cast<std::size_t>(std::ranges::count(scene_.bodies, link, &Body::link));
  }

  std::string disabled(const LinkPair& links, const char* reason, const std::string& why) const {
    return fmt::format("  <disable_collisions link1=\"{}\" link2=\"{}\" reason=\"{}\"/>  {}\n",
                       attribute_text(scene_.links[links.first].name),
                       attribute_text(scene_.links[links.second].name), reason, comment_text(why));
  }

  std::string enabled(const LinkPair& links, const std::string& why) const {
    const auto said = exempt_.find(links);
    const std::string against = said == exempt_.end() ? ""
                                                      : fmt::format(", although {} has the reason \"{}\"",
                                                                    scene_.srdf, said->second->reason);
    return fmt::format("  {}\n",
                       comment_text(fmt::format("{} - {}: not disabled{}: {}", scene_.links[links.first].name,
                                                scene_.links[links.second].name, against, why)));
  }

  const Scene& scene_;
  const SceneOptions& q_;
  const PairRule rule_;
  std::set<LinkPair> checked_;
  std::map<LinkPair, std::vector<const MotionProof*>> proofs_;
  std::map<LinkPair, const Exemption*> exempt_;
};

}  // namespace

std::string srdf_text(const Scene& scene, const SceneOptions& q, const SceneStudy& s) {
  return SrdfWriter(scene, q, s).text();
}

}  // namespace cyl
