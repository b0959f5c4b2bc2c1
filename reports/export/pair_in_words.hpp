// SPDX-License-Identifier: MIT
// A pair in words for the maintainers of a library.
#pragma once

#include <string>

#include "corpus/pairs/pair_io.hpp"

namespace cyl {

std::string triple(const Vector3& v);  ///< "(0, 1, 2.5)"

/// Returns "two spheres", "a capsule and a rounded cylinder".
std::string solids_in_words(const Pair& pair);

/// Returns the question whether they meet, with a table of their numbers.
std::string question_of(const Pair& pair);

}  // namespace cyl
