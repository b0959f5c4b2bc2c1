// SPDX-License-Identifier: MIT
#include "corpus/pairs/close_contact.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "corpus/pairs/touch_plane.hpp"

namespace cyl {
namespace {

using enum ContactFeature;

/// Returns 10^-U for an approximately uniform U in (first, last).
double within(RandomStream& s, int first, int last) {
  const double power = tenths[static_cast<std::size_t>(s.integer(first, last - 1))];
  return power * s.between(0.11, 0.95);  // keeps off the ends, so that rounding crosses none
}

/// An angle of 0 to pi/2.
struct Turn {
  double cosine, sine;
};
Turn turn_of(double tangent) {
  const double length = std::sqrt(1 + tangent * tangent);
  return {1 / length, tangent / length};
}
Turn rest_of(const Turn& t) { return {t.sine, t.cosine}; }
Turn with_cosine(double cosine) { return {cosine, std::sqrt((1 - cosine) * (1 + cosine))}; }
/// Returns t plus `by`, or minus if `more` is false, unless an end is nearer than `least`.
Turn shifted(const Turn& t, const Turn& by, bool more, double least) {
  const double sine = (more || t.sine <= least) && t.cosine > least ? by.sine : -by.sine;
  return {t.cosine * by.cosine - t.sine * sine, t.sine * by.cosine + t.cosine * sine};
}
Turn uniform_turn(RandomStream& s) {
  for (;;) {
    const double x = s.unit(), y = s.unit(), square = x * x + y * y;
    if (square <= 1 && square >= 1e-2) return {x / std::sqrt(square), y / std::sqrt(square)};
  }
}
bool is_generic(double cosine) {
  const double sine = std::sqrt(std::max(0.0, (1 - cosine) * (1 + cosine)));
  return std::abs(cosine) > generic_tol && sine > generic_tol;
}

/// Half of the angles are uniform. The others lie by decades from either end.
Turn extreme_turn(RandomStream& s, int last) {
  const bool uniform = s.coin(), at_right = s.coin();
  if (uniform) return uniform_turn(s);
  const Turn t = turn_of(within(s, 0, last));
  return at_right ? rest_of(t) : t;
}
/// A third is uniform. The others lie by decades from 0 or from pi/2, and a quarter of them exactly there.
Turn azimuth(RandomStream& s) {
  const std::size_t way = s.below(3);
  if (way == 0) return uniform_turn(s);
  const Turn t = turn_of(s.below(4) == 0 ? 0 : within(s, 0, 17));
  return way == 1 ? t : rest_of(t);
}
/// From 0, the middle, to 1, the border. It is exactly one of them, near one by decades, or uniform.
double place(RandomStream& s) {
  switch (s.below(5)) {
    case 0:
      return 0;
    case 1:
      return within(s, 0, 15);
    case 2:
      return 1 - within(s, 0, 15);
    case 3:
      return s.coin() ? 1 : 0;
    default:
      return s.unit();
  }
}

/// How the two axes lie about the normal. The tilts are from the normal, towards the contact. The azimuth is
/// from one axis to the other.
struct Poise {
  Turn tilt_a, tilt_b, azimuth;
  bool opposite = false;  ///< true if the azimuth counts from pi
};

/// The cosine of the angle between both axes towards the contact.
double cosine_of(const Poise& p) {
  const double across = p.tilt_a.sine * p.tilt_b.sine * p.azimuth.cosine;
  return (p.opposite ? -across : across) - p.tilt_a.cosine * p.tilt_b.cosine;
}

constexpr Turn at_side{0, 1}, at_cap{1, 0};

// Rim on rim, with axes at the angle s. s has two perpendicular components: the tilt towards the normal and
// the twist about the normal. Either both rims are nearly sides, or the caps face each other.
Poise parallel_rims(RandomStream& r, double s) {
  constexpr double tilted_share = 0x1p-4;  // of the tilt: if s is below it, both azimuths are alike
  const Turn share = extreme_turn(r, 12);
  const bool as_sides = r.below(3) == 0, more = r.coin();
  if (as_sides) {
    const double part = place(r), towards = s * share.cosine;
    return {rest_of(turn_of(towards * part)), rest_of(turn_of(towards * (1 - part))),
            turn_of(s * share.sine)};
  }
  Poise p;
  p.tilt_a = extreme_turn(r, 12);
  const bool tilted = tilted_share * p.tilt_a.sine > s;
  const Turn difference = turn_of(tilted ? s * share.cosine : s);
  p.tilt_b = shifted(p.tilt_a, difference, more, s);
  p.azimuth = turn_of(tilted ? s * share.sine / p.tilt_a.sine : 0);
  p.opposite = true;
  return p;
}

// Rim on rim. The axes differ from a right angle by an angle of sine s. Both axes lie in one plane with the
// normal, or the azimuth gives this angle to any tilts for which it can.
Poise square_rims(RandomStream& r, double s) {
  if (r.below(3) == 0) {
    const Turn tilt = extreme_turn(r, 12);
    return {tilt, rest_of(shifted(tilt, turn_of(s), r.coin(), s)), {1, 0}};
  }
  for (;;) {
    Poise p{extreme_turn(r, 12), extreme_turn(r, 12), {1, 0}};
    const double sines = p.tilt_a.sine * p.tilt_b.sine;
    const double cosine = (p.tilt_a.cosine * p.tilt_b.cosine + r.sign() * s) / sines;
    if (!(std::abs(cosine) <= 1)) continue;
    p.azimuth = with_cosine(std::abs(cosine));
    p.opposite = cosine < 0;
    return p;
  }
}

// Side on rim. The sine of the tilt times the cosine of the azimuth is s. Either of them may be the small
// one.
Poise square_side_rim(RandomStream& r, double s) {
  for (;;) {
    const Turn first = extreme_turn(r, 12);
    const bool tilt_first = r.coin(), opposite = r.coin();
    if (first.sine <= s) continue;
    const Turn second = with_cosine(s / first.sine);
    return tilt_first ? Poise{at_side, first, second, opposite}
                      : Poise{at_side, rest_of(second), rest_of(first), opposite};
  }
}

Poise parallel_poise(RandomStream& r, ContactFeature feature, double s) {
  switch (feature) {
    case side_side:
      return {at_side, at_side, turn_of(s), r.coin()};
    case side_rim: {
      const Turn share = extreme_turn(r, 12);
      return {at_side, rest_of(turn_of(s * share.cosine)), turn_of(s * share.sine), r.coin()};
    }
    case cap_rim:
      return {at_cap, turn_of(s), azimuth(r), r.coin()};
    case cap_cap:
      return {at_cap, at_cap, azimuth(r), r.coin()};
    default:
      return parallel_rims(r, s);
  }
}

Poise square_poise(RandomStream& r, ContactFeature feature, double s) {
  switch (feature) {
    case side_side:
      return {at_side, at_side, rest_of(turn_of(s)), r.coin()};
    case side_rim:
      return square_side_rim(r, s);
    case cap_rim:
      return {at_cap, rest_of(turn_of(s)), azimuth(r), r.coin()};
    case cap_side:
      return {at_cap, at_side, azimuth(r), r.coin()};
    default:
      return square_rims(r, s);
  }
}

// A rim has the small angle, to the plane of contact or to the normal.
Poise generic_poise(RandomStream& r, ContactFeature feature, double s) {
  for (;;) {
    const Turn small = r.coin() ? turn_of(s) : rest_of(turn_of(s));
    Poise p{at_side, small, uniform_turn(r), r.coin()};
    if (feature == side_side) p.tilt_b = at_side;
    if (feature == cap_rim) p.tilt_a = at_cap, p.tilt_b = uniform_turn(r);
    if (feature == rim_rim) p.tilt_a = uniform_turn(r);
    if (is_generic(cosine_of(p))) return p;
  }
}

/// Returns the features that can meet so. A side's or cap's own angle to the normal is not a small one.
std::span<const ContactFeature> features_of(AxesLie lie, AngleBand band) {
  static constexpr std::array all{side_rim, rim_rim, side_side, cap_rim};
  static constexpr std::array parallel{side_rim, rim_rim, side_side, cap_rim, cap_cap};
  static constexpr std::array square{side_rim, rim_rim, side_side, cap_rim, cap_side};
  if (lie == AxesLie::generic)
    return band == AngleBand::wide ? std::span<const ContactFeature>(all) : std::span(all).first(2);
  if (band != AngleBand::none) return all;
  return lie == AxesLie::near_parallel ? std::span<const ContactFeature>(parallel) : square;
}

double draw_angle(RandomStream& s, AxesLie lie, AngleBand band) {
  switch (band) {
    case AngleBand::wide:
      return lie == AxesLie::generic ? within(s, 0, 3) : within(s, 1, 3);
    case AngleBand::small:
      return within(s, 3, 8);
    case AngleBand::tiny:
      return within(s, 8, 13);
    case AngleBand::none:
      break;
  }
  return s.coin() ? 0 : within(s, 13, 18);
}

AngleBand band_of(double angle) {
  return angle > 1e-3    ? AngleBand::wide
         : angle > 1e-8  ? AngleBand::small
         : angle > 1e-13 ? AngleBand::tiny
                         : AngleBand::none;
}

int decade_of(double margin) {
  return std::clamp(margin_decade(margin), first_close_decade, last_close_decade);
}

/// Radii and heights are moderate, or over six decades, or some are exactly 0, or some are equal. Or one rim
/// is small beside the other, or the solids are rods.
void draw_lengths(RandomStream& s, CloseKind kind, Pair& p) {
  const std::array lengths{&p.a.radius, &p.a.height, &p.b.radius, &p.b.height};
  const std::size_t way = s.below(8);
  for (double* length : lengths) {
    constexpr std::array equal{1.0, 1.0, 2.0, 0.5};
    const double moderate = s.between(0.1, 2);
    *length = way < 2 ? within(s, 0, 6) : way == 2 ? s.pick(equal) : moderate;
    if ((way == 3 || way == 4) && s.below(3) == 0) *length = 0;
  }
  if (kind == CloseKind::rims) {
    p.a.radius = s.between(0.1, 2);
    p.b.radius = p.a.radius * within(s, 1, 4);
  } else if (kind == CloseKind::rods) {
    for (Solid* c : {&p.a, &p.b}) c->radius = s.between(0.05, 0.5), c->height = s.between(0.5, 2);
  }
  if (std::all_of(lengths.begin(), lengths.end(), [](const double* x) { return *x == 0; })) p.a.radius = 1;
}

/// Sets the axis of a solid whose outward normal at the contact is `n`. `e` is the direction of the axis in
/// the plane of contact. Returns the contact relative to the centre of the solid.
Vector3 set_solid(RandomStream& s, Solid& solid, TouchPart part, const Vector3& n, const Vector3& e,
                  const Turn& tilt) {
  const Vector3 towards = tilt.cosine * n + tilt.sine * e, radial = tilt.sine * n - tilt.cosine * e;
  const double where = place(s);
  const double along = part == TouchPart::line ? s.sign() * where : 1,
               across = part == TouchPart::face ? where : 1;
  solid.axis = s.sign() * towards;
  return along * solid.height / 2 * towards + across * solid.radius * radial;
}

// near_touching.cpp has the reason for f(n) = -g, which holds for all shapes. If g < 0, no depth is more
// than -g for all shapes too, because b moved by -g n only touches a. The depth may be less by an unknown
// amount.
CloseContact build(RandomStream& s, CloseKind kind, const CloseCell& cell, ContactFeature feature,
                   double angle, double margin) {
  CloseContact c{{}, cell, feature, {}, 0};
  Poise p = cell.lie == AxesLie::generic         ? generic_poise(s, feature, angle)
            : cell.lie == AxesLie::near_parallel ? parallel_poise(s, feature, angle)
                                                 : square_poise(s, feature, angle);
  auto [first, second] = parts_of(feature);
  if (s.coin()) {
    std::swap(first, second);
    std::swap(p.tilt_a, p.tilt_b);
  }
  const auto [n, e] = draw_frame(s);
  const Vector3 third = n.cross(e);
  const double cosine = p.opposite ? -p.azimuth.cosine : p.azimuth.cosine;
  const Vector3 other = cosine * e + s.sign() * p.azimuth.sine * third;
  draw_lengths(s, kind, c.pair);
  if (s.coin()) {
    std::swap(c.pair.a.radius, c.pair.b.radius);
    std::swap(c.pair.a.height, c.pair.b.height);
  }
  auto& [a, b] = c.pair;
  const Vector3 on_a = set_solid(s, a, first, n, e, p.tilt_a);
  const Vector3 on_b = set_solid(s, b, second, -n, other, p.tilt_b);
  if (angle == 0 && cell.lie == AxesLie::near_parallel) b.axis = s.sign() * a.axis;
  // Half of the first solids stand at the origin. There the centres' difference is not rounded once more.
  const double size = a.radius + a.height + b.radius + b.height;
  a.center = Vector3(0, 0, 0);
  if (s.coin())
    for (int i = 0; i < 3; ++i) a.center[i] = size * s.between(-1, 1);
  c.normal = n;
  c.distance = margin * size;
  b.center = a.center + ((on_a - on_b) + c.distance * n);
  return c;
}

// A method that takes rods for parallel, at the mean of their axes, loses at most a quarter of the angle
// times the heights. So the least margins show this most often.
CloseContact draw_rods(RandomStream& s, std::uint64_t index) {
  const double angle = s.between(2e-13, 9e-13), part = s.unit();
  const double margin = least_close_margin + part * part * part * (angle - least_close_margin);
  const ContactFeature feature = index % 8 == 0 ? side_side : side_rim;
  return build(s, CloseKind::rods, {AxesLie::near_parallel, AngleBand::tiny, decade_of(margin)}, feature,
               angle, -margin);
}

CloseContact draw_by_angle(RandomStream& s, std::uint64_t index) {
  constexpr std::size_t lies = enum_values<AxesLie>.size();
  const auto lie = static_cast<AxesLie>(index % lies);
  const int decade = first_close_decade + static_cast<int>(index / lies % close_decade_count);
  const std::uint64_t turn = index / lies / close_decade_count;
  const double angle = within(s, decade, decade + 1);
  const double margin = std::max(least_close_margin, angle * s.between(0.1, 1));
  const CloseCell cell{lie, band_of(angle), decade_of(margin)};
  const auto features = features_of(lie, cell.band);
  return build(s, CloseKind::by_angle, cell, features[turn / 2 % features.size()], angle,
               turn % 2 == 0 ? margin : -margin);
}

/// The names of the random streams. They never change.
constexpr std::array names{"close_contacts", "close_contacts_by_angle", "close_rods", "close_rims"};

}  // namespace

CloseContact draw_close_contact(CloseKind kind, RandomStream& s, std::uint64_t index) {
  if (kind == CloseKind::rods) return draw_rods(s, index);
  if (kind == CloseKind::by_angle) return draw_by_angle(s, index);
  CloseCell cell = close_cells[index % close_cell_count];
  if (kind == CloseKind::rims && s.coin()) cell.lie = AxesLie::generic, cell.band = AngleBand::wide;
  const std::uint64_t turn = index / close_cell_count;
  const auto features = features_of(cell.lie, cell.band);
  const ContactFeature feature = kind == CloseKind::rims ? rim_rim : features[turn / 2 % features.size()];
  const double angle = draw_angle(s, cell.lie, cell.band);
  const double margin = std::max(least_close_margin, within(s, cell.decade, cell.decade + 1));
  return build(s, kind, cell, feature, angle, turn % 2 == 0 ? margin : -margin);
}

CloseContact draw_close_contact(CloseKind kind, std::uint64_t seed, std::uint64_t index) {
  RandomStream stream(names[static_cast<std::size_t>(kind)], seed, index);
  return draw_close_contact(kind, stream, index);
}

std::vector<CloseContact> draw_close_round(std::uint64_t seed, std::uint64_t round) {
  std::vector<CloseContact> contacts;
  contacts.reserve(close_round);
  for (const CloseKind kind : enum_values<CloseKind>) {
    const std::uint64_t count = close_share(kind);
    for (std::uint64_t i = 0; i < count; ++i)
      contacts.push_back(draw_close_contact(kind, seed, round * count + i));
  }
  return contacts;
}

}  // namespace cyl
