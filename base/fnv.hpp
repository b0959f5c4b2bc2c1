// SPDX-License-Identifier: MIT
// FNV-1a, 64 bits: a short name for a text, the same on every machine. No defence against forgery.
#pragma once

#include <cstdint>
#include <string_view>

namespace cyl {

/// `so_far`: the hash of what stands before the text.
constexpr std::uint64_t fnv1a(std::string_view text, std::uint64_t so_far = 0xcbf29ce484222325) noexcept {
  for (const char c : text) so_far = (so_far ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  return so_far;
}

}  // namespace cyl
