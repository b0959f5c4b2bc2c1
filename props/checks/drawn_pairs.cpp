// SPDX-License-Identifier: MIT
#include "props/checks/drawn_pairs.hpp"

#include "corpus/pairs/close_contact.hpp"
#include "corpus/pairs/families.hpp"
#include "corpus/pairs/strata.hpp"

namespace cyl {
namespace {

constexpr std::uint64_t of_family = 600, of_stratum = 200, close_rounds = 60;

}  // namespace

std::vector<PairsOfKind> draw_pairs(std::uint64_t seed) {
  std::vector<Pair> of_families, close;
  for (const Family& family : families())
    for (std::uint64_t i = 0; i < of_family; ++i) of_families.push_back(family.generate(seed, i));
  for (std::uint64_t round = 0; round < close_rounds; ++round)
    for (const CloseContact& contact : draw_close_round(seed, round)) close.push_back(contact.pair);
  return {{"families", std::move(of_families)},
          {"strata", draw_in_all_strata(of_stratum, seed)},
          {"close contacts", std::move(close)}};
}

}  // namespace cyl
