// SPDX-License-Identifier: MIT
// Every erratum is shown by its case, or changes no verdict on the families.
#include "oracles/methods/errata.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <iterator>
#include <map>
#include <memory>
#include <string>
#include <string_view>

#include "corpus/pairs/families.hpp"
#include "corpus/pairs/pair_io.hpp"
#include "corpus/pairs/pair_numbers.hpp"
#include "corpus/store/case_files.hpp"
#include "oracles/referee/referee.hpp"

namespace cyl {
namespace {

constexpr std::uint64_t pairs_per_family = 100;
constexpr std::uint64_t family_seed = 20080302;
/// Relative to the size. Below it, rounding also decides for the corrected methods.
constexpr double rounding_margin = 1e-12;

std::unique_ptr<Method> method_named(const std::string& name) {
  for (auto methods : {literature_2008_methods, literature_2017_methods, errata_methods})
    for (auto& method : methods())
      if (method->name() == name) return std::move(method);
  return nullptr;
}

/// Two methods that differ by one fault alone. Both are literal, so no code of ours repairs its effect.
struct Difference {
  std::unique_ptr<Method> wrong, right;
};
/// Returns the corrected text with and without the fault, and the printed text with and without it.
std::array<Difference, 2> differences(const Erratum& e) {
  const std::string stem = "seed" + std::string(e.id.substr(0, e.id.find('-'))),
                    fault(e.id.substr(e.id.find('-') + 1));
  return {Difference{method_named(stem + "-only-" + fault), method_named(stem + "-mended")},
          Difference{method_named(stem + "-printed"), method_named(stem + "-without-" + fault)}};
}

/// Returns whether the pair is certainly not near touching, the right method gives the proved verdict, and
/// the wrong method gives the opposite. For touching pairs the convention of section 3.1 is the truth.
bool shows(const Pair& pair, const Erratum& e, const Difference& methods) {
  if (!methods.right) return false;  // the printed text has no such fault
  const Verdict said = methods.wrong->ask(pair).verdict, known = methods.right->ask(pair).verdict;
  if (said == known) return false;
  const Truth truth = judge(pair);
  if (e.fault == literature::Fault::mixed_strictness)
    return truth.verdict == Verdict::touching && known == Verdict::disjoint;
  if ((truth.verdict == Verdict::disjoint) != (known == Verdict::disjoint)) return false;
  const Enclosure distance = enclose_distance(pair, truth);
  return std::max(distance.lo, -distance.hi) >= rounding_margin * size_of(pair);
}

std::map<std::string, Case> cases() {
  std::map<std::string, Case> found;
  for (const Case& c : read_case_folder(DAYLIGHT_SOURCE_DIR "/corpus/cases"))
    if (c.id.starts_with("erratum-")) found.emplace(c.id.substr(std::string_view("erratum-").size()), c);
  return found;
}

/// Returns the part of errata.md about an erratum, on one line.
std::string section_of(const std::string& all, std::string_view id) {
  const std::size_t begin = all.find("\n### " + std::string(id) + '\n');
  if (begin == all.npos) return {};
  const std::size_t end = std::min(all.find("\n### ", begin + 1), all.find("\n## ", begin + 1));
  std::string line;
  for (const char c : all.substr(begin, end - begin)) {
    const bool blank = c == ' ' || c == '\n';
    if (!blank || !line.ends_with(' ')) line += blank ? ' ' : c;
  }
  return line;
}

TEST(Errata, EachCaseShowsOneAndErrataMdStatesItsAnswers) {
  std::ifstream file(DAYLIGHT_SOURCE_DIR "/solver/literature/errata.md");
  const std::string all{std::istreambuf_iterator<char>(file), {}};
  for (const auto& [id, c] : cases()) {
    const auto e = std::ranges::find(errata(), id, &Erratum::id);
    ASSERT_NE(e, errata().end()) << id;
    const auto ways = differences(*e);
    const auto way =
        std::ranges::find_if(ways, [&](const Difference& methods) { return shows(c.pair, *e, methods); });
    ASSERT_NE(way, ways.end()) << id;
    for (const double x : numbers_of(c.pair)) EXPECT_EQ(x, std::round(x)) << id;
    const std::string section = section_of(all, id);
    EXPECT_NE(section.find(" Kind: "), std::string::npos) << id;
    const auto answer = [&](const auto& method) {
      return '`' + std::string(method->name()) + "` answers " + to_string(method->ask(c.pair).verdict);
    };
    const std::string text = format_pair(c.pair);
    const std::size_t second = text.find("\"b\":");
    for (const std::string& stated :
         {std::string(to_string(judge(c.pair).verdict)) + ", by proof. " + answer(way->wrong) + ", " +
              answer(way->right) + '.',
          text.substr(0, second), text.substr(second)})  // the section has a line for each solid
      EXPECT_NE(section.find(stated), std::string::npos) << id << ": " << stated;
  }
}

/// A program can follow these errors, but no pair shows them. They change no verdict, alone or in the
/// printed text.
TEST(Errata, OnesWithoutACaseChangeNoVerdict) {
  const auto shown = cases();
  for (const Erratum& e : errata()) {
    if (shown.contains(std::string(e.id))) continue;
    for (const Difference& methods : differences(e))
      for (const Family& family : families())
        for (std::uint64_t index = 0; index < pairs_per_family; ++index) {
          const Pair pair = family.generate(family_seed, index);
          ASSERT_EQ(methods.wrong->ask(pair).verdict, methods.right->ask(pair).verdict)
              << methods.wrong->name() << ' ' << family.name << ' ' << index;
        }
  }
}

TEST(Errata, MethodsAreAskedWhereTheyAreNamed) {
  const auto methods = all_methods();
  for (const char* spec : {"", "-seed2017-only-kinks", "seed2017,seedbook", "seed2017-printed"})
    EXPECT_TRUE(named_errata(methods, spec).empty()) << spec;
  const auto named = named_errata(methods, "seed2017-only-kinks,intersect,seed2017-printed-octants");
  ASSERT_EQ(named.size(), 2u);
  EXPECT_EQ(named[0]->name(), "seed2017-printed-octants");
  EXPECT_EQ(named[1]->name(), "seed2017-only-kinks");
  EXPECT_GT(named_errata(methods, "seed2008-only").size(), 5u);
  for (const auto& method : errata_methods())
    for (const auto& other : methods) EXPECT_NE(method->name(), other->name());
}

}  // namespace
}  // namespace cyl
