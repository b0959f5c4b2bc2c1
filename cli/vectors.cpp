// SPDX-License-Identifier: MIT
// Test vectors for tests of code outside of this tree: pairs, the truth about them and its proof.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/source_tree.hpp"
#include "base/usage_error.hpp"
#include "cli/commands.hpp"
#include "cli/families.hpp"
#include "cli/options.hpp"
#include "corpus/pairs/pair_digest.hpp"
#include "corpus/pairs/pair_io.hpp"
#include "corpus/pairs/strata.hpp"
#include "corpus/pairs/truth_io.hpp"
#include "corpus/pairs/vector_geometry.hpp"
#include "corpus/store/case_files.hpp"
#include "oracles/methods/method.hpp"
#include "oracles/referee/certificate_check.hpp"
#include "oracles/referee/proofs.hpp"
#include "oracles/trial/contact.hpp"
#include "solver/distance.hpp"

namespace cyl {
namespace {

/// The rounded families of vectors/v1, which never change.
constexpr std::size_t rounded_in_v1 = 9;
/// The relative width of the distance that is searched.
constexpr double direction_width = 1e-13;

/// A vector, or a member of a group that has the same truth.
struct Vector {
  std::string id, line;  ///< of JSON
  std::string c;         ///< of the header of C; "" if it is not in there
  Verdict result = Verdict::undecided;
};

/// The further data that is written with a vector and its pair.
struct Extra {
  std::string like{}, change{}, source{};
  int prism_sides = 0;
};

Certificate direction_of(const Vector3& d) {
  const double head[3] = {d[0], d[1], d[2]};
  return {CertificateKind::direction, exact_vector(head, no_tail), {}};
}

Hull hull_of(const Solid& c) {
  if (c.radius == 0) return c.height == 0 ? Hull::center : Hull::line;
  return c.height == 0 ? Hull::plane : Hull::space;
}

/// Returns a point of the core that is close to the centre plus the offset.
std::optional<ExactVector> point_in(const Solid& c, const Vector3& offset) {
  for (const double share : {1.0, 1 - 0x1p-50, 1 - 0x1p-44, 1 - 0x1p-36, 1 - 0x1p-28}) {
    ExactVector x;
    for (std::size_t i = 0; i < 3; ++i) {
      x.head[i] = c.center[static_cast<int>(i)];
      x.tail[i] = share * offset[static_cast<int>(i)];
    }
    const Rational3 moved = project_to_hull(c, exact(x));
    if (in_each_exact({c, c}, moved, moved)) return x;
  }
  return {};
}

/// Returns two points of the cores, and an upper bound of their distance. Nothing if none are found.
std::optional<std::pair<Certificate, double>> nearest_points(const Pair& p) {
  Solid a = p.a, b = p.b;
  a.rounding = b.rounding = 0;
  const Distance near = distance(a, b);
  const auto x = point_in(a, near.on_a), y = point_in(b, near.on_b);
  if (!x || !y) return {};
  const Rational3 between = project_to_hull(b, exact(*y)) - project_to_hull(a, exact(*x));
  const long double length =
      Wide3(between.x.get_d(), between.y.get_d(), between.z.get_d()).norm() * (1 + 0x1p-51L);
  const long double high = length - p.a.rounding - p.b.rounding + 0x1p-58L * scale_of(p);
  Certificate proof{.kind = CertificateKind::points, .vector = *x, .second = *y};
  proof.hulls = {hull_of(a), hull_of(b)};
  return std::pair(proof, std::nextafter(static_cast<double>(high), std::numeric_limits<double>::infinity()));
}

/// Returns the members of the JSON object of a certificate.
std::string members(const Certificate& c) {
  const std::string text = format_certificate(c);
  return text.substr(1, text.size() - 2);
}

struct Proved {
  Enclosure distance;
  std::string certificate;
};

std::string id_of(const Pair& pair) { return fmt::format("v1-{:016x}", digest_of(pair, fnv1a(""))); }

/// Returns what the exact checker proves. Nothing if it has no such proof.
std::optional<Proved> prove(const Pair& pair, const Truth& truth) {
  if (truth.verdict == Verdict::touching) {
    std::string certificate = members(truth.certificate);
    if (certificate.starts_with("\"near\"")) return Proved{{0, 0}, certificate};
    const auto d = touching_direction(pair);
    // Published with a point near by, when no exact one was known. A vector never changes.
    const bool published = id_of(pair) == "v1-4483711e0308e479";
    if (!d) return published ? std::optional(Proved{{0, 0}, certificate}) : std::nullopt;
    return Proved{{0, 0}, certificate + ',' + members(direction_of(*d))};
  }
  const AttainedDistance attained = attain_distance(pair, truth, direction_width);
  const Vector3 d(attained.direction[0], attained.direction[1], attained.direction[2]);
  Proved proved{{proved_below(pair, d), attained.distance.hi}, members(direction_of(d))};
  if (!std::isfinite(proved.distance.lo) || !std::isfinite(proved.distance.hi)) return {};
  if (truth.verdict == Verdict::intersecting) {
    proved.certificate = members(truth.certificate) + ',' + proved.certificate;
  } else if (const auto near = nearest_points(pair)) {
    proved.distance.hi = near->second;
    proved.certificate += ",\"nearest\":" + format_certificate(near->first);
  }
  const bool apart = truth.verdict == Verdict::disjoint;
  if (proved.distance.lo > proved.distance.hi || (apart && proved.distance.lo <= 0)) return {};
  return proved;
}

std::string corners_text(const std::vector<Vector3>& corners) {
  std::string text;
  for (const Vector3& x : corners)
    text += fmt::format("{}[{},{},{}]", text.empty() ? "" : ",", format_double(x[0]), format_double(x[1]),
                        format_double(x[2]));
  return '[' + text + ']';
}

/// Writes numbers that JSON does not have as strings.
std::string solid(const Solid& c, const std::string& more = "") {
  const auto number = [](double x) {
    return std::isfinite(x) ? format_double(x) : '"' + format_double(x) + '"';
  };
  return fmt::format(R"({{"center":[{},{},{}],"axis":[{},{},{}],"radius":{},"height":{}{}{}}})",
                     number(c.center[0]), number(c.center[1]), number(c.center[2]), number(c.axis[0]),
                     number(c.axis[1]), number(c.axis[2]), number(c.radius), number(c.height),
                     c.rounding == 0 ? "" : ",\"rounding\":" + number(c.rounding), more);
}

std::string numbers_in_c(const Solid& c) {
  std::string text;
  const auto numbers = numbers_of(c);
  for (const double x : std::span(numbers).first(cylinder_number_count))
    text += fmt::format("{}{}", text.empty() ? "{" : ",", format_double(x));
  return text + '}';
}

std::optional<Vector> invalid_vector(const Pair& pair) {
  const Defect defect = std::max(find_defect(pair.a), find_defect(pair.b));
  if (defect == Defect::none) return {};
  Vector v{id_of(pair), "", "", Verdict::invalid};
  v.line = fmt::format(
      R"({{"id":"{}","kind":"invalid","flags":["Invalid"],"a":{},"b":{},"result":"invalid","why":"{}"}})",
      v.id, solid(pair.a), solid(pair.b), to_string(defect));
  return v;
}

std::optional<Vector> vector_of(Pair pair, const Extra& extra = {}) {
  if (!is_legal(pair)) return {};
  for (Solid* c : {&pair.a, &pair.b}) {  // no -0, because readers of JSON lose it
    c->center += Vector3::Zero();
    c->axis += Vector3::Zero();
  }
  static const auto solver = certifying_method();
  const MethodAnswer offered[] = {solver->ask(pair)};
  const Truth truth = judge(pair, offered);
  if (truth.verdict == Verdict::undecided) return {};
  const auto proved = prove(pair, truth);
  if (!proved) return {};
  const auto& [lo, hi] = proved->distance;
  const double least = lo > 0 ? lo : -std::min(hi, 0.0), most = std::max(std::abs(lo), std::abs(hi));
  const double size = size_of(pair), margin = size > 0 ? least / size : least > 0 ? 1 : 0;
  const bool floats = is_float(pair);
  const auto feature = contact_feature(pair, truth);
  const AxisTurn of_a = turn_of(pair.a, floats), of_b = turn_of(pair.b, floats);
  const long double off = (of_a.off + of_b.off) * (1 + 0x1p-30L);
  const bool turns = off == 0 || off < least / 2;
  const auto turned = [&](const AxisTurn& q) {
    return turns ? fmt::format(",\"quaternion\":[{},{},{},{}]", format_double(q.w), format_double(q.x),
                               format_double(q.y), format_double(q.z))
                 : "";
  };
  Vector v{id_of(pair), "", "", truth.verdict};
  v.line = fmt::format(
      R"({{"id":"{}","kind":"{}","precision":"{}","sizes":"{}","flags":[{}],"a":{},"b":{},"result":"{}",)"
      R"("distance":[{},{}],"margin":{},"acceptable_below":{})",
      v.id,
      extra.prism_sides      ? "prisms"
      : extra.change.empty() ? "pair"
                             : "changed",
      floats ? "float32" : "float64", is_everyday(pair) ? "ordinary" : "extreme",
      flags_of(pair, truth.verdict, feature, angle_class(pair), margin), solid(pair.a, turned(of_a)),
      solid(pair.b, turned(of_b)), to_string(truth.verdict), format_double(lo), format_double(hi),
      format_double(margin), format_double(most));
  if (feature) v.line += fmt::format(",\"feature\":\"{}\"", to_string(*feature));
  if (turns)
    v.line +=
        ",\"quaternion_off\":" + format_double(std::nextafter(static_cast<double>(off), off > 0 ? 1 : 0));
  if (!extra.change.empty())
    v.line += fmt::format(",\"like\":\"{}\",\"change\":\"{}\"", extra.like, extra.change);
  if (!extra.source.empty()) v.line += ",\"source\":" + quote_json(extra.source);
  if (extra.prism_sides) {
    if (truth.verdict == Verdict::touching || least < 1e-5 * size) return {};
    const bool around = truth.verdict == Verdict::intersecting;
    v.line +=
        fmt::format(R"(,"prisms":{{"sides":{},"lie":"{}","a":{},"b":{}}})", extra.prism_sides,
                    around ? "around" : "inside", corners_text(prism(pair.a, extra.prism_sides, around)),
                    corners_text(prism(pair.b, extra.prism_sides, around)));
  }
  v.line += ",\"certificate\":{" + proved->certificate + "}}";
  v.c = fmt::format("{{\"{}\", {}, {}, {}, {}, {}, {}}}", v.id, numbers_in_c(pair.a), numbers_in_c(pair.b),
                    truth.verdict == Verdict::disjoint       ? -1
                    : truth.verdict == Verdict::intersecting ? 1
                                                             : 0,
                    format_double(lo), format_double(hi), format_double(most));
  return v;
}

/// Draws vectors in turn from sources of every kind. The same seed gives the same vectors.
class Source {
 public:
  /// The reports that version 1 of the vectors has. Later ones do not enter it, because a vector never
  /// changes.
  static constexpr std::size_t reported_in_v1 = 47;

