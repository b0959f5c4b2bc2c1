# SPDX-License-Identifier: MIT
# A fuzz target is a file with LLVMFuzzerTestOneInput. Everywhere it becomes a program that replays files; with clang also
# one that searches, with all code of ours instrumented.
set(fuzz_targets core xcheck)
foreach(target ${fuzz_targets})
  add_executable(fuzz_${target} fuzz/guided/fuzz_${target}_target.cpp fuzz/guided/replay_main.cpp)
  target_link_libraries(fuzz_${target} PRIVATE daylight_fuzz_guided)
endforeach()
if(CMAKE_CXX_COMPILER_ID STREQUAL Clang)
  include(fuzz/guided/engine.cmake)
endif()
