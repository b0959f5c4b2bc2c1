// SPDX-License-Identifier: MIT
// Methods whose library calls our support function, with the sums of that function in another order. If this
// changes an answer, the answer depends on the last bit of our sums.
#pragma once

#include <memory>
#include <vector>

#include "oracles/methods/method.hpp"

namespace cyl {

/// Returns ccd_methods() with the other sums, under the same names.
#ifdef DAYLIGHT_WITH_CCD
std::vector<std::unique_ptr<Method>> ccd_methods_of_other_sums();
#else
inline std::vector<std::unique_ptr<Method>> ccd_methods_of_other_sums() { return {}; }
#endif

}  // namespace cyl
