# SPDX-License-Identifier: MIT
# How everything of ours is compiled. Of a project that takes us in by add_subdirectory() nothing is changed.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
if(PROJECT_IS_TOP_LEVEL)
  set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
  if(NOT CMAKE_BUILD_TYPE)
    set(CMAKE_BUILD_TYPE Release)
  endif()
endif()

# Determinism: no contraction of a*b+c, whatever the machine offers. Nobody reads errno, and sqrt is one instruction then.
add_compile_options(-ffp-contract=off -fno-math-errno)
if(PROJECT_IS_TOP_LEVEL)
  add_compile_options(-Wall -Wextra -Wconversion)
  if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
    add_compile_options(-Wno-stringop-overflow -Wno-array-bounds)  # GCC 12 sees them in its own std::string
  else()
    add_compile_options(-Wno-bitwise-instead-of-logical)  # both sides on purpose: a branch costs more than a comparison
  endif()
endif()
# A law says in which line it is written: from the top of the project, however the compiler was given the file's name.
file(RELATIVE_PATH up ${CMAKE_BINARY_DIR} ${PROJECT_SOURCE_DIR})
add_compile_options(-ffile-prefix-map=${PROJECT_SOURCE_DIR}/= -ffile-prefix-map=${up}=)
