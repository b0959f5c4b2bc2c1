// SPDX-License-Identifier: MIT
// Methods whose library asks our support function, with its sums in another order: an answer that this
// changes hangs on the last bit of ours.
#pragma once

#include <memory>
#include <vector>

#include "oracles/methods/method.hpp"

namespace cyl {

/// Those of ccd_methods(), by the same names.
#ifdef DAYLIGHT_WITH_CCD
std::vector<std::unique_ptr<Method>> ccd_methods_of_other_sums();
#else
inline std::vector<std::unique_ptr<Method>> ccd_methods_of_other_sums() { return {}; }
#endif

}  // namespace cyl
