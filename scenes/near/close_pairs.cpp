// SPDX-License-Identifier: MIT
#include "scenes/near/close_pairs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/stopwatch.hpp"
#include "base/usage_error.hpp"
#include "oracles/referee/decide_exactly.hpp"
#include "oracles/referee/referee.hpp"
#include "scenes/near/broad_phase.hpp"
#include "solver/decide.hpp"

namespace cyl {
namespace {

/// Returns the sum, or a double beside it on the given side if the sum is not a double.
double sum_towards(double x, double y, double side) {
  const double sum = x + y, of_y = sum - x;
  const double lost = (x - (sum - of_y)) + (y - of_y);  // exactly (Knuth)
  return lost == 0 ? sum : std::nextafter(sum, side);
}

/// Rounds one solid by the clearance more, so that the pair meets if it is within the clearance. A sum that
/// is not a double is rounded to the side on which a certificate proves less.
Pair wider_by(const Pair& pair, double clearance, bool said_within) {
  Pair wider = pair;
  double& grown = pair.a.rounding == 0 ? wider.a.rounding : wider.b.rounding;
  grown = sum_towards(grown, clearance, said_within ? 0 : std::numeric_limits<double>::infinity());
  return wider;
}

}  // namespace

ClosePairs find_close_pairs(std::span<const Solid> cylinders, double clearance) {
  ClosePairs s;
  s.bodies = cylinders.size();
  double began = processor_ns();
  std::vector<ProxyModels> models;
  std::vector<Box> boxes;
  models.reserve(cylinders.size());
  boxes.reserve(cylinders.size());
  for (const Solid& c : cylinders) {
    models.push_back(make_models(c));
    boxes.push_back(box_around(models.back().solid, clearance));
  }
  s.prepare_ms = 1e-6 * (processor_ns() - began);
  began = processor_ns();
  const std::size_t most = std::max(candidates_cap, 2 * cylinders.size());
  s.candidates = near_pairs(boxes, most);
  if (s.candidates.size() > most)
    throw InputError(fmt::format(
        "the boxes of more than {} pairs meet: remove solids that lie in the same place, or give a "
        "smaller --clearance",
        most));
  s.tree_ms = 1e-6 * (processor_ns() - began);
  began = processor_ns();
  for (const PairOfBodies& pair : s.candidates) {
    Proximity seen = Proximity::unclear;
    for (const Level level : crowd_levels) {
      seen = proximity(level, models[pair.first], models[pair.second], clearance);
      if (seen == Proximity::unclear) continue;
      ++s.decided[index_of(level)];
      break;
    }
    if (seen == Proximity::apart) continue;
    s.undecided += seen == Proximity::unclear;
    s.within.push_back(pair);
  }
  s.cascade_ms = 1e-6 * (processor_ns() - began);
  std::sort(s.within.begin(), s.within.end());
  return s;
}

void CertificateCheck::add(const Pair& pair, double clearance, bool said_within) {
  const Answer answer = decide_within(prepare(pair.a), prepare(pair.b), clearance);
  if (answer.proof == Proof::none) {
    ++undecided;
    return;
  }
  ++checked;
  MethodAnswer witness;
  witness.status = Status::answered;
  witness.verdict = answer.verdict;
  witness.set_witness(certificate_of(answer, pair.a, pair.b));
  const Verdict said = said_within ? Verdict::intersecting : Verdict::disjoint;
  failed += check_witness(wider_by(pair, clearance, said_within), witness) != said;
}

ClosePairsCheck check_close_pairs(std::span<const Solid> cylinders, double clearance,
                                  const ClosePairs& answered) {
  ClosePairsCheck check;
  const auto of_each = [&](auto add) {
    const double began = processor_ns();
    for (const PairOfBodies& pair : answered.candidates)
      add(Pair{cylinders[pair.first], cylinders[pair.second]},
          std::ranges::binary_search(answered.within, pair));
    return 1e-6 * (processor_ns() - began);
  };
  check.referee_ms =
      of_each([&](const Pair& pair, bool said) { check.referee.add(pair, clearance, 0, said); });
  check.certificates_ms =
      of_each([&](const Pair& pair, bool said) { check.certificates.add(pair, clearance, said); });
  return check;
}

}  // namespace cyl
