// SPDX-License-Identifier: MIT
// Finds the cases of corpus/cases/errata.jsonl. For each erratum that a pair can show, it simplifies pairs
// of the families that show it, in whole numbers, and takes the shortest line. Prints the lines. If no pair
// shows an erratum, it reports to standard error how many were tried. Arguments: pairs per family, and the
// id of an erratum if only one is meant.
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <span>
#include <string>
#include <vector>

#include "corpus/pairs/families.hpp"
#include "corpus/pairs/pair_io.hpp"
#include "oracles/methods/errata_test.hpp"
#include "props/shrink/simplify.hpp"

namespace cyl {
namespace {

constexpr std::uint64_t family_seed = 20170416;
constexpr int simplified_cap = 8;  ///< pairs of a family that are simplified

/// Returns 10^k for the least k <= 4 that makes all of `numbers` whole. Returns 0 if there is none.
double whole_factor(std::initializer_list<double> numbers) {
  for (const double factor : {1.0, 10.0, 100.0, 1000.0, 10000.0}) {
    bool whole = true;
    for (const double x : numbers) whole &= std::fabs(x * factor - std::round(x * factor)) < 1e-9;
    if (whole) return factor;
  }
  return 0;
}

Vector3 rounded(const Vector3& x) { return x.array().round(); }

/// Returns the pair in units in which all its numbers are whole. Each axis has its own unit.
Pair in_whole_numbers(Pair p) {
  const auto& ca = p.a.center;
  const auto& cb = p.b.center;
  const double unit = whole_factor(
      {ca.x(), ca.y(), ca.z(), cb.x(), cb.y(), cb.z(), p.a.radius, p.a.height, p.b.radius, p.b.height});
  if (unit == 0) return p;
  for (Cylinder* c : {&p.a, &p.b}) {
    const double along = whole_factor({c->axis.x(), c->axis.y(), c->axis.z()});
    if (along == 0) return p;
    *c = {rounded(c->center * unit), rounded(c->axis * along), std::round(c->radius * unit),
          std::round(c->height * unit)};
  }
  return p;
}

bool find(const Erratum& erratum, std::uint64_t pairs, double margin) {
  const ShownErratum shown(erratum);
  std::string best;
  bool best_is_whole = false;
  for (const Family& family : families()) {
    int count = 0;
    for (std::uint64_t i = 0; i < pairs && count < simplified_cap; ++i) {
      const Pair pair = family.generate(family_seed, i);
      if (!shown.on(pair, margin)) continue;
      ++count;
      Case c;
      c.pair = simplify(pair, [&](std::span<const Pair> some) {
                 std::vector<bool> fails;
                 for (const Pair& p : some) fails.push_back(shown.on(p, margin));
                 return fails;
               }).pair;
      const Pair whole = in_whole_numbers(c.pair);
      const bool is_whole = shown.on(whole, margin) && format_pair(whole).find('.') == std::string::npos;
      if (is_whole) c.pair = whole;
      c.id = "erratum-" + std::string(erratum.id);
      c.truth = judge(c.pair).verdict;
      c.source = wrong_method(erratum) + " is wrong, " + right_method(erratum) +
                 " right; found by find_errata in the family " + std::string(family.name);
      const std::string line = format_case(c);
      if (!best.empty() &&
          (best_is_whole > is_whole || (best_is_whole == is_whole && best.size() <= line.size())))
        continue;
      best = line;
      best_is_whole = is_whole;
    }
  }
  if (!best.empty()) std::puts(best.c_str());
  std::fflush(stdout);
  return !best.empty();
}

}  // namespace
}  // namespace cyl

int main(int argc, char** argv) {
  const std::uint64_t pairs = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 2000;
  for (const cyl::Erratum& erratum : cyl::errata()) {
    if (erratum.shown_by == cyl::ShownBy::none || (argc > 2 && erratum.id != argv[2])) continue;
    bool found = false;
    for (const double margin : {1e-2, 1e-6, 1e-12}) found = found || cyl::find(erratum, pairs, margin);
    if (!found)
      std::fprintf(stderr, "%s: no case in %llu pairs a family\n", std::string(erratum.id).c_str(),
                   static_cast<unsigned long long>(pairs));
  }
}
