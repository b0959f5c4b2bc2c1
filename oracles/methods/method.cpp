// SPDX-License-Identifier: MIT
#include "oracles/methods/method.hpp"

#include <set>
#include <utility>

#include "base/usage_error.hpp"

namespace cyl {

std::vector<std::size_t> select_names(const std::vector<std::string>& names, std::string_view spec) {
  const bool all_but = spec.starts_with('-');
  if (all_but) spec.remove_prefix(1);

  std::vector<bool> named(names.size());
  while (true) {
    const std::string item(spec.substr(0, spec.find(',')));
    bool known = false;
    // A family and its kin share words: `margin` stands for margin_1e-01 and all others.
    for (const char next : {'-', '_'}) {
      for (std::size_t i = 0; i < names.size() && !item.empty(); ++i)
        if (names[i] == item || names[i].starts_with(item + next)) named[i] = known = true;
      if (known) break;
    }
    if (!known) {
      // Settings of one method have its name before the first dash.
      std::string message = "unknown name '" + item + "'; known are";
      std::set<std::string> listed;
      for (const std::string& name : names)
        if (const std::string stem = name.substr(0, name.find('-')); listed.insert(stem).second)
          message += ' ' + stem;
      throw UsageError(message);
    }
    if (item.size() == spec.size()) break;
    spec.remove_prefix(item.size() + 1);
  }

  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < names.size(); ++i)
    if (named[i] != all_but) kept.push_back(i);
  return kept;
}

std::vector<std::unique_ptr<Method>> select_methods(std::vector<std::unique_ptr<Method>> methods,
                                                    std::string_view spec) {
  std::vector<std::string> names;
  for (const auto& method : methods) names.emplace_back(method->name());
  std::vector<std::unique_ptr<Method>> kept;
  for (std::size_t i : select_names(names, spec)) kept.push_back(std::move(methods[i]));
  return kept;
}

}  // namespace cyl
