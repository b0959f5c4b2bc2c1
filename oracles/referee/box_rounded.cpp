// SPDX-License-Identifier: MIT
#include <optional>
#include <utility>
#include <vector>

#include "corpus/pairs/pair_numbers.hpp"
#include "oracles/referee/box.hpp"
#include "oracles/referee/box_search.hpp"
#include "oracles/referee/proofs.hpp"
#include "oracles/referee/root_sum.hpp"
#include "oracles/referee/rounded.hpp"
#include "oracles/referee/tangency.hpp"

namespace cyl {
namespace {

bool at_most(const RootSum& a, const RootSum& b) { return (b - a).sign() >= 0; }
RootSum magnitude(const RootSum& x) { return x.sign() < 0 ? RootSum(0) - x : x; }

/// The two solids by what they are. Points are relative to the cylinder's centre.
struct Parts {
  explicit Parts(const Pair& pair)
      : box_first(is_box(pair.a)),
        box(box_first ? pair.a : pair.b),
        cylinder(box_first ? pair.b : pair.a),
        edges(edge_directions<mpq_class>(box.quaternion)),
        halves{mpq_class(box.edges[0]) / 2, mpq_class(box.edges[1]) / 2, mpq_class(box.edges[2]) / 2},
        axis(exact(cylinder.axis)),
        delta(exact(box.center) - exact(cylinder.center)),
        radius(cylinder.radius),
        half(mpq_class(cylinder.height) / 2),
        square(dot(axis, axis)),
        contact(contact_distance_of(pair)) {}
  bool box_first;
  const Solid &box, &cylinder;
  std::array<Rational3, 3> edges;
  std::array<mpq_class, 3> halves;
  Rational3 axis, delta;
  mpq_class radius, half, square, contact;

  Rational3 across(const Rational3& v) const { return v - mpq_class(dot(v, axis) / square) * axis; }

