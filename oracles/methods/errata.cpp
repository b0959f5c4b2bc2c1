// SPDX-License-Identifier: MIT
#include "oracles/methods/errata.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace cyl {
namespace {

using literature::Fault;

constexpr Erratum table[] = {
    {"2017-coincident-centers", Fault::coincident_centers},
    {"2017-mixed-strictness", Fault::mixed_strictness},
    {"2017-strictly-convex", Fault::kink_taken_for_convex},
    {"2017-first-quarter", Fault::first_quarter_ends_all},
    {"2017-vanished-root", Fault::division_by_vanished_root},
    {"2017-cancelling-sine", Fault::cancelling_sine},
    {"2017-one-octant", Fault::one_octant},
    {"2017-cancelling-root", Fault::cancelling_root},
    {"2017-kinks", Fault::kinks_taken_for_smooth},
    {"2017-boundary", Fault::stays_on_the_boundary},
    {"2008-radius", Fault::radius_not_squared},
    {"2008-parallel-distance", Fault::cancelling_distance},
    {"2008-derivative", Fault::derivative_of_the_wrong_term},
    {"2008-tangent-line", Fault::tangent_line_misses_u0},
    {"2008-negated-pair", Fault::negated_pair_ignored},
    {"2008-sign-of-p0", Fault::sign_of_p0},
    {"2008-b-squared", Fault::wrong_b_squared},
    {"2008-equal-eigenvalues", Fault::equal_eigenvalues},
    {"book-sign-of-p0", Fault::sign_of_p0},
    {"book-b-squared", Fault::wrong_b_squared},
    {"book-equal-eigenvalues", Fault::equal_eigenvalues},
};

}  // namespace

std::span<const Erratum> errata() { return table; }

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
