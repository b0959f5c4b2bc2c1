// SPDX-License-Identifier: MIT
#include <algorithm>
#include <utility>
#include <vector>

#include "oracles/methods/adapter.hpp"
#include "oracles/methods/method.hpp"
#include "solver/literature/separation_2008.hpp"

namespace cyl {
namespace {

using literature::CircleWay;
using literature::CriticalWay;
using literature::Options;

struct Setting {
  std::string_view name;
  CircleWay circle;
  CriticalWay critical;
  Options options;
  double relative;  ///< of the claim
};

// Claims: above the largest certain margins seen, relative to the size, on 6000 (polynomial) or 20000 pairs
// of each family. polynomial-polish: 1.6e-7, lattice_dust; real1e-6 and real1e-12: 0.065, needle_and_disk,
// where roots are nearly double and come as complex pairs; projection, arc1e-8, arc0 and seedbook: none, but
// for exact touching; arc1e-1, 1e-2: 4.5e-3 and 5.8e-5, needle_and_disk; arc1e-3, 1e-5: 1e-9 and 1e-12,
// touching_side_rim. The printed ones are held to what they would be without their faults.
constexpr Setting settings[] = {
    {"seed2008-polynomial-polish0", CircleWay::polynomial, CriticalWay::normalised, {{}, 0, 1e-3}, 1e-5},
    {"seed2008-polynomial-polish1", CircleWay::polynomial, CriticalWay::normalised, {{}, 1, 1e-3}, 1e-5},
    {"seed2008-polynomial-polish2", CircleWay::polynomial, CriticalWay::normalised, {{}, 2, 1e-3}, 1e-5},
    {"seed2008-polynomial-polish4", CircleWay::polynomial, CriticalWay::normalised, {{}, 4, 1e-3}, 1e-5},
    {"seed2008-polynomial-polish16", CircleWay::polynomial, CriticalWay::normalised, {{}, 16, 1e-3}, 1e-5},
    {"seed2008-polynomial-real1e-6", CircleWay::polynomial, CriticalWay::normalised, {{}, 16, 1e-6}, 0.2},
    {"seed2008-polynomial-real1e-12", CircleWay::polynomial, CriticalWay::normalised, {{}, 16, 1e-12}, 0.2},
    {"seed2008-projection-polish0", CircleWay::projection, CriticalWay::normalised, {{}, 0, 1e-3}, 1e-13},
    {"seed2008-projection-polish1", CircleWay::projection, CriticalWay::normalised, {{}, 1, 1e-3}, 1e-13},
    {"seed2008-projection-polish2", CircleWay::projection, CriticalWay::normalised, {{}, 2, 1e-3}, 1e-13},
    {"seed2008-projection-polish4", CircleWay::projection, CriticalWay::normalised, {{}, 4, 1e-3}, 1e-13},
    {"seed2008-projection-polish16", CircleWay::projection, CriticalWay::normalised, {{}, 16, 1e-3}, 1e-13},
    {"seed2008-minimise-arc1e-1", CircleWay::minimise, CriticalWay::normalised, {{}, 60, 1e-1}, 2e-2},
    {"seed2008-minimise-arc1e-2", CircleWay::minimise, CriticalWay::normalised, {{}, 60, 1e-2}, 1e-3},
    {"seed2008-minimise-arc1e-3", CircleWay::minimise, CriticalWay::normalised, {{}, 60, 1e-3}, 1e-6},
    {"seed2008-minimise-arc1e-5", CircleWay::minimise, CriticalWay::normalised, {{}, 60, 1e-5}, 1e-10},
    {"seed2008-minimise-arc1e-8", CircleWay::minimise, CriticalWay::normalised, {{}, 60, 1e-8}, 1e-13},
    {"seed2008-minimise-arc0", CircleWay::minimise, CriticalWay::normalised, {{}, 60, 0}, 1e-13},
    {"seed2008-printed",
     CircleWay::polynomial,
     CriticalWay::normalised,
     {literature::printed_2008, 16, 1e-3},
     1e-13},
    {"seedbook", CircleWay::minimise, CriticalWay::adjugate, {{}, 60, 0}, 1e-13},
    {"seedbook-printed",
     CircleWay::minimise,
     CriticalWay::adjugate,
     {literature::printed_book, 60, 0},
     1e-13},
};

class Literature2008 final : public Method {
 public:
  explicit Literature2008(const Setting& setting) : setting_(setting) {}
  std::string_view name() const override { return setting_.name; }
  std::string_view version() const override { return "2008-03-02"; }
  Claim claim() const override {
    return {.relative = setting_.relative,
            .source =
                "solver/literature/separation_2008.hpp: The text itself names no error. The relative part is "
                "ours, above the largest error seen.",
            .assumed = true};
  }
  bool foreign() const override { return false; }
  // Where section 7 does not decide, up to eight polynomials of degree 8 cost 30 to 100 us.
  unsigned share() const override { return setting_.circle == CircleWay::polynomial ? 16 : 1; }

  MethodAnswer answer(const Pair& pair) override {
    const literature::Separation found =
        literature::separation_2008(pair.a, pair.b, setting_.circle, setting_.critical, setting_.options);
    MethodAnswer answer;
    answer.status = Status::answered;
    answer.verdict = found.verdict;
    if (found.verdict == Verdict::disjoint) answer.set_direction(found.direction);
    return answer;
  }
  Call prepare_all(std::span<const Pair> pairs) override {
    return [solids = solids_of<Prepared>(pairs, prepare), s = setting_](std::size_t i) {
      return literature::separation_2008(solids[i].first, solids[i].second, s.circle, s.critical, s.options)
          .verdict;
    };
  }

 private:
  const Setting setting_;
};

}  // namespace

std::vector<std::unique_ptr<Method>> literature_2008_methods() {
  std::vector<std::unique_ptr<Method>> methods;
  for (const Setting& s : settings) methods.push_back(std::make_unique<Literature2008>(s));
  return methods;
}

}  // namespace cyl
