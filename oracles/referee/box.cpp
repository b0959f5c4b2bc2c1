// SPDX-License-Identifier: MIT
#include "oracles/referee/box.hpp"

#include <cmath>
#include <utility>

#include "corpus/pairs/pair_numbers.hpp"
#include "oracles/referee/box_search.hpp"
#include "oracles/referee/multiprecision.hpp"
#include "oracles/referee/proofs.hpp"
#include "oracles/referee/rounded.hpp"
#include "oracles/referee/tangency.hpp"

namespace cyl {
namespace {

/// Makes the cores smaller by a share, so that points of theirs are inside in spite of rounding.
template <class R>
TermsPair<R> shrunk(TermsPair<R> p, int bits) {
  const R share = R(1.0) - with_fewer_bits(R(1.0), bits);
  for (Terms<R>* s : {&p.a, &p.b}) {
    s->radius = share * s->radius;
    s->half = share * s->half;
    for (R& half : s->halves) half = share * half;
  }
  return p;
}

/// The result of the search in double.
struct Offer {
  explicit Offer(const Pair& pair)
      : p(shrunk(terms_in_unit<double>(pair, exponent), 42)), found(search_box(p, 53, true)) {}
  int exponent = 0;
  TermsPair<double> p;
  Simplex<double> found;

  std::array<double, 3> direction() const { return {found.nearest.x, found.nearest.y, found.nearest.z}; }
  std::array<double, 3> point() const {
    const Vec3<double> x = found.on_a();
    return {std::ldexp(x.x, exponent), std::ldexp(x.y, exponent), std::ldexp(x.z, exponent)};
  }
};

std::array<double, 3> center_of(const Solid& c) { return {c.center.x(), c.center.y(), c.center.z()}; }

Truth of(Verdict verdict, CertificateKind kind, ExactVector vector, int bits) {
  Truth t = proved(verdict, std::move(vector), Stage::exact, bits);
  t.certificate.kind = kind;
  return t;
}

Truth touching_truth(const Pair& pair, const BoxRelation& r) {
  if (is_rounded(pair)) return touching_at(pair, r.on_a, r.on_b, r.direction);
  for (const int digits : short_digits)
    if (const Rational3 simple = short_near(pair, r.on_a, digits); in_both_exact(pair, simple))
      return of(Verdict::touching, CertificateKind::point, exact_vector(simple), near_bits);
  if (const auto common = common_point(pair, r.on_a))
    return of(Verdict::touching, CertificateKind::point, common->written, near_bits);
  Truth t = of(Verdict::touching, CertificateKind::near, exact_vector(r.on_a), near_bits);
  t.certificate.second = exact_vector(r.direction);
  return t;
}

Truth disjoint_truth(const Pair& pair, Rational3 direction, int bits_cap) {
  for (int bits = first_multiprecision_bits; bits <= bits_cap; bits *= 2) {
    if (bits > near_bits) direction = box_relation(pair, bits).direction;
    if (auto t = prove_disjoint(pair, direction, bits)) return *t;
    if (support_gap_sign(pair, direction) < 0)
      return proved(Verdict::disjoint, exact_vector(direction), Stage::exact, bits);
  }
  Truth t;
  t.verdict = Verdict::disjoint;
  return t;
}

Truth overlap_truth(const Pair& pair, BoxRelation r, int bits_cap) {
  for (int bits = first_multiprecision_bits; bits <= bits_cap; bits *= 2) {
    if (is_rounded(pair)) {
      if (bits > near_bits) r = box_relation(pair, bits);
      if (auto t = meet_at(pair, r.on_a, r.on_b, bits)) return *t;
      continue;
    }
    const PrecisionScope precision(bits);
    const Simplex<MpFloat> found = search_box(shrunk(terms_of_pair<MpFloat>(pair), bits / 2), bits, true);
    auto common = common_point(pair, exact(pair.a.center) + rational(found.on_a()));
    // If the depth is tiny, an exact point may still be one.
    if (!common)
      common = common_point(pair, are_polytopes(pair) ? common_point_of_polytopes(pair, bits) : r.on_a);
    if (common) return of(Verdict::intersecting, CertificateKind::point, common->written, bits);
  }
  Truth t;
  t.verdict = Verdict::intersecting;
  return t;
}

}  // namespace

std::optional<Truth> prove_box_in_double(const Pair& pair, const Filter& filter, bool certified) {
  const Offer offer(pair);
  if (const auto d = offer.direction(); filter.separates(d.data()))
    return proved(Verdict::disjoint, exact_vector(d.data(), no_tail), Stage::filter, 53);
  const auto head = center_of(pair.a), tail = offer.point();
  if (filter.in_both(head.data(), tail.data()))
    return proved(Verdict::intersecting, exact_vector(head.data(), tail.data()), Stage::filter, 53);
  if (is_rounded(pair))
    return meet_by_filter(pair, filter, offer.found.on_a(), offer.found.on_b() - offer.p.delta,
                          offer.exponent);
  if (!filter.overlap_at(head.data(), tail.data(), {})) return {};
  if (!certified) return proved(Verdict::intersecting, {}, Stage::filter, 53);
  const auto moved = project_to_hulls(pair, sum(head.data(), tail.data()));
  if (!moved) return {};  // not covered: the filter saw the hulls meet
  return proved(Verdict::intersecting, exact_vector(*moved), Stage::filter, 53);
}

std::optional<Verdict> box_verdict_in_twins(const Pair& pair, const TwinFilter& filter) {
  // Makes the cores smaller by more than rounding carries a point out of them. Half of a tiny core is left.
  const auto smaller = [](const TwinInterval& length) {
    constexpr double inward_tol = 0x1p-90;
    return length.middle > Twin(2 * inward_tol) ? length.middle - Twin(inward_tol)
                                                : Twin(0.5) * length.middle;
  };
  const auto in_twins = [&](const Terms<TwinInterval>& s) {
    Terms<Twin> t{middle(s.axis), smaller(s.radius), smaller(s.half), s.rounding.middle, s.rounded, s.box};
    for (std::size_t i = 0; i < 3; ++i) {
      t.edges[i] = middle(s.edges[i]);
      t.halves[i] = smaller(s.halves[i]);
    }
    return t;
  };
  const TermsPair<Twin> p{in_twins(filter.a()), in_twins(filter.b()), middle(filter.delta())};
  const Simplex<Twin> found = search_box(p, twin_bits, true);
  if (filter.separates(intervals(found.nearest))) return Verdict::disjoint;
  const bool meet = is_rounded(pair)
                        ? filter.come_near(intervals(found.on_a()), intervals(found.on_b() - p.delta))
                        : filter.overlap_at(intervals(found.on_a()));
  return meet ? std::optional(Verdict::intersecting) : std::nullopt;
}

Truth judge_box_exactly(const Pair& pair, int bits_cap) {
  if (!has_box_relation(pair)) return judge_rounded_box(pair, bits_cap);
  const BoxRelation r = box_relation(pair, near_bits);
  if (r.sign < 0) return disjoint_truth(pair, r.direction, bits_cap);
  return r.sign == 0 ? touching_truth(pair, r) : overlap_truth(pair, r, bits_cap);
}

Truth box_verdict_exactly(const Pair& pair) {
  if (!has_box_relation(pair)) return judge_box_exactly(pair, precision_cap);
  const int sign = box_sign(pair);
  Truth t;
  t.verdict = sign < 0 ? Verdict::disjoint : sign > 0 ? Verdict::intersecting : Verdict::touching;
  t.stage = Stage::exact;
  t.bits = first_multiprecision_bits;
  return t;
}

}  // namespace cyl
