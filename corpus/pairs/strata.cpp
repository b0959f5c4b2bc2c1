// SPDX-License-Identifier: MIT
#include "corpus/pairs/strata.hpp"

#include <string>

#include "corpus/pairs/near_touching.hpp"
#include "corpus/pairs/random_stream.hpp"
#include "corpus/pairs/rounded_pairs.hpp"
#include "corpus/pairs/touch_plane.hpp"

namespace cyl {
namespace {

using enum ContactFeature;

/// The first decade whose penetrations are known by construction (near_touching.hpp), in general and of
/// slender solids.
constexpr int penetration_decade = 2, slender_penetration_decade = 6;

/// Returns the kinds of a feature, which are taken by turns.
std::vector<ContactKind> kinds_of(ContactFeature feature, bool slender_too) {
  std::vector<ContactKind> kinds;
  for (std::size_t i = 0; i < features_of_kinds.size(); ++i)
    if (const auto kind = static_cast<ContactKind>(i);
        features_of_kinds[i] == feature && (slender_too || !is_slender(kind)))
      kinds.push_back(kind);
  return kinds;
}

// p is a point of the outer solid's side or cap. The inner solid reaches from depth g below p to at most g/2
// below, and is at most g/2 wide. In that range the surface falls off by less than g/8. So the inner solid
// lies inside. Its depth is g by the argument of near_touching.cpp: moved by g along the normal it only
// touches. A ball of radius R >= g in the outer solid touches at p, so no direction does better. The point p
// is at most 0.3 of the way to the border, so R >= min(r, 0.35 h) >= 0.175. g <= 0.1 size is kept below 0.9
// of that.
Pair draw_containment(RandomStream& s, double margin) {
  constexpr double middle_part = 0.3, ball_part = 0.9;
  Solid outer, inner;
  outer.radius = s.between(0.5, 2);
  outer.height = s.between(0.5, 2);
  outer.axis = s.unit_vector();
  const Vector3 radial = s.perpendicular(outer.axis);
  const bool at_cap = s.coin();
  const Vector3 normal = at_cap ? Vector3(s.sign() * outer.axis) : radial;
  const double part = s.between(-middle_part, middle_part);
  const Vector3 contact = at_cap ? Vector3(outer.height / 2 * normal + part * outer.radius * radial)
                                 : Vector3(outer.radius * normal + part * outer.height / 2 * outer.axis);

  switch (s.below(3)) {  // parallel, parallel up to a power of ten, or any
    case 0:
      inner.axis = s.sign() * outer.axis;
      break;
    case 1: {
      const double angle = tenths[1 + s.below(12)];
      inner.axis = s.sign() * (outer.axis + angle * s.perpendicular(outer.axis));
      break;
    }
    default:
      inner.axis = s.unit_vector();
  }
  // In units of the depth g, which follows from g = margin (R + H + (r + h) g) and r + h <= 0.5.
  inner.radius = s.between(0.05, 0.15);
  inner.height = s.between(0.05, 0.2);
  const double outer_size = outer.radius + outer.height;
  const double ball = at_cap ? std::min(outer.height / 2, (1 - middle_part) * outer.radius)
                             : std::min(outer.radius, (1 - middle_part) * outer.height / 2);
  const double depth =
      std::min(margin * outer_size / (1 - margin * (inner.radius + inner.height)), ball_part * ball);
  inner.radius *= depth;
  inner.height *= depth;

  const Vector3 w = normalise(inner.axis);
  const double along = inner_product(normal, w);
  const Vector3 across = normal - along * w;
  const double support =
      inner.radius * std::sqrt(inner_product(across, across)) + inner.height / 2 * std::abs(along);
  for (int i = 0; i < 3; ++i) outer.center[i] = 0;
  if (s.coin())
    for (int i = 0; i < 3; ++i) outer.center[i] = s.between(-1, 1);
  inner.center = outer.center + (contact + (support - depth) * normal);
  // Draws which of the two is `a`.
  return s.coin() ? Pair{outer, inner} : Pair{inner, outer};
}

}  // namespace

std::optional<Pair> draw_in_stratum(ContactFeature feature, int decade, std::uint64_t seed,
                                    std::uint64_t index) {
  if (decade < first_decade || decade > last_decade) return {};
  if (feature == containment && decade == last_decade) return {};
  const auto cell = static_cast<std::uint64_t>(decade);
  RandomStream s(to_string(feature), seed, index * (last_decade + 1) + cell);
  // Keeps off the ends, so that rounding does not leave the decade. The lower end is not in the decade.
  const double margin = tenths[static_cast<std::size_t>(decade)] * s.between(0.11, 0.99);
  if (feature == containment) return draw_containment(s, margin);
  const bool penetrates = index % 2 == 1 && decade >= penetration_decade;
  const auto kinds = kinds_of(feature, !penetrates || decade >= slender_penetration_decade);
  const ContactKind kind = kinds[index / 2 % kinds.size()];
  return draw_contact_at(kind, s, penetrates ? -margin : margin).pair;
}

std::vector<Pair> draw_in_all_strata(std::uint64_t per_cell, std::uint64_t seed) {
  std::vector<Pair> pairs;
  for (const Stratum& stratum : drawn_strata)
    for (std::uint64_t index = 0; index < per_cell; ++index)
      if (const auto pair = draw_in_stratum(stratum.feature, stratum.decade, seed, index))
        pairs.push_back(*pair);
  return pairs;
}

namespace {

/// Returns the parts of a solid that a plane can touch.
std::span<const TouchPart> parts_of(SolidKind kind) {
  static constexpr std::array parts{TouchPart::point, TouchPart::line, TouchPart::face};
  if (kind == SolidKind::half_space) return std::span(parts).last(1);
  return std::span(parts).first(kind == SolidKind::sphere ? 1 : kind == SolidKind::capsule ? 2 : 3);
}

}  // namespace

Pair draw_in_stratum(const Kinds& kinds, std::uint64_t seed, std::uint64_t index) {
  RandomStream s(std::string(to_string(kinds.first)) + '-' + to_string(kinds.second), seed, index);
  const double margin = tenths[first_decade + index % drawn_decade_count] * s.between(0.11, 0.99);
  const std::uint64_t turn = index / drawn_decade_count;
  const std::span<const TouchPart> of_first = parts_of(kinds.first), of_second = parts_of(kinds.second);
  const std::array parts{of_first[turn / 2 % of_first.size()],
                         of_second[turn / 2 / of_first.size() % of_second.size()]};
  Pair p;
  p.a = draw_kind(kinds.first, s, draw_moderate);
  p.b = draw_kind(kinds.second, s, draw_moderate);
  return put_in_contact(p, parts, turn % 2 == 0 ? margin : -margin, s);
}

}  // namespace cyl
