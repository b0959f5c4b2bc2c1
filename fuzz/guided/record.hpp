// SPDX-License-Identifier: MIT
// A pair as fuzzers see it: 16 doubles of this machine's byte order, no header, no rounding. Any 128 bytes
// are a pair, perhaps an invalid one.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "corpus/pairs/pair_io.hpp"
#include "solver/cylinder.hpp"

namespace cyl {

inline constexpr std::size_t record_size = 128;  ///< bytes

/// a.center, a.axis, a.radius, a.height, then the same of b.
using Record = std::array<std::uint8_t, record_size>;

Record encode_record(const Pair& pair);
Pair decode_record(std::span<const std::uint8_t, record_size> bytes);

/// Returns the pairs of a folder of records, by file name, which becomes the id. Leaves out pairs with a
/// number that is not finite. Throws std::runtime_error that names a file of another size.
std::vector<Case> read_corpus(const std::string& folder);

}  // namespace cyl
