// SPDX-License-Identifier: MIT
// Laws 1 to 9 make changes that alter no digit of the problem, so the answer may not change either. A method
// that computes promises this bit for bit. If a method searches, only its verdict is checked.
#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>
#include <utility>

#include "corpus/pairs/pair_io.hpp"
#include "corpus/pairs/pair_numbers.hpp"
#include "corpus/pairs/touch_plane.hpp"
#include "props/laws/law_groups.hpp"

namespace cyl {
namespace {

/// The second answer that a law expects. It is the first answer's distance and point times `length`, its
/// direction times `direction`, and its hulls in this or the other order.
struct Expected {
  double length = 1;
  double direction = 1;
  bool swapped = false;
};

std::string differ(const char* what, double wanted, double got) {
  return std::string(what) + " is " + format_double(got) + ", expected " + format_double(wanted);
}

// Numbers are the same by ==, so 0 is -0. If the first number times `factor` loses bits to underflow, on
// either side of the product, they may differ by the lost bits.
bool same(double first, double second, double factor) {
  const double lost = std::max(1.0, std::fabs(factor)) * std::numeric_limits<double>::denorm_min();
  return second == factor * first || std::fabs(second - factor * first) <= lost;
}

std::string difference_in_bits(const MethodAnswer& first, const MethodAnswer& second,
                               const Expected& expected) {
  if (first.has_distance != second.has_distance) return "only one answer has a distance";
  if (first.has_distance && !same(first.distance, second.distance, expected.length))
    return differ("the distance", expected.length * first.distance, second.distance);
  if (first.witness != second.witness) return "the witnesses are of different kinds";
  if (first.witness == CertificateKind::none) return {};
  for (int i = 0; i < 2; ++i)
    if (second.hulls[i] != first.hulls[expected.swapped ? 1 - i : i]) return "the point is in other hulls";
  const bool is_direction = first.witness == CertificateKind::direction;
  const double factor = is_direction ? expected.direction : expected.length;
  const bool exchanged = first.witness == CertificateKind::points && expected.swapped;
  for (int i = 0; i < 3; ++i) {
    const std::array<double, 4> one{first.head[i], first.tail[i], first.other_head[i], first.other_tail[i]};
    std::array<double, 4> other{second.head[i], second.tail[i], second.other_head[i], second.other_tail[i]};
    if (exchanged) std::rotate(other.begin(), other.begin() + 2, other.end());
    for (std::size_t k = 0; k < one.size(); ++k)
      if (!same(one[k], other[k], factor))
        return differ("a coordinate of the witness", factor * one[k], other[k]);
  }
  return {};
}

std::optional<Violation> compare_answers(const LawCase& c, std::size_t i, const Expected& expected) {
  const MethodAnswer& second = c.answers[i];
  if (second.status != Status::answered) return {};
  const bool bitwise_stable = c.method.claim().bitwise_stable;
  if (c.first.verdict != second.verdict) {
    return Violation{std::string("the verdict turns from ") + to_string(c.first.verdict) + " to " +
                         to_string(second.verdict),
                     bitwise_stable ? Severity::contract : severity_of(c, i)};
  }
  if (!bitwise_stable) return {};
  std::string what = difference_in_bits(c.first, second, expected);
  if (what.empty()) return {};
  return Violation{std::move(what), Severity::contract};
}

std::optional<Violation> all_as_expected(const LawCase& c, const Expected& expected = {}) {
  return worst_of(c, [&](std::size_t i) { return compare_answers(c, i, expected); });
}

std::vector<LawQuery> swapped(const Method&, const Pair& pair, const MethodAnswer&) {
  return {{{pair.b, pair.a}}};
}

/// The least size and distance of the centres. A little below it, decide() looks for points that lose no
/// bits. If these overflow, it looks for points that do not.
constexpr double least_scaled_length = 0x1p-890;
/// The least radius, height, rounding or edge that is not 0. In a thinner solid few points have coordinates
/// that are doubles.
constexpr double least_scaled_side = 0x1p-960;

double extent(const Pair& pair) {
  return size_of(pair) + (pair.b.center - pair.a.center).lpNorm<Eigen::Infinity>();
}
/// One step each way, and farther than float or an absolute tolerance bears.
constexpr int scales[] = {-400, -1, 1, 400};

/// Returns the pair with all lengths times 2^k, or nothing if that is not exact or leaves a pair too small.
std::optional<Pair> scaled_far_from_underflow(const Pair& whole, int k) {
  const auto pair = scaled_exactly(whole, k);
  if (!pair) return {};
  for (const Solid* c : {&pair->a, &pair->b})
    for (const double side : {c->radius, c->height, c->rounding, c->edges[0], c->edges[1], c->edges[2]})
      if (side != 0 && std::min(side, std::ldexp(side, -k)) < least_scaled_side) return {};
  const double before = extent(whole), after = extent(*pair);
  if (std::min(before, after) < least_scaled_length) return {};
  if (!std::isfinite(std::max(before, after))) return {};
  return pair;
}

std::vector<LawQuery> at_other_scales(const Method&, const Pair& pair, const MethodAnswer&) {
  std::vector<LawQuery> asked;
  for (const int k : scales)
    if (const auto other = scaled_far_from_underflow(pair, k)) asked.push_back({*other});
  return asked;
}

std::optional<Violation> break_scaling(const LawCase& c) {
  std::vector<int> asked;
  std::copy_if(std::begin(scales), std::end(scales), std::back_inserter(asked),
               [&](int k) { return scaled_far_from_underflow(c.pair, k).has_value(); });
  const auto cut_off = [](const MethodAnswer& x) {
    return x.has_distance && std::fabs(x.distance) == std::numeric_limits<double>::max();
  };
  return worst_of(c, [&](std::size_t i) -> std::optional<Violation> {
    if (cut_off(c.first) || cut_off(c.answers[i])) return {};
    auto violation = compare_answers(c, i, {.length = std::ldexp(1, asked[i])});
    if (violation) violation->what = "times 2^" + std::to_string(asked[i]) + ": " + violation->what;
    return violation;
  });
}

// 0 - x makes no -0, unlike -x. A -0 would show the direction of an axis that lacks this coordinate.
// The negated normal of a half-space would be another solid.
std::vector<LawQuery> reversed(const Method&, const Pair& pair, const MethodAnswer&) {
  const auto changed = [](Solid c, auto change) {
    if (is_box(c))
      std::ranges::for_each(c.quaternion, change);
    else if (!is_half_space(c))
      std::ranges::for_each(c.axis, change);
    return c;
  };
  const auto negated = [&](const Solid& c) { return changed(c, [](double& x) { x = -x; }); };
  const auto taken_from_0 = [&](const Solid& c) { return changed(c, [](double& x) { x = 0 - x; }); };
  return {{{negated(pair.a), pair.b}},
          {{pair.a, negated(pair.b)}},
          {{taken_from_0(pair.a), pair.b}},
          {{pair.a, taken_from_0(pair.b)}},
          {{negated(pair.a), taken_from_0(pair.b)}}};
}

/// Returns the solid with its axis or quaternion times 2^k, or nothing if that is not exact.
std::optional<Solid> with_longer_axis(Solid c, int k) {
  bool exact = true;
  const auto lengthen = [&](double& x) {
    const double y = std::ldexp(x, k);
    exact = exact && std::isfinite(y) && std::ldexp(y, -k) == x;
    x = y;
  };
  if (is_box(c))
    std::ranges::for_each(c.quaternion, lengthen);
  else
    std::ranges::for_each(c.axis, lengthen);
  if (!exact) return {};
  return c;
}

std::vector<LawQuery> with_longer_axes(const Method&, const Pair& pair, const MethodAnswer&) {
  std::vector<LawQuery> asked;
  for (const int k : scales) {
    const auto a = with_longer_axis(pair.a, k), b = with_longer_axis(pair.b, -k);
    if (!a || !b) continue;
    asked.push_back({{*a, pair.b}});
    asked.push_back({{pair.a, *b}});
  }
  return asked;
}

std::vector<LawQuery> mirrored(const Method&, const Pair& pair, const MethodAnswer&) {
  const Eigen::Vector3i order(0, 1, 2);
  std::vector<LawQuery> asked;
  for (int k = 1; k <= 7; ++k) {
    const Vector3 signs(k & 1 ? -1.0 : 1.0, k & 2 ? -1.0 : 1.0, k & 4 ? -1.0 : 1.0);
    asked.push_back({{image(pair.a, order, signs), image(pair.b, order, signs)}});
  }
  return asked;
}

std::vector<LawQuery> permuted(const Method&, const Pair& pair, const MethodAnswer&) {
  std::vector<LawQuery> asked;
  Eigen::Vector3i order(0, 1, 2);
  while (std::next_permutation(order.begin(), order.end()))
    asked.push_back({{image(pair.a, order, Vector3::Ones()), image(pair.b, order, Vector3::Ones())}});
  return asked;
}

/// The bits of a quaternion's coordinates, relative to the largest, so that sums of two are exact.
constexpr int relabelled_bits = 40;

Solid with_short_quaternion(Solid c) {
  double largest = 0;
  for (const double x : c.quaternion) largest = std::max(largest, std::fabs(x));
  const int exponent = std::ilogb(largest);
  for (double& x : c.quaternion) x = std::nearbyint(std::scalbn(std::scalbn(x, -exponent), relabelled_bits));
  return c;
}

/// Returns the same box with its axes named anew: its rotation follows a turn of 90 degrees about coordinate
/// axis k, and the two other edges are exchanged. The turn has the quaternion 1 + e_k.
Solid relabelled(const Solid& c, std::size_t k) {
  const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
  const auto& q = c.quaternion;
  Solid other = c;
  std::swap(other.edges[i], other.edges[j]);
  other.quaternion[0] = q[0] - q[k + 1];
  other.quaternion[k + 1] = q[k + 1] + q[0];
  other.quaternion[i + 1] = q[i + 1] + q[j + 1];
  other.quaternion[j + 1] = q[j + 1] - q[i + 1];
  return other;
}

// The first pair has the rounded quaternions, with which the others are exact.
std::vector<LawQuery> with_other_labels(const Method&, const Pair& pair, const MethodAnswer&) {
  if (!has_box(pair)) return {};
  Pair base = pair;
  for (Solid* c : {&base.a, &base.b})
    if (is_box(*c)) *c = with_short_quaternion(*c);
  std::vector<LawQuery> asked{{base}};
  for (const auto solid : {&Pair::a, &Pair::b})
    for (std::size_t k = 0; is_box(base.*solid) && k < 3; ++k) {
      asked.push_back({base});
      asked.back().pair.*solid = relabelled(base.*solid, k);
    }
  return asked;
}

// Roles and signs that break ties may change, and the order of sums. So digits may differ, and a verdict may
// be undecided for one pair only.
std::optional<Violation> turned_verdict(const LawCase& c, bool promised) {
  return worst_of(c, [&](std::size_t i) -> std::optional<Violation> {
    const MethodAnswer& second = c.answers[i];
    if (!is_decided(c.first) || !is_decided(second) || says_meet(c.first) == says_meet(second)) return {};
    return Violation{std::string("the verdict turns from ") + to_string(c.first.verdict) + " to " +
                         to_string(second.verdict),
                     promised ? Severity::contract : severity_of(c, i)};
  });
}

}  // namespace

std::vector<Law> exact_laws() {
  const char* const bits =
      "always; bit for bit for intersect, decide, distance and seed2017, the verdict for other methods";
  return {
      {1, LawKind::exact, "swap",
       "swapped solids keep the verdict, distance and point, and the direction is negated", bits, swapped,
       [](const LawCase& c) { return all_as_expected(c, {.direction = -1, .swapped = true}); }},
      {2, LawKind::exact, "scaling",
       "lengths times 2^k keep the verdict and direction, and scale distance and point by 2^k",
       "if no length overflows or underflows; bit for bit as in law 1", at_other_scales, break_scaling},
      {3, LawKind::exact, "reversal",
       "a reversed axis of a cylinder, or a negated quaternion, keeps the verdict, distance, direction and "
       "point",
       bits, reversed, [](const LawCase& c) { return all_as_expected(c); }},
      {4, LawKind::exact, "axis length",
       "an axis, normal or quaternion times 2^k keeps the verdict, distance, direction and point",
       "if no coordinate of it overflows or underflows; bit for bit as in law 1", with_longer_axes,
       [](const LawCase& c) { return all_as_expected(c); }},
      {5, LawKind::exact, "mirror", "flipped signs of coordinates, in all 7 ways, keep the verdict",
       "if both answers are decided; for intersect without rounding always, for others if they claim to be "
       "right",
       mirrored,
       [](const LawCase& c) {
         return turned_verdict(c, c.method.claim().mirror_invariant && !is_rounded(c.pair));
       }},
      {6, LawKind::exact, "permutation", "permuted coordinates, in all 5 ways, keep the verdict",
       "if both answers are decided and the method claims to be right, because sums change their order",
       permuted, [](const LawCase& c) { return turned_verdict(c, false); }},
      {7, LawKind::exact, "relabelling",
       "a box turned by 90 degrees about an axis of its own, with two edges exchanged, keeps the verdict",
       "for boxes, with quaternions of 40 bits; if both answers are decided and the method claims to be "
       "right",
       with_other_labels,
       [](const LawCase& c) {
         return turned_verdict(
             {c.method, c.asked[0].pair, c.answers[0], c.asked.subspan(1), c.answers.subspan(1), c.proofs},
             false);
       }},
  };
}

}  // namespace cyl