  Source(std::uint64_t seed, const std::string& cases) : seed_(seed) {
    for (Case& c : read_case_folder(cases))
      if (c.file.ends_with("reported.jsonl") && reported_.size() < reported_in_v1)
        reported_.push_back(std::move(c));
  }

  /// Returns the vectors of one of 20 turns. k counts the rounds.
  std::vector<Vector> draw(std::uint64_t turn, std::uint64_t k) const {
    if (turn < 7) return one(vector_of(stratum(turn, 1 + k % 12, k)));
    if (turn < 11) return one(vector_of(in_floats(stratum((4 * k + turn) % 7, 1 + k % 5, k + (1U << 20U)))));
    if (turn == 11) return one(vector_of(of({"close_contacts", "close_rims", "coins_edge_to_edge"}, k)));
    if (turn == 12)
      return one(vector_of(
          of({"tiny_and_huge", "far", "mixed_scale", "needles", "disks", "raw_axes", "needle_and_disk"}, k)));
    if (turn == 13)
      return one(vector_of(of({"coaxial", "equal", "contained", "axes_parallel", "segments", "flat_disks",
                               "axes_nearly_parallel", "points", "axes_perpendicular"},
                              k)));
    if (turn == 14) {
      const auto rounded = rounded_families().first(rounded_in_v1);
      const Pair pair = rounded[k % rounded.size()].generate(seed_, k / rounded.size());
      return one(vector_of(k / rounded.size() % 2 ? in_floats(pair) : pair));
    }
    if (turn == 15) return one(touching(k));
    if (turn == 16) {
      if (k >= reported_.size()) return one(vector_of(of({"random"}, k)));
      return one(vector_of(reported_[k].pair, {.source = reported_[k].source}));
    }
    if (turn == 17)
      return k % 6 ? std::vector<Vector>{} : changed(stratum(k / 6 % 7, 1 + k % 5, k + (1U << 21U)));
    if (turn == 18)
      return one(vector_of(stratum(k % 6, 1 + k % 3, k + (1U << 22U)), {.prism_sides = k % 2 ? 8 : 6}));
    return one(invalid_vector(spoiled(k)));
  }

