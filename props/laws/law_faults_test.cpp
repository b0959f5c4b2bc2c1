// SPDX-License-Identifier: MIT
// Each law catches a planted fault. If other laws catch it too, there is a reason.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <bit>
#include <cmath>

#include "corpus/pairs/pair_numbers.hpp"
#include "oracles/referee/referee.hpp"
#include "props/laws/law_groups.hpp"
#include "props/laws/laws_test.hpp"

namespace cyl {
namespace {

/// One of our methods, asked about pairs of a family.
struct Asked {
  std::string_view ours;  ///< `measured`: see below
  std::string_view family = "random";
  Claim claim = of_verdicts;
};
const Asked intersecting{"intersect"}, deciding{"decide"}, promising{"decide", "random", of_everything},
    measuring{"distance"}, of_edges{"exact", "box_edges"}, of_box_and_cylinder{"exact", "box_cylinder"},
    of_plane{"exact", "half_space_cylinder"}, measuring_plane{"measured", "half_space_cylinder"};

/// A right answer with a distance, also for half-spaces. A gap comes with its direction.
MethodAnswer measured(const Pair& pair) {
  if (!has_half_space(pair)) return ask_ours("distance", pair);
  MethodAnswer answer = ask_ours("exact", pair);
  answer.has_distance = true;
  answer.distance = approximate_distance(pair).value;
  return answer;
}

using Change = std::function<void(const Pair&, MethodAnswer&)>;

/// The laws that our method with a fault breaks: `change` alters its answers.
Numbers broken_by(const Asked& asked, const Change& change) {
  const auto ask = [&](const Pair& pair) {
    MethodAnswer answer = asked.ours == "measured" ? measured(pair) : ask_ours(asked.ours, pair);
    change(pair, answer);
    return answer;
  };
  return laws_broken_by(Planted(ask, "planted", asked.claim), asked.family);
}

void catches(const char* fault, const Asked& asked, const Numbers& laws, const Change& change) {
  EXPECT_EQ(broken_by(asked, change), laws) << fault;
}
void catches_among_others(const char* fault, const Asked& asked, const Numbers& laws, const Change& change) {
  const Numbers broken = broken_by(asked, change);
  for (const int law : laws) EXPECT_TRUE(std::ranges::count(broken, law)) << fault << ' ' << law;
}

TEST(LawFaults, NoneIsSeenInRightAnswers) {
  const auto none = [](const Pair&, MethodAnswer&) {};
  for (const char* family : {"box_edges", "box_flush", "box_half_space", "box_quaternion"})
    catches(family, {"exact", family}, {}, none);
  for (const char* family : {"half_space_cylinder", "half_space_normal"})
    catches(family, {"measured", family}, {}, none);
}

double centre_distance(const Pair& pair) { return (pair.b.center - pair.a.center).norm(); }

/// Returns the distance of the solids in units of their size, if that is next to nothing, and otherwise 1.
double margin_near_contact(const Pair& pair) {
  const double margin = ask_ours("distance", pair).distance / size_of(pair);
  return std::fabs(margin) < 0.05 ? margin : 1;
}

TEST(LawFaults, OfAnswers) {
  catches("a failure", intersecting, {30}, [](const Pair&, MethodAnswer& answer) {
    answer.status = Status::failed;
    answer.failure = Failure::crash;
  });
  catches("a wrong verdict", intersecting, {31}, [](const Pair&, MethodAnswer& answer) {
    if (answer.verdict == Verdict::intersecting) answer.verdict = Verdict::touching;
  });
  catches("a direction that does not separate", deciding, {32}, [](const Pair&, MethodAnswer& answer) {
    if (answer.witness == CertificateKind::direction) answer.set_direction(Vector3(1, 0, 0));
  });
  catches("a distance too large", measuring, {33},
          [](const Pair& pair, MethodAnswer& answer) { answer.distance += 1e-9 * size_of(pair); });
  // The distance is wrong too, and no triangle shows a gap if there is none.
  catches("a distance of the other sign", measuring, {23, 33, 34}, [](const Pair&, MethodAnswer& answer) {
    if (answer.distance < 0) answer.distance = -answer.distance;
  });
  catches("more steps than allowed", deciding, {38},
          [](const Pair&, MethodAnswer& answer) { answer.steps = answer.step_cap + 1; });
  catches("who is undecided without need", promising, {1, 39, 41},
          [](const Pair& pair, MethodAnswer& answer) {
            if (pair.a.radius < 2 * pair.b.radius) return;
            answer = answered(Verdict::undecided);
          });
  catches("who takes a bad solid", promising, {41}, [](const Pair& pair, MethodAnswer& answer) {
    if (pair.b.radius < 0) answer.verdict = Verdict::disjoint;
  });
  catches("a direction the wrong way", promising, {40}, [](const Pair&, MethodAnswer& answer) {
    if (answer.witness == CertificateKind::direction)
      for (double& x : answer.head) x = -x;
  });
  // Three other laws see it too. The enclosure disagrees, a solid moved on along the direction is nearer than
  // that proves, and the distance jumps from a gap to none.
  catches("a distance below what a direction proves", measuring, {13, 22, 33, 42},
          [](const Pair& pair, MethodAnswer& answer) {
            if (answer.distance > 0) answer.distance -= 1e-9 * size_of(pair);
          });
}

TEST(LawFaults, OfExactLaws) {
  catches("an answer that looks at the length of an axis", promising, {4},
          [](const Pair& pair, MethodAnswer& answer) {
            if (pair.a.axis.norm() > 1e6) answer.verdict = Verdict::undecided;
          });
  // A mirror does not keep the sense in which the axes wind, nor do half of the permutations. The verdict is
  // wrong. Law 31 proves it, the proxies of 11 and 12 show it, and 22 sees it at the first wrong ones.
  catches("an answer that knows left from right", intersecting, {5, 6, 11, 12, 22, 31},
          [](const Pair& pair, MethodAnswer& answer) {
            const Vector3 delta = pair.b.center - pair.a.center;
            const double winding = delta.dot(pair.a.axis.cross(pair.b.axis)) * pair.a.axis.dot(pair.b.axis);
            if (winding < 0 && margin_near_contact(pair) < 0) answer.verdict = Verdict::disjoint;
          });
  // A rotation also turns x to y. The rest is as above.
  catches("an answer that favours a coordinate", intersecting, {6, 11, 12, 20, 22, 31},
          [](const Pair& pair, MethodAnswer& answer) {
            const Vector3 delta = pair.b.center - pair.a.center;
            if (std::fabs(delta.x()) > std::fabs(delta.y()) && margin_near_contact(pair) < 0)
              answer.verdict = Verdict::disjoint;
          });
  catches("a verdict that favours one role", intersecting, {1}, [](const Pair& pair, MethodAnswer& answer) {
    if (pair.a.radius < pair.b.radius) answer.verdict = Verdict::undecided;
  });
  // These hulls prove nothing about round solids, so law 32 finds them too.
  catches("hulls that stay with the first", promising, {1, 32}, [](const Pair&, MethodAnswer& answer) {
    if (answer.witness == CertificateKind::point) answer.hulls[0] = Hull::plane;
  });
}

// At the first scale that is asked, the solids are below an absolute claim. At the last scale they are not.
TEST(LawFaults, BeyondTheClaimAreFoundBehindOnesWithinIt) {
  const auto turns = [](const Pair& pair) {
    MethodAnswer answer = ask_ours("intersect", pair);
    const double size = size_of(pair);
    if (size < 1e-50 || size > 1e50) answer.verdict = Verdict::disjoint;
    return answer;
  };
  Planted method(turns, "planted", {0, 1e-6, "planted"});
  const Pair pair{{{0, 0, 0}, {0, 0, 1}, 1, 2}, {{1, 0, 0}, {0, 1, 0}, 1, 2}};
  const auto violation = violation_of(method, law_numbered(2), pair);
  ASSERT_TRUE(violation);
  EXPECT_EQ(violation->severity, Severity::contract) << violation->what;
}

TEST(LawFaults, OfApproximateLaws) {
  // The fault depends on the angle to the coordinate axes. No mirror or permutation changes it. The factor is
  // above 1, so moves are too long as well.
  catches("a distance that depends on the direction", measuring, {20, 22, 24, 33},
          [](const Pair& pair, MethodAnswer& answer) {
            const Vector3 delta = pair.b.center - pair.a.center;
            const double steep = delta.lpNorm<Eigen::Infinity>() / delta.norm();
            answer.distance *= 1 + 1e-6 * steep;
          });
  catches("a distance that depends on the place", measuring, {21},
          [](const Pair& pair, MethodAnswer& answer) {
            if (pair.a.center.norm() > 1000 * size_of(pair)) answer.distance *= 2;
          });
  catches("a verdict that depends on the place", intersecting, {21},
          [](const Pair& pair, MethodAnswer& answer) {
            if (pair.a.center.norm() > 1000 * size_of(pair)) answer.verdict = Verdict::intersecting;
          });
  // The distance is also wrong and below what its direction shows. Two ways together are shorter than one.
  catches("a distance in steps", measuring, {13, 22, 23, 33, 42}, [](const Pair& pair, MethodAnswer& answer) {
    const double step = size_of(pair) / 100;
    answer.distance = step * std::trunc(answer.distance / step);
  });
  // A small turn leaves the axis at nearly unit length.
  catches("a verdict that misses a small turn", intersecting, {22},
          [](const Pair& pair, MethodAnswer& answer) {
            const double square = pair.a.axis.squaredNorm();
            if (std::fabs(square - 1) > 0x1p-23 && std::fabs(square - 1) < 0x1p-19)
              answer.verdict = Verdict::intersecting;
          });
  // One solid is much smaller than the other. Only the middle solid of the triangle is.
  catches("a way that is longer than around", measuring, {23}, [](const Pair& pair, MethodAnswer& answer) {
    if (std::min(pair.a.radius, pair.b.radius) < std::max(pair.a.radius, pair.b.radius) / 512 &&
        answer.distance > 0)
      answer.distance = 0;
  });
  catches_among_others("a rounding that counts twice", {"distance", "capsule_capsule"}, {25},
                       [](const Pair& pair, MethodAnswer& answer) {
                         if (answer.distance > pair.a.rounding) answer.distance -= pair.a.rounding;
                       });
  // The fault lies next to touching. No drawn pair lies there, but every slide ends there.
  catches("a depth beyond the way back", measuring, {24}, [](const Pair& pair, MethodAnswer& answer) {
    const double least = 1e-5 * size_of(pair);
    if (answer.distance < 0 && answer.distance > -least) answer.distance = -least;
  });
  // For a method that never takes the right way out, the gap that a slide leaves shows the fault.
  catches("a depth that opens a gap", measuring, {22, 24, 33}, [](const Pair&, MethodAnswer& answer) {
    if (answer.distance < 0) answer.distance *= 1.001;
  });
}

TEST(LawFaults, OfOneSidedLaws) {
  // Some radii are left out of a table that is otherwise right. To grow out of the right ones is a jump, as
  // is any small change of a radius.
  catches("solids that grow apart", intersecting, {10, 11, 12, 22, 31},
          [](const Pair& pair, MethodAnswer& answer) {
            const auto bits =
                std::bit_cast<std::uint64_t>(pair.a.radius) ^ std::bit_cast<std::uint64_t>(pair.b.radius);
            if (bits % 4 == 0) answer.verdict = Verdict::disjoint;
          });
  // The needles have one length, so only a copy is so much smaller.
  catches("a solid missed inside another", {"intersect", "needles"}, {11},
          [](const Pair& pair, MethodAnswer& answer) {
            const double a = pair.a.radius + pair.a.height, b = pair.b.radius + pair.b.height;
            if (a < b / 1000 || b < a / 1000) answer.verdict = Verdict::disjoint;
          });
  // Without a direction, nothing is moved along it. But (22) moves a centre across the limit.
  catches("solids said to meet across a space", intersecting, {12, 22, 31},
          [](const Pair& pair, MethodAnswer& answer) {
            if (centre_distance(pair) > size_of(pair) / 2) answer.verdict = Verdict::intersecting;
          });
  catches("solids said to meet where they were moved apart", deciding, {13},
          [](const Pair& pair, MethodAnswer& answer) {
            if (centre_distance(pair) < 100 * size_of(pair)) return;
            answer.verdict = Verdict::intersecting;
            answer.witness = CertificateKind::none;
          });
  catches_among_others("a capsule that misses what its sphere meets", {"intersect", "capsule_capsule"}, {14},
                       [](const Pair& pair, MethodAnswer& answer) {
                         if (pair.a.height > pair.a.rounding) answer.verdict = Verdict::disjoint;
                       });
  catches("a distance that stops growing", measuring, {13}, [](const Pair& pair, MethodAnswer& answer) {
    const double most = 100 * size_of(pair);
    if (answer.distance > most) answer.distance = most;
  });
}

const Solid& box_of(const Pair& pair) { return is_box(pair.a) ? pair.a : pair.b; }
double quaternion_length(const Solid& box) {
  return Eigen::Vector4d::Map(box.quaternion.data()).stableNorm();
}

void turn_verdict(MethodAnswer& answer) {
  answer = answered(answer.verdict == Verdict::disjoint ? Verdict::intersecting : Verdict::disjoint);
}

TEST(LawFaults, WithBoxes) {
  catches("an absolute tolerance", of_edges, {2}, [](const Pair& pair, MethodAnswer& answer) {
    if (size_of(pair) < 1e-6) answer = answered(Verdict::undecided);
  });
  catches("who looks at the sign of a quaternion", of_edges, {3}, [](const Pair& pair, MethodAnswer& answer) {
    if (pair.a.quaternion[0] * pair.b.quaternion[0] < 0) answer = answered(Verdict::undecided);
  });
  catches("a quaternion that is taken for a unit vector", of_edges, {4},
          [](const Pair& pair, MethodAnswer& answer) {
            if (quaternion_length(box_of(pair)) > 1e6) answer = answered(Verdict::undecided);
          });
  // Only this law asks about quaternions of large integers. With other names for the edges their sum is even.
  catches("edges that are exchanged", of_box_and_cylinder, {7}, [](const Pair& pair, MethodAnswer& answer) {
    const auto& q = box_of(pair).quaternion;
    const double length = quaternion_length(box_of(pair));
    if (length > 0x1p39 && length < 0x1p44 && std::fmod(q[0] + q[1] + q[2] + q[3], 2) == 0)
      turn_verdict(answer);
  });
  catches_among_others("a box that grows out of another", of_edges, {10},
                       [](const Pair& pair, MethodAnswer& answer) {
                         if (std::bit_cast<std::uint64_t>(box_of(pair).edges[1]) % 4 == 0)
                           answer = answered(Verdict::disjoint);
                       });
  // No other law puts another shape into the place of a box.
  catches("a wrong answer about what is around or inside", of_box_and_cylinder, {15},
          [](const Pair& pair, MethodAnswer& answer) {
            if (!has_box(pair)) turn_verdict(answer);
          });
  // The verdict is wrong, too.
  catches_among_others("a quaternion that turns the other way", of_edges, {5, 31},
                       [](Pair pair, MethodAnswer& answer) {
                         for (Solid* c : {&pair.a, &pair.b})
                           for (double& x : c->quaternion) x = std::fabs(x);
                         answer = ask_ours("exact", pair);
                       });
}

const Solid& plane_of(const Pair& pair) { return is_half_space(pair.a) ? pair.a : pair.b; }
const Solid& solid_of(const Pair& pair) { return is_half_space(pair.a) ? pair.b : pair.a; }

/// How far the solid's centre is from the plane's point, along the plane.
double aside(const Pair& pair) {
  const Vector3 n = direction_of(plane_of(pair)), delta = solid_of(pair).center - plane_of(pair).center;
  return (delta - n.dot(delta) * n).stableNorm();
}

TEST(LawFaults, WithHalfSpaces) {
  catches("who looks at the sense of the solids axis", of_plane, {3},
          [](const Pair& pair, MethodAnswer& answer) {
            if (pair.a.axis.dot(pair.b.axis) < 0) answer = answered(Verdict::undecided);
          });
  catches("a solid that grows out of the plane", of_plane, {10, 11, 12, 22, 31},
          [](const Pair& pair, MethodAnswer& answer) {
            const auto bits = std::bit_cast<std::uint64_t>(solid_of(pair).radius);
            if (bits % 4 == 0) answer = answered(Verdict::disjoint);
          });
  // A plane without an inside. No solid of this family is wholly behind it.
  catches("a solid missed behind the plane", {"exact", "half_space_tilted"}, {11},
          [](const Pair& pair, MethodAnswer& answer) {
            if (approximate_distance(pair).value < -size_of(pair)) answer = answered(Verdict::disjoint);
          });
  catches("a gap that is taken for contact", of_plane, {12, 31}, [](const Pair& pair, MethodAnswer& answer) {
    if (approximate_distance(pair).value < 0.05 * size_of(pair)) answer = answered(Verdict::intersecting);
  });
  // The small third solids of the triangle are that far away too.
  catches("a distance that stops growing", measuring_plane, {13, 23},
          [](const Pair& pair, MethodAnswer& answer) {
            answer.distance = std::min(answer.distance, 100 * size_of(pair));
          });
  // A small turn leaves the normal at nearly unit length.
  catches("a verdict that misses a small turn", of_plane, {22}, [](const Pair& pair, MethodAnswer& answer) {
    const double off = std::fabs(plane_of(pair).axis.squaredNorm() - 1);
    if (off > 0x1p-23 && off < 0x1p-19) answer = answered(Verdict::intersecting);
  });
  catches("a way that is longer than around", measuring_plane, {23},
          [](const Pair& pair, MethodAnswer& answer) {
            if (has_half_space(pair) && size_of(pair) < 0.03 && answer.distance > 0) answer.distance = 0;
          });
  // No drawn solid lies that far from the point of the plane.
  catches("a plane that ends", of_plane, {26}, [](const Pair& pair, MethodAnswer& answer) {
    if (aside(pair) > 100 * size_of(pair)) answer = answered(Verdict::disjoint);
  });
  catches("a distance to the point of the plane", measuring_plane, {26},
          [](const Pair& pair, MethodAnswer& answer) {
            if (aside(pair) > 100 * size_of(pair)) answer.distance += 1e-6 * size_of(pair);
          });
}

}  // namespace
}  // namespace cyl
