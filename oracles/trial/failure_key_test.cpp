// SPDX-License-Identifier: MIT
#include "oracles/trial/failure_key.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "base/fnv.hpp"
#include "corpus/pairs/stratum.hpp"

namespace cyl {
namespace {

const Pair plain{{{0, 0, 0}, {0, 0, 1}, 1, 2}, {{3, 0, 0}, {0, 1, 1}, 1, 2}};

Pair changed(void (*change)(Pair&)) {
  Pair p = plain;
  change(p);
  return p;
}

TEST(CoordinateOf, ShowsWhatIsExtreme) {
  EXPECT_EQ(coordinate_of(plain, 0.1), Coordinate::plain);
  EXPECT_EQ(coordinate_of(plain, 1e-3), Coordinate::plain);
  EXPECT_EQ(coordinate_of(plain, 0.99e-3), Coordinate::margin);
  const auto of = [](void (*change)(Pair&), double margin = 0.1) {
    return coordinate_of(changed(change), margin);
  };
  EXPECT_EQ(of([](Pair& p) { p.a.center.y() = p.b.center.y() = 1e4; }), Coordinate::offset);
  EXPECT_EQ(of([](Pair& p) { p.a.center.y() = p.b.center.y() = 500; }), Coordinate::plain);
  EXPECT_EQ(of([](Pair& p) { p.a.center.y() = 550, p.b.center.y() = 1000; }), Coordinate::plain);
  EXPECT_EQ(of([](Pair& p) { p.b.center.y() = 1e4; }), Coordinate::plain);  // far apart
  EXPECT_EQ(of([](Pair& p) { p.a.center.y() = -1e4, p.b.center.y() = 1e4; }), Coordinate::plain);
  EXPECT_EQ(of([](Pair& p) {
              for (Solid* c : {&p.a, &p.b}) c->radius *= 1e-4, c->height *= 1e-4, c->center *= 1e-4;
            }),
            Coordinate::scale);
  EXPECT_EQ(of([](Pair& p) {
              for (Solid* c : {&p.a, &p.b}) c->radius *= 1e3, c->height *= 1e3, c->center *= 1e3;
            }),
            Coordinate::scale);
  EXPECT_EQ(of([](Pair& p) { p.a.radius = 0.0099; }), Coordinate::aspect);
  EXPECT_EQ(of([](Pair& p) { p.a.radius = 0.0101; }), Coordinate::plain);
  EXPECT_EQ(of([](Pair& p) { p.a.radius = 0; }), Coordinate::plain);  // a segment is not a needle
  EXPECT_EQ(of([](Pair& p) { p.b.height = 0.0199; }), Coordinate::aspect);
  EXPECT_EQ(of([](Pair& p) { p.b.radius = 0.01, p.b.height = 0.01; }), Coordinate::aspect);
  EXPECT_EQ(of([](Pair& p) { p.b.axis = {0, 1e-9, 1}; }), Coordinate::angle);
  EXPECT_EQ(of([](Pair& p) { p.b.axis = {0, 0.009, 1}; }), Coordinate::angle);
  EXPECT_EQ(of([](Pair& p) { p.b.axis = {0, 1, 1e-15}; }), Coordinate::angle);
  EXPECT_EQ(of([](Pair& p) { p.b.axis = {0, 0, -3}; }), Coordinate::plain);
  EXPECT_EQ(of([](Pair& p) { p.b.axis = {1, 1, 0}; }), Coordinate::plain);
  EXPECT_EQ(of([](Pair& p) { p.a.radius = p.a.height = p.b.radius = p.b.height = 0; }), Coordinate::plain);
  EXPECT_EQ(of([](Pair& p) { p.a.radius = p.a.height = 0, p.a.rounding = 1; }), Coordinate::plain);
  EXPECT_EQ(of([](Pair& p) { p.a.radius = p.a.height = 0, p.a.rounding = 1e-3; }), Coordinate::aspect);
}

TEST(CoordinateOf, TakesTheFirstInOrder) {
  Pair p = plain;
  EXPECT_EQ(coordinate_of(p, 1e-9), Coordinate::margin);
  p.b.axis = {0, 1e-9, 1};
  EXPECT_EQ(coordinate_of(p, 1e-9), Coordinate::angle);
  p.a.height = 500;
  EXPECT_EQ(coordinate_of(p, 1e-9), Coordinate::aspect);
  p.a.height = 5000;
  EXPECT_EQ(coordinate_of(p, 1e-9), Coordinate::scale);
  p.a.center.x() = p.b.center.x() = 1e9;
  EXPECT_EQ(coordinate_of(p, 1e-9), Coordinate::offset);
}

TEST(FailureKey, IsMethodFailureFeatureCoordinate) {
  EXPECT_EQ(
      failure_key("fcl-libccd", "wrong_disjoint", to_string(ContactFeature::side_rim), Coordinate::angle),
      "fcl-libccd/wrong_disjoint/side-rim/angle");
  EXPECT_EQ(failure_key("ode", "swap", to_string(ContactFeature::containment), Coordinate::plain),
            "ode/swap/containment/plain");
}

TEST(FailureKey, AsLettersIsItsHash) {
  // The published value of the hash of "foobar": 85944171f73967e8.
  EXPECT_EQ(fnv1a("foobar"), 0x85944171f73967e8u);
  EXPECT_EQ(fnv1a("bar", fnv1a("foo")), fnv1a("foobar"));
  EXPECT_EQ(letter_hash("foobar"), "ebhbphdjghoi");
  std::set<std::string> seen;
  for (const char* method : {"fcl-libccd", "fcl-indep", "bullet", "ode", "mujoco"})
    for (int f = 0; f < 7; ++f)
      for (int c = 0; c < 6; ++c) {
        const std::string key = failure_key(
            method, "wrong_disjoint", to_string(static_cast<ContactFeature>(f)), static_cast<Coordinate>(c));
        const std::string letters = letter_hash(key);
        EXPECT_EQ(letters.size(), 12u);
        EXPECT_EQ(letters.find_first_not_of("abcdefghijklmnop"), std::string::npos);
        EXPECT_TRUE(seen.insert(letters).second) << key;
      }
}

}  // namespace
}  // namespace cyl
