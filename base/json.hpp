// SPDX-License-Identifier: MIT
// JSON, compiled once: whoever includes this instead of nlohmann's own header does not compile the reader and
// the writer again.
#pragma once

#include <nlohmann/json.hpp>
#include <string_view>

extern template class nlohmann::basic_json<>;
extern template class nlohmann::basic_json<nlohmann::ordered_map>;

namespace cyl {

/// The value that `text` holds. Throws nlohmann::json::exception, with the place, where it is no JSON.
nlohmann::json parse_json(std::string_view text);

/// Likewise, with the keys of objects in their order.
nlohmann::ordered_json parse_ordered_json(std::string_view text);

}  // namespace cyl
