// SPDX-License-Identifier: MIT
// Proofs in words.
#pragma once

#include <string>

#include "corpus/pairs/certificate.hpp"
#include "corpus/pairs/finding.hpp"
#include "corpus/pairs/method_answer.hpp"
#include "solver/solid.hpp"

namespace cyl {

/// Returns "A plane with normal (1, 0, 0) separates them ..." or "No verdict could be proved." A fraction
/// that is too long to read is rounded. format_certificate() has it in full.
std::string in_words(const Certificate& certificate);

/// Returns "margin 0.2 to 0.25", "margin 0.25" or "margin of more than 1000 sizes". A greater number would
/// add nothing.
std::string margin_in_words(const Enclosure& margin);
/// Returns "wrong_disjoint (beyond its claim, margin 0.25 to 0.5)".
std::string describe_finding(const Finding& finding);

/// Returns "the direction misses by 1.1e-17 of the size": how far the witness of an answer is from a proof.
/// Empty if that is not known (witness_miss()).
std::string miss_in_words(const Pair& pair, const MethodAnswer& answer);

}  // namespace cyl
