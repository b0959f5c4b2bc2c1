// SPDX-License-Identifier: MIT
// Finds the cases of corpus/cases/errata.jsonl that show faults of the text of 2017: of the first pairs of
// each family on which the text put right is right and the text with that fault alone wrong, the one that
// simplifies to the shortest line. Writes the lines to standard output, and how many pairs of each family
// show the fault (at most 6 are looked for), to standard error. Argument: pairs a family.
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "corpus/pairs/families.hpp"
#include "corpus/pairs/pair_io.hpp"
#include "oracles/methods/literature_2017_errata_test.hpp"
#include "props/shrink/simplify.hpp"

namespace cyl {
namespace {

constexpr std::uint64_t family_seed = 20170416;
constexpr int simplified_cap = 5;  ///< pairs of a family that are simplified

void find(const Fault2017& fault, std::uint64_t pairs) {
  const StillFails still_shows = [&](std::span<const Pair> some) {
    std::vector<bool> shown;
    for (const Pair& p : some) shown.push_back(shows(fault, p));
    return shown;
  };
  std::map<std::string_view, int> count;
  std::string best;
  for (const Family& family : families()) {
    for (std::uint64_t i = 0; i < pairs; ++i) {
      const Pair pair = family.generate(family_seed, i);
      if (!shows(fault, pair)) continue;
      if (++count[family.name] > simplified_cap) break;
      Case c{simplify(pair, still_shows).pair, "errata-2017-" + std::string(fault.name), {}, {}, {}};
      c.truth = judge(c.pair).verdict;
      c.source = "the text of 2017 put right is wrong with this fault " +
                 std::string(fault.beside.has(literature::Fault::stays_on_the_boundary)
                                 ? "and stays-on-the-boundary, and right with the latter alone"
                                 : "alone") +
                 "; found in family " + std::string(family.name) + ", simplified while that held";
      const std::string line = format_case(c);
      if (best.empty() || line.size() < best.size()) best = line;
    }
  }
  if (!best.empty()) std::cout << best << std::endl;
  std::cerr << fault.name;
  for (const auto& [family, n] : count) std::cerr << "  " << family << " " << n;
  std::cerr << "\n";
}

}  // namespace
}  // namespace cyl

int main(int argc, char** argv) {
  const std::uint64_t pairs = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 20000;
  for (const cyl::Fault2017& fault : cyl::faults_2017()) cyl::find(fault, pairs);
}
