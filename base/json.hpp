// SPDX-License-Identifier: MIT
// JSON, compiled once. A source that includes this instead of nlohmann's own header does not compile the
// reader and the writer again.
#pragma once

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

extern template class nlohmann::basic_json<>;
extern template class nlohmann::basic_json<nlohmann::ordered_map>;

namespace cyl {

/// Returns the value of `text`. Throws nlohmann::json::exception, with the place, if it is not JSON.
nlohmann::json parse_json(std::string_view text);

/// A reader of JSON that is nested deeper may use up the stack. Ours is some 10 deep.
inline constexpr int json_depth_cap = 100;
/// Returns whether the text is nested deeper than that. Brackets in strings do not count.
bool is_too_deep(std::string_view json);

/// Does the same for a file that a stranger may have written. Escapes the control characters of its strings
/// (safe_text.hpp). Throws InputError if it is_too_deep().
nlohmann::json parse_foreign_json(std::string_view text);

/// Does the same, and keeps the order of the keys of objects.
nlohmann::ordered_json parse_ordered_json(std::string_view text);

/// Returns a number, or null if it is not finite, or an optional that is empty.
template <class Json = nlohmann::json>
Json number_or_null(auto x) {
  if constexpr (requires { *x; })
    return x ? number_or_null<Json>(*x) : Json();
  else
    return std::isfinite(x) ? Json(x) : Json();
}

/// Returns a value as CBOR, which one process of ours passes to another of the same build. Strings need not
/// be UTF-8.
std::string format_cbor(const nlohmann::json& value);
/// Returns what format_cbor() was given. Throws nlohmann::json::exception if the bytes are not complete.
nlohmann::json parse_cbor(std::string_view bytes);

}  // namespace cyl
