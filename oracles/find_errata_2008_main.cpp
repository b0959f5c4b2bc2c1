// SPDX-License-Identifier: MIT
// Finds the cases of corpus/errata.jsonl: for each fault the first pair of the families that the mended
// method answers right and the method with that fault alone wrong, by certificate; brought to few digits.
// Writes the lines to standard output, and for a fault that no pair shows how many were tried, to standard
// error. Arguments: pairs a family, and the erratum's id where only one is meant.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <string>
#include <vector>

#include "corpus/families.hpp"
#include "corpus/pair_io.hpp"
#include "oracles/referee.hpp"
#include "oracles/seed_2008_errata.hpp"
#include "solver/decide.hpp"

namespace cyl {
namespace {

constexpr std::uint64_t family_seed = 2008;
constexpr int digit_cap = 17;  ///< all that a double has

/// What the pair certainly is, where `erratum` shows on it at a distance of at least `margin` sizes.
std::optional<Verdict> shown(const Erratum& erratum, const Pair& pair, double margin) {
  if (find_defect(pair.a) != Defect::none || find_defect(pair.b) != Defect::none) return {};
  const Verdict wrong = with_fault(erratum, pair);
  if (wrong == without_fault(erratum, pair)) return {};
  const Truth truth = judge(pair);
  if (truth.verdict == Verdict::undecided) return {};
  if ((truth.verdict == Verdict::disjoint) == (wrong == Verdict::disjoint)) return {};
  const Enclosure distance = enclose_distance(pair, truth);
  if (!(std::max(distance.lo, -distance.hi) >= margin * size_of(pair))) return {};
  return truth.verdict;
}

double rounded(double x, int digits) {
  char text[40];
  std::snprintf(text, sizeof text, "%.*e", digits - 1, x);
  return std::strtod(text, nullptr);
}

/// Every number in turn to 0, to 1, to as few digits as still show the erratum; until nothing changes.
Pair shrunk(const Erratum& erratum, Pair pair, double margin) {
  for (bool changed = true; changed;) {
    changed = false;
    for (Cylinder* c : {&pair.a, &pair.b}) {
      for (double* x : {&c->center[0], &c->center[1], &c->center[2], &c->axis[0], &c->axis[1], &c->axis[2],
                        &c->radius, &c->height}) {
        const double before = *x;
        std::vector<double> tries{0, 1};
        for (int digits = 1; digits < digit_cap; ++digits) tries.push_back(rounded(before, digits));
        for (double simpler : tries) {
          *x = simpler;
          if (simpler == before || shown(erratum, pair, margin)) break;
        }
        if (*x != before && !shown(erratum, pair, margin)) *x = before;
        changed |= *x != before && format_double(*x).size() < format_double(before).size();
      }
    }
  }
  return pair;
}

void find(const Erratum& erratum, std::uint64_t pairs) {
  for (const double margin : {1e-2, 1e-6, 0.0}) {
    for (const Family& family : families()) {
      for (std::uint64_t index = 0; index < pairs; ++index) {
        Case found{
            .pair = family.generate(family_seed, index), .id = {}, .source = {}, .truth = {}, .note = {}};
        if (!shown(erratum, found.pair, margin)) continue;
        found.pair = shrunk(erratum, found.pair, margin);
        found.id = erratum.id;
        found.source = std::string("found by find_errata_2008 in the family ") + std::string(family.name) +
                       ": " + std::string(erratum.what);
        found.truth = shown(erratum, found.pair, margin);
        std::puts(format_case(found).c_str());
        std::fflush(stdout);
        return;
      }
    }
  }
  std::fprintf(stderr, "%s: no case in %zu families of %llu pairs\n", std::string(erratum.id).c_str(),
               families().size(), static_cast<unsigned long long>(pairs));
}

}  // namespace
}  // namespace cyl

int main(int argc, char** argv) {
  const std::uint64_t pairs = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 2000;
  for (const cyl::Erratum& erratum : cyl::errata_2008())
    if (argc < 3 || erratum.id == argv[2]) cyl::find(erratum, pairs);
}
