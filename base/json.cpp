// SPDX-License-Identifier: MIT
#include "base/json.hpp"

#include "base/safe_text.hpp"
#include "base/usage_error.hpp"

template class nlohmann::basic_json<>;
template class nlohmann::basic_json<nlohmann::ordered_map>;

namespace cyl {

nlohmann::json parse_json(std::string_view text) { return nlohmann::json::parse(text); }

nlohmann::json parse_foreign_json(std::string_view text) {
  constexpr int depth_cap = 100;
  return nlohmann::json::parse(text, [](int depth, nlohmann::json::parse_event_t, nlohmann::json& value) {
    if (depth > depth_cap) throw InputError("JSON that is nested more than 100 deep");
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
