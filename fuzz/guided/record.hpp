// SPDX-License-Identifier: MIT
// A pair as fuzzers see it: for each solid a tag of its shape and the numbers of that shape, in this
// machine's byte order. There is no header, so any bytes of the right number and with known tags are a pair,
// perhaps an invalid one.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "solver/solid.hpp"

namespace cyl {

inline constexpr std::size_t record_size = 272;  ///< bytes; no two layouts have the same size

/// Tag, center, axis, radius, height, rounding, edges, quaternion of a, then the same of b. Numbers that the
/// shape does not have are not read.
using Record = std::array<std::uint8_t, record_size>;

Record encode_record(const Pair& pair);
/// Returns nothing if the bytes are not a record, by their number or by a tag that is not known.
std::optional<Pair> decode_record(std::span<const std::uint8_t> bytes);

/// Returns the pairs of the records in a folder and its subfolders, each once, in the order of their names.
/// Leaves out pairs with a number that is not finite. Throws std::runtime_error that names the file if it is
/// not a record.
std::vector<Pair> read_corpus(const std::string& folder);

}  // namespace cyl
