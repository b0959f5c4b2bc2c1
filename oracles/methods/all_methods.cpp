// SPDX-License-Identifier: MIT
// This is apart from method.cpp, so that a program may hold methods without linking every library.
#include <initializer_list>
#include <iterator>
#include <utility>

#include "oracles/methods/method.hpp"

namespace cyl {

namespace {

using Make = std::vector<std::unique_ptr<Method>>();

std::vector<std::unique_ptr<Method>> together(std::initializer_list<Make*> makers) {
  std::vector<std::unique_ptr<Method>> methods;
  for (Make* make : makers) {
    auto more = make();
    std::move(more.begin(), more.end(), std::back_inserter(methods));
  }
  return methods;
}

}  // namespace

std::vector<std::unique_ptr<Method>> all_methods() {
  return together({
      own_methods,
      literature_2008_methods,
      literature_2017_methods,
      nlopt_methods,
#ifdef DAYLIGHT_WITH_FCL
      fcl_methods,
#endif
#ifdef DAYLIGHT_WITH_BULLET
      bullet_methods,
#endif
#ifdef DAYLIGHT_WITH_CCD
      ccd_methods,
#endif
#ifdef DAYLIGHT_WITH_ODE
      ode_methods,
#endif
#ifdef DAYLIGHT_WITH_MUJOCO
      mujoco_methods,
#endif
  });
}

std::vector<std::unique_ptr<Method>> setting_methods() {
  return together({
      nlopt_settings,
#ifdef DAYLIGHT_WITH_FCL
      fcl_settings,
#endif
#ifdef DAYLIGHT_WITH_BULLET
      bullet_settings,
#endif
#ifdef DAYLIGHT_WITH_CCD
      ccd_settings,
#endif
#ifdef DAYLIGHT_WITH_MUJOCO
      mujoco_settings,
#endif
  });
}

#ifndef DAYLIGHT_WITH_CCD
std::vector<std::unique_ptr<Method>> ccd_methods_of_other_sums() { return {}; }
#endif

}  // namespace cyl
