// SPDX-License-Identifier: MIT
// Finds the cases of corpus/cases/errata.jsonl: for each fault the first pair of the families that the mended
// method answers right and the method with that fault alone wrong, by certificate; simplified.
// Writes the lines to standard output, and for a fault that no pair shows how many were tried, to standard
// error. Arguments: pairs a family, and the erratum's id where only one is meant.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "corpus/pairs/families.hpp"
#include "corpus/pairs/pair_io.hpp"
#include "oracles/methods/literature_2008_errata_test.hpp"
#include "oracles/referee/referee.hpp"
#include "props/shrink/simplify.hpp"

namespace cyl {
namespace {

constexpr std::uint64_t family_seed = 2008;

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

void find(const Erratum& erratum, std::uint64_t pairs) {
  for (const double margin : {1e-2, 1e-6, 0.0}) {
    for (const Family& family : families()) {
      for (std::uint64_t index = 0; index < pairs; ++index) {
        Case found{
            .pair = family.generate(family_seed, index), .id = {}, .source = {}, .truth = {}, .note = {}};
        if (!shown(erratum, found.pair, margin)) continue;
        found.pair = simplify(found.pair, [&](std::span<const Pair> pairs) {
                       std::vector<bool> fails;
                       for (const Pair& p : pairs) fails.push_back(shown(erratum, p, margin).has_value());
                       return fails;
                     }).pair;
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
