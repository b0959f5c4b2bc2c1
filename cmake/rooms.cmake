# SPDX-License-Identifier: MIT
# A room is a folder with one idea in it. daylight_room(FOLDER ..) makes of its sources a static library,
# daylight_<folder with _>, known to others as daylight::<the same>.
#   USES       the rooms whose headers it may include; .ci/includes holds the sources to this list
#   WITH       folders below it that are part of it
#   LIBRARIES  what it links beyond the rooms
#   WITHOUT    sources left out, because a foreign library is not there
#   COLD       not worth the optimizer's time: what turns results into text
#   WHOLE      compiled as one source, which takes half the time: what these sources share is compiled once. Not of rooms
#              that faults are planted in, whose objects are exchanged one by one (cmake/planted_faults.cmake)
# Sources that end in _test, _main or _target belong to programs, not to the room.
function(daylight_target_of folder result)
  string(REPLACE / _ name ${folder})
  set(${result} daylight_${name} PARENT_SCOPE)
endfunction()

function(daylight_room folder)
  cmake_parse_arguments(it "COLD;WHOLE" "" "USES;WITH;LIBRARIES;WITHOUT" ${ARGN})
  daylight_target_of(${folder} target)
  set(patterns ${folder}/*.cpp)
  foreach(below ${it_WITH})
    list(APPEND patterns ${below}/*.cpp)
  endforeach()
  file(GLOB sources RELATIVE ${PROJECT_SOURCE_DIR} CONFIGURE_DEPENDS ${patterns})
  list(FILTER sources EXCLUDE REGEX "(_test|_main|_target)\\.cpp$")
  if(it_WITHOUT)
    list(REMOVE_ITEM sources ${it_WITHOUT})
  endif()
  set(libraries ${it_LIBRARIES})
  foreach(room ${it_USES})
    daylight_target_of(${room} used)
    list(APPEND libraries ${used})
  endforeach()
  add_library(${target} STATIC ${sources})
  target_include_directories(${target} PUBLIC ${PROJECT_SOURCE_DIR})
  target_link_libraries(${target} PUBLIC ${libraries})
  if(NOT target STREQUAL daylight_solver)
    # For shared libraries that link what is installed. The solver would be slower.
    set_target_properties(${target} PROPERTIES POSITION_INDEPENDENT_CODE ON)
    target_compile_options(${target} PRIVATE -fno-semantic-interposition)
  endif()
  if(it_COLD)
    target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
  endif()
  if(it_WHOLE AND NOT CMAKE_DISABLE_PRECOMPILE_HEADERS)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 16)
  endif()
  daylight_precompiled(${target})
  string(REPLACE daylight_ daylight:: alias ${target})
  add_library(${alias} ALIAS ${target})
  set_property(GLOBAL PROPERTY daylight_sources_${target} ${sources})
endfunction()
