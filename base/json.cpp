// SPDX-License-Identifier: MIT
#include "base/json.hpp"

#include "base/safe_text.hpp"
#include "base/usage_error.hpp"

template class nlohmann::basic_json<>;
template class nlohmann::basic_json<nlohmann::ordered_map>;

namespace cyl {

nlohmann::json parse_json(std::string_view text) { return nlohmann::json::parse(text); }

bool is_too_deep(std::string_view json) {
  int depth = 0;
  bool in_string = false;
  for (std::size_t i = 0; i < json.size() && depth <= json_depth_cap; ++i) {
    const char c = json[i];
    if (c == '"') in_string = !in_string;
    if (in_string)
      i += c == '\\';
    else
      depth += (c == '[' || c == '{') - (c == ']' || c == '}');
  }
  return depth > json_depth_cap;
}

nlohmann::json parse_foreign_json(std::string_view text) {
  if (is_too_deep(text)) throw InputError("JSON that is nested more than 100 deep");
  return nlohmann::json::parse(text, [](int, nlohmann::json::parse_event_t, nlohmann::json& value) {
    if (value.is_string()) value = escaped_controls(value.get_ref<const std::string&>());
    return true;
  });
}

nlohmann::ordered_json parse_ordered_json(std::string_view text) {
  return nlohmann::ordered_json::parse(text);
}

std::string format_cbor(const nlohmann::json& value) {
  std::string bytes;
  nlohmann::json::to_cbor(value, bytes);
  return bytes;
}

nlohmann::json parse_cbor(std::string_view bytes) { return nlohmann::json::from_cbor(bytes); }

}  // namespace cyl
