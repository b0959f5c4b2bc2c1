// SPDX-License-Identifier: MIT
// K is a sum of segments, its generators, and at most one disk with unit normal w: the edges of boxes, and
// the axis and the disk of a cylinder.
//
// 1. Directions. If K holds delta, the depth is the least f over unit directions. It is attained at
//    (i) w or -w, or (ii) a direction square to a generator.
//    Proof. Let the depth be t > 0, attained at D. The ball of radius t about delta lies in K, and x = delta
//    + t D is on the boundary of both. A plane that supports K at x supports the ball too. So D is the only
//    outward normal of K at x. Now let D be neither (i) nor (ii). Then every generator has one end that is
//    farthest along D, and the disk has one such point. x is the sum of these. If there is a disk, turn D a
//    little in the plane of D and w. The same ends stay farthest, and so does the point of the rim. Without a
//    disk, any small turn keeps x. So x has other normals, which is a contradiction.
//    If t = 0, delta is on the boundary of K. If K is flat, a normal of its plane or line is (i) or (ii).
//    Else the normals at x form a cone that holds no line. f is 0 on all of it, so also on its edges. An edge
//    of the cone is (i) or (ii), since else the turn above would keep it within the cone, on both sides.
//
// 2. Circles. The directions square to a generator are a great circle. There f is the support function of a
//    plane figure, the shadow of K, less a product with the shadow of delta. The half of the circle towards
//    delta is enough, because f(D) = f(-D) - 2 D.delta.
//
// 3. Arcs. For any y of K - delta, f(D) >= D.y. At the ends d0 and d1 of an arc of at most a right angle, let
//    y0 and y1 be the points with f(d) = d.y. Then f >= max(D.y0, D.y1) on the arc. Both are equal at the
//    direction of c = d0 + s (d1 - d0), with s = (f(d0) - d0.y1) / (f(d0) - d0.y1 + f(d1) - d1.y0). From d0
//    to c the first is the greater one. A sinusoid is least at an end of an arc, or opposite to y, at -|y|.
//    For a figure with corners c is the normal of its side, and the bound is f(c) itself. At a round part the
//    bound is short by the square of the angle. Arcs are split in turn at the least bound and in the middle.
#include "oracles/referee/great_circles.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <queue>
#include <vector>

namespace cyl {
namespace {

using Vec = Vec3<double>;
struct Vec2 {
  double x, y;
};
double dot(const Vec2& a, const Vec2& b) { return a.x * b.x + a.y * b.y; }
double turn(const Vec2& a, const Vec2& b) { return a.x * b.y - a.y * b.x; }
Vec2 unit(const Vec2& v) {
  const double length = std::sqrt(dot(v, v));
  return {v.x / length, v.y / length};
}

/// Half vectors, and the disk of the one solid that may have one.
struct Generators {
  std::array<Vec, 6> all;
  std::size_t count = 0;
  Vec axis{};
  double radius = 0;

  explicit Generators(const CorePair& pair) {
    for (const Terms<double>* s : {&pair.a, &pair.b}) {
      for (std::size_t i = 0; s->box && i < 3; ++i) add(s->edges[i], s->halves[i]);
      if (s->box) continue;
      add(s->axis, s->half);
      axis = s->axis;
      radius = s->radius;
    }
  }

 private:
  void add(const Vec& along, double half) {
    if (half > short_tol) all[count++] = half * along;
  }
};

class Circle {
 public:
  Circle(const Generators& of, const Vec& delta, const Vec& pole) {
    const Vec e = pole / norm(pole);
    u_ = cross(e, std::fabs(e.x) < 0.5 ? Vec{1, 0, 0} : Vec{0, 1, 0});
    u_ = u_ / norm(u_);
    v_ = cross(e, u_);
    for (; count_ < of.count; ++count_) generators_[count_] = shadow(of.all[count_]);
    delta_ = shadow(delta);
    axis_ = shadow(of.axis);
    radius_ = of.radius;
    along_ = dot(e, of.axis);
  }

  Vec in_space(const Vec2& d) const { return d.x * u_ + d.y * v_; }

  /// A direction towards delta.
  Vec2 towards() const { return dot(delta_, delta_) > short_tol * short_tol ? unit(delta_) : Vec2{1, 0}; }

