// SPDX-License-Identifier: MIT
#include "oracles/methods/errata.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace cyl {
namespace {

using literature::Fault;
using enum ShownBy;

constexpr Erratum table[] = {
    {"2017-coincident-centers", none, Fault::coincident_centers},
    {"2017-mixed-strictness", alone, Fault::mixed_strictness},
    {"2017-kink-of-equation-9", none},
    {"2017-equation-10", none},
    {"2017-strictly-convex", none, Fault::kink_taken_for_convex},
    {"2017-first-quarter", taken_out, Fault::first_quarter_ends_all},
    {"2017-no-return", none},
    {"2017-vanished-root", alone, Fault::division_by_vanished_root},
    {"2017-cancelling-sine", taken_out, Fault::cancelling_sine},
    {"2017-one-octant", alone, Fault::one_octant},
    {"2017-cancelling-root", taken_out, Fault::cancelling_root},
    {"2017-kinks", taken_out, Fault::kinks_taken_for_smooth},
    {"2017-boundary", alone, Fault::stays_on_the_boundary},
    {"2017-sixteenth", none},
    {"2017-slips", none},
    {"2008-wall-alone", none},
    {"2008-radius", alone, Fault::radius_not_squared},
    {"2008-parallel-distance", alone, Fault::cancelling_distance},
    {"2008-derivative", alone, Fault::derivative_of_the_wrong_term},
    {"2008-tangent-line", alone, Fault::tangent_line_misses_u0},
    {"2008-vanished-term", none},
    {"2008-disk-distance", none},
    {"2008-negated-pair", alone, Fault::negated_pair_ignored},
    {"2008-step-4", none},
    {"2008-sign-of-p0", alone, Fault::sign_of_p0},
    {"2008-b-squared", alone, Fault::wrong_b_squared},
    {"2008-equal-eigenvalues", none, Fault::equal_eigenvalues},
    {"2008-slips", none},
    {"book-sign-of-p0", alone, Fault::sign_of_p0},
    {"book-b-squared", alone, Fault::wrong_b_squared},
    {"book-equal-eigenvalues", none, Fault::equal_eigenvalues},
};

/// Returns "seed2017", "seed2008" or "seedbook".
std::string stem_of(const Erratum& erratum) {
  return "seed" + std::string(erratum.id.substr(0, erratum.id.find('-')));
}
std::string name_of(const Erratum& erratum, std::string_view way) {
  return stem_of(erratum) + std::string(way) + std::string(erratum.id.substr(erratum.id.find('-') + 1));
}

}  // namespace

std::span<const Erratum> errata() { return table; }

std::string case_of(const Erratum& erratum) { return "erratum-" + std::string(erratum.id); }

std::string wrong_method(const Erratum& erratum) {
  return erratum.shown_by == ShownBy::taken_out ? stem_of(erratum) + "-printed" : name_of(erratum, "-only-");
}

std::string right_method(const Erratum& erratum) {
  if (erratum.shown_by == ShownBy::taken_out) return name_of(erratum, "-without-");
  return stem_of(erratum) + "-mended";
}

std::vector<std::unique_ptr<Method>> errata_methods() {
  auto methods = errata_2008_methods();
  std::ranges::move(errata_2017_methods(), std::back_inserter(methods));
  return methods;
}

std::vector<std::unique_ptr<Method>> named_errata(const std::vector<std::unique_ptr<Method>>& methods,
                                                  std::string_view spec) {
  std::vector<std::unique_ptr<Method>> named;
  if (spec.starts_with('-')) return named;
  const auto names = [](std::string_view item, const std::unique_ptr<Method>& method) {
    const std::string_view name = method->name();
    return name == item || (name.starts_with(item) && name.substr(item.size()).starts_with('-'));
  };
  std::vector<std::string_view> wanted;  // names of nothing yet
  for (std::size_t begin = 0; begin < spec.size();) {
    const std::size_t end = std::min(spec.find(',', begin), spec.size());
    const std::string_view item = spec.substr(begin, end - begin);
    if (std::ranges::none_of(methods, [&](const auto& m) { return names(item, m); })) wanted.push_back(item);
    begin = end + 1;
  }
  if (wanted.empty()) return named;
  for (auto& method : errata_methods())
    if (std::ranges::any_of(wanted, [&](std::string_view item) { return names(item, method); }))
      named.push_back(std::move(method));
  return named;
}

}  // namespace cyl
