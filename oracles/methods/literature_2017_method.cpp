// SPDX-License-Identifier: MIT
// The text of 2017, put right by both of its minimisers at several caps, and as printed.
#include <algorithm>
#include <string>
#include <utility>

#include "oracles/methods/adapter.hpp"
#include "oracles/methods/method.hpp"
#include "solver/literature/separation_2017.hpp"

namespace cyl {
namespace {

using literature::Minimiser;

/// The steps of each search along a line, and the lines (rounds of lines) of each search in a cell.
struct Setting {
  std::string_view name;
  Minimiser minimiser;
  int cap;
  double relative;  ///< of the claim
  unsigned share;
};

// Shares: 64 steps take 25 us where nothing separates, 32 steps 12 us, and twice to five times that next to
// touching. Claims: above the largest margin at which a setting was wrong, table in
// solver/literature/errata.md.
constexpr Setting settings[] = {
    {"seed2017-cg-steps-4", Minimiser::conjugate_gradients, 4, 2e-2, 1},
    {"seed2017-cg-steps-8", Minimiser::conjugate_gradients, 8, 1e-4, 1},
    {"seed2017-cg-steps-16", Minimiser::conjugate_gradients, 16, 1e-8, 1},
    {"seed2017-cg-steps-32", Minimiser::conjugate_gradients, 32, 1e-12, 2},
    {"seed2017-cg-steps-64", Minimiser::conjugate_gradients, 64, 1e-12, 8},
    {"seed2017-powell-steps-4", Minimiser::powell, 4, 2e-2, 1},
    {"seed2017-powell-steps-8", Minimiser::powell, 8, 1e-4, 1},
    {"seed2017-powell-steps-16", Minimiser::powell, 16, 1e-8, 1},
    {"seed2017-powell-steps-32", Minimiser::powell, 32, 1e-12, 2},
    {"seed2017-powell-steps-64", Minimiser::powell, 64, 1e-12, 8},
};

class Literature2017 final : public Method {
 public:
  Literature2017(std::string_view name, Minimiser minimiser, const literature::Options& options,
                 const Claim& claim, unsigned share)
      : name_(name), minimiser_(minimiser), options_(options), claim_(claim), share_(share) {}

  std::string_view name() const override { return name_; }
  std::string_view version() const override { return DAYLIGHT_VERSION; }
  Claim claim() const override { return claim_; }
  bool foreign() const override { return false; }
  unsigned share() const override { return share_; }
  MethodAnswer answer(const Pair& pair) override {
    const literature::Separation found = separate(prepare(pair.a), prepare(pair.b));
    MethodAnswer answer;
    answer.status = Status::answered;
    answer.verdict = found.verdict;
    if (found.verdict == Verdict::disjoint) answer.set_direction(found.direction);
    return answer;
  }
  Call prepare_all(std::span<const Pair> pairs) override {
    return [this, solids = solids_of<Prepared>(pairs, prepare)](std::size_t i) {
      return separate(solids[i].first, solids[i].second).verdict;
    };
  }

 private:
  literature::Separation separate(const Prepared& a, const Prepared& b) const {
    return literature::separated_cylinders(a, b, minimiser_, options_);
  }

  const std::string_view name_;
  const Minimiser minimiser_;
  const literature::Options options_;
  const Claim claim_;
  const unsigned share_;
};

}  // namespace

std::vector<std::unique_ptr<Method>> literature_2017_methods() {
  std::vector<std::unique_ptr<Method>> methods;
  for (const Setting& s : settings) {
    literature::Options options;
    options.step_cap = options.line_cap = s.cap;
    methods.push_back(std::make_unique<Literature2017>(
        s.name, s.minimiser, options,
        Claim{.relative = s.relative,
              .source = "solver/literature/errata.md: above the largest margin at which it was wrong.",
              .assumed = true,
              .every_bit = true},
        s.share));
  }
  literature::Options printed;
  printed.faults = literature::faults_2017;
  methods.push_back(std::make_unique<Literature2017>(
      "seed2017-printed", Minimiser::conjugate_gradients, printed,
      Claim{.source =
                "Intersection of Cylinders, 2017, section 8: It returns true whenever the cylinders are "
                "separated.",
            .every_bit = true},
      1));
  return methods;
}

}  // namespace cyl
