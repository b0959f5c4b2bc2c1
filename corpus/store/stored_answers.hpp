// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "base/safe_text.hpp"

namespace cyl {

/// Calls use(answer, methods) for each different answer in `answers`, the parsed FindingRecord::answers, with
/// the names of the methods that gave it; parts of another form are skipped. Json: a type of nlohmann's.
template <class Json, class Use>
void for_each_answer(const Json& answers, Use use) {
  if (!answers.is_array()) return;
  for (const Json& each : answers) {
    if (!each.is_array() || each.size() != 2 || !each[0].is_object() || !each[1].is_array()) continue;
    std::vector<std::string> methods;
    for (const Json& method : each[1])
      if (method.is_string()) methods.push_back(escaped_controls(method.template get<std::string>()));
    use(each[0], methods);
  }
}

}  // namespace cyl
