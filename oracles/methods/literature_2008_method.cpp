// SPDX-License-Identifier: MIT
// The text of 2008 and the page of the book. They exist as corrected, with each way of the circle, and
// literally: as printed, mended, and with single faults.
#include <string>

#include "oracles/methods/errata.hpp"
#include "oracles/methods/literature_method.hpp"
#include "solver/literature/separation_2008.hpp"

namespace cyl {
namespace {

using literature::CircleWay;
using literature::Options;

struct Setting {
  std::string_view library, algorithm, setting;
  CircleWay circle;
  int step_cap;
  double tolerance;
  double relative;  ///< of the claim
};

// Claims lie above the largest certain margins seen, relative to the size, on 6000 (polynomial) or 20000
// pairs of each family. The literal methods must be as good as exact arithmetic would make them. The margins:
//     polynomial-polish: 1.6e-7, lattice_dust. projection, seedbook: none, except for exact touching.
constexpr Setting settings[] = {
    {"seed2008", "polynomial", "polish0", CircleWay::polynomial, 0, 1e-3, 1e-5},
    {"seed2008", "polynomial", "polish4", CircleWay::polynomial, 4, 1e-3, 1e-5},
    {"seed2008", "projection", "polish0", CircleWay::projection, 0, 1e-3, 1e-13},
    {"seed2008", "projection", "polish4", CircleWay::projection, 4, 1e-3, 1e-13},
    {"seedbook", "", "", CircleWay::projection, 60, 1e-3, 1e-13},
};

/// The meaning of the settings, and the part of them that is in no document.
constexpr std::string_view source =
    "solver/literature/separation_2008.hpp: the text itself names no error; the relative part is ours, above "
    "the largest error seen. polishN: N Newton steps of a root.";

std::unique_ptr<Method> method_of(const Setting& s, bool literal = false, literature::Faults faults = {}) {
  const Options options{
      .faults = faults, .step_cap = s.step_cap, .tolerance = s.tolerance, .literal = literal};
  return std::make_unique<LiteratureMethod>(
      MethodName{std::string(s.library), std::string(s.algorithm), std::string(s.setting)}, "2008-03-02",
      Claim{.relative = s.relative, .source = source, .assumed = true},
      // If section 7 does not decide, up to four polynomials of degree 8 cost 30 to 60 us.
      s.circle == CircleWay::polynomial ? 16 : 1, literal,
      [=](const Prepared& a, const Prepared& b) { return separation_2008(a, b, s.circle, options); });
}

/// The literal document, with these faults.
std::unique_ptr<Method> literal_method(Document document, const std::string& name,
                                       literature::Faults faults) {
  if (document == Document::book)
    return method_of({"seedbook", "", name, CircleWay::projection, 60, 1e-3, 1e-13}, true, faults);
  return method_of({"seed2008", "", name, CircleWay::polynomial, 60, 1e-3, 1e-13}, true, faults);
}

}  // namespace

std::vector<std::unique_ptr<Method>> literature_2008_methods() {
  std::vector<std::unique_ptr<Method>> methods;
  for (const Setting& s : settings) methods.push_back(method_of(s));
  methods.push_back(literal_method(Document::text_2008, "printed", literature::printed_2008));
  methods.push_back(literal_method(Document::book, "printed", literature::printed_book));
  return methods;
}

std::vector<std::unique_ptr<Method>> errata_2008_methods() {
  std::vector<std::unique_ptr<Method>> methods;
  for (const Document document : {Document::text_2008, Document::book})
    methods.push_back(literal_method(document, "mended", {}));
  for (const Erratum& e : errata()) {
    if (e.document() == Document::text_2017) continue;
    const std::string name(e.id.substr(e.id.find('-') + 1));
    methods.push_back(literal_method(e.document(), "only-" + name, e.fault));
    const auto printed = e.document() == Document::book ? literature::printed_book : literature::printed_2008;
    if (printed.has(e.fault))
      methods.push_back(literal_method(e.document(), "without-" + name, printed.without(e.fault)));
  }
  return methods;
}

}  // namespace cyl
