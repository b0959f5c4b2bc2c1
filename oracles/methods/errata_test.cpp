// SPDX-License-Identifier: MIT
// Every erratum is shown: by its case, or, where `why` says that no verdict changes, by none on the families.
#include "oracles/methods/errata_test.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>

#include "corpus/pairs/families.hpp"
#include "corpus/store/case_files.hpp"

namespace cyl {
namespace {

constexpr std::uint64_t pairs_per_family = 100;
constexpr std::uint64_t family_seed = 20080302;
/// In sizes: below it the methods put right are rounding too.
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
    EXPECT_EQ(judge(c.pair).verdict, c.truth) << e.id;
    for (const Cylinder& solid : {c.pair.a, c.pair.b})
      for (const double x : {solid.center.x(), solid.center.y(), solid.center.z(), solid.axis.x(),
                             solid.axis.y(), solid.axis.z(), solid.radius, solid.height})
        EXPECT_EQ(x, std::round(x)) << e.id;
    left.erase(found);
  }
  for (const auto& [id, c] : left) ADD_FAILURE() << id << " belongs to no erratum";
}

/// Those that no pair shows, though a program can follow them: alone they change no verdict.
TEST(Errata, HarmlessOnesChangeNoVerdict) {
  for (const Erratum& e : errata()) {
    if (e.shown_by != ShownBy::none || !e.fault) continue;
    const ShownErratum shown(e);
    for (const Family& family : families())
      for (std::uint64_t index = 0; index < pairs_per_family; ++index) {
        const Pair pair = family.generate(family_seed, index);
        ASSERT_EQ(shown.wrong->ask(pair).verdict, shown.right->ask(pair).verdict)
            << e.id << ' ' << family.name << ' ' << index;
      }
  }
}

/// What a row says it is in words.
TEST(Errata, SayWhatIsSo) {
  std::set<std::string_view> ids;
  for (const Erratum& e : errata()) {
    EXPECT_TRUE(ids.insert(e.id).second) << e.id;
    EXPECT_EQ(e.shown_by == ShownBy::none, e.rate.empty()) << e.id;
    EXPECT_TRUE(e.fault || e.shown_by == ShownBy::none) << e.id;
    EXPECT_TRUE(e.shown_by != ShownBy::none || e.why.find("o verdict changes") != e.why.npos) << e.id;
  }
}

TEST(Errata, MethodsAreAskedWhereTheyAreNamed) {
  const auto methods = all_methods();
  for (const char* spec : {"", "-seed2017-only-kinks", "seed2017,seedbook", "seed2017-printed"})
    EXPECT_TRUE(named_errata(methods, spec).empty()) << spec;
  const auto named = named_errata(methods, "seed2017-only-kinks,intersect,seed2017-printed-powell");
  ASSERT_EQ(named.size(), 2u);
  EXPECT_EQ(named[0]->name(), "seed2017-printed-powell");
  EXPECT_EQ(named[1]->name(), "seed2017-only-kinks");
  EXPECT_GT(named_errata(methods, "seed2008-only").size(), 5u);
  for (const auto& method : errata_methods())
    for (const auto& other : methods) EXPECT_NE(method->name(), other->name());
}

}  // namespace
}  // namespace cyl
