// SPDX-License-Identifier: MIT
#include <array>
#include <utility>

#include "corpus/pairs/families.hpp"
#include "corpus/pairs/near_touching.hpp"
#include "corpus/pairs/random_stream.hpp"
#include "corpus/pairs/stratum.hpp"

namespace cyl {
namespace {

constexpr std::array<std::string_view, 15> margin_names{
    "margin_1e-01", "margin_1e-02", "margin_1e-03", "margin_1e-04", "margin_1e-05",
    "margin_1e-06", "margin_1e-07", "margin_1e-08", "margin_1e-09", "margin_1e-10",
    "margin_1e-11", "margin_1e-12", "margin_1e-13", "margin_1e-14", "margin_1e-15"};
constexpr std::array general_contacts{ContactKind::side_side, ContactKind::side_rim, ContactKind::rim_rim,
                                      ContactKind::cap_rim};

// A penetration of 1e-1 would not be known by construction.
template <std::size_t i>
Pair generate_at_margin(std::uint64_t seed, std::uint64_t index) {
  RandomStream stream(margin_names[i], seed, index);
  const double sign = i > 0 && index % 2 == 1 ? -1 : 1;
  const ContactKind kind = general_contacts[index / 2 % general_contacts.size()];
  return draw_contact_at(kind, stream, sign * tenths[1 + i]).pair;
}

template <std::size_t... i>
constexpr std::array<Family, margin_names.size()> make_margin_families(std::index_sequence<i...>) {
  return {
      Family{margin_names[i], "near touching at that margin, gap and penetration", generate_at_margin<i>}...};
}

constexpr auto all_margin_families = make_margin_families(std::make_index_sequence<margin_names.size()>());

}  // namespace

std::span<const Family> margin_families() { return all_margin_families; }

}  // namespace cyl
