// SPDX-License-Identifier: MIT
// Test vectors for tests of code outside of this tree: pairs, the truth about them and its proof.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/source_tree.hpp"
#include "cli/commands.hpp"
#include "cli/families.hpp"
#include "cli/options.hpp"
#include "corpus/pairs/pair_digest.hpp"
#include "corpus/pairs/pair_io.hpp"
#include "corpus/pairs/strata.hpp"
#include "corpus/pairs/truth_io.hpp"
#include "oracles/referee/referee.hpp"
#include "oracles/trial/contact.hpp"

namespace cyl {
namespace {

/// A vector with a longer line, in bytes, is left out. Some common points have thousands of digits.
constexpr std::size_t vector_cap = 2000;
/// The files of cases that are known from public reports.
constexpr std::array<std::string_view, 4> reports{"boxes", "half_spaces", "reported", "rounded"};

struct VectorsOptions {
  std::uint64_t seed = 1, count = 500;
  bool header = false;
  std::string cases;
};

/// Returns the flags that vectors/v1/flags.json and vectors/v2/flags.json explain, as JSON.
std::string flags_of(const Pair& p, Verdict verdict, std::optional<ContactFeature> feature, double margin) {
  std::string flags;
  const auto flag = [&](bool has, std::string_view name) {
    if (has) flags += fmt::format("{}\"{}\"", flags.empty() ? "" : ",", name);
  };
  const auto either = [&](auto has) { return has(p.a) || has(p.b); };
  const auto has_kind = [&](SolidKind kind) {
    return either([&](const Solid& c) { return kind_of(c) == kind; });
  };
  const auto extent = [](const Solid& c) { return size_of({c, {}}); };
  const auto shortest = [](const Solid& c) { return std::ranges::min(c.edges); };
  const auto longest = [](const Solid& c) { return std::ranges::max(c.edges); };
  const auto is_thin = [](double x, double y) { return x > 0 && x < 0.01 * y; };
  const AngleClass angle = angle_class(p);
  const Vector3 delta = p.b.center - p.a.center;
  const double size = size_of(p), of_a = extent(p.a), of_b = extent(p.b);
  const bool box = has_box(p), plane = has_half_space(p);
  const bool turns =
      !either([&](const Solid& c) { return !is_half_space(c) && !is_box(c) && c.radius + c.height == 0; });
  const bool coaxial = !box && !plane && delta.cross(p.a.axis.stableNormalized()).norm() <= 1e-12 * size;
  flag(turns && angle == AngleClass::parallel, "ParallelAxes");
  flag(turns && angle > AngleClass::parallel && angle < AngleClass::generic, "NearlyParallelAxes");
  flag(turns && angle == AngleClass::right, "SquareAxes");
  flag(turns && angle == AngleClass::near_right, "NearlySquareAxes");
  flag(turns && angle == AngleClass::parallel && coaxial, "Coaxial");
  flag(!plane && delta.isZero(0), "Concentric");
  flag(feature == ContactFeature::containment, "Contained");
  flag(feature == ContactFeature::cap_cap, "FaceOnFace");
  flag(!box && feature == ContactFeature::rim_rim, "RimOnRim");
  flag(!box && (feature == ContactFeature::side_rim || feature == ContactFeature::cap_rim), "RimOnFace");
  flag(box && feature == ContactFeature::side_side, "EdgeOnEdge");
  flag(verdict == Verdict::touching, "Touching");
  flag(verdict != Verdict::touching && margin < 1e-6, "NearlyTouching");
  flag(either([&](const Solid& c) {
         return c.rounding == 0 && !is_half_space(c) && (is_box(c) ? shortest(c) : c.radius * c.height) == 0;
       }),
       "Flat");
  flag(either([&](const Solid& c) { return is_thin(c.radius, c.height); }), "Needle");
  flag(either([&](const Solid& c) { return is_thin(c.height, c.radius); }), "Coin");
  flag(either([&](const Solid& c) { return is_thin(shortest(c), longest(c)); }), "ThinBox");
  flag(has_kind(SolidKind::sphere), "Sphere");
  flag(has_kind(SolidKind::capsule), "Capsule");
  flag(has_kind(SolidKind::rounded) || has_kind(SolidKind::rounded_box), "RoundedEdges");
  flag(box, "Box");
  flag(plane, "HalfSpace");
  flag(size < 1e-3 || size > 1e3, "UnusualSize");
  flag(std::max(p.a.center.stableNorm(), p.b.center.stableNorm()) > 1000 * size, "FarAway");
  flag(std::min(of_a, of_b) > 0 && std::max(of_a, of_b) > 1000 * std::min(of_a, of_b), "MixedSizes");
  flag(either([](const Solid& c) { return !is_box(c) && std::abs(c.axis.stableNorm() - 1) > 1e-6; }),
       "AxisOfAnyLength");
  return flags;
}

constexpr std::string_view header_head = R"(/* SPDX-License-Identifier: MIT
   Pairs of solids with proved results, as `daylight vectors` writes them. The signed distance is from low to high.
   Shape 0 is a cylinder, shape 1 a half-space with a point of its plane as center and its outward normal as axis,
   shape 2 a box with full edges and a quaternion w x y z of any length. All points within the rounding belong to it. */
#ifndef DAYLIGHT_VECTORS_H
#define DAYLIGHT_VECTORS_H
typedef struct {
  int shape;
  double center[3], axis[3], radius, height, rounding, edges[3], quaternion[4];
} DaylightSolid;
typedef struct {
  const char* id;
  DaylightSolid a, b;
  int result; /* -1 disjoint, 0 touching, 1 intersecting */
  double low, high;
} DaylightVector;
static const DaylightVector daylight_vectors[] = {
)";

std::string in_c(const Solid& c) {
  const auto row = numbers_of(c);
  const auto some = [&](std::size_t first, std::size_t count) {
    return fmt::format("{{{}}}", fmt::join(std::span(row).subspan(first, count), ", "));
  };
  return fmt::format("{{{}, {}, {}, {}, {}, {}, {}, {}}}", static_cast<int>(c.shape), some(0, 3), some(3, 3),
                     c.radius, c.height, c.rounding, some(9, 3), some(12, 4));
}

/// Returns the vector of a pair, or nothing if it has no proof or no double holds the distance.
std::optional<std::string> vector_of(Case c, bool header) {
  const Truth truth = judge(c.pair);
  const Enclosure distance = enclose_distance(c.pair, truth);
  if (truth.verdict == Verdict::undecided || !std::isfinite(distance.lo) || !std::isfinite(distance.hi))
    return {};
  c.truth = truth.verdict;
  const double least = std::max({distance.lo, -distance.hi, 0.0}), size = size_of(c.pair);
  const double margin = size > 0 ? least / size : least > 0 ? 1 : 0;
  std::string line = format_case(c);
  line.pop_back();
  line += fmt::format(R"(,"flags":[{}],"feature":"{}","margin":{},"answer":{}}})",
                      flags_of(c.pair, truth.verdict, contact_feature(c.pair, truth), margin),
                      contact_in_words(c.pair, truth), format_double(margin), format_truth(truth, &distance));
  if (line.size() > vector_cap) return {};
  if (!header) return line;
  const int result = truth.verdict == Verdict::disjoint ? -1 : truth.verdict == Verdict::touching ? 0 : 1;
  return fmt::format("  {{\"{}\", {}, {}, {}, {}, {}}},", c.id, in_c(c.pair.a), in_c(c.pair.b), result,
                     distance.lo, distance.hi);
}

/// Writes the pairs of public reports, then pairs of each family and of each two kinds of solids in turn.
int write_vectors(const VectorsOptions& options) {
  std::vector<Case> cases = cases_in(options.cases, [](const Pair&) { return true; });
  std::erase_if(cases, [](const Case& c) {
    return std::ranges::none_of(
        reports, [&](std::string_view file) { return c.file.ends_with(fmt::format("{}.jsonl", file)); });
  });
  const auto all = campaign_families();
  const std::size_t turns = all.size() + drawn_kinds.size();
  constexpr std::uint64_t step = 7;  // no turns of a family or stratum have this period
  std::set<std::string> ids;
  if (options.header) fmt::print("{}", header_head);
  for (std::uint64_t i = 0, written = 0; written < options.count; ++i) {
    Case c;
    if (i < cases.size()) {
      c.pair = cases[i].pair;
      c.source = cases[i].source;
    } else {
      const std::uint64_t drawn = i - cases.size(), turn = drawn % turns, index = drawn / turns * step + turn;
      c.pair = turn < all.size() ? all[turn].generate(options.seed, index)
                                 : draw_in_stratum(drawn_kinds[turn - all.size()], options.seed, index);
    }
    for (Solid* solid : {&c.pair.a, &c.pair.b})  // no -0, because readers of JSON lose it
      for (double* x : numbers_of(*solid)) *x += 0.0;
    c.id = fmt::format("v2-{:016x}", digest_of(c.pair, fnv1a("")));
    if (!ids.insert(c.id).second) continue;
    const auto line = vector_of(c, options.header);
    if (line) fmt::print("{}\n", *line);
    written += line.has_value();
  }
  if (options.header) fmt::print("}};\n#endif\n");
  return exit_pass;
}

}  // namespace

void add_vectors(Program& program) {
  Command command = program.command("Measure", "vectors",
                                    "Writes test vectors: pairs with their verdict, distance and proof");
  auto options = std::make_shared<VectorsOptions>();
  options->cases = in_source_tree("corpus/cases");
  command.section("Pairs");
  command.number("--seed N", options->seed, "seed; the same seed gives the same pairs on every machine");
  command.number("--count N", options->count, "number of vectors");
  command.option("--cases DIR", options->cases, "folder with the pairs of public reports; '' for none")
      .default_text("corpus/cases/");
  command.section("Output");
  command.flag("--header", options->header, "write a C header instead of JSON Lines");
  command.examples(
      "  daylight vectors --count 20000 --seed 7 > vectors.jsonl\n"
      "  daylight vectors --header > vectors.h",
      "The exit codes 2 and 3 do not occur for vectors.");
  command.run([options] { return write_vectors(*options); });
}

}  // namespace cyl
