// SPDX-License-Identifier: MIT
#include "fuzz/campaign/climbed.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "corpus/pairs/close_contact.hpp"
#include "corpus/pairs/pair_numbers.hpp"
#include "corpus/pairs/random_stream.hpp"
#include "corpus/pairs/stratum.hpp"
#include "fuzz/campaign/derived.hpp"
#include "oracles/methods/adapter.hpp"
#include "oracles/methods/own_answers.hpp"
#include "oracles/referee/referee.hpp"
#include "solver/distance.hpp"

namespace cyl {
namespace {

/// The referee's cap. A tie at 4096 bits takes as long as the whole climb.
constexpr int climb_bits_cap = 256;
/// Sizes of the pairs. Pairs beyond them are not harder.
constexpr double least_size = 1e-6, most_size = 1e6;
/// The shortest length that is not 0, over the size.
constexpr double least_part = 1e-9;

/// Returns a number of either sign, by decades from 1 to 1e-17.
double tenth(RandomStream& s) {
  const double sign = s.sign(), decade = s.pick(std::span(tenths).first<17>());
  return sign * decade * s.between(0.1, 1);
}

Cylinder& either(Pair& p, RandomStream& s) { return s.coin() ? p.a : p.b; }

void change_length(Pair& p, RandomStream& s) {
  Cylinder& c = either(p, s);
  double& length = s.coin() ? c.radius : c.height;
  const std::size_t way = s.below(8);
  length = way == 0      ? 0
           : length == 0 ? size_of(p) * std::abs(tenth(s))
                         : length * (way < 5 ? 1 + tenth(s) : 2 * std::abs(tenth(s)));
  if (length < least_part * size_of(p)) length = 0;
}

void turn(Pair& p, RandomStream& s) {
  Cylinder& c = either(p, s);
  const Vector3 own = unit_axis(c.axis), other = unit_axis(&c == &p.a ? p.b.axis : p.a.axis);
  const std::size_t way = s.below(4);
  const double tilt = s.below(8) == 0 ? 0 : tenth(s);
  const Vector3 from = way < 2 ? own : way == 2 ? other : s.perpendicular(other);
  c.axis = from + tilt * (way == 3 ? other : s.perpendicular(from));
}

void slide(Pair& p, RandomStream& s) {
  const double by = tenth(s) * size_of(p);
  p.b.center += by * s.unit_vector();
}

void step_number(Pair& p, RandomStream& s) {
  double& x = *numbers_of(either(p, s))[s.below(core_number_count)];
  x = std::nextafter(x, s.sign() * std::numeric_limits<double>::infinity());
}

// Uses the solver's own distance, right or wrong. Brings the pair to a margin near the earlier one, or to
// any.
void bring_to_margin(Pair& p, double margin, RandomStream& s) {
  const bool anew = s.below(4) == 0, other_side = s.below(4) == 0;
  double wanted = anew ? tenth(s) : margin * s.between(0.3, 3);
  if (other_side) wanted = -wanted;
  for (int i = 0; i < 2; ++i) {
    const Distance d = distance(p.a, p.b);
    p.b.center += (wanted * size_of(p) - d.value) * d.direction;
  }
}

bool is_moderate(const Pair& p) {
  return is_legal(p) && size_of(p) >= least_size && size_of(p) <= most_size &&
         (p.b.center - p.a.center).cwiseAbs().maxCoeff() <= 100 * size_of(p);
}

Pair changed(const Pair& from, RandomStream& s) {
  constexpr std::array changes{change_length, turn, slide, step_number};
  for (int trial = 0; trial < 8; ++trial) {
    Pair p = from;
    for (std::size_t i = s.below(3); i > 0; --i) changes[s.below(changes.size())](p, s);
    if (!is_moderate(p)) continue;
    if (s.below(8) != 0) bring_to_margin(p, distance(from.a, from.b).value / size_of(from), s);
    if (is_moderate(p)) return p;
  }
  return from;
}

Pair drawn_start(RandomStream& s, std::uint64_t index) {
  const auto kind = enum_values<CloseKind>[index % enum_values<CloseKind>.size()];
  const std::uint64_t number = s.bits() >> 32;
  return draw_close_contact(kind, s, number).pair;
}

/// Returns all pairs of a climb, in their order.
std::vector<Pair> climb(std::uint64_t seed, std::uint64_t number) {
  RandomStream s("climbed", seed, number);
  const ClimbGoal& goal = goal_of_climb(number);
  std::vector<Pair> pairs;
  Pair best;
  double highest = -1;
  for (std::uint64_t i = 0; i < climb_size; ++i) {
    pairs.push_back(i < climb_starts ? drawn_start(s, i) : changed(best, s));
    const double height = height_of(goal, pairs.back());
    if (height < highest) continue;
    highest = height;
    best = pairs.back();
  }
  return pairs;
}

// Callers go through the indices in order, so the last climb is kept.
Pair climbed(std::uint64_t seed, std::uint64_t index) {
  struct Last {
    std::uint64_t seed, number;
    std::vector<Pair> pairs;
  };
  thread_local Last last{};
  const std::uint64_t number = index / climb_size;
  if (last.pairs.empty() || last.seed != seed || last.number != number)
    last = {seed, number, climb(seed, number)};
  return last.pairs[index % climb_size];
}

}  // namespace

double height_of(const ClimbGoal& goal, const Pair& pair) {
  return badness_of(goal.objective, {}, pair, goal.ask(pair), Effort::quick).value;
}

const ClimbGoal& goal_of_climb(std::uint64_t climb) {
  using enum Objective;
  constexpr auto by_decide = [](const Pair& p) { return answer_of(p, decide(p.a, p.b)); };
  constexpr auto by_distance = [](const Pair& p) { return answer_of(p, distance(p.a, p.b)); };
  constexpr auto by_judge = [](const Pair& p) { return answer_of(judge(p, {}, climb_bits_cap)); };
  static constexpr ClimbGoal turns[] = {{undecided, by_decide}, {bound, by_distance}, {steps, by_decide},
                                        {undecided, by_decide}, {bound, by_distance}, {steps, by_distance},
                                        {undecided, by_decide}, {steps, by_judge}};
  return turns[climb % std::size(turns)];
}

const Family& climbed_family() {
  static constexpr Family family{climbed_name, "changed again and again to the worst for our own calls",
                                 climbed};
  return family;
}

std::span<const Family> campaign_families() {
  static const std::vector<Family> all = [] {
    std::vector<Family> both(families().begin(), families().end());
    both.insert(both.end(), rounded_families().begin(), rounded_families().end());
    both.push_back(climbed_family());
    both.push_back(derived_family());
    return both;
  }();
  return all;
}

}  // namespace cyl
