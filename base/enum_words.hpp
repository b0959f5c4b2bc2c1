// SPDX-License-Identifier: MIT
// The words of an enum, from one table beside it that is read in both directions:
//
//   enum class Stage : unsigned char { filter, wide, exact };
//   constexpr auto words_of(Stage) { return std::array{"filter", "wide", "exact"}; }
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <type_traits>

namespace cyl {

/// An enum with a table of words, whose values are 0, 1, .. in the order of the table.
template <typename E>
concept Worded = std::is_enum_v<E> && requires {
  words_of(E{});
};

template <Worded E>
inline constexpr auto enum_words = words_of(E{});

/// All values, in their order.
template <Worded E>
inline constexpr auto enum_values = [] {
  std::array<E, enum_words<E>.size()> values{};
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<E>(i);
  return values;
}();

/// Returns the word of a value, or the last word for a number that is not a value.
template <Worded E>
constexpr const char* to_string(E value) noexcept {
  return enum_words<E>[std::min(static_cast<std::size_t>(value), enum_words<E>.size() - 1)];
}

/// Returns the value that has this word, or nothing.
template <Worded E>
constexpr std::optional<E> from_word(std::string_view word) noexcept {
  for (const E value : enum_values<E>)
    if (word == to_string(value)) return value;
  return {};
}

}  // namespace cyl
