// SPDX-License-Identifier: MIT
#include "oracles/trial/mechanism.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "oracles/methods/fake_method_test.hpp"
#include "oracles/referee/referee.hpp"
#include "oracles/trial/algorithm_groups.hpp"
#include "oracles/trial/trial.hpp"
#include "solver/decide.hpp"

namespace cyl {
namespace {

/// Returns a method that is wrong if `errs` is true for the pair.
std::unique_ptr<Method> erring(std::string name, std::function<bool(const Pair&)> errs, bool capped = false,
                               bool guest = false) {
  const auto ask = [errs = std::move(errs), capped](const Pair& pair) {
    const bool meets = intersect(pair.a, pair.b) != Verdict::disjoint;
    MethodAnswer answer = answered(meets != errs(pair) ? Verdict::intersecting : Verdict::disjoint);
    answer.step_cap = 5;
    answer.steps = capped ? 5 : 1;
    return answer;
  };
  return fake_method(std::move(name), ask, {.guest = guest});
}

using Methods = std::vector<std::unique_ptr<Method>>;

Pair crossing(double size, double offset = 0) {
  Pair p;
  p.a = {{offset, 0, 0}, {0, 0, 1}, size / 4, size / 4};
  p.b = {{offset + size / 8, 0, 0}, {0, 1, 0}, size / 4, size / 4};
  return p;
}

Classification classified(const Methods& methods, const Pair& pair,
                          FindingKind kind = FindingKind::wrong_disjoint) {
  Asker asker(methods);
  return classify(methods, {0, kind, pair}, asker);
}

Classification classified(std::function<bool(const Pair&)> errs, const Pair& pair, bool capped = false) {
  Methods methods;
  methods.push_back(erring("lib-way", std::move(errs), capped));
  return classified(methods, pair);
}

TEST(Mechanism, IsGoneWhereTheMethodIsRightNow) {
  EXPECT_EQ(classified([](const Pair&) { return false; }, crossing(1)).mechanism, Mechanism::gone);
}

TEST(Mechanism, IsUnclassifiedWhereEveryPairIsWrong) {
  EXPECT_EQ(classified([](const Pair&) { return true; }, crossing(1)).mechanism, Mechanism::unclassified);
}

TEST(Mechanism, ShowsAnOffset) {
  const auto far = [](const Pair& p) { return p.a.center.norm() > 1e5; };
  EXPECT_EQ(classified(far, crossing(1, 1e6)).mechanism, Mechanism::offset);
  EXPECT_EQ(classified(far, crossing(0, 1e6)).mechanism, Mechanism::offset) << "points";
}

TEST(Mechanism, ShowsTheCapOnSteps) {
  EXPECT_EQ(classified([](const Pair&) { return true; }, crossing(1), true).mechanism,
            Mechanism::iteration_cap);
}

TEST(Mechanism, ShowsAFixedLength) {
  const Classification small = classified([](const Pair& p) { return size_of(p) < 1e-3; }, crossing(1e-4));
  EXPECT_EQ(small.mechanism, Mechanism::absolute_length);
  EXPECT_TRUE(small.larger);
  EXPECT_FALSE(small.smaller);
  const Classification large = classified([](const Pair& p) { return size_of(p) > 0.01; }, crossing(1));
  EXPECT_EQ(large.mechanism, Mechanism::absolute_length);
  EXPECT_TRUE(large.smaller);
}

TEST(Mechanism, ShowsWhatLeavesTheDoubles) {
  EXPECT_EQ(classified([](const Pair& p) { return size_of(p) > 1e100; }, crossing(1e120)).mechanism,
            Mechanism::overflow);
  EXPECT_EQ(classified([](const Pair& p) { return size_of(p) < 1e-100; }, crossing(1e-120)).mechanism,
            Mechanism::underflow);
}

/// A cut-off of the method itself is not an overflow, however large the pair is.
TEST(Mechanism, TellsACutOffFarAway) {
  for (const auto& [size, wrong] : {std::pair(
                                        0x1p200, +[](const Pair& p) { return size_of(p) > 300; }),
                                    std::pair(
                                        0x1p-200, +[](const Pair& p) { return size_of(p) < 300; })}) {
    Methods methods;
    methods.push_back(erring("lib-way", wrong));
    EXPECT_EQ(classified(methods, crossing(size)).mechanism, Mechanism::absolute_length);
  }
}

/// The edges that Bullet rounds are nothing at that size, and its model has no verdict.
TEST(Mechanism, AModelWithoutAVerdictIsNoCause) {
  const auto methods = select_methods(bullet_methods(), "bullet-cylinder");
  Pair nested;
  nested.a = {{0, 0, 0}, {0, 0, 1}, 1, 1};
  nested.b = {{0, 0, 0}, {0, 0, 1}, 9e307, 9e307};
  EXPECT_EQ(classified(methods, nested).mechanism, Mechanism::overflow);
}

/// Single precision has no numbers at that size, or the height is rounded to 0.
TEST(Mechanism, WhatVanishesIsNoCure) {
  EXPECT_EQ(classified([](const Pair& p) { return size_of(p) > 0x1p-64; }, crossing(1)).mechanism,
            Mechanism::unclassified);
  EXPECT_EQ(classified([](const Pair& p) { return size_of(p) < 0x1p64; }, crossing(1)).mechanism,
            Mechanism::unclassified);
  Pair flat = crossing(1);
  flat.a.height = 3e-308;
  EXPECT_EQ(classified([](const Pair& p) { return p.a.height > 0; }, flat).mechanism,
            Mechanism::unclassified);
}

/// The method is off by 2 % at every size, and answers nothing about small solids.
TEST(Mechanism, WhatFailsOtherwiseIsNoCure) {
  Methods methods;
  methods.push_back(fake_method("lib-way", [](const Pair& pair) {
    if (size_of(pair) < 1e-4) return failed_answer(Failure::reported, "too small");
    MethodAnswer answer = answered(Verdict::intersecting);
    answer.has_distance = true;
    answer.distance = 0.98 * approximate_distance(pair).value;
    return answer;
  }));
  const Classification found = classified(methods, crossing(1), FindingKind::distance_outside);
  EXPECT_EQ(found.mechanism, Mechanism::unclassified);
  EXPECT_FALSE(found.smaller || found.larger);
}

/// A distance 2 % off at every size. If the claim allows it for small pairs, that does not cure large ones.
TEST(Mechanism, ADistanceThatIsOffAsMuchAtEverySizeIsNoFixedLength) {
  Methods methods;
  methods.push_back(fake_method("coarse",
                                [](const Pair& pair) {
                                  MethodAnswer answer = answered(Verdict::disjoint);
                                  answer.has_distance = true;
                                  answer.distance = 0.98 * approximate_distance(pair).value;
                                  return answer;
                                },
                                {.claim = {.absolute = 1, .source = "this test"}}));
  Pair large = crossing(0x1p23);
  large.b.center.x() = 0x1p24;
  EXPECT_EQ(classified(methods, large, FindingKind::distance_outside).mechanism, Mechanism::unclassified);
}

TEST(Mechanism, ShowsRounding) {
  Pair p = crossing(1);
  p.b.center.x() = 0.5;  // the walls touch
  EXPECT_EQ(classified([](const Pair&) { return true; }, p).mechanism, Mechanism::rounding);
}

TEST(Mechanism, ShowsASettingThatIsRight) {
  Methods methods;
  methods.push_back(erring("lib-way", [](const Pair&) { return true; }));
  methods.push_back(erring("lib-way-fine", [](const Pair&) { return false; }));
  methods.push_back(erring("other", [](const Pair&) { return false; }));
  const Classification reported = classified(methods, crossing(1));
  EXPECT_EQ(reported.mechanism, Mechanism::setting);
  EXPECT_EQ(reported.right_sibling, 1u);
}

TEST(Mechanism, GivesOneKeyToOneCause) {
  Methods methods;
  methods.push_back(erring("lib-way", [](const Pair&) { return true; }));
  methods.push_back(erring("lib-way-fine", [](const Pair&) { return true; }));
  methods.push_back(erring("other-way", [](const Pair&) { return true; }));
  const std::vector<std::size_t> groups{0, 0, 0};
  Pair pair{{{0, 0, 0}, {0, 0, 1}, 1, 1}, {{0, 0, 2}, {0, 0, 1}, 1, 1}};
  const auto key = [&](std::size_t m, FindingKind kind, Severity severity, Mechanism mechanism,
                       std::string_view reason = {}) {
    return cause_key({methods, groups}, {m, kind, pair}, severity, mechanism, reason);
  };
  const auto contract = Severity::contract;
  EXPECT_EQ(key(1, FindingKind::wrong_disjoint, contract, Mechanism::absolute_length),
            "lib-way/absolute-length");
  EXPECT_EQ(key(1, FindingKind::bad_witness, contract, Mechanism::unclassified), "lib-way/bad_witness");
  EXPECT_EQ(key(1, FindingKind::bad_witness, contract, Mechanism::setting), "lib-way/bad_witness");
  EXPECT_EQ(key(0, FindingKind::wrong_disjoint, contract, Mechanism::overflow), "lib-way/overflow");
  EXPECT_EQ(key(2, FindingKind::wrong_disjoint, contract, Mechanism::unclassified),
            "other-way/wrong_disjoint")
      << "shares its algorithm with another library, and is called by its own name";
  EXPECT_EQ(methods_sharing_algorithm({methods, groups}, 2), (std::vector<std::size_t>{0, 1}));
  EXPECT_EQ(key(0, FindingKind::wrong_disjoint, Severity::resolution, Mechanism::unclassified),
            "lib/within-claim");
  EXPECT_EQ(key(0, FindingKind::crash, contract, Mechanism::unclassified,
                "SIGABRT: at 0x7f33 in line 12, bad shape"),
            "lib/crash/sigabrt-at-in-line-bad-shape");
  for (const auto& [reason, slug] : {std::pair("GjkEpaResultState 1", "gjkeparesultstate-1"),
                                     {"GjkEpaResultState 257", "gjkeparesultstate-257"},
                                     {"error: -3 of pair 77", "error-3-of-pair"},
                                     {"257", "257"},
                                     {"at 0.5, 31 steps", "at-steps"}})
    EXPECT_EQ(key(0, FindingKind::reported, contract, Mechanism::unclassified, reason),
              std::string("lib/reported/") + slug);
  // One fault of ordinary solids and another of huge ones do not share a key.
  pair.a.radius = 1e76;
  EXPECT_EQ(key(0, FindingKind::wrong_disjoint, contract, Mechanism::unclassified),
            "lib-way/wrong_disjoint/extreme");
}

TEST(Kin, ASettingIsAMethodOfTheSameLibraryAndAlgorithm) {
  const Methods all = all_methods();
  const auto differ = [&](const char* x, const char* y) {
    const auto named = [&](const char* name) -> const Method& {
      return **std::ranges::find(all, name, [](const auto& m) { return m->name(); });
    };
    return differ_in_setting(named(x), named(y));
  };
  EXPECT_TRUE(differ("fcl-libccd", "fcl-libccd-tol1e-10"));
  EXPECT_TRUE(differ("fcl-libccd-tol1e-10", "fcl-libccd"));
  EXPECT_TRUE(differ("bullet-hull-16", "bullet-hull-64"));
  EXPECT_TRUE(differ("ode", "ode-unrefined"));
  EXPECT_TRUE(differ("nlopt-direct-600", "nlopt-direct-6000"));
  EXPECT_FALSE(differ("fcl-libccd", "fcl-libccd"));
  EXPECT_FALSE(differ("fcl-libccd", "fcl-indep"));
  EXPECT_FALSE(differ("fcl-libccd", "fcl-distance-libccd"));
  EXPECT_FALSE(differ("nlopt-direct-600", "nlopt-sign-600"));
  // A guest with the name of a packaged library is another library.
  const auto guest = fake_method("mujoco", [](const Pair&) { return MethodAnswer{}; }, {.guest = true});
  for (const auto& m : all) EXPECT_FALSE(differ_in_setting(*m, *guest));
}

TEST(Kin, KeysNameAGuestApartFromThePackagedLibrary) {
  Methods methods;
  for (const bool guest : {false, true})
    methods.push_back(fake_method(guest ? "mujoco-js" : "mujoco",
                                  [](const Pair&) { return answered(Verdict::disjoint); }, {.guest = guest}));
  const std::vector<std::size_t> groups{0, 1};
  const auto key = [&](std::size_t method) {
    return cause_key({methods, groups}, {method, FindingKind::wrong_disjoint, {}}, Severity::resolution,
                     Mechanism::unclassified, "");
  };
  EXPECT_EQ(key(0), "mujoco/within-claim");
  EXPECT_EQ(key(1), "mujoco-guest/within-claim");
}

TEST(Kin, IsTheSettingOrTheSameErrors) {
  // The side on which b lies decides. The first two are wrong alike, and the third on the other half.
  const auto up = [](const Pair& p) { return p.b.center.z() > 0; };
  const auto down = [](const Pair& p) { return p.b.center.z() <= 0; };
  Methods methods;
  methods.push_back(erring("x-one", up));
  methods.push_back(erring("y-two", up));
  methods.push_back(erring("y-three", down));
  methods.push_back(erring("z-right", [](const Pair&) { return false; }));
  EXPECT_EQ(algorithm_groups(methods), (std::vector<std::size_t>{0, 0, 2, 3}));

  methods.push_back(erring("guest", up, false, true));
  methods.push_back(erring("guest-fast", down, false, true));
  EXPECT_EQ(algorithm_groups(methods), (std::vector<std::size_t>{0, 0, 2, 3, 4, 4}))
      << "of guests the name counts";
}

TEST(Kin, ALibraryAloneHasTheGroupsThatItHasAmongAll) {
  const Methods methods = all_methods();
  const std::vector<std::size_t> among_all = algorithm_groups(methods);
  for (std::size_t m = 0; m < methods.size(); ++m) {
    const auto is_of_library = [&](const Method& other) { return other.library() == methods[m]->library(); };
    if (m > 0 && is_of_library(*methods[m - 1])) continue;
    const std::vector<std::size_t> alone = algorithm_groups(methods, is_of_library);
    for (std::size_t x = 0; x < methods.size(); ++x)
      for (std::size_t y = 0; y < x; ++y)
        if (is_of_library(*methods[x]) && is_of_library(*methods[y])) {
          EXPECT_EQ(alone[x] == alone[y], among_all[x] == among_all[y])
              << methods[x]->name() << ' ' << methods[y]->name();
        }
  }
}

// Disjoint by 1/3. libccd's GJK reports intersecting if our sums go from the left.
TEST(DependsOnLastBit, TwoCoins) {
  const Pair coins{{Vector3(0, 0, 0), Vector3(1, 2, 2), 3, 1}, {Vector3(-4, -2, 2), Vector3(1, 2, 2), 3, 1}};
  const auto methods = ccd_methods();
  ASSERT_TRUE(try_method(methods[0], coins).fails(FindingKind::wrong_intersecting));
  EXPECT_EQ(depends_on_last_bit("libccd-gjk", FindingKind::wrong_intersecting, coins), true);
  EXPECT_EQ(depends_on_last_bit("ode", FindingKind::wrong_intersecting, coins), std::nullopt);
}

// GJK takes the distance for zero, with sums in any order.
TEST(DependsOnLastBit, NotAnAbsoluteLength) {
  const Pair tiny{{Vector3(0, 0, 0), Vector3(0, 0, 1), 1e-9, 2e-9},
                  {Vector3(3e-9, 1e-10, 0), Vector3(0, 0, 1), 1e-9, 2e-9}};
  EXPECT_EQ(depends_on_last_bit("libccd-gjk", FindingKind::wrong_intersecting, tiny), false);
}

}  // namespace
}  // namespace cyl
