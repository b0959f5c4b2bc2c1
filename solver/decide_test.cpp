// SPDX-License-Identifier: MIT
#include "solver/decide.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <cstdint>

#include "solver/distance.hpp"
#include "solver/intersect_batch.hpp"
#include "solver/solver_test.hpp"

namespace cyl {
namespace {

class Stream : public Numbers {
 public:
  using Numbers::Numbers;
  Vector3 direction() {
    for (;;) {
      const Vector3 v(between(-1, 1), between(-1, 1), between(-1, 1));
      if (v.norm() > 0.1 && v.norm() < 1) return v / v.norm();
    }
  }
  Solid cylinder() {
    return {Vector3(between(-1, 1), between(-1, 1), between(-1, 1)), direction(), between(0.1, 2),
            between(0.1, 4)};
  }
};

// Returns the point of a solid farthest in direction d, from its centre, or any of several.
Vector3 support(const Solid& c, const Vector3& d, Stream& random) {
  const Vector3 w = c.axis.normalized();
  const double along = d.dot(w);
  const Vector3 radial = d - along * w;
  Vector3 x =
      (std::fabs(along) > 1e-12 ? std::copysign(0.5, along) : random.between(-0.5, 0.5)) * c.height * w;
  if (radial.norm() > 1e-12) x += c.radius * radial.normalized();
  return x;
}

// A pair at the given signed distance, in units of its size, along d.
Pair at_distance(Solid a, Solid b, const Vector3& d, double relative_gap, Stream& random) {
  const double size = a.radius + a.height + b.radius + b.height;
  b.center = a.center + support(a, d, random) - support(b, -d, random) + d * (relative_gap * size);
  return {a, b};
}

TEST(Decide, RightAndProvedOnBothSidesOfTouching) {
  Stream random(20261121);
  int decided[2] = {0, 0}, undecided = 0;
  for (int i = 0; i < 40000; ++i) {
    Solid a = random.cylinder(), b = random.cylinder();
    if (i % 3 == 1) a.radius *= 1e-4;  // needles
    if (i % 3 == 2) b.height *= 1e-4;  // coins
    const Vector3 w0 = a.axis, w1 = b.axis;
    const Vector3 directions[5] = {random.direction(), w0, w0.cross(w1).normalized(),
                                   w0.cross(random.direction()).normalized(), Vector3(-w1)};
    const double decade = std::pow(10, -1 - i % 12);  // 0.1 .. 1e-12
    const bool apart = random.unit() < 0.5;
    const Pair p = at_distance(a, b, directions[i % 5], apart ? decade : -decade, random);
    const Verdict truth = apart ? Verdict::disjoint : Verdict::intersecting;
    ASSERT_EQ(intersect(p.a, p.b), truth) << "pair " << i;
    const Answer answer = decide(p.a, p.b);
    ASSERT_LT(answer.iterations, decide_iteration_cap);
    if (answer.verdict == Verdict::undecided) {
      ++undecided;
      continue;
    }
    ASSERT_EQ(answer.verdict, truth) << "pair " << i;
    ++decided[apart];
    if (apart) {
      ASSERT_EQ(answer.proof, Proof::direction);
      ASSERT_LT(support_gap(p, answer.direction), 0) << "pair " << i;
      ASSERT_GT(answer.direction.dot(p.b.center - p.a.center), 0);
    } else {
      ASSERT_EQ(answer.proof, Proof::point);
    }
  }
  // The test reached both sides, and hardly ever a pair without an answer.
  EXPECT_GT(decided[0], 15000);
  EXPECT_GT(decided[1], 15000);
  EXPECT_LT(undecided, 400);
}

TEST(Decide, EndsOfTheRange) {
  const Solid far_left = upright(-1.7e308, 0, 0, 1, 2), far_right = upright(1.7e308, 0, 0, 1e308, 2);
  EXPECT_EQ(decide(far_left, far_right).verdict, Verdict::disjoint);  // the centres' difference overflows
  const Solid speck = upright(0, 0, 0, 5e-324, 5e-324);
  EXPECT_EQ(decide(speck, speck).verdict, Verdict::intersecting);
}

TEST(Decide, NoPointBeyondTheLargestDouble) {
  const Solid a{Vector3(-1e308, 0, 0), Vector3(1, 0, 2), 1.7e308, 1.7e308};
  const Solid b{Vector3(1.29e308, 0, 0), Vector3(1, 0, 0), 1.75e308, 1e308};
  const Answer answer = decide(a, b);
  EXPECT_TRUE(answer.point_tail.allFinite());
  EXPECT_NE(answer.verdict, Verdict::disjoint);
}

// The law that an answer with room for a proof is not undecided found this. The highest slice ends at the
// tip of a disk (the rim of a stands on that of b, with the axes at right angles). Or it ends at the tip of
// a segment, which is nothing but tip.
TEST(Decide, ProvesGapsBesideTips) {
  const Pair pairs[] = {
      {{Vector3(2, 2, -2), Vector3(0, 0, 1), 2, 1}, {Vector3(-2, 3, -3), Vector3(1, 0, 0), 1, 4}},
      {{Vector3(-2, -2, 2), Vector3(0, 1, 0), 2, 4}, {Vector3(1, 2, 1), Vector3(1, 0, -2), 2, 2}},
      {{Vector3(0, -1, -2), Vector3(0, 0, 1), 2, 4}, {Vector3(-2, 1, 1), Vector3(0, 1, 0), 1, 2}},
      {{Vector3(-2, 1, -1), Vector3(0, 1, 0), 3, 2}, {Vector3(1, -1, 2), Vector3(1, 0, 0), 1, 5}},
      {{Vector3(0.70447, -0.84696, 0.0806), Vector3(0.03698, -0.99895, -0.02698), 8.6162, 2.21505},
       {Vector3(-10.28945, -1.51019, -2.87309), Vector3(-0.68619, -0.66851, 0.28677), 0, 8.05704}},
      {{Vector3(0.06749, 0.70675, -0.3734), Vector3(0.75725, 0.48968, -0.43218), 3.6398, 2.97556},
       {Vector3(-0.03325, -1.39051, 2.16108), Vector3(-0.76654, 0.58642, 0.26177), 0, 6.58504}}};
  for (const Pair& p : pairs) {
    EXPECT_EQ(decide(p.a, p.b).verdict, Verdict::disjoint);
    EXPECT_EQ(decide(p.b, p.a).verdict, Verdict::disjoint);
  }
}

// Cubes of a lattice whose axes are at right angles but for a rounding, 0.02 to 0.18 apart. The end of one is
// in line with the rim of the other. A campaign of a billion pairs found them.
TEST(Decide, ProvesGapsAtAxesSquareButForARounding) {
  const Pair pairs[] = {
      {{Vector3(0, 3, 2), Vector3(2, 1, 0), 1, 2},
       {Vector3(2, 3, 0), Vector3(8.937938184587448e-17, -4.484781043539769e-17, 1), 1, 2}},
      {{Vector3(1, -3, 0), Vector3(-1.5259030389609006e-16, -1.0000000000000002, 2), 1, 2},
       {Vector3(-1, -3, -2), Vector3(-1, 0, 0), 1, 2}},
      {{Vector3(-1, 2, 1), Vector3(5.122876111306861e-17, 1, 8.588139516111827e-17), 1, 2},
       {Vector3(-1, 0, 3), Vector3(-1, 0, 2), 1, 2}},
      {{Vector3(-2, -1, -1), Vector3(1, 5.407808132487433e-16, -8.411635465365984e-16), 1, 2},
       {Vector3(0, 0, 1), Vector3(0, 0, -1), 1, 2}},
      {{Vector3(0, 1, 1), Vector3(4.876598504893711e-16, -8.730337165428862e-16, -1), 1, 2},
       {Vector3(2, 0, 3), Vector3(-1, 0, 0), 1, 2}}};
  for (const Pair& p : pairs) {
    EXPECT_EQ(decide(p.a, p.b).verdict, Verdict::disjoint);
    EXPECT_EQ(decide(p.b, p.a).verdict, Verdict::disjoint);
    EXPECT_EQ(intersect(p.a, p.b), Verdict::disjoint);
    const IndexPair indices[16] = {};  // in every lane
    Verdict verdicts[16];
    const Prepared a = prepare(p.a), b = prepare(p.b);
    intersect_batch({&a, 1}, {&b, 1}, indices, verdicts);
    for (const Verdict said : verdicts) EXPECT_EQ(said, Verdict::disjoint);
  }
}

// z rounds to r0 + r1: the slope of F is noise far out, and the search must see that it is.
TEST(Decide, EndsWhereTheSlopeIsRounding) {
  const Solid a{Vector3(0, 0, 0), Vector3(-0x1.bc7ef9e954412p-1, -0x1.75cb3e842c151p-2, 0x1.584e98e3a88d7p-2),
                0x1.472ac2e4c35b8p-3, 0x1.88dd11025c14ep-1};
  const Solid b{Vector3(0x1.0546e5371aedbp-1, 0x1.47f69de9f6e2dp-5, -0x1.b75759a1d8b39p-4),
                Vector3(-0x1.bf2b2e4b125e3p-1, -0x1.85b7e51f68ab1p-2, 0x1.3737acbb0fab1p-2),
                0x1.a229711c88df8p-7, 0x1.c30eac1384af2p-3};
  EXPECT_LT(decide(a, b).iterations, 60);
}

// Gaps that double alone does not prove. A cap's border is in the plane of the other's cap, with the axes
// 1e-15 apart. Or the axes are all but square, or segments lie side by side, or lengths are 1e271 apart.
TEST(Decide, ProvesGapsThatRoundingHides) {
  const Pair pairs[] = {
      {{Vector3(0, 0, 0), Vector3(0, 0, 1), 3, 6}, {Vector3(-5, 2, -7), Vector3(0, 3, 4), 4, 4}},
      {{Vector3(0, 0, 0), Vector3(0, 0, 1), 5, 6}, {Vector3(6, -8, 7), Vector3(0, 3, -4), 3, 10}},
      {{Vector3(0, 0, 0), Vector3(0.3422637646834484, -0.8395023563572672, -0.4220086599292826),
        0.11017494225220584, 2.6456315525242347},
       {Vector3(-0.9749389316379928, -5.828023973286293, 6.704393193310718),
        Vector3(0.34226376468345354, -0.8395023563572676, -0.4220086599292777), 7.711211487953818,
        0.8136516519828619}},
      {{Vector3(0, 0, 0), Vector3(0, -1, 0), 4, 2},
       {Vector3(-4.571739711562755, -4, 3.9685115978853105),
        Vector3(-1.0476591106850177e-15, 1, -1.798451146637744e-15), 2, 6}},
      {{Vector3(0, 0, 0), Vector3(-0.8474871826606096, -0.5307409473544117, -0.008917512395516523),
        0.7011727422361593, 0.3673396247333566},
       {Vector3(-0.5115251256922481, 0.46618208821713697, 0.22280472549821798),
        Vector3(-0.06590183611067849, 0.12451568001130262, -0.9900276613982899), 8.849546964868194e-05,
        0.6150513289088054}},
      {{Vector3(0, 0, 0), Vector3(0.9453033725360256, 0.2875220722153185, -0.15405386026005674), 0,
        0.2123553564467482},
       {Vector3(-3.3855030671627087, -1.0297296537754541, 0.5517274470517148),
        Vector3(236.58306241928716, 71.95875349026868, -38.555383485049575), 0, 7.164059981223426}},
      {{Vector3(0, 0, 0), Vector3(0, 0, -1), 3.32101592848426e-288, 6.510129745930559e-246},
       {Vector3(0.06713070102102087, -1.819587959123952e-229, -0.1377979219284154), Vector3(0, -1, 0),
        0.1377979219284154, 3.639175918247904e-229}}};
  for (const Pair& p : pairs) {
    EXPECT_EQ(decide(p.a, p.b).proof, Proof::direction) << &p - pairs;
    EXPECT_EQ(decide(p.b, p.a).proof, Proof::direction) << &p - pairs;
  }
}

// A feature of each solid at a common normal, at any tilt and in any place down to rounding, with lengths
// from 1e-6 to 1. Gaps of 1.01e-13 of the size are proved, and so are overlaps that hold a ball of 1e-13
// size.
TEST(Decide, UndecidedOnlyWithinItsWord) {
  Stream random(20261122);
  const auto decades = [&](double least) { return std::pow(10, random.between(least, 0)); };
  const auto angle = [&] {
    const int kind = static_cast<int>(random.between(0, 4));
    return kind == 0   ? decades(-16)
           : kind == 1 ? 1.5707963267948966 - decades(-16)
           : kind == 2 ? 0
                       : random.between(0, 1.57);
  };
  int gaps = 0, balls = 0;
  for (int i = 0; i < 30000; ++i) {
    const Vector3 n = random.direction(), u = n.cross(random.direction()).normalized(), v = n.cross(u);
    const double between = angle();
    const Vector3 turned = std::cos(between) * u + std::sin(between) * v;
    Solid a = random.cylinder(), b = random.cylinder();
    for (double* length : {&a.radius, &a.height, &b.radius, &b.height})
      if (i % 2) *length = decades(-6);
    a.center = Vector3(0, 0, 0);
    const double tilt_a = angle(), tilt_b = i % 3 ? angle() : tilt_a + decades(-16);
    a.axis = std::cos(tilt_a) * u + std::sin(tilt_a) * n;
    b.axis = std::cos(tilt_b) * turned + std::sin(tilt_b) * n;
    const double margin = 1.01e-13 + decades(-14);
    const Pair apart = at_distance(a, b, n, margin, random), common = at_distance(a, b, n, -margin, random);
    if (support_gap(apart, n) < -1.005e-13L * (a.radius + a.height + b.radius + b.height)) {
      ++gaps;
      EXPECT_EQ(decide(apart.a, apart.b).proof, Proof::direction) << "pair " << i;
    }
    Pair inner = common;
    const double ball = 1e-13 * (a.radius + a.height + b.radius + b.height);
    for (Solid* c : {&inner.a, &inner.b}) {
      c->radius -= ball;
      c->height -= 2 * ball;
    }
    if (intersect(inner.a, inner.b) == Verdict::intersecting) {
      ++balls;
      EXPECT_EQ(decide(common.a, common.b).proof, Proof::point) << "pair " << i;
    }
  }
  EXPECT_GT(gaps, 25000);
  EXPECT_GT(balls, 15000);
}

// A thin solid just inside the side of a large one: near the thin one's outermost line its width grows by
// 1e-10 over the rounding of a double.
TEST(Decide, ProvesThatThinSolidsMeetJustInsideASide) {
  const Pair pairs[] = {{{{0, 0, 0}, {1, -1, 1.5}, 1.1861443422987863e-06, 2.1512072844500797e-05},
                         {{0.15929014607854455, 0.26209215184990375, 0.068561717361532978},
                          {0.76527961450485327, -0.55175774882646111, 0.33152752258788276},
                          0.31426996328444928,
                          2.1512072844500797e-05}},
                        {{{0, 0, 0},
                          {0.37604961273151361, 0.69551759239754818, 0.61224338904556308},
                          9.7382360682857586e-07,
                          0.00010120123349317763},
                         {{0.123838762845924, 0.020284123993049085, -0.099024807585726668},
                          {2, 0, 2.5},
                          0.15985331878994027,
                          1.8745585459273174e-10}},
                        {{{0, 0, 0},
                          {-0.40409461917815731, 0.76429234778295707, 0.50255820147687902},
                          0.76211461466304309,
                          1.0000000000003701},
                         {{0.34329963489366522, 0.080023107464933588, -0.84057629381856347},
                          {0.45162670461976895, -0.75265583004309411, -0.48203568593232221},
                          3.3852608385904964e-06,
                          6.0023581454897202e-06}}};
  for (const Pair& p : pairs) EXPECT_EQ(decide(p.a, p.b).proof, Proof::point);
}

// Solids without inner points: what they share is known by the lines and planes they lie in.
TEST(Decide, ProvesThatFlatSolidsMeet) {
  const Vector3 oblique(0.3, -0.5, 0.7), other(0.9, 0.1, -0.2);
  const Solid solid{Vector3(0.1, 0.2, 0.3), oblique, 1, 2}, segment{Vector3(0.12, 0.2, 0.31), other, 0, 3},
      disk{Vector3(0, 0.1, 0.2), other, 1, 0}, tilted{Vector3(0.1, 0.2, 0.3), oblique, 1, 0},
      point{Vector3(0.3, 0.1, 0.2), other, 0, 0}, thin{Vector3(0.2, 0, 0.4), other, 1e-17, 3};
  const struct {
    Solid a, b;
    Hull hull_a, hull_b;
  } cases[] = {{segment, solid, Hull::line, Hull::space},  {disk, solid, Hull::plane, Hull::space},
               {segment, tilted, Hull::line, Hull::plane}, {disk, tilted, Hull::plane, Hull::plane},
               {thin, solid, Hull::line, Hull::space},     {point, solid, Hull::center, Hull::space}};
  for (const auto& c : cases) {
    const Answer answer = decide(c.a, c.b), swapped = decide(c.b, c.a);
    EXPECT_EQ(answer.proof, Proof::point) << &c - cases;
    EXPECT_EQ(swapped.proof, Proof::point) << &c - cases;
    EXPECT_EQ(answer.hull_a, c.hull_a);
    EXPECT_EQ(answer.hull_b, c.hull_b);
    EXPECT_EQ(swapped.hull_b, c.hull_a);
  }
  EXPECT_EQ(decide(segment, segment).proof, Proof::point);  // one centre
}

// No edge goes through the other box, if roundings are believed.
TEST(Decide, ProvesThatBoxesMeetWhoseCornersCoincideButForRounding) {
  Solid a, b;
  a.shape = b.shape = Shape::box;
  a.edges = {0.9029406409130795, 2.62476568863047e-06, 1.9196053420029793};
  b.edges = {0.7700292680986964, 0.8910974188748206, 0.00217879372956778};
  b.center = {-0.06645575880165666, 0.44555008515501593, 0.9587135919892081};
  b.quaternion = {0.9999999998927445, 3.5669779043358895e-07, 7.743205232053791e-16, 8.124191416907793e-08};
  EXPECT_EQ(decide(a, b).verdict, Verdict::intersecting);
}

// Some directions show a gap within rounding, and only the last search shows the whole gap.
TEST(Decide, ProvesAGapThatOtherDirectionsHardlyShow) {
  Solid box;
  box.shape = Shape::box;
  box.edges = {4, 1, 5};
  box.center = {-3.0000000022701028, -1.249999999201159, 2.49997955349691};
  box.quaternion = {-1, -1, 1, 0.9999999981839702};
  EXPECT_EQ(decide(box, {{0, 0, 0}, {-1, 0, 0}, 2, 1}).verdict, Verdict::disjoint);
}

// It is flat by the word of decide(), but a little thicker than a common point in its plane needs.
TEST(Decide, ProvesThatADiskReachesIntoACorner) {
  Solid box;
  box.shape = Shape::box;
  box.edges = {0.905693013727656, 0.5735003793246456, 1.9798432401547077};
  const Solid disk = {Vector3(0.45284650685380134, 0.28675018965206694, 0.9899216200674803),
                      Vector3(-0.7781200626282494, 0.43428655440798813, 0.4537888901194551),
                      1.080901635803147e-11, 9.437723291610633e-14};
  EXPECT_EQ(decide(box, disk).verdict, Verdict::intersecting);
}

TEST(Decide, NothingIsAllocated) {
  Stream random(11);
  Pair pairs[64];
  for (Pair& p : pairs)
    p = at_distance(random.cylinder(), random.cylinder(), random.direction(), random.between(-1e-8, 1e-8),
                    random);
  Prepared a[64], b[64];
  IndexPair indices[64];
  Verdict verdicts[64];
  const long before = allocations;
  for (std::uint32_t i = 0; i < 64; ++i) {
    a[i] = prepare(pairs[i].a);
    b[i] = prepare(pairs[i].b);
    indices[i] = {i, i};
  }
  intersect_batch(a, b, indices, verdicts);
  int met = 0;
  for (const Pair& p : pairs) {
    met += intersect(p.a, p.b) == Verdict::intersecting;
    met += decide(p.a, p.b).verdict == Verdict::intersecting;
    met += distance(p.a, p.b).verdict == Verdict::intersecting;
  }
  EXPECT_EQ(allocations, before);
  EXPECT_GT(met, 10);
  EXPECT_LT(met, 182);
}

}  // namespace
}  // namespace cyl
