// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <map>
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

std::string attribute_text(const std::string& name) {
  return replaced(replaced(replaced(name, "&", "&amp;"), "<", "&lt;"), "\"", "&quot;");
}

/// No comment holds two hyphens in a row.
std::string comment_text(const std::string& words) { return "<!-- " + replaced(words, "--", "- -") + " -->"; }

/// What is said of two links: a line that disables them, or one that says why not.
struct Said {
  std::string reason;  ///< empty: they are not disabled
  std::string why;
};

class SrdfWriter {
 public:
  SrdfWriter(const Scene& scene, const SceneQuestion& q, const SceneStudy& s)
      : scene_(scene),
        q_(q),
        s_(s),
        rule_(scene, q.all_pairs, q.each_link),
        default_(place(scene, joints_at(scene))) {
    for (std::size_t i = 0; i < s.pairs.size(); ++i) checked_[links_of(s.pairs[i])].push_back(i);
    for (const Exemption& e : scene.exemptions) exempt_[std::minmax(e.a, e.b)] = &e;
    if (!s.motions) return;
    for (const ExemptionProof& proof : s.motions->exemptions) {
      const Exemption& e = scene.exemptions[proof.exemption];
      proofs_[std::minmax(e.a, e.b)] = &proof;
    }
  }

  std::string text() const {
    std::string out = fmt::format(
        "<?xml version=\"1.0\"?>\n{}\n<robot name=\"{}\">\n",
        comment_text(fmt::format("Pairs of links of {} that need no check, at a clearance of {}: {} "
                                 "configurations drawn, seed {}.",
                                 q_.file, q_.clearance, s_.configurations, q_.seed)),
        attribute_text(scene_.name.empty() ? "robot" : scene_.name));
    for (std::size_t b = 0; b < scene_.links.size(); ++b)
      for (std::size_t a = 0; a < b; ++a)
        if (scene_.links[a].shapes > 0 && scene_.links[b].shapes > 0) out += line({a, b});
    return out + "</robot>\n";
  }

 private:
  LinkPair links_of(const PairStudy& pair) const {
    return std::minmax(scene_.bodies[pair.a].link, scene_.bodies[pair.b].link);
  }

  std::string line(const LinkPair& links) const {
    const Said said = say(links);
    const std::string &a = scene_.links[links.first].name, &b = scene_.links[links.second].name;
    if (said.why.empty()) return "";
    if (said.reason.empty()) return fmt::format("  {}\n", comment_text(a + " - " + b + ": " + said.why));
    return fmt::format("  <disable_collisions link1=\"{}\" link2=\"{}\" reason=\"{}\"/>  {}\n",
                       attribute_text(a), attribute_text(b), attribute_text(said.reason),
                       comment_text(said.why));
  }

  Said say(const LinkPair& links) const {
    const Body a{"", links.first, {}, 1, 1}, b{"", links.second, {}, 1, 1};
    switch (rule_.reason(a, b)) {
      case PairRule::Reason::same_body:
        return {"Adjacent", "one rigid body"};
      case PairRule::Reason::adjacent:
        return {"Adjacent", "a joint joins them"};
      case PairRule::Reason::disabled:
        return say_disabled(links);
      case PairRule::Reason::checked:
        break;
    }
    return say_checked(links);
  }

  Said say_disabled(const LinkPair& links) const {
    const auto said = exempt_.find(links);
    if (said == exempt_.end()) return {"User", "as the file says"};
    const std::string from = "as " + scene_.srdf + " says";
    const auto proof = proofs_.find(links);
    if (proof == proofs_.end()) return {said->second->reason, from};
    if (proof->second->verdict == MotionVerdict::refuted)
      return {"", "NOT disabled " + from + ", which is refuted: " + exemption_text(scene_, *proof->second)};
    return {said->second->reason,
            from + "; " + to_string(proof->second->verdict) + ": " + exemption_text(scene_, *proof->second)};
  }

  Said say_checked(const LinkPair& links) const {
    const bool unknown = has_unknown_shapes(scene_, links.first) || has_unknown_shapes(scene_, links.second);
    const auto found = checked_.find(links);
    if (found == checked_.end()) return {"", unknown ? "shapes were not looked at" : ""};
    // What comes near of a solid that only holds a box or mesh shows nothing of these.
    const auto holds = [&](const PairStudy& pair) {
      return scene_.bodies[pair.a].box || scene_.bodies[pair.b].box;
    };
    bool never = true, known = true;
    for (const std::size_t i : found->second) {
      const PairStudy& pair = s_.pairs[i];
      known &= is_known(scene_, pair);
      if (pair.within == pair.samples && !holds(pair))
        return {"Always", fmt::format("all of {} draws: apart in below {} at 95 %", pair.samples,
                                      rate_text(pair.samples))};
      never &= pair.within == 0;
    }
    for (const std::size_t i : found->second)
      if (!holds(s_.pairs[i]) &&
          referee_within({default_[s_.pairs[i].a], default_[s_.pairs[i].b]}, q_.clearance) == true)
        return {"Default", "with the joints at 0, or at the limit nearest to it"};
    if (!known) return {"", "not disabled: they come near the bound of a box or mesh, so nothing is known"};
    if (!never) return {};
    if (unknown) return {"", "not disabled: shapes were not looked at"};
    for (const std::size_t i : found->second)
      if (!held_between(scene_, s_.pairs[i]).empty())
        return {"", "not disabled: a joint between them was not moved"};
    return say_never(found->second);
  }

  Said say_never(const std::vector<std::size_t>& pairs) const {
    std::size_t draws = s_.pairs[pairs[0]].samples;
    for (const std::size_t i : pairs) draws = std::min(draws, s_.pairs[i].samples);
    const std::string drawn =
        !moves(scene_) ? "nothing moves"
                       : fmt::format("{} draws without a hit: below {} at 95 %", draws, rate_text(draws));
    if (!s_.motions) return {"Never", drawn};
    const auto worst =
        std::ranges::min_element(pairs, {}, [&](std::size_t i) { return risk_of(s_.motions->pairs[i]); });
    const MotionProof& proof = s_.motions->pairs[*worst];
    const std::string proved = proof_text(scene_, proof);
    if (proof.verdict == MotionVerdict::never) return {"Never", "proved: " + proved};
    if (proof.verdict == MotionVerdict::open) return {"Never", drawn + "; " + proved};
    return {"", "not disabled: " + drawn + ", but " + proved};
  }

  const Scene& scene_;
  const SceneQuestion& q_;
  const SceneStudy& s_;
  PairRule rule_;
  std::vector<Cylinder> default_;
  std::map<LinkPair, std::vector<std::size_t>> checked_;  ///< the study's pairs of two links
  std::map<LinkPair, const Exemption*> exempt_;
  std::map<LinkPair, const ExemptionProof*> proofs_;
};

}  // namespace

std::string srdf_text(const Scene& scene, const SceneQuestion& q, const SceneStudy& s) {
  return SrdfWriter(scene, q, s).text();
}

}  // namespace cyl
