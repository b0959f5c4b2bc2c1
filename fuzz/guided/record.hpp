// SPDX-License-Identifier: MIT
// A pair as fuzzers see it: 16 doubles of this machine's byte order, no header, no rounding. Any 128 bytes
// are a pair, perhaps an invalid one.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "solver/cylinder.hpp"

namespace cyl {

inline constexpr std::size_t record_size = 128;  ///< bytes

/// a.center, a.axis, a.radius, a.height, then the same of b.
using Record = std::array<std::uint8_t, record_size>;

Record encode_record(const Pair& pair);
Pair decode_record(std::span<const std::uint8_t, record_size> bytes);

}  // namespace cyl