  /// A point y of K - delta with f(d) = d.y.
  Vec2 support(const Vec2& d) const {
    Vec2 y{-delta_.x, -delta_.y};
    for (std::size_t i = 0; i < count_; ++i) {
      const Vec2& g = generators_[i];
      const double along = dot(g, d), sign = along > 0 ? 1 : along < 0 ? -1 : 0;
      y.x += sign * g.x;
      y.y += sign * g.y;
    }
    if (radius_ == 0) return y;
    // The disk's part is r |D x w|. The square is that of D x (shadow of w) and of D times the rest of w.
    const double turned = turn(d, axis_), size = std::sqrt(turned * turned + along_ * along_);
    if (!(size > 0)) return y;
    const double part = radius_ / size;
    y.x += part * (turned * axis_.y + along_ * along_ * d.x);
    y.y += part * (along_ * along_ * d.y - turned * axis_.x);
    return y;
  }

 private:
  Vec2 shadow(const Vec& v) const { return {dot(v, u_), dot(v, v_)}; }
  Vec u_, v_;
  std::array<Vec2, 6> generators_;
  std::size_t count_ = 0;
  Vec2 delta_, axis_;
  double radius_, along_;
};

/// A direction, a support point there, and f.
struct Sample {
  Vec2 d, y;
  double f;
};

struct Arc {
  std::size_t circle;
  Sample from, to;
  bool halve = false;  ///< at its middle
  Vec2 split{};
  double below = 0;
  bool operator<(const Arc& o) const { return below > o.below; }  // the least bound first

  void bound() {
    const double one = std::max(0.0, from.f - dot(to.y, from.d)),
                 other = std::max(0.0, to.f - dot(from.y, to.d)),
                 share = one + other > 0 ? one / (one + other) : 0.5;
    const auto mixed = [&](double s) {
      return unit({(1 - s) * from.d.x + s * to.d.x, (1 - s) * from.d.y + s * to.d.y});
    };
    const Vec2 c = mixed(share);
    below = dot(c, from.y);
    split = c;
    dip(from.y, from.d, c);
    dip(to.y, c, to.d);
    if (halve) split = mixed(0.5);
    below = std::min({below, from.f, to.f});
  }

 private:
  /// Looks at the direction opposite to y, if it is between the two.
  void dip(const Vec2& y, const Vec2& first, const Vec2& last) {
    const double size = std::sqrt(dot(y, y));
    if (!(-size < below) || size < short_tol) return;
    const Vec2 d{-y.x / size, -y.y / size};
    if (turn(first, d) < 0 || turn(d, last) < 0 || dot(first, d) < 0) return;
    below = -size;
    split = d;
  }
};

class Search {
 public:
  Search(const CorePair& pair, LeastOnCircles& least) : generators_(pair), least_(least) {
    const double apart = norm(pair.delta);
    const auto take = [&](const Vec& d) {
      if (const double f = pair.value(d); f < least_.best) least_.best = f, least_.direction = d;
    };
    least_.best = std::numeric_limits<double>::infinity();
    take(apart > short_tol ? pair.delta / apart : Vec{0, 0, 1});
    if (generators_.radius > 0)
      take(dot(generators_.axis, pair.delta) < 0 ? -1.0 * generators_.axis : generators_.axis);
    for (std::size_t i = 0; i < generators_.count; ++i) {
      circles_.emplace_back(generators_, pair.delta, generators_.all[i]);
      const Vec2 to = circles_[i].towards(), left{-to.y, to.x}, right{to.y, -to.x};
      const Sample middle = sample(i, to);
      add({i, sample(i, right), middle});
      add({i, middle, sample(i, left)});
    }
  }

  void narrow(double width, std::size_t most_cells) {
    while (!arcs_.empty() && arcs_.top().below < least_.best - width && least_.cells < most_cells) {
      const Arc arc = arcs_.top();
      arcs_.pop();
      const Sample between = sample(arc.circle, arc.split);
      add({arc.circle, arc.from, between, !arc.halve});
      add({arc.circle, between, arc.to, !arc.halve});
    }
    least_.floor = arcs_.empty() ? least_.best : std::min(least_.best, arcs_.top().below);
  }

 private:
  Sample sample(std::size_t circle, const Vec2& d) {
    const Vec2 y = circles_[circle].support(d);
    const double f = dot(d, y);
    if (f < least_.best) {
      least_.best = f;
      least_.direction = circles_[circle].in_space(d);
    }
    return {d, y, f};
  }
  void add(Arc arc) {
    ++least_.cells;
    arc.bound();
    if (arc.below < least_.best) arcs_.push(arc);
  }

  Generators generators_;
  std::vector<Circle> circles_;
  std::priority_queue<Arc> arcs_;
  LeastOnCircles& least_;
};

}  // namespace

LeastOnCircles least_on_circles(const CorePair& pair, double width, std::size_t most_cells) {
  LeastOnCircles least;
  Search search(pair, least);
  search.narrow(width, most_cells);
  return least;
}

}  // namespace cyl