 private:
  static std::vector<Vector> one(std::optional<Vector> v) {
    return v ? std::vector<Vector>{std::move(*v)} : std::vector<Vector>{};
  }

  Pair stratum(std::uint64_t feature, std::uint64_t decade, std::uint64_t k) const {
    const auto pair =
        draw_in_stratum(static_cast<ContactFeature>(feature), static_cast<int>(decade), seed_, k);
    return pair ? *pair : of({"random"}, k);
  }

  Pair of(std::vector<std::string_view> names, std::uint64_t k) const {
    return find_family(names[k % names.size()])->generate(seed_, k / names.size());
  }

  std::optional<Vector> touching(std::uint64_t k) const {
    for (std::uint64_t i = 0; i < 200; ++i) {
      const auto v = vector_of(of({"lattice"}, 200 * k + i));
      if (v && v->result == Verdict::touching) return v;
    }
    return {};
  }

  std::vector<Vector> changed(const Pair& pair) const {
    std::vector<Vector> group = one(vector_of(pair));
    if (group.empty()) return group;
    const std::string like = group[0].id;
    for (const ExactChange& change : exact_changes())
      if (auto v = vector_of(change.of(pair), {.like = like, .change = change.name}))
        group.push_back(std::move(*v));
    return group;
  }

  Pair spoiled(std::uint64_t k) const {
    Pair pair = of({"random"}, k + (1U << 20U));
    Solid& c = k % 2 ? pair.b : pair.a;
    const double bad[] = {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
                          -1};
    const std::uint64_t what = k % 10;
    if (what < 8) {
      *numbers_of(c)[what < 2 ? what : what + 1] = bad[what < 5 ? k % 2 : k % 3];
    } else {
      c.axis.setZero();
    }
    return pair;
  }

