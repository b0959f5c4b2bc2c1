// SPDX-License-Identifier: MIT
// 1. Boxes, segments and points are sums of segments, and so is their difference body. The pair is disjoint
//    if f < 0 in one of the directions of the body's facets, and overlaps if f > 0 in all. A facet's plane
//    is spanned by two of the segments.
// 2. The same with roundings. Then the distance of the cores is compared with the contact distance, both
//    squared. The search for the nearest points is exact. It starts at the result in doubles.
// 3. A box and a cylinder without roundings. The slab between the planes of the caps cuts a polytope out of
//    the box. Seen along the axis, its distance from the axis is compared with the radius.
// All numbers are rational, or have the one root |w| of the axis w.
#include <algorithm>
#include <limits>
#include <vector>

#include "corpus/pairs/pair_numbers.hpp"
#include "oracles/referee/box.hpp"
#include "oracles/referee/box_search.hpp"
#include "oracles/referee/proofs.hpp"
#include "oracles/referee/root_sum.hpp"
#include "oracles/referee/surd.hpp"
#include "oracles/referee/tangency.hpp"

namespace cyl {
namespace {

bool is_polytope(const Solid& c) { return is_box(c) || c.radius == 0; }

/// A segment about the origin: from -half to half.
struct Bar {
  std::size_t edge;  ///< of the box; 0 for the axis
  Rational3 direction;
  Surd3 half;
};

/// Half the length along the axis, c |w| w/(w.w). `square` is w.w, and outlives the result.
Surd3 half_axis(const Solid& c, const mpq_class& square) {
  const mpq_class share = mpq_class(c.height) / 2 / square;
  const std::optional<mpq_class> root = RootSum::root(1, square).rational();
  const Surd length = root ? Surd(mpq_class(share * *root)) : Surd(share, square);
  return length * lift(exact(c.axis));
}

std::vector<Bar> bars_of(const Solid& c, const mpq_class& square) {
  std::vector<Bar> bars;
  if (is_box(c)) {
    const auto directions = edge_directions<mpq_class>(c.quaternion);
    for (std::size_t i = 0; i < 3; ++i)
      if (c.edges[i] > 0)
        bars.push_back(
            {i, in_integers(directions[i]), lift(mpq_class(mpq_class(c.edges[i]) / 2) * directions[i])});
  } else if (c.height > 0) {
    bars.push_back({0, in_integers(exact(c.axis)), half_axis(c, square)});
  }
  return bars;
}

mpq_class axis_square(const Pair& pair) {
  const Rational3 w = exact(is_box(pair.a) ? pair.b.axis : pair.a.axis);
  return dot(w, w);
}

SimplexLimits<Surd> exact_limits(const mpq_class& contact) {
  SimplexLimits<Surd> limits;
  limits.contact = Surd(contact);
  limits.sign_only = true;
  limits.rounds_cap = std::numeric_limits<int>::max();
  return limits;
}

/// Some vector square to v.
Rational3 square_to(const Rational3& v) {
  const Rational3 n = cross(v, {1, 0, 0});
  return is_zero(n) ? cross(v, {0, 1, 0}) : n;
}

/// Returns rational directions. If the polytopes do not overlap, one of them has f <= 0. If the bars span no
/// space, they are square to their plane or line, or to a facet in it.
std::vector<Rational3> facet_directions(const std::vector<Bar>& bars, const Rational3& delta) {
  std::vector<Rational3> normals;
  for (std::size_t i = 0; i < bars.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (const Rational3 n = cross(bars[i].direction, bars[j].direction); !is_zero(n)) normals.push_back(n);
  if (bars.empty()) return {delta};
  const Rational3& first = bars[0].direction;
  if (normals.empty()) {
    const Rational3 beside = cross(first, cross(delta, first));
    return {first, is_zero(beside) ? square_to(first) : beside};
  }
  const Rational3 normal = normals[0];
  if (std::ranges::any_of(bars, [&](const Bar& b) { return dot(normal, b.direction) != 0; })) return normals;
  normals = {normal};
  for (const Bar& b : bars) normals.push_back(cross(normal, b.direction));
  return normals;
}

class Polytopes {
 public:
  explicit Polytopes(const Pair& pair)
      : pair_(pair),
        square_(axis_square(pair)),
        of_a_(bars_of(pair.a, square_)),
        of_b_(bars_of(pair.b, square_)),
        delta_(exact(pair.b.center) - exact(pair.a.center)) {
    take_denominators(unit_, lift(delta_));
    for (const auto* bars : {&of_a_, &of_b_})
      for (const Bar& bar : *bars) take_denominators(unit_, bar.half);
    for (auto* bars : {&of_a_, &of_b_})
      for (Bar& bar : *bars) bar.half = unit() * bar.half;
  }

  /// Sets the direction unless the solids overlap.
  int facet_sign(Rational3& direction) const {
    std::vector<Bar> bars = of_a_;
    bars.insert(bars.end(), of_b_.begin(), of_b_.end());
    const TwinFilter filter(pair_);
    int least = 1;
    for (const Rational3& raw : facet_directions(bars, delta_)) {
      // Two points in one place touch in any direction.
      const Rational3 d = is_zero(raw)           ? Rational3{1, 0, 0}
                          : dot(raw, delta_) < 0 ? mpq_class(-1) * raw
                                                 : raw;
      const TwinInterval gap = filter.support_gap(enclosed<TwinInterval>(d));
      if (surely_less(0.0, gap)) continue;
      const int sign = surely_less(gap, 0.0) ? -1 : exact_gap(lift(d)).sign();
      if (sign >= least) continue;
      direction = d;
      least = sign;
      if (sign < 0) break;
    }
    return least;
  }

  /// f(d) of the cores, times unit().
  Surd exact_gap(const Surd3& d) const {
    Surd f = -abs(dot(d, unit() * lift(delta_)));
    for (const auto* bars : {&of_a_, &of_b_})
      for (const Bar& bar : *bars) f = f + abs(dot(d, bar.half));
    return f;
  }

  /// The points of the cores that are nearest to each other, from a's centre. Or points that are nearer than
  /// the contact distance. Or, if they are farther apart, points whose difference is a direction that shows
  /// it. All lengths are times unit().
  Simplex<Surd> nearest(const mpq_class& contact) const {
    const Surd3 delta = unit() * lift(delta_);
    const auto lowest = [&](const Surd3& d) {
      Surd3 on_a{}, between = delta;
      for (const Bar& bar : of_a_) add(on_a, dot(d, lift(bar.direction)).sign(), bar.half);
      for (const Bar& bar : of_b_) add(between, -dot(d, lift(bar.direction)).sign(), bar.half);
      return BodyCorner<Surd>{between - on_a, on_a};
    };
    Simplex<Surd> s = start(delta);
    s.reduce(Surd(), false);
    approach(s, exact_limits(contact * mpq_class(unit_)), lowest);
    return s;
  }
  int sign_of(const Simplex<Surd>& s, const mpq_class& contact) const {
    const Surd reach = Surd(contact) * unit();
    return (reach * reach - s.square).sign();
  }

  const mpq_class& square() const { return square_; }
  Surd unit() const { return Surd(mpq_class(unit_)); }

 private:
  static void add(Surd3& sum, int sign, const Surd3& half) {
    if (sign > 0) sum = sum + half;
    if (sign < 0) sum = sum - half;
  }

  /// The corners at which the search in double ended, exactly.
  Simplex<Surd> start(const Surd3& delta) const {
    int exponent = 0;
    const TermsPair<double> p = terms_in_unit<double>(pair_, exponent);
    const Simplex<double> found = search_box(p, 53, false);
    const auto like = [](const std::vector<Bar>& bars, const Terms<double>& terms, const Vec3<double>& x) {
      Surd3 corner{};
      for (const Bar& bar : bars)
        add(corner, dot(x, terms.box ? terms.edges[bar.edge] : terms.axis) < 0 ? -1 : 1, bar.half);
      return corner;
    };
    Simplex<Surd> s;
    for (; s.count < found.count; ++s.count) {
      const BodyCorner<double>& c = found.corners[s.count];
      const Surd3 on_a = like(of_a_, p.a, c.on_a), on_b = like(of_b_, p.b, c.at + c.on_a - p.delta);
      s.corners[s.count] = {delta + on_b - on_a, on_a};
    }
    return s;
  }

  const Pair& pair_;
  mpq_class square_;
  std::vector<Bar> of_a_, of_b_;
  Rational3 delta_;
  mpz_class unit_ = 1;  // the common denominator of all lengths
};

/// A box and a cylinder with a radius, both without rounding. Points are relative to the cylinder's centre.
class BoxInSlab {
 public:
  explicit BoxInSlab(const Pair& pair)
      : box_first_(is_box(pair.a)),
        box_(box_first_ ? pair.a : pair.b),
        cylinder_(box_first_ ? pair.b : pair.a),
        square_(axis_square(pair)),
        axis_(exact(cylinder_.axis)),
        delta_(exact(box_.center) - exact(cylinder_.center)),
        bars_(bars_of(box_, square_)),
        half_(dot(half_axis(cylinder_, square_), lift(axis_))) {}

  int sign() {
    cut();
    if (clip_.empty()) return -1;
    const Surd radius{mpq_class(cylinder_.radius)};
    const auto lowest = [&](const Surd3& d) {
      const BodyCorner<Surd>* best = nullptr;
      Surd least;
      for (const BodyCorner<Surd>& c : clip_)
        if (const Surd along = dot(d, c.at); !best || along < least) {
          best = &c;
          least = along;
        }
      return *best;
    };
    found_.corners[found_.count++] = lowest(lift(delta_ - mpq_class(dot(delta_, axis_) / square_) * axis_));
    found_.reduce(Surd(), false);
    approach(found_, exact_limits(cylinder_.radius), lowest);
    if (const int sign = (radius * radius - found_.square).sign(); sign <= 0) return sign;
    return inside_slab() ? 1 : 0;
  }

  /// After sign(): the point of the box within the slab that is nearest to the axis, or near enough.
  Surd3 point() const { return found_.on_a(); }

  /// After sign(), which is <= 0: the direction from the cylinder to the box in which f is least.
  Surd3 direction() const {
    const Surd radius{mpq_class(cylinder_.radius)};
    if (clip_.empty() || found_.square < radius * radius)
      return dot(delta_, axis_) < 0 ? lift(mpq_class(-1) * axis_) : lift(axis_);
    // It is p + m w, with p from the axis to the point. In m, f is convex and has its kinks at
    // directions square to the axis or to an edge.
    const Surd3 &p = found_.nearest, w = lift(axis_);
    Surd3 best = p;
    Surd least = height(p);
    for (const Bar& bar : bars_) {
      const mpq_class along = dot(bar.direction, axis_);
      if (along == 0) continue;
      const Surd m = -dot(p, lift(bar.direction)) / Surd(along);
      const Surd3 d = p + m * w;
      if (const Surd h = height(d); h < least) {
        least = h;
        best = d;
      }
    }
    return best;
  }

  const mpq_class& square() const { return square_; }
  mpq_class radius() const { return cylinder_.radius; }
  Rational3 center() const { return exact(cylinder_.center); }
  bool box_first() const { return box_first_; }

 private:
  /// f(d) without the part of the radius, which is the same for all d that have the same part square to w.
  Surd height(const Surd3& d) const {
    Surd sum = abs(dot(d, lift(axis_))) * half_ / Surd(square_) - dot(d, lift(delta_));
    for (const Bar& bar : bars_) sum = sum + abs(dot(d, bar.half));
    return sum;
  }

  /// Whether the box has a point strictly within the slab, or, for a disk, on both sides of its plane.
  bool inside_slab() const {
    mpq_class reach = 0;
    for (const Bar& bar : bars_) reach += abs(dot(rational_part(bar.half), axis_));
    if (reach == 0 && half_.sign() == 0) return false;
    return Surd(mpq_class(abs(dot(delta_, axis_)))) < half_ + Surd(reach);
  }

  void cut() {
    std::vector<Rational3> corners{delta_};
    for (const Bar& bar : bars_) {
      const Rational3 half = rational_part(bar.half);
      const std::size_t count = corners.size();
      for (std::size_t i = 0; i < count; ++i) {
        corners.push_back(corners[i] + half);
        corners[i] = corners[i] - half;
      }
    }
    const Surd3 w = lift(axis_);
    const auto keep = [&](const Surd3& x, const Surd& along) {
      clip_.push_back({x - (along / Surd(square_)) * w, x});
    };
    std::vector<Surd> along;
    for (const Rational3& x : corners) {
      along.emplace_back(mpq_class(dot(x, axis_)));
      if (!(abs(along.back()) > half_)) keep(lift(x), along.back());
    }
    // Bit k of a corner's index is its side of the k-th edge.
    for (std::size_t i = 0; i < corners.size(); ++i)
      for (std::size_t bit = 1; bit < corners.size(); bit *= 2) {
        const std::size_t j = i | bit;
        if (j == i) continue;
        const Surd3 edge = lift(corners[j] - corners[i]);
        for (const Surd& plane : {half_, -half_})
          if ((along[i] - plane).sign() * (along[j] - plane).sign() < 0) {
            const Surd share = (plane - along[i]) / (along[j] - along[i]);
            keep(lift(corners[i]) + share * edge, plane);
            if (half_.sign() == 0) break;
          }
      }
  }

  bool box_first_;
  const Solid &box_, &cylinder_;
  mpq_class square_;  // of the axis
  Rational3 axis_, delta_;
  std::vector<Bar> bars_;
  Surd half_;                           // the height/2 times |axis|
  std::vector<BodyCorner<Surd>> clip_;  // its corners; `at` is seen along the axis
  Simplex<Surd> found_;
};

}  // namespace

bool has_box_relation(const Pair& pair) { return are_polytopes(pair) || !is_rounded(pair); }

int box_sign(const Pair& pair) {
  if (!are_polytopes(pair)) return BoxInSlab(pair).sign();
  const Polytopes p(pair);
  Rational3 direction;
  if (!is_rounded(pair)) return p.facet_sign(direction);
  const mpq_class contact = contact_distance_of(pair);
  return p.sign_of(p.nearest(contact), contact);
}

BoxRelation box_relation(const Pair& pair, int bits) {
  BoxRelation r;
  const mpq_class size = exact_size(pair);
  if (!are_polytopes(pair)) {
    BoxInSlab slab(pair);
    r.sign = slab.sign();
    if (r.sign >= 0) {
      r.on_a = r.on_b = slab.center() + rounded(slab.point(), slab.square(), size, bits);
    }
    if (r.sign <= 0) {
      const Surd3 d = slab.direction();
      r.direction = rounded(d, slab.square(), slab.radius(), bits);
      if (slab.box_first()) r.direction = mpq_class(-1) * r.direction;
    }
    return r;
  }
  const Polytopes p(pair);
  const mpq_class contact = contact_distance_of(pair);
  if (contact == 0) {
    r.sign = p.facet_sign(r.direction);
    if (r.sign == 0) r.on_a = r.on_b = common_point_of_polytopes(pair, bits);
    return r;
  }
  const Simplex<Surd> s = p.nearest(contact);
  r.sign = p.sign_of(s, contact);
  r.direction = rounded(s.nearest, p.square(), contact * p.unit().rational_part(), bits);
  const Surd to_scene = Surd(1.0) / p.unit();
  r.on_a = exact(pair.a.center) + rounded(to_scene * s.on_a(), p.square(), size, bits);
  r.on_b = exact(pair.a.center) + rounded(to_scene * s.on_b(), p.square(), size, bits);
  return r;
}

Rational3 common_point_of_polytopes(const Pair& pair, int bits) {
  const Polytopes p(pair);
  const Surd to_scene = Surd(1.0) / p.unit();
  return exact(pair.a.center) + rounded(to_scene * p.nearest(0).on_a(), p.square(), exact_size(pair), bits);
}

bool are_polytopes(const Pair& pair) { return is_polytope(pair.a) && is_polytope(pair.b); }

}  // namespace cyl
