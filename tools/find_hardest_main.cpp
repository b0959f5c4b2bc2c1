// SPDX-License-Identifier: MIT
// Finds the cases of corpus/cases/hardest.jsonl. Each has the smallest margin that is not 0 for its contact
// feature, lie of the axes and band of their small angle (corpus/pairs/close_contact.hpp). The search draws
// contacts and brings them to touch in 256 bits. Then it moves each coordinate of the second centre by up to
// `reach` units in the last place to the least margin. To first order the places are a lattice. It tries two
// coordinates and solves for the third. Prints the lines. Arguments: contacts per cell, seed.
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "corpus/pairs/close_contact.hpp"
#include "corpus/pairs/pair_io.hpp"
#include "corpus/pairs/pair_numbers.hpp"
#include "oracles/referee/multiprecision.hpp"
#include "oracles/referee/referee.hpp"
#include "oracles/referee/search.hpp"
#include "solver/distance.hpp"

namespace cyl {
namespace {

constexpr int bits = 256;
constexpr int reach = 400;  ///< units in the last place: 0.6 million places, a margin of 1e-22 or so
constexpr std::size_t looked_at = 8;  ///< places of least margin to first order, examined in 256 bits

using Direction = Vec3<MpFloat>;

/// Signed, in the unit of the pair, along the contact's normal: the gap, or the depth to first order.
struct Margin {
  double value;
  Direction normal;
  std::array<double, 3> rounded;
};

Vec3<MpFloat> lifted(const Vector3& v) { return {v.x(), v.y(), v.z()}; }
MpFloat length(const Vec3<MpFloat>& v) { return sqrt(dot(v, v)); }

MpFloat support(const Vec3<MpFloat>& axis, double radius, double height, const Vec3<MpFloat>& d) {
  const Vec3<MpFloat> unit = axis / length(axis);
  return MpFloat(radius) * length(cross(d, unit)) + MpFloat(height / 2) * abs(dot(d, unit));
}

// Uses the direction in which the referee's search in 256 bits ends. For solids that overlap, it ends in
// none. Then `near` is good enough, because f has its least there.
std::optional<Margin> margin_of(const Pair& pair, const std::optional<Direction>& near) {
  const PrecisionScope scope(bits);
  const MpFloat half(0.5);
  const Direction a = lifted(pair.a.axis), b = lifted(pair.b.axis),
                  delta = lifted(pair.b.center) - lifted(pair.a.center);
  const auto found = search<MpFloat>({a, b, delta, pair.a.radius, MpFloat(pair.a.height) * half,
                                      pair.b.radius, MpFloat(pair.b.height) * half},
                                     bits);
  const bool is_found = found.has_direction && length(found.direction) > MpFloat(0);
  if (!is_found && !near) return {};
  const Direction d = is_found ? found.direction / length(found.direction) : *near;
  const MpFloat value = dot(d, delta) - support(a, pair.a.radius, pair.a.height, d) -
                        support(b, pair.b.radius, pair.b.height, d);
  return Margin{value.to_double(), d, {d.x.to_double(), d.y.to_double(), d.z.to_double()}};
}

/// Returns the unit in the last place. Returns 0 for 0, which stays.
double last_place(double x) {
  return x == 0 ? 0 : std::nextafter(std::abs(x), std::numeric_limits<double>::infinity()) - std::abs(x);
}

/// Whether no number is as small as dust. A tiny margin that comes from such a number does not count.
bool is_plain(const Pair& pair) {
  constexpr double dust = 0x1p-80;
  const auto numbers = numbers_of(pair);
  return std::all_of(numbers.begin(), numbers.end(), [](double x) { return x == 0 || std::abs(x) >= dust; });
}

struct Place {
  long double margin;
  std::array<int, 3> steps;
};

/// Returns the places around b's centre with the least margin that is not 0, to first order.
std::vector<Place> least_places(const Pair& pair, const Margin& from) {
  std::array<long double, 3> change;
  for (int i = 0; i < 3; ++i) {
    change[static_cast<std::size_t>(i)] =
        static_cast<long double>(from.rounded[static_cast<std::size_t>(i)]) * last_place(pair.b.center[i]);
  }
  std::size_t solved = 0;  // the coordinate that changes the margin most
  for (std::size_t i = 1; i < 3; ++i)
    if (std::abs(change[i]) > std::abs(change[solved])) solved = i;
  const std::size_t first = (solved + 1) % 3, second = (solved + 2) % 3;
  std::vector<Place> places;
  if (change[solved] == 0) return places;
  const auto less = [](const Place& x, const Place& y) { return std::abs(x.margin) < std::abs(y.margin); };
  for (int i = -reach; i <= reach; ++i) {
    for (int j = -reach; j <= reach; ++j) {
      const long double rest = from.value + static_cast<long double>(i) * change[first] +
                               static_cast<long double>(j) * change[second];
      const long double k = -std::nearbyint(rest / change[solved]);
      if (!(std::abs(k) <= 4 * reach)) continue;
      Place place{rest + k * change[solved], {}};
      if (places.size() == looked_at && !less(place, places.back())) continue;
      place.steps[first] = i, place.steps[second] = j, place.steps[solved] = static_cast<int>(k);
      if (places.size() == looked_at) places.pop_back();
      places.insert(std::lower_bound(places.begin(), places.end(), place, less), place);
    }
  }
  return places;
}

struct Hardest {
  Pair pair;
  double margin;  ///< relative to the size
  Truth truth;
};

/// The least gap and the least overlap.
using Both = std::array<std::optional<Hardest>, 2>;

void keep(Both& both, const Pair& pair, const Direction& near) {
  const auto margin = margin_of(pair, near);
  if (!is_plain(pair) || !margin || margin->value == 0) return;
  auto& hardest = both[margin->value < 0];
  const double relative = std::abs(margin->value) / size_of(pair);
  if (hardest && relative >= hardest->margin) return;
  const Truth truth = judge(pair);
  const Verdict expected = margin->value > 0 ? Verdict::disjoint : Verdict::intersecting;
  if (truth.verdict == expected && truth.bits > 53) hardest = Hardest{pair, relative, truth};
}

// First moves the solids a hair apart, because the search finds the normal there. Then moves them until that
// margin is 0, as far as doubles can.
void try_around(Both& both, Pair pair) {
  constexpr double hair = 1e-14;
  const Distance d = distance(pair.a, pair.b);
  pair.b.center += (hair * size_of(pair) - d.value) * d.direction;
  std::optional<Margin> margin = margin_of(pair, {});
  for (int i = 0; i < 2 && margin; ++i) {
    for (int k = 0; k < 3; ++k)
      pair.b.center[k] -= margin->value * margin->rounded[static_cast<std::size_t>(k)];
    margin = margin_of(pair, margin->normal);
  }
  if (!margin) return;
  for (const Place& place : least_places(pair, *margin)) {
    Pair moved = pair;
    for (int i = 0; i < 3; ++i)
      moved.b.center[i] += place.steps[static_cast<std::size_t>(i)] * last_place(pair.b.center[i]);
    keep(both, moved, margin->normal);
  }
}

int run(std::uint64_t contacts, std::uint64_t seed) {
  struct Cell {
    Both both;
    std::uint64_t tried = 0;
  };
  using Key = std::tuple<ContactFeature, AxesLie, AngleBand>;
  std::map<Key, Cell> cells;
  constexpr std::uint64_t features_most = 5;
  for (std::uint64_t i = 0; i < 2 * features_most * contacts * close_cell_count; ++i) {
    if (close_cells[i % close_cell_count].decade != last_close_decade) continue;
    const CloseContact c = draw_close_contact(CloseKind::by_decade, seed, i);
    Cell& cell = cells[{c.feature, c.cell.lie, c.cell.band}];
    if (cell.tried++ < contacts) try_around(cell.both, c.pair);
  }
  for (const auto& [key, cell] : cells) {
    const auto& [feature, lie, band] = key;
    const std::string name = fmt::format("{} {} {}", to_string(feature), to_string(lie), to_string(band));
    for (const auto& hardest : cell.both) {
      if (!hardest) {
        fmt::print(stderr, "{}: none\n", name);
        continue;
      }
      Case c;
      c.pair = hardest->pair;
      c.truth = hardest->truth.verdict;
      c.id = fmt::format("hardest-{}-{}-{}-{}", to_string(feature), to_string(lie), static_cast<int>(band),
                         c.truth == Verdict::disjoint ? "gap" : "overlap");
      c.source = fmt::format("tools/find_hardest_main.cpp, seed {}", seed);
      c.note = fmt::format("small angle {}; margin {:.2g} of the size", to_string(band), hardest->margin);
      fmt::print("{}\n", format_case(c));
    }
  }
  return 0;
}

}  // namespace
}  // namespace cyl

int main(int argc, char** argv) {
  if (argc != 3) {
    fmt::print(stderr, "arguments: contacts a cell, the seed\n");
    return 1;
  }
  return cyl::run(std::strtoull(argv[1], nullptr, 10), std::strtoull(argv[2], nullptr, 10));
}