  std::uint64_t seed_;
  std::vector<Case> reported_;
};

struct VectorsOptions {
  std::string tier = "smoke";
  std::uint64_t seed = 1, count = 0;
  bool header = false;
  std::string cases;
};

std::uint64_t count_of(const VectorsOptions& options) {
  constexpr std::pair<std::string_view, std::uint64_t> tiers[] = {
      {"smoke", 200}, {"standard", 2000}, {"full", 200000}};
  for (const auto& [name, count] : tiers)
    if (name == options.tier) return options.count ? options.count : count;
  throw UsageError("--tier " + options.tier + ": smoke, standard or full");
}

constexpr std::string_view header_head = R"(/* SPDX-License-Identifier: MIT
   Pairs of solids with proved results: the legal vectors of the tier {}, as in its JSON file.
   A solid: center, axis, radius, full height, rounding. A result of -1 is disjoint, 0 touching, 1 intersecting.
   The signed distance is from low to high. With a tolerance above acceptable_below, both answers are right. */
#ifndef DAYLIGHT_VECTORS_H
#define DAYLIGHT_VECTORS_H
typedef struct {{
  const char* id;
  double a[9], b[9];
  int result;
  double low, high, acceptable_below;
}} DaylightVector;
static const DaylightVector daylight_vectors[] = {{
)";

int write_vectors(const VectorsOptions& options) {
  const std::uint64_t count = count_of(options);
  const Source source(options.seed, options.cases);
  std::set<std::string> ids;
  if (options.header)
    fmt::print(header_head, options.tier);
  else
    fmt::print(
        "{{\"schema\":\"daylight-vectors-v1\",\"tier\":\"{}\",\"seed\":{},\"count\":{},\"vectors\":[\n",
        options.tier, options.seed, count);
  for (std::uint64_t i = 0; ids.size() < count; ++i)
    for (const Vector& v : source.draw(i % 20, i / 20)) {
      if (ids.size() >= count || !ids.insert(v.id).second) continue;
      if (!options.header)
        fmt::print("{}{}\n", v.line, ids.size() < count ? "," : "");
      else if (!v.c.empty())
        fmt::print("  {},\n", v.c);
    }
  fmt::print("{}\n", options.header ? "};\n#endif" : "]}");
  return exit_pass;
}

}  // namespace

void add_vectors(Program& program) {
  Command command = program.command("Measure", "vectors",
                                    "Writes test vectors: pairs with their verdict, distance and proof");
  auto options = std::make_shared<VectorsOptions>();
  options->cases = in_source_tree("corpus/cases");
  command.section("Pairs");
  command.option("--tier NAME", options->tier, "smoke (200 vectors), standard (2,000) or full (200,000)");
  command.number("--seed N", options->seed, "seed; the same seed gives the same pairs on every machine");
  command.number("--count N", options->count, "number of vectors; 0 for as many as the tier has");
  command
      .option("--cases DIR", options->cases,
              "folder with reported.jsonl, the pairs of public reports; '' for none")
      .default_text("corpus/cases/");
  command.section("Output");
  command.flag("--header", options->header, "write a C header with the legal pairs instead of JSON");
  command.examples(
      "  daylight vectors --tier full --seed 7 > full.json\n"
      "  daylight vectors --tier smoke --header > smoke.h",
      "The exit codes 2 and 3 do not occur for vectors.");
  command.run([options] { return write_vectors(*options); });
}

}  // namespace cyl
