// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace cyl {

/// Calls use(answer, method) for each method in `answers`, the parsed FindingRecord::answers; parts of
/// another form are skipped. Json: a type of nlohmann's.
template <class Json, class Use>
void for_each_answer(const Json& answers, Use use) {
  if (!answers.is_array()) return;
  for (const Json& each : answers) {
    if (!each.is_array() || each.size() != 2 || !each[0].is_object() || !each[1].is_array()) continue;
    for (const Json& method : each[1])
      if (method.is_string()) use(each[0], method.template get<std::string>());
  }
}

}  // namespace cyl
