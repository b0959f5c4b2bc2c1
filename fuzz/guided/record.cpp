// SPDX-License-Identifier: MIT
#include "fuzz/guided/record.hpp"

#include <bit>
#include <cstring>

namespace cyl {

using Numbers = std::array<double, 16>;
static_assert(sizeof(Numbers) == record_size);

Record encode_record(const Pair& pair) {
  Numbers numbers;
  auto next = numbers.begin();
  for (const Cylinder* c : {&pair.a, &pair.b}) {
    for (const double x : c->center) *next++ = x;
    for (const double x : c->axis) *next++ = x;
    *next++ = c->radius;
    *next++ = c->height;
  }
  return std::bit_cast<Record>(numbers);
}

Pair decode_record(std::span<const std::uint8_t, record_size> bytes) {
  Numbers n;
  std::memcpy(n.data(), bytes.data(), record_size);
  return {{{n[0], n[1], n[2]}, {n[3], n[4], n[5]}, n[6], n[7]},
          {{n[8], n[9], n[10]}, {n[11], n[12], n[13]}, n[14], n[15]}};
}

}  // namespace cyl
