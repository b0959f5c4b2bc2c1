// SPDX-License-Identifier: MIT
#include "fuzz/worst/pair_chart.hpp"

#include <nlopt.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <memory>
#include <vector>

#include "corpus/pairs/pair_numbers.hpp"
#include "corpus/pairs/touch_plane.hpp"
#include "oracles/methods/adapter.hpp"
#include "oracles/referee/referee.hpp"

namespace cyl {
namespace {

/// The coordinates are the decades of the whole and of each length, and a rotation vector of the whole. A
/// turn of b about its own direction follows, for boxes alone. Then come the displacement of b in sizes
/// (along a's direction, aside, square to both) and the decades of the distance. The last are the decades of
/// the angle between the directions, and the azimuth of b about a's.
enum : std::size_t {
  scale,
  lengths,
  rotation = lengths + 6,
  spin = rotation + 3,
  move,
  margin = move + 3,
  angle,
  azimuth
};
static_assert(azimuth + 1 == PairChart::dimensions);

constexpr double pi = 3.14159265358979323846;
/// Decades from 45 degrees at which an angle is taken to be exactly 0. Doubles do not resolve such an angle.
constexpr double exact_decades = 15.5, most_decades = 16;
/// Decades by which lengths may change; sizes, by which b may move.
constexpr double length_reach = 3, move_reach = 1;
/// Decades by which the distance may.
constexpr double margin_reach = 6;
/// The cosine of an edge and the direction of the distance from which on a box touches in a facet.
constexpr double facet_tol = 1e-6;
/// Evaluations of one walk. Walks of this length from several places find more than longer ones.
constexpr int walk_cap = 250;
/// Changes in a coordinate below which a walk is over.
constexpr double walk_step_tol = 1e-5;

/// Returns the radius and height, or the edges, of both solids.
std::vector<double*> lengths_of(Pair& p) {
  std::vector<double*> all;
  for (Solid* c : {&p.a, &p.b})
    if (is_box(*c))
      for (double& edge : c->edges) all.push_back(&edge);
    else
      all.insert(all.end(), {&c->radius, &c->height});
  return all;
}

void scale_lengths(Pair& p, double factor) {
  for_each_length(p, [&](double& x) { x *= factor; });
}

/// Maps a point of `from`, an offset from its centre, to `to`. The directions are those of `from`.
Vector3 stretched(const Solid& from, const Solid& to, const Vector3& point) {
  const auto ratio = [](double x, double y) { return x > 0 ? y / x : 1; };
  if (is_box(from)) {
    Vector3 sum(0, 0, 0);
    for (std::size_t i = 0; i < 3; ++i) {
      const Vector3 edge = edge_direction(from, i);
      sum += ratio(from.edges[i], to.edges[i]) * edge.dot(point) * edge;
    }
    return sum;
  }
  const Vector3 axis = unit_axis(from.axis), along = axis.dot(point) * axis;
  return ratio(from.height, to.height) * along + ratio(from.radius, to.radius) * (point - along);
}

/// Returns the axis. The axis of a box that touches in a facet is the normal of the facet. That of any other
/// box is the edge that is most nearly square to the direction of the distance.
Vector3 direction_of(const Solid& c, const Vector3& of_distance) {
  if (!is_box(c)) return unit_axis(c.axis);
  const auto along = [&](std::size_t i) { return std::abs(edge_direction(c, i).dot(of_distance)); };
  constexpr std::array<std::size_t, 3> edges{0, 1, 2};
  const std::size_t most = *std::ranges::max_element(edges, {}, along);
  return edge_direction(c, along(most) > 1 - facet_tol ? most : *std::ranges::min_element(edges, {}, along));
}

void turn(Solid& box, const Eigen::Quaterniond& by) {
  const auto& [w, x, y, z] = box.quaternion;
  const Eigen::Quaterniond q = by * Eigen::Quaterniond(w, x, y, z);
  box.quaternion = {q.w(), q.x(), q.y(), q.z()};
}

double farthest(const Pair& p) {
  return std::max(p.a.center.cwiseAbs().maxCoeff(), p.b.center.cwiseAbs().maxCoeff());
}

}  // namespace

// By a power of two, so that only lengths that leave the range of doubles are rounded.
std::optional<Pair> bring_into(const Domain& domain, const Pair& pair) {
  if (has_half_space(pair)) return {};  // no search for these yet
  Pair p = pair;
  const double size = is_legal(p) ? size_of(p) : 0;
  if (!(size > 0)) return {};
  if (size < domain.least_size) scale_lengths(p, std::exp2(std::ceil(std::log2(domain.least_size / size))));
  if (size > domain.most_size) scale_lengths(p, std::exp2(std::floor(std::log2(domain.most_size / size))));
  const double now = size_of(p);
  for (double* x : lengths_of(p))
    if (*x > 0) *x = std::max(*x, domain.least_part * now);
  if (farthest(p) > domain.most_offset * now) {
    p.b.center -= p.a.center;
    p.a.center.setZero();
  }
  if (!is_legal(p) || farthest(p) > domain.most_offset * now) return {};
  return p;
}

bool is_in(const Domain& domain, const Pair& pair) {
  constexpr double rounding = 0x1p-40;  // of a few products and sums, generously
  if (!is_legal(pair)) return false;
  const double size = size_of(pair);
  return size >= domain.least_size * (1 - rounding) && size <= domain.most_size * (1 + rounding) &&
         farthest(pair) <= domain.most_offset * size * (1 + rounding);
}

PairChart::PairChart(const Pair& start, std::optional<ContactFeature> feature, const Domain& domain)
    : start_(start), feature_(feature), domain_(domain), size_(size_of(start)) {
  const MeasuredDistance d = measure_with_points(start);
  on_a_ = d.on_a;
  on_b_ = d.on_b;
  gap_ = d.value * d.direction;
  a_ = direction_of(start.a, d.direction);
  b_ = direction_of(start.b, d.direction);
  const double along = a_.dot(b_), across = a_.cross(b_).norm();
  aside_ = across > 0 ? Vector3(b_ - along * a_).normalized() : a_.unitOrthogonal();
  sign_ = along < 0 ? -1 : 1;
  const double small = std::min(across, std::abs(along));
  const double decades =
      small > 0 ? std::clamp(std::log10(std::asin(small) / (pi / 4)), -most_decades, 0.0) : -most_decades;
  decades_ = across < std::abs(along) ? decades : -decades;

  const auto set = [&](std::size_t i, double low, double high, double step) {
    low_[i] = std::min(low, 0.0);
    high_[i] = std::max(high, 0.0);
    step_[i] = step;
  };
  // Without room it is left out by NLopt.
  const auto leave_out = [&](std::size_t i) { low_[i] = high_[i] = 0, step_[i] = 1; };
  set(scale, std::log10(domain.least_size / size_), std::log10(domain.most_size / size_), 0.5);
  const std::size_t lengths_end = lengths + lengths_of(start_).size();
  for (std::size_t i = lengths; i < lengths_end; ++i) set(i, -length_reach, length_reach, 0.25);
  for (std::size_t i = lengths_end; i < rotation; ++i) leave_out(i);
  for (std::size_t i = rotation; i < spin; ++i) set(i, -pi, pi, 0.25);
  if (is_box(start.b))
    set(spin, -pi, pi, 0.25);
  else
    leave_out(spin);
  for (std::size_t i = move; i < margin; ++i) set(i, -move_reach, move_reach, 0.05);
  if (domain.fine)
    set(margin, -margin_reach, margin_reach, 0.5);
  else
    leave_out(margin);
  set(angle, -most_decades - decades_, most_decades - decades_, 0.5);
  set(azimuth, -pi, pi, 0.25);
}

// The angle between the directions is 45 degrees times 10^decades from parallel if decades < 0. Otherwise it
// is 45 degrees times 10^-decades from perpendicular.
Vector3 PairChart::turned_axis(double decades, double by) const {
  const Vector3 towards = std::cos(by) * aside_ + std::sin(by) * a_.cross(aside_);
  if (feature_ == ContactFeature::cap_cap || decades <= -exact_decades) return sign_ * a_;
  if (feature_ == ContactFeature::cap_side || decades >= exact_decades) return towards;
  const double small = pi / 4 * std::pow(10, -std::abs(decades));
  return decades < 0 ? Vector3(std::cos(small) * sign_ * a_ + std::sin(small) * towards)
                     : Vector3(std::sin(small) * sign_ * a_ + std::cos(small) * towards);
}

// The solids are put together again at the points that face each other: turned about that of b, each moved in
// its solid as lengths change. So what meets stays what meets, mostly.
Pair PairChart::pair(std::span<const double, dimensions> x) const {
  Pair p = start_;
  const bool turned = x[angle] != 0 || x[azimuth] != 0 || x[spin] != 0;
  Eigen::Quaterniond turn_b = Eigen::Quaterniond::Identity();
  if (turned) {
    const Vector3 direction = turned_axis(decades_ + x[angle], x[azimuth]);
    turn_b = Eigen::Quaterniond::FromTwoVectors(b_, direction);
    if (is_box(p.b)) {
      turn_b = turn_b * Eigen::AngleAxisd(x[spin], b_);
      turn(p.b, turn_b);
    } else {
      p.b.axis = direction;
    }
  }
  if (turned || x[margin] != 0 ||
      std::any_of(x.begin() + scale, x.begin() + rotation, [](double y) { return y != 0; })) {
    std::size_t i = lengths;
    for (double* length : lengths_of(p))
      *length *= domain_.fine && x[i] == low_[i] ? 0 : std::pow(10, x[i]), ++i;
    if (!(size_of(p) > 0)) *lengths_of(p).front() = size_;
    const double size = size_of(p);
    for (double* length : lengths_of(p))
      if (*length > 0) *length = std::max(*length, domain_.least_part * size);
    const double wanted = std::clamp(size_ * std::pow(10, x[scale]), domain_.least_size, domain_.most_size);
    scale_lengths(p, wanted / size_of(p));
    p.a.center = wanted / size_ * start_.a.center;
    const Vector3 on_b = stretched(start_.b, p.b, on_b_);
    const Vector3 turned_on_b = turned ? Vector3(turn_b * on_b) : on_b;
    p.b.center = p.a.center + stretched(start_.a, p.a, on_a_) +
                 wanted / size_ * std::pow(10, x[margin]) * gap_ - turned_on_b;
  }
  if (x[move] != 0 || x[move + 1] != 0 || x[move + 2] != 0)
    p.b.center += size_of(p) * (x[move] * a_ + x[move + 1] * aside_ + x[move + 2] * a_.cross(aside_));
  const Vector3 whole(x[rotation], x[rotation + 1], x[rotation + 2]);
  if (const double by = whole.norm(); by > 0) {
    const Eigen::AngleAxisd rotation_of_all(by, whole / by);
    const Eigen::Matrix3d m = rotation_of_all.toRotationMatrix();
    for (Solid* c : {&p.a, &p.b}) {
      if (is_box(*c))
        turn(*c, Eigen::Quaterniond(rotation_of_all));
      else
        c->axis = m * c->axis;
      c->center = m * c->center;
    }
  }
  return p;
}

// One slide may not quite touch, so there are two.
std::optional<Ray> ray_of(const Pair& pair) {
  Ray ray{pair, {0, 0, 0}, size_of(pair)};
  for (int i = 0; i < 2; ++i) {
    const MeasuredDistance d = approximate_distance(ray.touching);
    if (!(d.direction.norm() > 0.5)) return {};
    ray.direction = d.direction;
    ray.touching.b.center -= d.value * d.direction;
  }
  return ray;
}

// NLopt's status codes do not matter, because `value` notes the finds on the way.
void PairChart::walk(const Point& first_step,
                     const std::function<std::optional<double>(const Pair&)>& value) const {
  const std::unique_ptr<nlopt_opt_s, decltype(&nlopt_destroy)> optimizer(
      nlopt_create(NLOPT_LN_SBPLX, dimensions), nlopt_destroy);
  std::exception_ptr thrown;
  std::function<double(const double*)> objective = [&](const double* x) {
    std::optional<double> found;
    try {
      found = value(pair(std::span<const double, dimensions>(x, dimensions)));
    } catch (...) {
      thrown = std::current_exception();
    }
    if (!found) nlopt_force_stop(optimizer.get());
    return found.value_or(0);
  };
  const auto call = [](unsigned, const double* x, double*, void* data) {
    return (*static_cast<std::function<double(const double*)>*>(data))(x);
  };
  nlopt_set_max_objective(optimizer.get(), call, &objective);
  nlopt_set_lower_bounds(optimizer.get(), low_.data());
  nlopt_set_upper_bounds(optimizer.get(), high_.data());
  nlopt_set_initial_step(optimizer.get(), first_step.data());
  nlopt_set_xtol_abs1(optimizer.get(), walk_step_tol);
  nlopt_set_maxeval(optimizer.get(), walk_cap);
  Point x{};
  double best = 0;
  nlopt_optimize(optimizer.get(), x.data(), &best);
  if (thrown) std::rethrow_exception(thrown);
}

}  // namespace cyl
