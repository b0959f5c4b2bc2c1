// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "reports/scene_study.hpp"

namespace cyl {
namespace {

std::size_t index_of(Rung rung) { return static_cast<std::size_t>(rung); }

std::string plural(std::size_t n, const char* what) {
  return fmt::format("{} {}{}", n, what, n == 1 ? "" : "s");
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

/// "3 boxes, ..." would hide which: each kind with the links that have it.
std::string left_out_text(const Scene& scene) {
  std::map<std::string, std::vector<std::string>> by_kind;
  for (const std::string& shape : scene.left_out) {
    const auto of = shape.find(" of ");
    by_kind[shape.substr(0, of)].push_back(shape.substr(of + 4));
  }
  std::string text;
  for (const auto& [kind, links] : by_kind)
    text += fmt::format("  not a cylinder: {} {} ({})\n", links.size(), kind, joined(links));
  return text;
}

std::string heading(const Scene& scene, const SceneStudy& s) {
  std::size_t turning = 0, mimics = 0;
  for (const Link& link : scene.links) {
    turning += link.motion != Motion::fixed && !link.follow && link.low < link.high;
    mimics += link.follow.has_value();
  }
  std::string text =
      fmt::format("{} on {}, {}{}\n", plural(s.bodies, "cylinder"), plural(scene.links.size(), "link"),
                  plural(turning, "free joint"), mimics ? fmt::format(", {} that mimic", mimics) : "");
  text += left_out_text(scene);
  for (const std::string& note : scene.notes) text += "  " + note + "\n";
  std::size_t all = 0;
  for (const std::size_t n : s.pairs_by_reason) all += n;
  return text +
         fmt::format("{}: {} checked; not checked: {} of one link, {} of adjacent links, {} disabled\n",
                     plural(all, "pair"), s.pairs_by_reason[0], s.pairs_by_reason[1], s.pairs_by_reason[2],
                     s.pairs_by_reason[3]);
}

struct Total {
  std::size_t decided = 0, wrong = 0, wrong_pairs = 0;
  double alarm = 0, missed = 0;
};

Total total_of(const SceneStudy& s, Rung rung) {
  Total t;
  for (const PairStudy& pair : s.pairs) {
    const Score& score = pair.alone[index_of(rung)];
    t.decided += pair.decided[index_of(rung)];
    t.wrong += score.wrong;
    t.wrong_pairs += score.wrong > 0;
    t.alarm = std::max(t.alarm, score.alarm);
    t.missed = std::max(t.missed, score.missed);
  }
  return t;
}

std::string length_text(double x) { return x == 0 ? "-" : fmt::format("{:.3g}", x); }
std::string count_text(std::size_t n) { return n == 0 ? "-" : std::to_string(n); }

std::string models_table(const SceneQuestion& q, const SceneStudy& s) {
  constexpr const char* row = "{:<15} {:>10} {:>9} {:>10} {:>9} {:>9} {:>12} {:>9}\n";
  std::string text = fmt::format(fmt::runtime("\n" + std::string(row)), "model", "decides", "alone ns",
                                 "suffices", "wrong", "in pairs", "false alarm", "missed");
  for (const Rung rung : all_rungs) {
    const Total t = total_of(s, rung);
    const auto enough = std::count_if(s.pairs.begin(), s.pairs.end(), [&](const PairStudy& pair) {
      return suffices(pair, rung, q.tolerated);
    });
    text += fmt::format(fmt::runtime(row), to_string(rung), count_text(t.decided),
                        fmt::format("{:.0f}", s.alone_ns[index_of(rung)]), enough, count_text(t.wrong),
                        count_text(t.wrong_pairs), length_text(t.alarm), length_text(t.missed));
  }
  if (s.asked_referee > 0)
    text += fmt::format("{} left to the referee, {} of them not proved and taken for within\n",
                        plural(s.asked_referee, "sample"), s.undecided);
  return text;
}

std::string plan_words(const Plan& plan) {
  std::string text;
  for (std::size_t i = 0; i < plan.first.size(); ++i)
    if (plan.first[i]) text += std::string(to_string(all_rungs[i])) + ", ";
  return text + to_string(plan.last);
}

const char* body(const Scene& scene, std::size_t i) { return scene.bodies[i].name.c_str(); }

/// Pairs that a line each would name are cut off here; --json has them all.
constexpr std::size_t named_cap = 12;

std::string needs_more(const Scene& scene, const SceneQuestion& q, const SceneStudy& s) {
  std::string text;
  std::size_t named = 0, more = 0;
  for (const PairStudy& pair : s.pairs) {
    if (suffices(pair, Rung::sphere, q.tolerated) || suffices(pair, Rung::outer, q.tolerated)) continue;
    if (++named > named_cap) {
      ++more;
      continue;
    }
    text += fmt::format("  {} - {}: {} (capsules: {} false alarms, up to {:.3g})\n", body(scene, pair.a),
                        body(scene, pair.b), plan_words(pair.plan), pair.alone[index_of(Rung::outer)].wrong,
                        pair.alone[index_of(Rung::outer)].alarm);
  }
  return more ? text + fmt::format("  and {} more\n", more) : text;
}

std::string sufficiency(const Scene& scene, const SceneQuestion& q, const SceneStudy& s) {
  std::size_t balls = 0, capsules = 0, all = s.pairs.size();
  for (const PairStudy& pair : s.pairs) {
    const bool ball = suffices(pair, Rung::sphere, q.tolerated);
    balls += ball;
    capsules += ball || suffices(pair, Rung::outer, q.tolerated);
  }
  std::string text = fmt::format("\nspheres suffice for {} of {}, spheres or capsules for {}", balls,
                                 plural(all, "pair"), capsules);
  if (capsules == all) return text + "\n";
  return text +
         (all - capsules == 1 ? "; this one needs more:\n"
                              : fmt::format("; these {} need more:\n", all - capsules)) +
         needs_more(scene, q, s);
}

std::string recommendation(const SceneQuestion& q, const SceneStudy& s) {
  std::map<Rung, std::size_t> last;
  for (const PairStudy& pair : s.pairs) ++last[pair.plan.last];
  std::vector<std::string> parts;
  for (const auto& [rung, count] : last)
    parts.push_back(fmt::format("{} for {}", to_string(rung), plural(count, "pair")));
  const Rung exact = q.clearance > 0 ? Rung::distance : Rung::cylinder;
  std::string text = fmt::format(
      "recommended: {}\n"
      "  {:.2f} us a configuration, against {:.2f} us with the {} test for every pair; {:.2f} us more to "
      "move the "
      "bodies\n",
      joined(parts), s.plan_ns / 1000, s.alone_ns[index_of(exact)] / 1000, to_string(exact),
      (s.kinematics_ns + s.models_ns) / 1000);
  std::size_t forgiven = 0;
  for (const PairStudy& pair : s.pairs) forgiven += pair.plan_wrong;
  if (forgiven)
    text += fmt::format("  with {} that {:.3g} allows\n", plural(forgiven, "false alarm"), q.tolerated);
  return text;
}

std::string capsule_text(const SceneStudy& s) {
  const Total t = total_of(s, Rung::outer);
  if (t.wrong == 0) return "capsules in every cylinder's place: the same answer in every sample\n";
  return fmt::format(
      "capsules in every cylinder's place: not the same: {} in {}, of cylinders up to {:.3g} beyond the "
      "clearance\n",
      plural(t.wrong, "false alarm"), plural(t.wrong_pairs, "pair"), t.alarm);
}

std::string accuracy_text(const Scene& scene, const SceneQuestion& q, const SceneStudy& s) {
  if (!s.closest) return "";
  const ClosestCall& c = *s.closest;
  const double miss = std::abs(c.distance - q.clearance);
  return fmt::format(
      "closest call: {} - {} in configuration {}, {:.3g} {} the clearance; an error of {:.1e} of their size "
      "({:.3g}) would "
      "change it\n",
      body(scene, c.a), body(scene, c.b), c.configuration, miss,
      c.distance > q.clearance ? "beyond" : "below", miss / c.size, c.size);
}

std::string verification_text(const SceneStudy& s) {
  if (!s.verification) return "";
  const Verification& v = *s.verification;
  return fmt::format("referee: {} asked, {} wrong, {} tolerated, {} not proved\n",
                     plural(v.asked, "recommended answer"), v.wrong, v.tolerated, v.undecided);
}

}  // namespace

std::string study_text(const Scene& scene, const SceneQuestion& q, const SceneStudy& s) {
  std::string text = fmt::format("seed {}\n", q.seed) + heading(scene, s);
  if (s.pairs.empty()) return text + "nothing to check\n";
  std::size_t never = 0, always = 0;
  for (const PairStudy& pair : s.pairs) {
    never += pair.within == 0;
    always += pair.within == pair.samples;
  }
  text += fmt::format("{}, clearance {}: {} never within it, {} always, {} at times\n",
                      plural(s.configurations, "configuration"), q.clearance, plural(never, "pair"), always,
                      s.pairs.size() - never - always);
  return text + models_table(q, s) + sufficiency(scene, q, s) + recommendation(q, s) + capsule_text(s) +
         accuracy_text(scene, q, s) + verification_text(s);
}

}  // namespace cyl
