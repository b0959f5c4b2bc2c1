// SPDX-License-Identifier: MIT
#include "props/laws/laws.hpp"

#include <algorithm>
#include <stdexcept>

#include "corpus/pairs/pair_numbers.hpp"
#include "corpus/pairs/support.hpp"
#include "corpus/pairs/touch_plane.hpp"
#include "props/laws/law_groups.hpp"
#include "solver/decide.hpp"

namespace cyl {
namespace {

/// The relative rounding of a distance by a method that claims no error, as compare() allows it.
constexpr double distance_rounding_error = 0x1p-50;

}  // namespace

std::span<const Law> all_laws() {
  static const std::vector<Law> laws = [] {
    std::vector<Law> all;
    for (const auto& part : {exact_laws(), one_sided_laws(), approximate_laws(), answer_laws()})
      all.insert(all.end(), part.begin(), part.end());
    return all;
  }();
  return laws;
}

const Law& law_numbered(int number) {
  const auto laws = all_laws();
  const auto found =
      std::find_if(laws.begin(), laws.end(), [&](const Law& law) { return law.number == number; });
  if (found == laws.end()) throw std::invalid_argument("there is no law " + std::to_string(number));
  return *found;
}

bool is_decided(const MethodAnswer& answer) {
  return answer.status == Status::answered &&
         (answer.verdict == Verdict::disjoint || answer.verdict == Verdict::intersecting ||
          answer.verdict == Verdict::touching);
}

bool says_meet(const MethodAnswer& answer) {
  return is_decided(answer) && answer.verdict != Verdict::disjoint;
}

bool is_refuted(const LawCase& c, const Pair& pair, const MethodAnswer& answer) {
  if (!is_decided(answer)) return false;
  const Verdict truth = c.proofs.of(pair).truth.verdict;
  if (truth == Verdict::undecided || truth == Verdict::invalid) return false;
  return says_meet(answer) == (truth == Verdict::disjoint);
}

Severity severity_of(const LawCase& c, std::size_t i) {
  const Claim claim = c.method.claim();
  const Pair& second = c.asked[i].pair;
  const bool promised = beyond_claim(c.proofs.of(c.pair), claim);
  const bool second_promised = beyond_claim(c.proofs.of(second), claim);
  const bool contract = (promised && second_promised) || (promised && is_refuted(c, c.pair, c.first)) ||
                        (second_promised && is_refuted(c, second, c.answers[i]));
  return contract ? Severity::contract : Severity::resolution;
}

double distance_allowance(const LawCase& c, const Pair& pair, double said) {
  const double length = size_of(pair) + (pair.b.center - pair.a.center).norm();
  return std::max(reach(c.method.claim(), length),
                  distance_rounding_error * std::max(std::fabs(said), length));
}

Vector3 offered_direction(const Pair& pair, const MethodAnswer& answer) {
  const Vector3 u = Vector3(answer.head[0], answer.head[1], answer.head[2]).stableNormalized();
  return u.dot(pair.b.center - pair.a.center) < 0 ? Vector3(-u) : u;
}

double shown_by(const Pair& pair, const Vector3& u) {
  const Vector3 delta = pair.b.center - pair.a.center;
  double lengths = delta.norm();
  for (const Solid* c : {&pair.a, &pair.b}) lengths += core_extent(*c) + c->rounding;
  // |u| is 1 within 4 roundings, which half of the second bound covers.
  const double lost = 2 * separation_error * lengths;
  if (has_half_space(pair)) {
    const bool first = is_half_space(pair.a);
    const Vector3 n = direction_of(first ? pair.a : pair.b);
    return (first ? n : Vector3(-n)).dot(delta) -
           support(terms_of<double>(first ? pair.b : pair.a), lifted<double>(n)) - lost;
  }
  return -support_gap(terms_of<double>(pair.a), terms_of<double>(pair.b), lifted<double>(delta),
                      lifted<double>(u)) -
         lost;
}

double core_extent(const Solid& c) { return c.radius + c.height / 2 + edges_of(c) / 2; }

Vector3 direction_of(const Solid& c) {
  if (is_box(c)) {
    const auto longest = std::ranges::max_element(c.edges) - c.edges.begin();
    return edge_direction(c, static_cast<std::size_t>(longest));
  }
  const Vector3 w = prepare({.axis = c.axis}).unit_axis;  // of either sign
  return is_half_space(c) && w.dot(c.axis) < 0 ? Vector3(-w) : w;
}

bool is_in_range(const Pair& pair) {
  double largest = 0;
  for (const Solid* c : {&pair.a, &pair.b})
    largest = std::max({largest, c->center.lpNorm<Eigen::Infinity>(), c->radius, c->height, c->rounding,
                        std::ranges::max(c->edges)});
  return largest >= 0x1p-200 && largest <= 0x1p200;
}

}  // namespace cyl
