// SPDX-License-Identifier: MIT
// The text of 2017. It exists as corrected, with conjugate gradients at several caps, and literally: as
// printed, mended, and with single faults.
#include <string>
#include <utility>

#include "oracles/methods/errata.hpp"
#include "oracles/methods/literature_method.hpp"
#include "solver/literature/separation_2017.hpp"

namespace cyl {
namespace {

/// The number of steps of each search along a line, and of lines (rounds of lines) of each search in a cell.
struct Setting {
  std::string_view setting;
  int cap;
  double relative;  ///< of the claim
  unsigned share;
};

// Shares: 64 steps take 25 us if nothing separates, 32 steps take 12 us. Next to touching they take two to
// five times that. Claims lie above the largest margin at which a setting was wrong, in the table of
// solver/literature/readings.md.
constexpr Setting settings[] = {
    {"steps-4", 4, 2e-2, 1},    {"steps-8", 8, 1e-4, 1},    {"steps-16", 16, 1e-8, 1},
    {"steps-32", 32, 1e-12, 2}, {"steps-64", 64, 1e-12, 8},
};

std::unique_ptr<Method> method_of(std::string algorithm, std::string setting,
                                  const literature::Options& options, const Claim& claim, unsigned share) {
  return std::make_unique<LiteratureMethod>(
      MethodName{"seed2017", std::move(algorithm), std::move(setting)}, "2017-04-16", claim, share,
      options.literal,
      [=](const Prepared& a, const Prepared& b) { return separated_cylinders(a, b, options); });
}

/// The text defines touching solids as apart, so that answer is not one of its faults.
constexpr Claim claim_of_text{
    .relative = 1e-13,
    .source =
        "Intersection of Cylinders, 2017, sections 3.1 and 8: yes where they are separated, "
        "and what only touches counts as that. The relative part, for rounding, is ours.",
    .assumed = true};

/// The literal document, with these faults.
std::unique_ptr<Method> literal_method(std::string setting, literature::Faults faults) {
  return method_of("", std::move(setting), {.faults = faults, .literal = true, .touching_apart = true},
                   claim_of_text, faults.has(literature::Fault::one_octant) ? 1 : 8);
}

}  // namespace

std::vector<std::unique_ptr<Method>> literature_2017_methods() {
  std::vector<std::unique_ptr<Method>> methods;
  for (const Setting& s : settings) {
    literature::Options options;
    options.step_cap = options.line_cap = s.cap;
    methods.push_back(
        method_of("cg", std::string(s.setting), options,
                  {.relative = s.relative,
                   .source = "solver/literature/readings.md: above the largest margin at which it was wrong.",
                   .assumed = true,
                   .bitwise_stable = true},
                  s.share));
  }
  methods.push_back(literal_method("printed", literature::printed_2017));
  return methods;
}

std::vector<std::unique_ptr<Method>> errata_2017_methods() {
  using literature::printed_2017;
  std::vector<std::unique_ptr<Method>> methods;
  methods.push_back(literal_method("printed-octants", printed_2017.without(literature::Fault::one_octant)));
  methods.push_back(literal_method("mended", {}));
  for (const Erratum& e : errata()) {
    if (e.document() != Document::text_2017) continue;
    const std::string name(e.id.substr(e.id.find('-') + 1));
    methods.push_back(literal_method("only-" + name, e.fault));
    methods.push_back(literal_method("without-" + name, printed_2017.without(e.fault)));
  }
  return methods;
}

}  // namespace cyl
