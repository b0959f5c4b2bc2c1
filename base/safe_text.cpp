// SPDX-License-Identifier: MIT
#include "base/safe_text.hpp"

#include <fmt/format.h>

#include "base/json.hpp"

namespace cyl {

std::string valid_utf8(std::string_view text) {
  using nlohmann::json;
  return parse_json(json(text).dump(-1, ' ', false, json::error_handler_t::replace)).get<std::string>();
}

std::string one_line(std::string_view text) { return escaped_controls(valid_utf8(text)); }

std::string grouped(std::uint64_t n) {
  return n < 1000 ? std::to_string(n) : fmt::format("{},{:03}", grouped(n / 1000), n % 1000);
}

std::string counted(std::uint64_t n, std::string_view thing) {
  if (n == 1) return fmt::format("1 {}", thing);
  if (thing.ends_with('y')) return fmt::format("{} {}ies", grouped(n), thing.substr(0, thing.size() - 1));
  const bool hisses = thing.ends_with('x') || thing.ends_with("sh");
  return fmt::format("{} {}{}", grouped(n), thing, hisses ? "es" : "s");
}

}  // namespace cyl
