// SPDX-License-Identifier: MIT
// Proofs in words for people.
#pragma once

#include <string>

#include "corpus/pairs/certificate.hpp"
#include "corpus/pairs/method_answer.hpp"
#include "solver/cylinder.hpp"

namespace cyl {

/// "A plane with normal (1, 0, 0) separates them ...", "No verdict could be proved." A fraction that is too
/// long to read is rounded: format_certificate() has all of it.
std::string in_words(const Certificate& certificate);

/// "margin 0.2 to 0.25", "margin 0.25", "margin of more than 1000 sizes": beyond that the two are so small or
/// so far apart that the number says no more.
std::string margin_in_words(const Enclosure& margin);

/// "the direction misses by 1.1e-17 of the size": by how much the witness of an answer does not prove what it
/// is offered for; empty where that is not known (witness_miss()).
std::string miss_in_words(const Pair& pair, const MethodAnswer& answer);

}  // namespace cyl
