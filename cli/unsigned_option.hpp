// SPDX-License-Identifier: MIT
// Options that hold a whole number: digits only, read in base ten, in range. The parser's own conversion
// takes -1 for 2^64 - 1 and 010 for 8.
#pragma once

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <concepts>
#include <cstdint>
#include <limits>
#include <string>
#include <system_error>

namespace cyl {

/// Adds option `name`, which sets `value`, an integer or a std::optional of std::uint64_t. What is no whole
/// number from `least` to `most` is a usage error that says so.
template <class T>
CLI::Option* add_unsigned(CLI::App& command, const std::string& name, T& value, const std::string& help,
                          std::uint64_t least = 0,
                          std::uint64_t most = std::numeric_limits<std::uint64_t>::max()) {
  if constexpr (std::integral<T>) {
    most = std::min(most, static_cast<std::uint64_t>(std::numeric_limits<T>::max()));
  }
  const auto set = [&value, name, least, most](const std::string& text) {
    std::uint64_t n = 0;
    const char* end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(text.data(), end, n);
    if (error != std::errc() || rest != end || n < least || n > most) {
      throw CLI::ValidationError(name, "'" + text + "' is no whole number from " + std::to_string(least) +
                                           " to " + std::to_string(most));
    }
    if constexpr (std::integral<T>) {
      value = static_cast<T>(n);
    } else {
      value = n;
    }
  };
  CLI::Option* option = command.add_option_function<std::string>(name, set, help)->type_name("N");
  if constexpr (std::integral<T>) option->default_str(std::to_string(value));
  return option;
}

}  // namespace cyl
