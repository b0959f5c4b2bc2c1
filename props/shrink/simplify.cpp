// SPDX-License-Identifier: MIT
#include "props/shrink/simplify.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <set>

#include "corpus/pairs/pair_numbers.hpp"
#include "oracles/referee/referee.hpp"
#include "props/shrink/moves.hpp"

namespace cyl {
namespace {

using namespace moves;

/// Pairs in one call. They are many, so that a fork costs little, and few, so that few are asked in vain.
constexpr std::size_t batch_cap = 32;

using Bits = std::array<std::uint64_t, 2 * solid_number_count>;

/// Returns which lengths of a solid are 0: bit 0 the radius, bit 1 the height. A box has as many bits set as
/// edges that are 0.
unsigned zeros(const Solid& c) {
  if (is_box(c)) return (1u << std::ranges::count(c.edges, 0.0)) - 1;
  return (c.radius == 0 ? 1u : 0u) | (c.height == 0 ? 2u : 0u);
}

/// Returns whether a pair has a radius, height or edge of 0 that the pair as found has not, in either order
/// of the solids. Solids without a length are special cases of many libraries, with faults of their own.
bool has_new_zeros(const Pair& p, const Pair& found) {
  const unsigned a = zeros(p.a), b = zeros(p.b), of_a = zeros(found.a), of_b = zeros(found.b);
  return ((a & ~of_a) | (b & ~of_b)) != 0 && ((a & ~of_b) | (b & ~of_a)) != 0;
}

/// Returns the bits of the numbers, which are equal only for the same pair.
Bits bits_of(const Pair& p) { return std::bit_cast<Bits>(numbers_of(p)); }

class Search {
 public:
  Search(const Pair& pair, const StillFails& still_fails, std::size_t cap)
      : best_(pair), still_fails_(still_fails), cap_(cap), found_(pair) {}

  Simplified run() {
    using Move = Pairs (*)(const Pair&);
    constexpr Move moves[] = {translations, shapes, axes, frames, centres, roundings, scales, equalities};
    // Goes on until a round finds nothing. Then the result depends on the pair alone, not on the way to it.
    for (bool changed = true; changed && !at_cap_;) {
      changed = false;
      for (const Move move : moves)
        while (improve([&] { return move(best_); }, true)) changed = true;
      // Roundings, lengths and centres come before axes. Scenes of simple shapes keep failing more easily.
      constexpr std::size_t b = solid_number_count;
      constexpr std::array<std::size_t, 2 * b> order{
          8,     8 + b, 6, 7, 9, 10, 11, 6 + b, 7 + b, 9 + b, 10 + b, 11 + b, 0,      1,      2,      b,
          1 + b, 2 + b, 3, 4, 5, 12, 13, 14,    15,    3 + b, 4 + b,  5 + b,  12 + b, 13 + b, 14 + b, 15 + b};
      for (const std::size_t which : order)
        while (improve([&] { return one_number(best_, which); }, true)) changed = true;
      while (improve([&] { return symmetries(best_); }, false)) changed = true;
    }
    return {best_, questions_, at_cap_};
  }

 private:
  // Takes the simplest failing pair. If none fails and the pair is near touching, takes it from these pairs
  // at its distance.
  template <class Make>
  bool improve(Make make, bool may_keep_distance) {
    const Pairs pairs = make();
    if (ask(pairs)) return true;
    if (!may_keep_distance) return false;
    const double kept = approximate_distance(best_).value;
    if (kept == 0 || !(std::fabs(kept) < near_margin * size_of(best_))) return false;
    Pairs at_distance;
    for (const Pair& p : pairs) add_at_distance(p, kept, at_distance);
    return ask(at_distance);
  }

  bool ask(const Pairs& pairs) {
    struct Ranked {
      Complexity complexity;
      Pair pair;
    };
    const Complexity now = complexity(best_);
    std::vector<Ranked> ranked;
    for (const Pair& p : pairs) {
      if (!is_legal(p) || has_new_zeros(p, found_)) continue;
      const Complexity c = complexity(p);
      if (c < now && asked_.insert(bits_of(p)).second) ranked.push_back({c, p});
    }
    std::ranges::sort(ranked, [](const Ranked& x, const Ranked& y) { return x.complexity < y.complexity; });
    for (std::size_t first = 0; first < ranked.size(); first += batch_cap) {
      const std::size_t left = cap_ - questions_, wanted = std::min(batch_cap, ranked.size() - first);
      const std::size_t count = std::min(wanted, left);
      at_cap_ |= count < wanted;
      if (count == 0) return false;
      Pairs batch;
      for (std::size_t i = 0; i < count; ++i) batch.push_back(ranked[first + i].pair);
      questions_ += count;
      const std::vector<bool> fails = still_fails_(batch);
      for (std::size_t i = 0; i < std::min(count, fails.size()); ++i)
        if (fails[i]) {
          best_ = batch[i];
          return true;
        }
    }
    return false;
  }

  Pair best_;
  const StillFails& still_fails_;
  std::size_t cap_, questions_ = 0;
  const Pair found_;
  bool at_cap_ = false;
  std::set<Bits> asked_;
};

}  // namespace

Simplified simplify(const Pair& pair, const StillFails& still_fails, std::size_t question_cap) {
  if (!is_legal(pair)) return {pair, 0, false};
  return Search(pair, still_fails, question_cap).run();
}

}  // namespace cyl
