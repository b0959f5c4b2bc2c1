// SPDX-License-Identifier: MIT
#include "oracles/methods/errata.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace cyl {
namespace {

using enum Document;

/// "seed2017", "seed2008", "seedbook".
std::string stem_of(const Erratum& erratum) {
  return "seed" + std::string(erratum.id.substr(0, erratum.id.find('-')));
}
std::string name_of(const Erratum& erratum, std::string_view way) {
  return stem_of(erratum) + std::string(way) + std::string(erratum.id.substr(erratum.id.find('-') + 1));
}

}  // namespace

std::span<const Erratum> errata() {
  static const std::vector<Erratum> all = [] {
    std::vector<Erratum> both(errata_2017().begin(), errata_2017().end());
    both.insert(both.end(), errata_2008().begin(), errata_2008().end());
    return both;
  }();
  return all;
}

std::string_view title_of(Document document) {
  switch (document) {
    case text_2017:
      return "\"Intersection of Cylinders\", D. Eberly, 16 April 2017";
    case text_2008:
      return "\"Intersection of Cylinders\", D. Eberly, 2 March 2008";
    case book:
      return "\"Geometric Tools for Computer Graphics\", P. Schneider and D. Eberly, page 656";
  }
  return "";
}

std::string_view to_string(ErratumKind kind) {
  switch (kind) {
    case ErratumKind::error:
      return "error";
    case ErratumKind::gap:
      return "gap in the argument";
    case ErratumKind::rounding:
      return "rounding";
    case ErratumKind::trap:
      return "trap";
    case ErratumKind::remark:
      return "remark";
  }
  return "";
}

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
