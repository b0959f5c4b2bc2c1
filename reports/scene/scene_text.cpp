// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <tuple>

#include "base/safe_text.hpp"
#include "corpus/pairs/solid_kind.hpp"
#include "reports/scene/motion_text.hpp"
#include "reports/scene/scene_report.hpp"

namespace cyl {
namespace {

/// Names each kind of shape with its links, because "3 boxes, ..." would not show which boxes are meant.
std::vector<std::string> left_out_words(const Scene& scene) {
  std::map<std::string, std::map<std::string, std::size_t>> by_kind;
  for (const auto& [shape, link] : scene.left_out) ++by_kind[shape][link];
  std::vector<std::string> words;
  for (const auto& [kind, links] : by_kind) {
    std::size_t count = 0;
    std::vector<std::string> names;
    for (const auto& [link, times] : links) {
      count += times;
      names.push_back(times == 1 ? link : fmt::format("{} of {}", times, link));
    }
    words.push_back(fmt::format("{} ({})", counted(count, kind), fmt::join(names, ", ")));
  }
  return words;
}

/// Returns "2 capsules (1 written as a cylinder and two spheres), 3 cylinders, 1 mesh (as a bounding solid),
/// ..".
std::string shapes_words(const Scene& scene) {
  std::array<std::size_t, words_of(SolidKind{}).size()> counts{};
  std::map<std::string, std::size_t> bounded;
  for (const Body& body : scene.bodies)
    ++(body.box ? bounded[body.box->shape] : counts[static_cast<std::size_t>(kind_of(body.solid))]);
  std::vector<std::string> words;
  for (const SolidKind kind : enum_values<SolidKind>) {
    const std::size_t count = counts[static_cast<std::size_t>(kind)];
    if (count == 0) continue;
    words.push_back(counted(count, kind == SolidKind::rounded       ? "rounded cylinder"
                                   : kind == SolidKind::half_space  ? "half-space"
                                   : kind == SolidKind::rounded_box ? "rounded box"
                                                                    : to_string(kind)));
    if (kind == SolidKind::capsule && scene.folded > 0)
      words.back() += fmt::format(" ({} written as a cylinder and two spheres)", scene.folded);
  }
  for (const auto& [shape, count] : bounded)
    words.push_back(counted(count, shape) +
                    (count == 1 ? " (as a bounding solid)" : " (as bounding solids)"));
  return words.empty() ? "no shapes" : fmt::format("{}", fmt::join(words, ", "));
}

std::string counts_words(const Scene& scene) {
  std::size_t moving = 0, mimics = 0, floats = 0;
  for (const Link& link : scene.links) {
    moving += link.motion != Motion::fixed && !link.follow && link.low < link.high;
    mimics += link.follow.has_value();
    floats += link.floats;
  }
  return fmt::format("{}; {}, {}{}{}", shapes_words(scene), counted(scene.links.size(), "link"),
                     counted(moving, "moving joint"), mimics ? fmt::format(", {} that mimic", mimics) : "",
                     floats ? ", " + counted(floats, "free joint") : "");
}

std::string pairs_words(const Scene& scene, const SceneStudy& s) {
  std::size_t all = 0;
  for (const std::size_t n : s.pairs_by_reason) all += n;
  std::size_t by_bits = 0;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) by_bits += !may_collide(scene.bodies[i], scene.bodies[j]);
  std::string text = fmt::format(
      "{}: {} checked. Not checked: {} in one rigid body, {} of adjacent bodies, {} disabled{}",
      counted(all, "pair"), s.pairs_by_reason[0], s.pairs_by_reason[1], s.pairs_by_reason[2],
      s.pairs_by_reason[3],
      scene.srdf.empty()
          ? ""
          : fmt::format(" ({} disables {})", scene.srdf, counted(scene.exemptions.size(), "link pair")));
  if (s.pairs_by_reason[4] > 0)
    text += fmt::format(", {} that a free joint can always bring together", s.pairs_by_reason[4]);
  if (s.far > 0)
    text +=
        fmt::format(". {} of the checked pairs are far apart: boxes around all that they reach do not meet",
                    grouped(s.far));
  if (s.pairs.empty() && by_bits > 0)
    text += fmt::format(". contype and conaffinity let {} collide",
                        by_bits == all ? "no two shapes" : fmt::format("{} not", counted(by_bits, "pair")));
  return text;
}

const char* body(const Scene& scene, std::size_t i) { return scene.bodies[i].name.c_str(); }

/// The most pairs that one line names. --json has them all.
constexpr std::size_t named_cap = 12;

/// Returns ", because .. (table - hand, table - arm)" of the pairs that are not known.
std::string why_unknown(const Scene& scene, const SceneStudy& s) {
  std::vector<std::string> named;
  std::size_t count = 0;
  for (const PairStudy& pair : s.pairs)
    if (is_open(pair) && ++count <= named_cap)
      named.push_back(fmt::format("{} - {}", body(scene, pair.a), body(scene, pair.b)));
  if (count == 0) return "";
  if (count > named_cap) named.push_back(fmt::format("and {} more", count - named_cap));
  return fmt::format(", because the bounding solid of a mesh or ellipsoid comes within the clearance ({})",
                     fmt::join(named, ", "));
}

struct Draws {
  std::size_t clear = 0, always = 0, sometimes = 0, unknown = 0;  ///< pairs within the clearance
};

Draws draws_of(const SceneStudy& s) {
  Draws draws{.clear = s.far};
  for (const PairStudy& pair : s.pairs)
    ++(pair.within == 0           ? draws.clear
       : is_open(pair)            ? draws.unknown
       : pair.met == pair.samples ? draws.always
                                  : draws.sometimes);
  return draws;
}

std::string configurations_words(const SceneOptions& q, const SceneStudy& s) {
  return fmt::format("{} of seed {}, clearance {}", counted(s.configurations, "configuration"), q.seed,
                     q.clearance);
}

std::string draws_words(const SceneOptions& q, const SceneStudy& s) {
  const Draws draws = draws_of(s);
  return fmt::format("{}: {} clear in all, {} within it in some, {} in all, {} not known",
                     configurations_words(q, s), counted(draws.clear, "pair"), draws.sometimes, draws.always,
                     draws.unknown);
}

/// Returns what draws show. Only proofs may report "never".
std::vector<std::string> draw_lines(const Scene& scene, const SceneOptions& q, const SceneStudy& s) {
  const Draws draws = draws_of(s);
  return {
      fmt::format("clear    {} of {} in {} (--prove decides over all motions)", draws.clear,
                  counted(s.pairs.size() + s.far - draws.unknown, "known pair"), configurations_words(q, s)),
      fmt::format("within   {} in some, {} in all", draws.sometimes, draws.always),
      fmt::format("open     {}{}", draws.unknown, why_unknown(scene, s))};
}

std::string length_text(double x) { return x == 0 ? "-" : fmt::format("{:.3g}", x); }
std::string count_text(std::size_t n) { return n == 0 ? "-" : std::to_string(n); }

std::string models_table(const SceneStudy& s, double tolerated) {
  constexpr const char* row = "{:<15} {:>10} {:>9} {:>10} {:>9} {:>9} {:>12} {:>9}\n";
  std::string text = "\n";
  text += fmt::format(fmt::runtime(row), "model", "decides", "alone ns", "suffices", "wrong", "in pairs",
                      "false alarm", "missed");
  for (const Level level : enum_values<Level>) {
    const Total t = total_of(s, level, tolerated);
    text += fmt::format(fmt::runtime(row), to_string(level), count_text(t.decided),
                        fmt::format("{:.0f}", s.alone_ns[index_of(level)]), t.suffices, count_text(t.wrong),
                        count_text(t.wrong_pairs), length_text(t.alarm), length_text(t.missed));
  }
  if (s.asked_referee > 0)
    text +=
        fmt::format("the referee judged {}. It could not prove {}, which count as within the clearance.\n",
                    counted(s.asked_referee, "sample"), s.undecided);
  return text;
}

std::string cascade_words(const Cascade& cascade) {
  std::string text;
  for (std::size_t i = 0; i < cascade.first.size(); ++i)
    if (cascade.first[i]) text += std::string(to_string(enum_values<Level>[i])) + ", ";
  return text + to_string(cascade.last);
}

/// Lists pairs by the most exact model that they need, then by false alarms of capsules, the worst first.
std::string needs_more(const Scene& scene, const SceneOptions& q, const SceneStudy& s) {
  std::vector<const PairStudy*> pairs;
  for (const PairStudy& pair : s.pairs)
    if (is_known(pair) && !suffices(pair, Level::sphere, q.tolerated) &&
        !suffices(pair, Level::outer, q.tolerated))
      pairs.push_back(&pair);
  const auto alarms = [](const PairStudy& pair) -> const Score& {
    return pair.alone[index_of(Level::outer)];
  };
  std::ranges::stable_sort(pairs, std::greater(), [&](const PairStudy* pair) {
    return std::tuple(pair->cascade.last, alarms(*pair).wrong, alarms(*pair).alarm);
  });
  std::string text;
  for (const PairStudy* pair : pairs)
    text += fmt::format("\n  {} - {}: {} (capsules: {}, up to {:.3g})", body(scene, pair->a),
                        body(scene, pair->b), cascade_words(pair->cascade),
                        counted(alarms(*pair).wrong, "false alarm"), alarms(*pair).alarm);
  return text;
}

/// Returns how rare errors are that no configuration showed.
std::string surely(const SceneStudy& s) {
  const auto rests_on_draws = [&](const PairStudy& pair) { return is_known(pair) && is_statistical(pair); };
  if (std::ranges::none_of(s.pairs, rests_on_draws)) return "";
  return fmt::format(" (each wrong in less than {} of all configurations, at 95 % confidence)",
                     rate_text(s.configurations));
}

std::string enough_words(const SceneOptions& q, const SceneStudy& s) {
  std::size_t balls = s.far, capsules = s.far, all = s.far;
  for (const PairStudy& pair : s.pairs) {
    if (!is_known(pair)) continue;
    ++all;
    const bool ball = suffices(pair, Level::sphere, q.tolerated);
    balls += ball;
    capsules += ball || suffices(pair, Level::outer, q.tolerated);
  }
  if (all == 0) return "";
  std::string text = fmt::format("spheres suffice for {} of {}, spheres or capsules for {}", balls,
                                 counted(all, "pair"), capsules);
  if (s.drawn && capsules > 0) text += surely(s);
  if (capsules == all) return text;
  return text + (all - capsules == 1 ? ". This one needs more"
                                     : fmt::format(". These {} need more", all - capsules));
}

/// The level of the cylinders stands for the shapes of the file themselves.
std::string plural_of(Level level, const Scene& scene) {
  const auto is_other = [](const Body& body) { return kind_of(body.solid) != SolidKind::cylinder; };
  if (level == Level::cylinder && std::ranges::any_of(scene.bodies, is_other)) return "the shapes themselves";
  return std::array{
      "spheres", "capsules", "inner capsules", "cylinders", "distances", "proofs", "boxes"}[index_of(level)];
}

std::string recommended_words(const Scene& scene, const SceneStudy& s) {
  std::map<Level, std::size_t> last;
  if (s.far > 0) last[Level::sphere] = s.far;
  for (const PairStudy& pair : s.pairs)
    if (is_known(pair)) ++last[pair.cascade.last];
  std::vector<std::string> parts;
  for (const auto& [level, count] : last)
    parts.push_back(fmt::format("{} for {}", plural_of(level, scene), counted(count, "pair")));
  return parts.empty() ? "nothing" : fmt::format("{}", fmt::join(parts, ", "));
}

/// Times vary by this part, so a smaller saving counts as none.
constexpr double least_saving = 0.1;

std::string cost_words(const SceneStudy& s) {
  const double alone = s.alone_ns[index_of(Level::cylinder)];
  return fmt::format(
      "{:.2f} us per configuration, instead of {:.2f} us with the {} test for every pair{}; moving the "
      "bodies "
      "takes another {:.2f} us",
      s.cascade_ns / 1000, alone / 1000, to_string(Level::cylinder),
      s.cascade_ns > (1 - least_saving) * alone ? ", which SAVES NOTHING" : "",
      (s.kinematics_ns + s.models_ns) / 1000);
}

std::string bound_or_body(const Scene& scene, std::size_t i) {
  return scene.bodies[i].name + (scene.bodies[i].box ? " (bounding solid)" : "");
}

std::string closest_words(const Scene& scene, const SceneOptions& q, const SceneStudy& s) {
  if (!s.closest) return "";
  const ClosestCall& c = *s.closest;
  const double miss = std::abs(c.distance - q.clearance);
  return fmt::format(
      "closest call: {} - {} in configuration {}, {:.3g} {} the clearance. An error of {:.1e} of their size "
      "({:.3g}) would change the answer",
      bound_or_body(scene, c.a), bound_or_body(scene, c.b), c.configuration, miss,
      c.distance > q.clearance ? "beyond" : "below", miss / c.size, c.size);
}

std::string verified_words(const SceneStudy& s) {
  const Verification& v = s.verification;
  return fmt::format("referee: {} judged, {} wrong, {} tolerated, {} not proved",
                     counted(v.asked, "recommended answer"), v.wrong, v.tolerated, v.undecided);
}

/// The most lines of a text without tables, and the most notes of its scene among them.
constexpr std::size_t line_count_cap = 40, notes_cap = 4;

using TextLines = std::vector<std::string>;

/// Shortens a list to so many lines. The last line counts the others.
void shorten(TextLines& lines, std::size_t room) {
  if (lines.size() <= room) return;
  const std::size_t left = lines.size() - room + 1;
  lines.resize(room - 1);
  lines.push_back(fmt::format("  {} more, which --table lists", grouped(left)));
}

void add(TextLines& lines, const std::string& words, const char* before = "") {
  if (!words.empty()) lines.push_back(before + words);
}

TextLines advice(const Scene& scene, const SceneOptions& q, const SceneStudy& s, bool table) {
  TextLines lines, notes;
  add(lines, counts_words(scene));
  for (const std::string& note : scene.notes) add(notes, note, "  ");
  if (!table) shorten(notes, notes_cap);
  lines.insert(lines.end(), notes.begin(), notes.end());
  add(lines, pairs_words(scene, s));
  if (s.pairs.empty()) return lines;
  if (s.motions) add(lines, draws_words(q, s));
  if (table) add(lines, models_table(s, q.tolerated));
  const std::string more = needs_more(scene, q, s);
  add(lines, enough_words(q, s) + (more.empty() ? "" : table ? ":" + more : " (--table lists them)"));
  add(lines, recommended_words(scene, s), "recommended: ");
  if (const TextLines held = joints_held_between(scene, s); !held.empty())
    add(lines, fmt::format("  NOT MOVED: {}", fmt::join(held, ", ")));
  add(lines, cost_words(s), "  ");
  add(lines, closest_words(scene, q, s));
  add(lines, verified_words(s));
  return lines;
}

}  // namespace

std::string study_text(const Scene& scene, const SceneOptions& q, const SceneStudy& s, bool table) {
  TextLines lines{"nothing to check"}, proofs = proof_lines(scene, s, table);
  if (!s.pairs.empty() || !proofs.empty()) lines = s.motions ? verdict_lines(q, s) : draw_lines(scene, q, s);
  const TextLines left_out = left_out_words(scene), rest = advice(scene, q, s, table);
  lines.push_back(left_out.empty() ? "not read 0 shapes"
                                   : fmt::format("not read {}", fmt::join(left_out, ", ")));
  if (!table) shorten(proofs, line_count_cap - lines.size() - rest.size());
  lines.insert(lines.end(), proofs.begin(), proofs.end());
  lines.insert(lines.end(), rest.begin(), rest.end());
  return fmt::format("{}\n", fmt::join(lines, "\n"));
}

}  // namespace cyl
