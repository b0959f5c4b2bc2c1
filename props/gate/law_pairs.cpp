// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <functional>
#include <string>

#include "corpus/pairs/close_contact.hpp"
#include "corpus/pairs/families.hpp"
#include "corpus/pairs/random_stream.hpp"
#include "corpus/pairs/strata.hpp"
#include "props/gate/sample.hpp"

namespace cyl {
namespace {

struct Kind {
  std::string name;
  std::function<std::optional<Pair>(std::uint64_t)> pair;  ///< by its number in the draw
};

/// Numbers n/64, |n| <= 256, which are exact in sums and products and often touch. Half of the axes have
/// coordinates -2..2, so parallel and perpendicular axes are common.
Solid grid_solid(RandomStream& s) {
  const auto vector = [&](int most, double unit) {
    Vector3 v;
    for (int i = 0; i < 3; ++i) v[i] = s.integer(-most, most) * unit;
    return v;
  };
  Solid c;
  c.center = vector(256, 1.0 / 64);
  const bool coarse = s.coin();
  do c.axis = coarse ? vector(2, 1) : vector(256, 1.0 / 64);
  while (c.axis.isZero(0));
  c.radius = s.integer(0, 256) / 64.0;
  c.height = s.integer(0, 256) / 64.0;
  return c;
}

Kind grid(RandomStream& s) {
  return {"grid", [s](std::uint64_t) mutable {
            const Solid a = grid_solid(s), b = grid_solid(s);
            return Pair{a, b};
          }};
}

/// The indices of a family take its kinds in turn. So the first index of close contacts is drawn as well.
constexpr std::uint64_t turns = 16 * close_cell_count;

Kind family(std::span<const Family> all, RandomStream& s, std::uint64_t first_cap) {
  const Family& f = all[s.below(all.size())];
  const std::uint64_t seed = s.bits(), first = seed % first_cap;
  return {fmt::format("family {}", f.name),
          [&f, seed, first](std::uint64_t i) { return f.generate(seed, first + i); }};
}

Kind stratum(RandomStream& s) {
  const auto feature = static_cast<ContactFeature>(s.below(contact_feature_count));
  const int decade = s.integer(first_decade, last_decade);
  const std::uint64_t seed = s.bits();
  return {fmt::format("stratum {} 1e-{:02}", to_string(feature), decade),
          [=](std::uint64_t i) { return draw_in_stratum(feature, decade, seed, i); }};
}

Kind close_cell(RandomStream& s) {
  const std::size_t number = s.below(close_cell_count);
  const CloseCell& cell = close_cells[number];
  const std::uint64_t seed = s.bits();
  return {fmt::format("close {} {} 1e-{:02}", to_string(cell.lie), to_string(cell.band), cell.decade),
          [=](std::uint64_t i) {
            return draw_close_contact(CloseKind::by_decade, seed, number + i * close_cell_count).pair;
          }};
}

Kind any_kind(RandomStream& s) {
  const std::size_t n = s.below(6);
  if (n == 0) return grid(s);
  return n < 3 ? family(families().first(families().size() - close_families().size()), s, 1) : stratum(s);
}

Kind close_kind(RandomStream& s) {
  return s.below(4) == 0 ? family(close_families(), s, turns) : close_cell(s);
}

Kind rounded_kind(RandomStream& s) {
  if (s.below(4) == 0) {
    const Kinds& kinds = drawn_kinds[s.below(drawn_kinds.size())];
    const std::uint64_t seed = s.bits(), first = seed % turns;
    return {fmt::format("stratum {}-{}", to_string(kinds.first), to_string(kinds.second)),
            [&kinds, seed, first](std::uint64_t i) { return draw_in_stratum(kinds, seed, first + i); }};
  }
  return family(campaign_families().subspan(families().size()), s, turns);
}

SampleRound draw_round(Kind (*draw_kind)(RandomStream&), std::uint64_t seed, std::uint64_t round) {
  SampleRound drawn;
  for (std::uint64_t d = 0; d < draws_per_round; ++d) {
    const std::uint64_t first = (round * draws_per_round + d) * pairs_per_draw;
    RandomStream stream("laws", seed, first);
    const Kind kind = draw_kind(stream);
    for (std::uint64_t i = 0; i < pairs_per_draw; ++i) {
      const std::optional<Pair> pair = kind.pair(i);
      if (!pair) continue;
      drawn.pairs.push_back(*pair);
      drawn.origins.push_back(fmt::format("{}, seed {}, index {}", kind.name, seed, first + i));
    }
  }
  return drawn;
}

}  // namespace

SampleRound draw_law_pairs(std::uint64_t seed, std::uint64_t round) {
  return draw_round(any_kind, seed, round);
}
SampleRound draw_close_law_pairs(std::uint64_t seed, std::uint64_t round) {
  return draw_round(close_kind, seed, round);
}
SampleRound draw_rounded_law_pairs(std::uint64_t seed, std::uint64_t round) {
  return draw_round(rounded_kind, seed, round);
}

}  // namespace cyl
