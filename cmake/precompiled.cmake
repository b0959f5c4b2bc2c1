# SPDX-License-Identifier: MIT
# Precompiled headers: the standard library, fmt and JSON take most of the time of nearly every file above the solver.
# Two sets, compiled once each and shared: `plain`, and `tests` with the test libraries added. A source still includes all
# that it uses (CMAKE_DISABLE_PRECOMPILE_HEADERS=ON, as the preset clang has it, shows where one does not).
set(daylight_common_headers
  <algorithm> <array> <charconv> <chrono> <cmath> <cstdint> <filesystem> <fstream> <functional> <map> <memory> <optional>
  <set> <span> <sstream> <string> <string_view> <utility> <vector> <fmt/format.h> <nlohmann/json.hpp> <Eigen/Geometry>)

function(daylight_precompiled_set set)
  file(WRITE ${CMAKE_BINARY_DIR}/precompiled/${set}.cpp "")
  add_library(daylight_precompiled_${set} OBJECT ${CMAKE_BINARY_DIR}/precompiled/${set}.cpp)
  target_link_libraries(daylight_precompiled_${set} PRIVATE ${ARGN})
endfunction()

daylight_precompiled_set(plain Eigen3::Eigen nlohmann_json::nlohmann_json fmt::fmt)
target_precompile_headers(daylight_precompiled_plain PRIVATE ${daylight_common_headers})
set_target_properties(daylight_precompiled_plain PROPERTIES POSITION_INDEPENDENT_CODE ON)  # as the rooms are

function(daylight_precompiled target)
  if(NOT target STREQUAL daylight_solver)  # it sees Eigen alone
    target_link_libraries(${target} PRIVATE Eigen3::Eigen nlohmann_json::nlohmann_json fmt::fmt)
    target_precompile_headers(${target} REUSE_FROM daylight_precompiled_plain)
  endif()
endfunction()
