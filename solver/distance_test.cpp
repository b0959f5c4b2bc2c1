// SPDX-License-Identifier: MIT
#include "solver/distance.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>

#include "solver/solver_test.hpp"

namespace cyl {
namespace {

class Stream : public Numbers {
 public:
  using Numbers::Numbers;
  Vector3 vector(double limit) {
    return {between(-limit, limit), between(-limit, limit), between(-limit, limit)};
  }
  Solid cylinder() { return {vector(1), vector(1), between(0, 1), between(0, 3)}; }
  // Every shape, in every pose, that has cases of its own.
  Pair pair(int i) {
    Pair p{cylinder(), cylinder()};
    if (i % 3 == 1) p.a.radius = 0;
    if (i % 5 == 1) p.b.height = 0;
    if (i % 7 == 1) p.b.axis = p.a.axis;
    if (i % 7 == 2) p.b.axis = -p.a.axis + vector(1e-9);
    if (i % 7 == 3) p.b.axis = p.a.axis.cross(p.b.axis);
    if (i % 11 == 1) p.b.center = p.a.center;
    if (i % 11 == 2) p.b.radius = 0;
    return p;
  }
};

Solid lying(double x, double y, double z, double radius, double height) {
  return {Vector3(x, y, z), Vector3(1, 0, 0), radius, height};
}

struct Known {
  Pair pair;
  double value;
  Vector3 direction;  // 0: any
};

const Vector3 any(0, 0, 0);

TEST(Distance, PairsKnownOnPaper) {
  const Solid unit = upright(0, 0, 0, 1, 2);
  const Known all[] = {
      // Parallel: faces, sides, rims at a 3-4-5 corner, inside one another.
      {{unit, upright(0.5, 0, 5, 1, 2)}, 3, {0, 0, 1}},
      {{unit, upright(-3, -4, 0.5, 1, 2)}, 3, {-0.6, -0.8, 0}},
      {{unit, upright(5, 0, 6, 1, 2)}, 5, {0.6, 0, 0.8}},
      {{unit, upright(0, 0, 7, 1, 2)}, 5, {0, 0, 1}},
      {{unit, upright(0, 0, 1.5, 1, 2)}, -0.5, {0, 0, 1}},
      {{unit, upright(1.75, 0, 0, 1, 2)}, -0.25, {1, 0, 0}},
      {{unit, unit}, -2, any},
      {{unit, upright(0, 0, 2, 1, 2)}, 0, {0, 0, 1}},
      // Crossed at right angles: side over cap, side by side, rim over side.
      {{unit, lying(0, 0, 4, 1, 2)}, 2, {0, 0, 1}},
      {{unit, lying(0, 0, 4, 1, 40)}, 2, {0, 0, 1}},
      {{unit, lying(0, 4, 0, 1, 2)}, 2, {0, 1, 0}},
      {{unit, lying(6, 0, 0, 1, 4)}, 3, {1, 0, 0}},
      {{unit, lying(0, 0, 1.5, 1, 2)}, -0.5, {0, 0, 1}},
      // The lying rim's lowest point over the upright one's rim: (1, 0, 1) and (5, 0, 4).
      {{unit, lying(6, 0, 5, 1, 2)}, 5, {0.8, 0, 0.6}},
      // Askew: the lowest point of b's rim, 5 - (3 h + 4 r)/5 = 3.6 up, over the cap.
      {{unit, {Vector3(1, 0, 5), Vector3(4, 0, 3), 0.5, 10.0 / 3}}, 2.6, {0, 0, 1}},
      // A segment whose end is farther from its line's nearest point: from (0, 3, 4) to the rim (0, 1, 1).
      {{unit, {Vector3(0, 6, 8), Vector3(0, 3, 4), 0, 10}}, std::sqrt(13.0), any},
      // Segments, disks and points.
      {{upright(0, 0, 0, 0, 2), lying(0, 3, 0, 0, 2)}, 3, {0, 1, 0}},
      {{upright(0, 0, 0, 0, 2), lying(0, 0, 0, 0, 2)}, 0, {0, 1, 0}},
      {{upright(0, 0, 0, 1, 0), upright(5, 0, 4, 1, 0)}, 5, {0.6, 0, 0.8}},
      {{upright(0, 0, 0, 1, 0), lying(0, 0, 0, 1, 0)}, -1, any},
      {{upright(1, 2, 3, 0, 0), upright(3, 5, 9, 0, 0)}, 7, {2.0 / 7, 3.0 / 7, 6.0 / 7}},
      {{upright(1, 2, 3, 0, 0), lying(3, 5, 9, 0, 0)}, 7, {2.0 / 7, 3.0 / 7, 6.0 / 7}},
      {{upright(1, 2, 3, 0, 0), lying(1, 2, 3, 0, 0)}, 0, any},
      {{unit, lying(3, 0, 0, 0, 0)}, 2, {1, 0, 0}},
      {{unit, lying(0.75, 0, 0, 0, 0)}, -0.25, {1, 0, 0}}};
  for (const Known& k : all) {
    const Distance d = distance(k.pair.a, k.pair.b);
    const auto which = &k - all;
    EXPECT_NEAR(d.value, k.value, 1e-13 * reach_of(k.pair)) << "pair " << which;
    EXPECT_LE(d.error, 1e-13 * reach_of(k.pair)) << "pair " << which;
    if (k.direction != any) {
      EXPECT_LE((d.direction - k.direction).norm(), 1e-13) << "pair " << which;
    }
    if (std::fabs(k.value) > 1e-3) {
      EXPECT_EQ(d.verdict, k.value > 0 ? Verdict::disjoint : Verdict::intersecting) << "pair " << which;
    }
  }
}

// No feature brings the bounds together here, the points do that by going to and fro.
TEST(Distance, PointsAreBroughtNearer) {
  const Pair p{upright(0, 0, 0, 1, 0.6), {{1, 1.118033991749895, 0}, {0, 1e-8, 1}, 0.5, 0.6}};
  const Distance d = distance(p.a, p.b);
  EXPECT_EQ(d.verdict, Verdict::disjoint);
  EXPECT_LE(d.error, 1e-13 * reach_of(p));
}

// The plane that separates and the points are twice the rounding apart, and the error includes this.
TEST(Distance, ErrorHoldsTheWidthBetweenPlaneAndPoints) {
  const Pair p{upright(0, 0, 0, 1.4376847625826106, 0.67450831044606685),
               {{-1.4599086940320833, 0.67152285153773139, 2.8674881306595212},
                {0, 5.5445032830773847e-13, 1},
                0.51508226793627943,
                0.74792293011110422}};
  const Distance d = distance(p.a, p.b);
  const Wide way =
      (p.b.center - p.a.center).cast<long double>() + d.on_b.cast<long double>() - d.on_a.cast<long double>();
  EXPECT_LE(std::fabs(way.norm() - static_cast<long double>(d.value)), static_cast<long double>(d.error));
  EXPECT_GT(d.error,
            2 * distance_error *
                (p.a.radius + p.b.radius + (p.a.height + p.b.height) / 2 + (p.b.center - p.a.center).norm()));
}

// If only the heights differ, they alone decide which solid is first.
TEST(Distance, SwapOfSolidsAboutOneCentre) {
  const Solid a = upright(1, 2, 3, 1, 2), b = upright(1, 2, 3, 1, 4);
  const Distance d = distance(a, b), back = distance(b, a);
  EXPECT_EQ(d.direction, -back.direction);
  EXPECT_EQ(d.on_a, back.on_b);
  EXPECT_EQ(d.on_b, back.on_a);
}

// The lowest direction is next to the axis of a, and the point of the pole is exactly on the rim.
TEST(Distance, MinimumBesideAStationaryPole) {
  const Solid askew{Vector3(2, -1, -3), Vector3(-1, 0, -2), 3, 6};
  const Distance d = distance(askew, upright(3, 1, 0, 3, 4));
  EXPECT_GE(d.value, -2.99999914);  // the axis itself gives -3
  EXPECT_LE(d.value, -2.99999911);
}

// A direction square to nothing in particular: no random one is lower, apart or not.
TEST(Distance, NoOtherDirectionIsLower) {
  Stream random(5);
  for (int i = 0; i < 2000; ++i) {
    const Pair p = random.pair(i);
    const Distance d = distance(p.a, p.b);
    for (int j = 0; j < 100; ++j) {
      const Vector3 other = random.vector(1);
      ASSERT_LE(-support_gap(p, other), d.value + d.error) << "pair " << i;
      ASSERT_LE(-support_gap(p, d.direction + 1e-3 * other), d.value + d.error) << "pair " << i;
    }
  }
}

TEST(Distance, EndsOfTheRange) {
  const double most = std::numeric_limits<double>::max();
  for (const Solid& other : {upright(most, most, most, 1, 2), lying(most, most, most, most, most)}) {
    const Distance d = distance(upright(-most, -most, -most, 1, 2), other);
    EXPECT_EQ(d.verdict, Verdict::disjoint);
    EXPECT_LE(d.value, most);  // cut off there
    EXPECT_GT(d.value, most / 8);
  }
  const Solid speck = upright(0, 0, 0, 5e-324, 5e-324);
  EXPECT_EQ(distance(speck, speck).verdict, Verdict::intersecting);
  EXPECT_TRUE(std::isfinite(distance(speck, lying(0, 0, 0, 1e308, 5e-324)).value));
}

// Half of the least double between two disks.
TEST(Distance, AGapBelowAllDoublesIsNotZero) {
  const Solid disk{{0, 0, 0}, {3, -4, 12}, 0.9, 0};
  const Solid beside{{0, -2 * std::numeric_limits<double>::denorm_min(), 0}, {3, -4, 12}, 0.8, 0};
  const Distance d = distance(disk, beside);
  EXPECT_EQ(d.verdict, d.value > 0 ? Verdict::disjoint : Verdict::intersecting);
  EXPECT_LE(std::fabs(d.value), d.error);
}

// Coaxial but for a rounding: any direction square to the axis will do, but square it must be.
TEST(Distance, CoaxialSolidsKeepTheirDirectionSquare) {
  const Vector3 w(1, 1, 2);
  for (const double radius : {0.0, 0.25}) {
    const Solid a{Vector3(0, 0, 0), w, radius, 1}, b{w, w, radius / 2, 5};
    const Distance d = distance(a, b);
    EXPECT_GE(d.direction.dot(b.center - a.center), -1e-15);
    EXPECT_LE(std::fabs(d.direction.dot(w)), 1e-15);
    EXPECT_NEAR(d.value, -1.5 * radius, 1e-15);
  }
}

// The deepest point lies in its solid. This holds if a whole side is deepest, if caps all but lie on each
// other, and if a rim is all but square to the direction.
TEST(Distance, DeepestPointsLieInTheirSolids) {
  const Pair pairs[] = {
      {upright(0, 0, 0, 0.1, 2), lying(0, 0, 1.9, 1, 100)},
      {upright(0, 0, 0, 0.1, 2), lying(3, 0.01, 1.9, 1, 100)},
      {lying(0, 0, 0, 1, 5), upright(-0.75, -1.5, 1.75, 2, 4)},
      {{{0, 0, 0},
        {-0.28016788322002556, -0.053950688065066199, -0.95843376426069182},
        0.94995584336315919,
        0.62320225877173696},
       {{0.17033391726727803, -1.2832298608460666, -1.8565673456552638},
        {-0.28016711218074852, -0.053950105939432245, -0.95843402241490983},
        0.79277972168858202,
        2.9986094824252532}},
      {lying(0, 0, 0, 1.8213673951383307, 2.1940805778713246),
       {{0.79957459116879093, -0.5, -1.3249708591326761}, {0, 1, 0}, 2.0970072773141153, 3.1940145546282301}},
      {{{0, 0, 0}, {0, 0, 1}, 0.50869604375587918, 0.00067755723201702947},
       {{-0.0042646740975587766, -0.50903482237177844, -0.0099298839687209494},
        {0, 1, 0},
        0.010496511183431555,
        0.00067755723201702947}}};
  for (const Pair& p : pairs) {
    const Distance d = distance(p.a, p.b);
    ASSERT_LT(d.value, 0);
    EXPECT_LE(outside(p.a, d.on_a), 1e-13 * reach_of(p));
    EXPECT_LE(outside(p.b, d.on_b), 1e-12 * reach_of(p));
    const Vector3 y = p.b.center - p.a.center + d.on_b - d.on_a;
    EXPECT_LE((y - d.value * d.direction).norm(), 1e-14 * reach_of(p));
  }
}

// Found by a campaign. f is flat from the poles to the circles; depths in 113 bits, by a search over
// directions.
TEST(Distance, FindsTheDepthInAFlatValley) {
  const Solid a{{2.1620297199287264, -2.4687042190803603, 1.256769312395855},
                {0.5086679462676531, 0.8609627869076851, 0},
                1.1578625628677526,
                0.4788928469533734},
      b{{3.625019602821091, -2.4024347995372226, 1.2567694051985225},
        {0.508667177555022, 0.8609632410725654, 1.7791759813279657e-07},
        0.06800865597854862,
        1.1235701581616409};
  EXPECT_NEAR(distance(a, b).value, -1.20425892e-12, 1e-16);
  const Solid c{{0, 0, 0},
                {0.9671522631386378, 0.007889216095092846, -0.25407530414272045},
                0.003876462523378664,
                8.413680357385453e-06},
      d{{0.004584573012102359, 0.03925209595696156, 0.025074067402078515},
        {0.9671522631468801, 0.007889216108005715, -0.2540753041109447},
        0.04289753561431928,
        0.003245692057004645};
  EXPECT_NEAR(distance(c, d).value, -1.97303e-15, 1e-17);
}

TEST(Distance, DirectionIsOfUnitLengthWhereSquaresVanish) {
  for (const Vector3& off : {Vector3(3e-162, 1e-162, 0), Vector3(1e-160, 3.3e-161, 0)})
    for (const double radius : {0.0, 0.5}) {
      const Solid a{Vector3(0, 0, 0), Vector3(0, 0, 1), radius, 1}, b{off, a.axis, radius, 1};
      EXPECT_NEAR(distance(a, b).direction.norm(), 1, 4e-16);
    }
}

// The lowest point of a circle is the meeting point of two others. Its search ended when the tangent of an
// angle was subnormal, and the value of a subnormal number depends on the unit.
TEST(Distance, UnitsDoNotShowWhereALowestPointIsAtAnEnd) {
  const Pair pair{{{-0.69492695114483305, -0.63410625349428928, 0.34496909509936036},
                   {-0.68766948294923613, 0.4423907275606298, -0.57567449692083594},
                   0.0010027025120531836,
                   0.0024651598547548712},
                  {{0, 0, 0}, {-1, 3, 3.5}, 1, 0}};
  const Distance here = distance(pair.a, pair.b);
  EXPECT_LE(here.iterations, 12);
  for (const double unit : {0x1p-3, 0x1p-1, 0x1p5, 0x1p-20}) {
    Pair p = pair;
    for (Solid* c : {&p.a, &p.b}) {
      c->center *= unit;
      c->radius *= unit;
      c->height *= unit;
    }
    EXPECT_EQ(distance(p.a, p.b).on_a, Vector3(here.on_a * unit));
  }
}

}  // namespace
}  // namespace cyl