  std::vector<Rational3> corners() const {
    std::vector<Rational3> all{delta};
    for (std::size_t i = 0; i < 3; ++i) {
      if (halves[i] == 0) continue;
      const std::size_t count = all.size();
      for (std::size_t k = 0; k < count; ++k) {
        all.push_back(all[k] + halves[i] * edges[i]);
        all[k] = all[k] - halves[i] * edges[i];
      }
    }
    return all;
  }
};

/// Whether the two faces in the direction d, from the cylinder to the box, share a point if they are seen
/// along d. The face of the box has the edges square to d. That of the cylinder is a cap, a part of a line
/// along the axis, or the point of a rim.
bool faces_meet(const Parts& p, const Rational3& d) {
  Rational3 from_face{0, 0, 0};  // from the middle of the box's face to the cylinder's centre
  from_face = from_face - p.delta;
  std::vector<std::size_t> open;
  for (std::size_t i = 0; i < 3; ++i) {
    const int side = sgn(dot(d, p.edges[i]));
    if (side == 0) open.push_back(i);
    from_face = from_face + mpq_class(side * p.halves[i]) * p.edges[i];
  }
  // Rows of |offset + slope k| <= reach for the cylinder's point k along its axis.
  struct Row {
    mpq_class offset, slope, reach;
  };
  std::vector<Row> rows;
  const auto add = [&](const Rational3& m, const mpq_class& reach) {
    rows.push_back({dot(from_face, m), dot(p.axis, m), reach});
  };
  const Rational3 radial = p.across(d);
  if (is_zero(radial)) {  // a cap: the distance of its middle from the face
    Rational3 rest = from_face - mpq_class(dot(from_face, d) / dot(d, d)) * d;
    for (const std::size_t i : open) {
      const mpq_class along = dot(from_face, p.edges[i]);
      rest = rest - mpq_class(along > p.halves[i]    ? p.halves[i]
                              : along < -p.halves[i] ? mpq_class(-p.halves[i])
                                                     : along) *
                        p.edges[i];
    }
    return dot(rest, rest) <= p.radius * p.radius;
  }
  for (const std::size_t i : open) add(p.edges[i], p.halves[i]);
  if (open.size() == 1) add(cross(p.edges[open[0]], d), 0);
  if (open.empty()) {
    const Rational3 beside = cross(d, radial);  // is 0 if they are parallel
    const Rational3 m = !is_zero(beside) ? beside : cross(d, p.axis);
    add(m, 0);
    add(cross(d, m), 0);
  }
  const mpq_class along = dot(d, p.axis);
  if (along != 0) {
    const RootSum k = RootSum::root(sgn(along) * p.half / p.square, p.square) -
                      RootSum::root(p.radius * along / p.square / dot(radial, radial), dot(radial, radial));
    for (const Row& row : rows)
      if (!at_most(magnitude(RootSum(row.offset) + RootSum(row.slope) * k), row.reach)) return false;
    return true;
  }
  std::optional<mpq_class> low, high;
  for (const Row& row : rows) {
    if (row.slope == 0) {
      if (abs(row.offset) > row.reach) return false;
      continue;
    }
    mpq_class from = (-row.reach - row.offset) / row.slope, to = (row.reach - row.offset) / row.slope;
    if (from > to) std::swap(from, to);
    if (!low || from > *low) low = from;
    if (!high || to < *high) high = to;
  }
  const RootSum end = RootSum::root(p.half / p.square, p.square);
  return !low || (*low <= *high && at_most(*low, end) && at_most(RootSum(0) - end, *high));
}

/// The way from the rim to a corner of the box, if it is rational. It is if the two are at the contact
/// distance. Let u be the part across the axis. Then (|u| - radius)^2 + (|along| - half)^2 is rational, and
/// the multiples of the two roots in it have the same sign.
std::optional<Rational3> rim_to_corner(const Parts& p, const Rational3& corner) {
  const Rational3 u = p.across(corner);
  const mpq_class along = dot(corner, p.axis), uu = dot(u, u);
  if (uu == 0) return {};
  const auto of_axis = (RootSum(mpq_class(along / p.square)) -
                        RootSum::root(sgn(along) * p.half / p.square, p.square))
                           .rational(),
             of_u = (RootSum(1) - RootSum::root(p.radius / uu, uu)).rational();
  if (!of_axis || !of_u) return {};
  return *of_axis * p.axis + *of_u * u;
}

/// The directions in which a face, an edge or a corner of the box may touch a cap, the side or, in part, a
/// rim.
std::vector<Rational3> tie_directions(const Parts& p) {
  std::vector<Rational3> all{p.edges[0], p.edges[1], p.edges[2], p.axis};
  for (const Rational3& edge : p.edges) all.push_back(cross(edge, p.axis));
  for (const Rational3& corner : p.corners()) {
    all.push_back(p.across(corner));
    if (const auto d = rim_to_corner(p, corner)) all.push_back(*d);
  }
  return all;
}

Simplex<MpFloat> search_wide(const Pair& pair, int bits, bool sign_only) {
  return search_box(terms_of_pair<MpFloat>(pair), bits, sign_only);
}

/// Decides a tie by algebra. The points are the nearest ones that were found with so many bits.
std::optional<Truth> prove_tie(const Pair& pair, const Rational3& on_a, const Rational3& on_b, int bits) {
  const Parts p(pair);
  const Rational3 delta = exact(pair.b.center) - exact(pair.a.center);
  std::vector<Rational3> directions = tie_directions(p);
  std::vector<std::pair<Rational3, Rational3>> simple;
  for (const int guessed : {bits, bits / 2, bits / 4}) {
    simple.emplace_back(simplest_near(pair, on_a, guessed), simplest_near(pair, on_b, guessed));
    directions.push_back(simple.back().second - simple.back().first);
  }
  const TwinFilter filter(pair);
  const auto touching = [&](const Rational3& direction) {
    for (const auto& [x, y] : simple)
      if (Truth t = touching_at(pair, x, y, {}); t.certificate.kind == CertificateKind::points) return t;
    const PrecisionScope precision(near_bits);
    const Simplex<MpFloat> found = search_wide(pair, near_bits, false);
    const Rational3 center = exact(pair.a.center);
    return touching_at(pair, center + rational(found.on_a()), center + rational(found.on_b()), direction);
  };
  for (Rational3 d : directions) {
    if (is_zero(d)) continue;
    if (dot(d, delta) < 0) d = mpq_class(-1) * d;
    if (surely_less(0.0, filter.support_gap(enclosed<TwinInterval>(d)))) continue;
    const int sign = support_gap_sign(pair, d);
    if (sign < 0) {
      const auto t = prove_disjoint(pair, d, bits);
      return t ? *t : proved(Verdict::disjoint, exact_vector(d), Stage::exact, bits);
    }
    if (sign == 0 && faces_meet(p, p.box_first ? mpq_class(-1) * d : d)) return touching(d);
  }
  return {};
}

}  // namespace

Truth touching_at(const Pair& pair, const Rational3& on_a, const Rational3& on_b,
                  const Rational3& direction) {
  const Rational3 between = on_b - on_a;
  const mpq_class contact = contact_distance_of(pair);
  Truth t = proved(Verdict::touching, exact_vector(on_a), Stage::exact, near_bits);
  if (in_each_exact(pair, on_a, on_b) && dot(between, between) == contact * contact) {
    t.certificate.kind = CertificateKind::points;
    t.certificate.second = exact_vector(on_b);
  } else {
    t.certificate.kind = CertificateKind::near_points;
    t.certificate.second = exact_vector(direction);
    t.certificate.third = exact_vector(on_b);
  }
  return t;
}

Truth judge_rounded_box(const Pair& pair, int bits_cap) {
  Truth undecided;
  undecided.stage = Stage::exact;
  const Rational3 center = exact(pair.a.center);
  for (int bits = first_multiprecision_bits; bits <= bits_cap; bits *= 2) {
    undecided.bits = bits;
    const PrecisionScope precision(bits);
    const Simplex<MpFloat> found = search_wide(pair, bits, true);
    const Rational3 direction = rational(found.nearest), on_a = center + rational(found.on_a()),
                    on_b = center + rational(found.on_b());
    if (auto t = prove_disjoint(pair, direction, bits)) return *t;
    if (auto t = meet_at(pair, on_a, on_b, bits)) return *t;
    if (bits <= tangency_bits)
      if (auto t = prove_tie(pair, on_a, on_b, bits)) return *t;
  }
  return undecided;
}

}  // namespace cyl
