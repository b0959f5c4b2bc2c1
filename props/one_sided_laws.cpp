// SPDX-License-Identifier: MIT
// Laws 10 to 19: one answer bounds another.
#include "props/law_groups.hpp"

namespace cyl {

std::vector<Law> one_sided_laws() { return {}; }

}  // namespace cyl
