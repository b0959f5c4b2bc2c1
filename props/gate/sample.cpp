// SPDX-License-Identifier: MIT
#include "props/gate/sample.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "corpus/pairs/families.hpp"
#include "corpus/pairs/pair_numbers.hpp"
#include "oracles/trial/compare.hpp"

namespace cyl {
namespace {

/// A pair under all laws takes as long as this many of the sample. Both phases are to take equally long.
constexpr std::uint64_t law_cost = 50;
/// A relative allowance, so that a computed 10^-13 and a claim that is rounded up still count as 1e-13.
constexpr double claim_rounding_error = 0x1p-48;

/// Returns whether every pair of this size and decade of margin is beyond the claim.
bool claims(const Claim& claim, double size, int decade) {
  return std::pow(10.0, -decade - 1) * size * (1 + claim_rounding_error) >= reach(claim, size);
}

bool is_beyond_cylinders(const Pair& pair) { return number_of_kinds(pair) < drawn_kinds.size(); }

/// Counts a drawn pair. Its cell is claimed as long as all pairs drawn so far are.
void count_drawn(auto& cell, bool claimed) { cell.claimed = (cell.drawn++ == 0 || cell.claimed) && claimed; }

/// Counts pair `p` as undecided if its answer is. Returns whether the pair is a trial, with an answer and a
/// truth.
bool is_trial(const RoundAnswers& said, std::size_t p, std::uint64_t& undecided) {
  const MethodAnswer& answer = said.answers[p];
  if (answer.status != Status::answered) return false;
  const bool silent = answer.verdict == Verdict::undecided;
  undecided += silent;
  return !silent && said.truths[p] != Verdict::undecided;
}

}  // namespace

std::vector<GateCell> empty_cells() {
  std::vector<GateCell> cells;
  for (const Stratum& stratum : drawn_strata) cells.push_back({stratum});
  return cells;
}

std::vector<CloseGateCell> empty_close_cells() {
  std::vector<CloseGateCell> cells;
  for (const CloseCell& cell : close_cells) cells.push_back({cell});
  return cells;
}

SampleRound draw_strata(std::uint64_t seed, std::uint64_t round) {
  SampleRound drawn;
  for (const Stratum& stratum : drawn_strata) {
    for (std::uint64_t i = 0; i < pairs_per_stratum; ++i) {
      const std::uint64_t index = round * pairs_per_stratum + i;
      const auto pair = draw_in_stratum(stratum.feature, stratum.decade, seed, index);
      if (!pair) continue;
      drawn.pairs.push_back(*pair);
      drawn.strata.push_back(stratum);
      drawn.origins.push_back(fmt::format("{} 1e-{:02}, seed {}, index {}", to_string(stratum.feature),
                                          stratum.decade, seed, index));
    }
  }
  return drawn;
}

SampleRound draw_close_contacts(std::uint64_t seed, std::uint64_t round) {
  SampleRound drawn;
  drawn.contacts = draw_close_round(seed, round);
  for (const CloseContact& c : drawn.contacts) {
    drawn.origins.push_back(fmt::format("{} {} 1e-{:02} {}, seed {}, round {}, number {}",
                                        to_string(c.cell.lie), to_string(c.cell.band), c.cell.decade,
                                        to_string(c.feature), seed, round, drawn.pairs.size()));
    drawn.pairs.push_back(c.pair);
    drawn.strata.push_back({c.feature, c.cell.decade});
  }
  return drawn;
}

/// The radius becomes the rounding, so that sides keep their distance, and so do nearly parallel axes.
static Solid as_capsule(Solid c) {
  c.rounding = c.radius;
  c.radius = 0;
  return c;
}

SampleRound draw_rounded_solids(std::uint64_t seed, std::uint64_t round) {
  SampleRound drawn;
  for (const Family& family : campaign_families().subspan(families().size())) {  // half-spaces too
    for (std::uint64_t i = 0; i < pairs_per_kinds; ++i) {
      const std::uint64_t index = round * pairs_per_kinds + i;
      drawn.pairs.push_back(family.generate(seed, index));
      drawn.origins.push_back(fmt::format("{}, seed {}, index {}", family.name, seed, index));
    }
  }
  for (const Kinds& kinds : drawn_kinds) {
    for (std::uint64_t i = 0; i < pairs_per_kinds; ++i) {
      const std::uint64_t index = round * pairs_per_kinds + i;
      drawn.pairs.push_back(draw_in_stratum(kinds, seed, index));
      drawn.origins.push_back(fmt::format("stratum {}-{}, seed {}, index {}", to_string(kinds.first),
                                          to_string(kinds.second), seed, index));
    }
  }
  SampleRound close = draw_close_contacts(seed, round);
  for (std::size_t p = 0; p < close.pairs.size(); ++p) {
    drawn.pairs.push_back({as_capsule(close.pairs[p].a), as_capsule(close.pairs[p].b)});
    drawn.origins.push_back("as capsules: " + close.origins[p]);
  }
  return drawn;
}

DrawnSolids solids_of(std::span<const std::unique_ptr<Method>> methods) {
  DrawnSolids solids{.cylinders = false};
  for (const auto& method : methods) {
    solids.cylinders = solids.cylinders || method->supports(SolidKind::cylinder);
    if (method->sizes()) solids.sizes = common_range(solids.sizes, *method->sizes());
  }
  const auto some_guest_supports = [&](const Pair& pair) {
    return is_beyond_cylinders(pair) && std::ranges::any_of(methods, [&](const auto& method) {
             return method->guest() && method->supports_kinds(pair);
           });
  };
  solids.rounded =
      static_cast<std::uint64_t>(std::ranges::count_if(draw_rounded_solids(0, 0).pairs, some_guest_supports));
  return solids;
}

GateAmount amount_of(std::uint64_t pairs, const DrawnSolids& solids) {
  constexpr std::uint64_t law_round = draws_per_round * pairs_per_draw;
  constexpr std::uint64_t sample_round = pairs_per_stratum * drawn_strata.size();
  const auto rounds = [](std::uint64_t amount, std::uint64_t round) {
    return std::max<std::uint64_t>(1, (amount + round - 1) / round);
  };
  const std::uint64_t parts = std::max<std::uint64_t>(1, (solids.cylinders ? 2 : 0) + (solids.rounded > 0));
  const std::uint64_t under_laws = pairs / (1 + law_cost) / parts,
                      sampled = (pairs - parts * under_laws) / parts;
  GateAmount amount;
  if (solids.cylinders) {
    amount.law_rounds = amount.close_law_rounds = rounds(under_laws, law_round);
    amount.sample_rounds = rounds(sampled, sample_round);
    amount.close_rounds = rounds(sampled, close_round);
  }
  if (solids.rounded > 0) {
    // Only the drawn pairs that a method supports are asked.
    const std::uint64_t all =
        pairs_per_kinds * (campaign_families().size() - families().size() + drawn_kinds.size()) + close_round;
    amount.rounded_law_rounds = rounds(under_laws * all / solids.rounded, law_round);
    amount.rounded_rounds = rounds(sampled, solids.rounded);
  }
  return amount;
}

void keep_supported(SampleRound& round, std::span<const std::unique_ptr<Method>> methods,
                    const SizeRange& sizes) {
  SampleRound kept;
  for (std::size_t p = 0; p < round.pairs.size(); ++p) {
    const auto pair = fitted(round.pairs[p], sizes);
    if (!pair || std::ranges::none_of(methods, [&](const auto& m) { return m->supports(*pair); })) continue;
    kept.pairs.push_back(*pair);
    kept.origins.push_back(std::move(round.origins[p]));
    if (!round.strata.empty()) kept.strata.push_back(round.strata[p]);
    if (!round.contacts.empty()) kept.contacts.push_back(round.contacts[p]);
  }
  round = std::move(kept);
}

void count_cells(GateMethod& method, const SampleRound& round, const RoundAnswers& said) {
  for (std::size_t p = 0; p < round.pairs.size(); ++p) {
    const double size = size_of(round.pairs[p]);
    if (round.strata.empty()) {
      const std::size_t kinds = number_of_kinds(round.pairs[p]);
      if (kinds == drawn_kinds.size()) continue;
      const bool trial = is_trial(said, p, method.rounded.undecided);
      for (VerdictCount* at : {&method.rounded, &method.by_kinds[kinds]}) {
        at->pairs += trial;
        at->wrong += said.wrong_beyond[p];
      }
    } else if (round.contacts.empty()) {
      GateCell& at = method.cells[number_of(round.strata[p])];
      count_drawn(at, claims(method.claim, size, at.stratum.decade));
      at.pairs += is_trial(said, p, at.undecided);
      at.wrong += said.wrong[p];
    } else {
      CloseGateCell& at = method.close_cells[number_of(round.contacts[p].cell)];
      const bool gap = round.contacts[p].distance > 0;
      count_drawn(at, claims(method.claim, size, at.cell.decade));
      (gap ? at.gaps : at.overlaps) += is_trial(said, p, at.undecided);
      (gap ? at.wrong_gaps : at.wrong_overlaps) += said.wrong_beyond[p];
    }
  }
}

}  // namespace cyl
