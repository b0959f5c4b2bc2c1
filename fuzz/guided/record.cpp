// SPDX-License-Identifier: MIT
#include "fuzz/guided/record.hpp"

#include <array>
#include <bit>
#include <cstring>

#include "corpus/pairs/pair_numbers.hpp"

namespace cyl {

using Numbers = std::array<double, 2 * core_number_count>;
static_assert(sizeof(Numbers) == record_size);

Record encode_record(const Pair& pair) { return std::bit_cast<Record>(core_numbers_of(pair)); }

Pair decode_record(std::span<const std::uint8_t, record_size> bytes) {
  Numbers n;
  std::memcpy(n.data(), bytes.data(), record_size);
  return pair_of(n.data(), core_number_count);
}

}  // namespace cyl
