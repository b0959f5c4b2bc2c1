// SPDX-License-Identifier: MIT
#include "props/gate/pair_generators.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <tuple>
#include <utility>

#include "corpus/pairs/close_contact.hpp"
#include "corpus/pairs/families.hpp"
#include "corpus/pairs/pair_io.hpp"
#include "corpus/pairs/strata.hpp"

namespace cyl {
namespace {

/// Generates n/64 with least <= n <= 256.
rc::Gen<double> on_grid(int least) {
  return rc::gen::map(rc::gen::inRange(least, 257), [](int n) { return n / 64.0; });
}

template <typename Coordinate>
rc::Gen<Vector3> vector_of(const rc::Gen<Coordinate>& x) {
  return rc::gen::map(rc::gen::tuple(x, x, x),
                      [](const auto& v) { return Vector3(std::get<0>(v), std::get<1>(v), std::get<2>(v)); });
}

rc::Gen<Vector3> grid_axis() {
  return rc::gen::suchThat(rc::gen::oneOf(vector_of(rc::gen::inRange(-2, 3)), vector_of(on_grid(-256))),
                           [](const Vector3& v) { return v != Vector3::Zero(); });
}

rc::Gen<Cylinder> grid_cylinder() {
  return rc::gen::map(rc::gen::tuple(vector_of(on_grid(-256)), grid_axis(), on_grid(0), on_grid(0)),
                      [](const auto& c) {
                        return Cylinder{std::get<0>(c), std::get<1>(c), std::get<2>(c), std::get<3>(c)};
                      });
}

/// Generates `count` pairs, with a name. `draw` makes them of (seed, index). RapidCheck never shrinks them.
template <class Draw>
rc::Gen<PairsDrawn> drawn(std::string from, int count, Draw draw) {
  return rc::gen::noShrink(rc::gen::map(rc::gen::arbitrary<std::uint64_t>(),
                                        [from = std::move(from), count, draw](std::uint64_t seed) {
                                          PairsDrawn result{from, {}};
                                          for (int i = 0; i < count; ++i)
                                            if (const auto pair = draw(seed, static_cast<std::uint64_t>(i)))
                                              result.pairs.push_back(*pair);
                                          return result;
                                        }));
}

/// The indices of a family take its kinds in turn. So the first index of close contacts is drawn as well.
constexpr std::uint64_t turns = 16 * close_cell_count;

/// Generates `count` pairs of one family, from its first indices or from any index.
rc::Gen<PairsDrawn> family_of(std::span<const Family> all, int count, bool from_any_index) {
  return rc::gen::mapcat(rc::gen::noShrink(rc::gen::inRange<std::size_t>(0, all.size())), [=](std::size_t i) {
    const Family& f = all[i];
    return drawn("family " + std::string(f.name), count,
                 [&f, from_any_index](std::uint64_t seed, std::uint64_t index) -> std::optional<Pair> {
                   return f.generate(seed, index + (from_any_index ? seed % turns : 0));
                 });
  });
}

}  // namespace

void showValue(const Pair& pair, std::ostream& out) { out << format_pair(pair); }

void showValue(const PairsDrawn& drawn, std::ostream& out) {
  out << drawn.from;
  for (const Pair& pair : drawn.pairs) out << '\n' << format_pair(pair);
}

rc::Gen<Pair> grid_pair() {
  return rc::gen::map(rc::gen::pair(grid_cylinder(), grid_cylinder()), [](const auto& p) {
    return Pair{p.first, p.second};
  });
}

rc::Gen<PairsDrawn> pairs_of_one_kind(int count) {
  const auto grid =
      rc::gen::map(rc::gen::container<std::vector<Pair>>(static_cast<std::size_t>(count), grid_pair()),
                   [](std::vector<Pair> pairs) {
                     return PairsDrawn{"grid", std::move(pairs)};
                   });
  const auto family = family_of(families().first(first_close_family), count, false);
  const auto stratum =
      rc::gen::mapcat(rc::gen::noShrink(rc::gen::pair(rc::gen::inRange<std::size_t>(0, contact_feature_count),
                                                      rc::gen::inRange(first_decade, last_decade + 1))),
                      [count](const std::pair<std::size_t, int>& cell) {
                        const auto feature = static_cast<ContactFeature>(cell.first);
                        const int decade = cell.second;
                        return drawn(fmt::format("stratum {} 1e-{:02}", to_string(feature), decade), count,
                                     [feature, decade](std::uint64_t seed, std::uint64_t index) {
                                       return draw_in_stratum(feature, decade, seed, index);
                                     });
                      });
  return rc::gen::weightedOneOf<PairsDrawn>({{1, grid}, {2, family}, {3, stratum}});
}

rc::Gen<PairsDrawn> close_pairs_of_one_kind(int count) {
  const auto cell = rc::gen::mapcat(
      rc::gen::noShrink(rc::gen::inRange<std::size_t>(0, close_cell_count)), [count](std::size_t i) {
        const CloseCell at = close_cells[i];
        return drawn(
            fmt::format("close {} {} 1e-{:02}", to_string(at.lie), to_string(at.band), at.decade), count,
            [i](std::uint64_t seed, std::uint64_t index) -> std::optional<Pair> {
              return draw_close_contact(CloseKind::by_decade, seed, i + index * close_cell_count).pair;
            });
      });
  // Uses the full size. At a smaller one RapidCheck draws the first cells and seeds near 0 again and again.
  return rc::gen::resize(
      rc::kNominalSize,
      rc::gen::weightedOneOf<PairsDrawn>(
          {{3, cell}, {1, family_of(families().subspan(first_close_family), count, true)}}));
}

rc::Gen<PairsDrawn> rounded_pairs_of_one_kind(int count) {
  return rc::gen::resize(rc::kNominalSize, family_of(rounded_families(), count, true));
}

}  // namespace cyl
