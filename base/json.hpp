// SPDX-License-Identifier: MIT
// JSON, compiled once: whoever includes this instead of nlohmann's own header does not compile the reader and
// the writer again.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

extern template class nlohmann::basic_json<>;
extern template class nlohmann::basic_json<nlohmann::ordered_map>;

namespace cyl {

/// The value that `text` holds. Throws nlohmann::json::exception, with the place, where it is no JSON.
nlohmann::json parse_json(std::string_view text);

/// Likewise, with the keys of objects in their order.
nlohmann::ordered_json parse_ordered_json(std::string_view text);

/// Returns a value as CBOR: what one process of ours hands to another of the same build. Strings need be no
/// UTF-8.
std::string format_cbor(const nlohmann::json& value);
/// Returns what format_cbor() was given. Throws nlohmann::json::exception where the bytes are not whole.
nlohmann::json parse_cbor(std::string_view bytes);

}  // namespace cyl
