// SPDX-License-Identifier: MIT
// Proofs in words for people.
#pragma once

#include <string>

#include "corpus/pairs/certificate.hpp"

namespace cyl {

/// "A plane with normal (1, 0, 0) separates them ...", "No verdict could be proved."
std::string in_words(const Certificate& certificate);

}  // namespace cyl
