// SPDX-License-Identifier: MIT
// Asks intersect(), decide() and distance() about close contacts (corpus/pairs/close_contact.hpp), 5 us a
// pair, and holds them to what their headers promise: on gaps, which are gaps by construction, and on a
// hundredth of all pairs and wherever two of them differ, by the referee. Writes what broke a promise, a pair
// a line, and the counts. Arguments: the first index, how many, the seed. Exit status 2 where a promise was
// broken, 1 where arguments are missing.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <map>
#include <string>

#include "corpus/pairs/close_contact.hpp"
#include "corpus/pairs/pair_io.hpp"
#include "oracles/referee/decide_exactly.hpp"
#include "oracles/referee/referee.hpp"
#include "solver/distance.hpp"

namespace cyl {
namespace {

constexpr double claim_margin = 1e-13;       // of the size: beyond it all three claim to be right
constexpr double built_error = 2e-15;        // of the size: a gap is built as wide as it is said to be
constexpr std::uint64_t judged_share = 100;  // one pair in so many is judged, whatever was answered
constexpr int shown_cap = 40;                // pairs written

class Counts {
 public:
  void note(const char* what, std::uint64_t count = 1) { counts_[what] += count; }
  void broken(const char* what, const Pair& pair) {
    note(what);
    if (++broken_ <= shown_cap) fmt::print("{} {}\n", what, format_pair(pair));
  }
  int print() const {
    for (const auto& [what, count] : counts_) fmt::print("{:12} {}\n", count, what);
    return broken_ == 0 ? 0 : 2;
  }

 private:
  std::map<std::string, std::uint64_t> counts_;
  std::uint64_t broken_ = 0;
};

/// Whether the solids hold a ball of `radius` in common, by the pair with a shell of that width taken off. No
/// solid as thin as two radii does.
bool common_ball(Pair pair, double radius) {
  for (Cylinder* c : {&pair.a, &pair.b}) {
    if (c->radius <= 2 * radius || c->height <= 4 * radius) return false;
    c->radius -= radius;
    c->height -= 2 * radius;
  }
  return judge_verdict(pair).verdict == Verdict::intersecting;
}

struct Answers {
  Verdict verdict;
  Answer proved;
  Distance distance;
};

void check_gap(const Pair& pair, double gap, const Answers& of, Counts& counts) {
  const double error = of.distance.error + built_error * size_of(pair);
  if (of.verdict != Verdict::disjoint) counts.broken("gaps of which intersect says intersecting", pair);
  if (of.proved.proof != Proof::direction) counts.broken("gaps that decide does not prove", pair);
  if (of.distance.verdict != Verdict::disjoint) counts.broken("gaps that distance calls intersecting", pair);
  if (!(std::abs(of.distance.value - gap) <= error + 1e-9 * gap))
    counts.broken("gaps that distance tells beyond its error", pair);
  if (of.distance.error > 1e-12 * size_of(pair)) counts.note("gaps with an error above 1e-12 of the size");
}

void check_overlap(const Pair& pair, double way_back, const Answers& of, Counts& counts) {
  if (of.proved.proof == Proof::none) {
    counts.note("overlaps that decide leaves undecided");
    if (common_ball(pair, claim_margin * size_of(pair)))
      counts.broken("overlaps left undecided that hold a ball of 1e-13 of the size", pair);
  }
  if (of.distance.value < 0 && -of.distance.value > way_back + 1e-9 * size_of(pair))
    counts.note("overlaps told deeper than a way back, by 1e-9 of the size or more");
}

void check_by_referee(const Pair& pair, const Answers& of, Counts& counts) {
  MethodAnswer witness;
  witness.status = Status::answered;
  witness.verdict = of.proved.verdict;
  witness.set_witness(certificate_of(of.proved, pair.a, pair.b));
  const Truth truth = judge_verdict(pair);
  const bool apart = truth.verdict == Verdict::disjoint;
  counts.note("judged");
  if (truth.verdict == Verdict::undecided) return counts.broken("undecided by the referee", pair);
  if (truth.verdict != Verdict::touching && judge_verdict(pair, {&witness, 1}).verdict != truth.verdict)
    counts.broken("judged otherwise with the witness", pair);
  if (of.proved.proof != Proof::none) {
    if (of.proved.verdict != (apart ? Verdict::disjoint : Verdict::intersecting))
      counts.broken("decided wrongly", pair);
    if (check_witness(pair, witness) != of.proved.verdict)
      counts.broken("decided with a wrong witness", pair);
  }
  const bool wrong = apart != (of.verdict == Verdict::disjoint), told = apart != (of.distance.value > 0);
  if (!wrong && !told) return;
  const Enclosure exact = enclose_distance(pair, truth);
  const bool beyond = std::max(exact.lo, -exact.hi) > claim_margin * size_of(pair);
  const auto count = [&](bool it, const char* within, const char* claimed) {
    if (it && !beyond) counts.note(within);
    if (it && beyond) counts.broken(claimed, pair);
  };
  count(wrong, "judged: intersect wrong within its claim", "judged: intersect wrong beyond its claim");
  count(told, "judged: distance wrong within its claim", "judged: distance wrong beyond its claim");
}

void ask(std::uint64_t seed, std::uint64_t index, Counts& counts) {
  constexpr auto kinds = enum_values<CloseKind>;
  const CloseContact contact = draw_close_contact(kinds[index % kinds.size()], seed, index / kinds.size());
  const Pair& pair = contact.pair;
  const Prepared a = prepare(pair.a), b = prepare(pair.b);
  const Answers answers{intersect(a, b), decide(a, b), distance(a, b)};
  // What is claimed of a gap is claimed beyond rounding: of its own making, too.
  const bool gap = contact.distance >= (claim_margin + 2 * built_error) * size_of(pair);
  counts.note(gap ? "gaps" : "overlaps");
  if (gap)
    check_gap(pair, contact.distance, answers, counts);
  else
    check_overlap(pair, -contact.distance, answers, counts);
  const bool apart = answers.proved.proof == Proof::direction;
  const bool differ =
      apart != (answers.distance.value > 0) ||
      (answers.proved.proof != Proof::none && apart != (answers.verdict == Verdict::disjoint));
  if (differ || index % judged_share == 0) check_by_referee(pair, answers, counts);
}

int run(int count, char** words) {
  if (count != 4) {
    fmt::print(stderr, "usage: ask_close_contacts FIRST COUNT SEED\n");
    return 1;
  }
  const auto number = [&](int i) { return std::strtoull(words[i], nullptr, 10); };
  Counts counts;
  for (std::uint64_t i = number(1); i < number(1) + number(2); ++i) ask(number(3), i, counts);
  return counts.print();
}

}  // namespace
}  // namespace cyl

int main(int count, char** words) { return cyl::run(count, words); }
