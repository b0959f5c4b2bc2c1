// SPDX-License-Identifier: MIT
#include "corpus/pairs/method_answer.hpp"

#include <algorithm>
#include <cstring>

namespace cyl {

void MethodAnswer::set_reason(std::string_view text) noexcept {
  const std::size_t length = std::min(text.size(), sizeof reason - 1);
  std::memcpy(reason, text.data(), length);
  std::memset(reason + length, 0, sizeof reason - length);
}

void MethodAnswer::set_direction(const Vector3& d) noexcept {
  witness = WitnessKind::direction;
  std::copy_n(d.data(), 3, head);
}

}  // namespace cyl
