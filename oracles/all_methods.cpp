// SPDX-License-Identifier: MIT
// Apart from method.cpp, so that a program may hold methods without linking every library there is.
#include <iterator>
#include <utility>

#include "oracles/method.hpp"

namespace cyl {

std::vector<std::unique_ptr<Method>> all_methods() {
  auto methods = own_methods();
  for (auto make : {seed_2008_methods, seed_2017_methods, nlopt_methods, fcl_methods, bullet_methods,
                    ccd_methods, ode_methods, mujoco_methods}) {
    auto more = make();
    std::move(more.begin(), more.end(), std::back_inserter(methods));
  }
  return methods;
}

}  // namespace cyl
