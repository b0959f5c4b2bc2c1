// SPDX-License-Identifier: MIT
// For tests that ask the referee or the solver about many pairs, with other formulas than theirs.
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "corpus/pairs/close_contact.hpp"
#include "corpus/pairs/families.hpp"
#include "corpus/pairs/pair_io.hpp"
#include "corpus/pairs/strata.hpp"

namespace cyl {

/// A seed for tests, which no count depends on.
inline constexpr std::uint64_t drawing_seed = 2;

/// Steps are counted over pairs that are always the same: from seed to seed their mean changes by some
/// hundredths, which would hide what costs less than that. The counts are whole numbers and the same on every
/// machine; the room is for the logarithms in their means.
inline constexpr std::uint64_t counting_seed = 1;
inline constexpr double step_tolerance = 1.00005;

template <class T>
auto shown(const T& x) {
  return fmt::format("{}", x);
}
inline std::string shown(const Pair& pair) { return format_pair(pair); }

/// Fails the test with the details of the first of each kind that does not hold.
template <class... Details>
void check_that(bool holds, const char* what, const Details&... details) {
  static std::set<std::string_view> failed;
  if (holds || !failed.insert(what).second) return;
  std::string message = what;
  ((message += " " + shown(details)), ...);
  ADD_FAILURE() << message;
}

struct PairsOfKind {
  std::string_view name;
  std::vector<Pair> pairs;
};

/// Returns pairs of every family, of every stratum, and close contacts of every cell. A pure function of the
/// seed.
inline std::vector<PairsOfKind> draw_pairs(std::uint64_t seed) {
  constexpr std::uint64_t of_family = 600, of_stratum = 200, close_rounds = 60;
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
