// SPDX-License-Identifier: MIT
// Every erratum is shown by its case, or changes no verdict on the families.
#include "oracles/methods/errata_test.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include "corpus/pairs/families.hpp"
#include "corpus/pairs/pair_io.hpp"
#include "corpus/store/case_files.hpp"
#include "solver/literature/separation_2008.hpp"

namespace cyl {
namespace {

constexpr std::uint64_t pairs_per_family = 100;
constexpr std::uint64_t family_seed = 20080302;
/// Relative to the size. Below it, rounding also decides for the corrected methods.
constexpr double rounding_margin = 1e-12;

std::map<std::string, Case> cases() {
  std::map<std::string, Case> found;
  for (const Case& c : read_case_folder(DAYLIGHT_SOURCE_DIR "/corpus/cases"))
    if (c.id.starts_with("erratum-")) found.emplace(c.id, c);
  return found;
}

TEST(Errata, EachThatAPairShowsIsShownByItsCase) {
  auto left = cases();
  for (const Erratum& e : errata()) {
    if (e.shown_by == ShownBy::none) continue;
    const auto found = left.find(case_of(e));
    ASSERT_NE(found, left.end()) << e.id;
    const Case& c = found->second;
    EXPECT_TRUE(ShownErratum(e).on(c.pair, rounding_margin)) << e.id;
    for (const Solid& solid : {c.pair.a, c.pair.b})
      for (const double x : {solid.center.x(), solid.center.y(), solid.center.z(), solid.axis.x(),
                             solid.axis.y(), solid.axis.z(), solid.radius, solid.height})
        EXPECT_EQ(x, std::round(x)) << e.id;
    left.erase(found);
  }
  for (const auto& [id, c] : left) ADD_FAILURE() << id << " belongs to no erratum";
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

TEST(Errata, ErrataMdStatesThePairAndTheAnswersOfEach) {
  std::ifstream file(DAYLIGHT_SOURCE_DIR "/solver/literature/errata.md");
  const std::string all{std::istreambuf_iterator<char>(file), {}};
  const auto pairs = cases();
  for (const Erratum& e : errata()) {
    const std::string section = section_of(all, e.id);
    ASSERT_FALSE(section.empty()) << e.id;
    EXPECT_NE(section.find(" Kind: "), std::string::npos) << section;
    if (e.shown_by == ShownBy::none) continue;
    const Pair& pair = pairs.at(case_of(e)).pair;
    const ShownErratum shown(e);
    const std::string text = format_pair(pair);
    const std::size_t second = text.find("\"b\":");
    for (const std::string& stated :
         {std::string(to_string(judge(pair).verdict)) + ", by proof. `" + wrong_method(e) + "` answers " +
              std::string(to_string(shown.wrong->ask(pair).verdict)) + ", `" + right_method(e) +
              "` answers " + std::string(to_string(shown.right->ask(pair).verdict)) + '.',
          text.substr(0, second), text.substr(second)})  // the section has a line for each solid
      EXPECT_NE(section.find(stated), std::string::npos) << e.id << ": " << stated;
  }
}

/// A program can follow these errors, but no pair shows them. They change no verdict, alone or in the
/// printed text.
TEST(Errata, HarmlessOnesChangeNoVerdict) {
  for (const Erratum& e : errata()) {
    if (e.shown_by != ShownBy::none || !e.fault) continue;
    const std::string only = wrong_method(e), stem = only.substr(0, only.find('-')),
                      name = only.substr(stem.size() + std::string_view("-only-").size());
    for (const auto& [with, without] :
         {std::pair(only, stem + "-mended"), std::pair(stem + "-printed", stem + "-without-" + name)}) {
      const auto one = ShownErratum::method_named(with), other = ShownErratum::method_named(without);
      for (const Family& family : families())
        for (std::uint64_t index = 0; index < pairs_per_family; ++index) {
          const Pair pair = family.generate(family_seed, index);
          ASSERT_EQ(one->ask(pair).verdict, other->ask(pair).verdict)
              << with << ' ' << family.name << ' ' << index;
        }
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
