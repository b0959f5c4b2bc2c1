// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string_view>

namespace cyl {

/// Returns how many letters must be inserted, left out, changed or exchanged with their neighbour to turn one
/// word into the other. Cost: the product of the lengths.
std::size_t typing_errors(std::string_view x, std::string_view y);

}  // namespace cyl
