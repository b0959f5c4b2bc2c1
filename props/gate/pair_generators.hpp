// SPDX-License-Identifier: MIT
// RapidCheck generators of pairs. RapidCheck does not shrink doubles to simple ones, so pairs that it may
// shrink come from a dyadic grid. Pairs of families and strata are not shrunk here (see simplify.hpp).
#pragma once

#include <rapidcheck.h>

#include <ostream>
#include <string>
#include <vector>

#include "solver/cylinder.hpp"

namespace cyl {

/// Prints a counterexample of RapidCheck as a line of a case file.
void showValue(const Pair& pair, std::ostream& out);

/// Generates numbers n/64, |n| <= 256, which are exact in sums and products and often touch. Half of the axes
/// have coordinates -2..2, so parallel and perpendicular axes are common.
rc::Gen<Pair> grid_pair();

/// Pairs of one kind, which `from` names: "grid", "family random", "stratum side-rim 1e-09" or
/// "close near-parallel 1e-03..1e-08 1e-05".
struct PairsDrawn {
  std::string from;
  std::vector<Pair> pairs;
};
/// Generates at most `count` pairs of one kind. The kind is drawn at random: the grid, each family of version
/// 0.1.0, each stratum.
rc::Gen<PairsDrawn> pairs_of_one_kind(int count);
/// The same of close contacts: each cell, and each family since.
rc::Gen<PairsDrawn> close_pairs_of_one_kind(int count);
/// The same of rounded solids: each pair of kinds.
rc::Gen<PairsDrawn> rounded_pairs_of_one_kind(int count);
void showValue(const PairsDrawn& drawn, std::ostream& out);

}  // namespace cyl
