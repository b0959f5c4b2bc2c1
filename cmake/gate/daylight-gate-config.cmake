# SPDX-License-Identifier: MIT
# find_package(daylight-gate), or FetchContent with SOURCE_SUBDIR cmake/gate. Neither builds daylight or needs its libraries.
#   daylight::plugin         the folder of plugin.h
#   daylight_add_gate(NAME name PLUGIN target | COMMAND "python3 mine.py" [CLAIM 1e-6] [PAIRS 20000, default 500000] [FOR 5m]
#                     [SEED 1] [SUPPRESSIONS known.jsonl] [ANNOTATE src/gjk.cpp:10] [AGAINST base.json])
# adds a test that runs the gate once, name.gate, and one that reads the result for each contact feature: name.side-rim ..
#   daylight_add_fuzz(NAME name PLUGIN target [FOR 1m])
# adds the test name.fuzz, which fuzzes the library. clang counts its branches, which guide the search.
# name.other has what belongs to no feature, such as a suppression that no stored case needs.
# With AGAINST, PAIRS and SEED have no effect: the gate reruns the pairs of the base.
# Skipped is a feature on which the gate decided nothing. DAYLIGHT_PROGRAM is the program: of this installation, of PATH, or
# the launcher of the source tree, which builds the program at the first test.
get_filename_component(daylight_gate_folder ${CMAKE_CURRENT_LIST_DIR} ABSOLUTE)
set(daylight_gate_folder ${daylight_gate_folder} CACHE INTERNAL "")
set(prefixes ${daylight_gate_folder}/../../.. ${daylight_gate_folder}/../../../..)
find_program(DAYLIGHT_PROGRAM daylight HINTS ${prefixes} PATH_SUFFIXES bin)
find_program(DAYLIGHT_PROGRAM daylight HINTS ${daylight_gate_folder}/../.. NO_DEFAULT_PATH)
list(TRANSFORM prefixes APPEND /share/daylight/oracles)
find_path(DAYLIGHT_PLUGIN_FOLDER plugin.h HINTS ${daylight_gate_folder}/../../oracles ${prefixes} NO_DEFAULT_PATH)
if(NOT TARGET daylight::plugin)
  add_library(daylight::plugin INTERFACE IMPORTED GLOBAL)
  set_target_properties(daylight::plugin PROPERTIES INTERFACE_INCLUDE_DIRECTORIES ${DAYLIGHT_PLUGIN_FOLDER})
endif()

function(daylight_add_gate)
  cmake_parse_arguments(it "" "NAME;PLUGIN;COMMAND;CLAIM;PAIRS;FOR;SEED;SUPPRESSIONS;ANNOTATE;AGAINST" "" ${ARGN})
  if(it_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "daylight_add_gate: unknown arguments ${it_UNPARSED_ARGUMENTS}")
  elseif(NOT it_NAME OR (it_PLUGIN AND it_COMMAND) OR NOT (it_PLUGIN OR it_COMMAND))
    message(FATAL_ERROR "daylight_add_gate: give NAME, and either PLUGIN or COMMAND")
  elseif(it_PLUGIN AND NOT TARGET "${it_PLUGIN}")
    message(FATAL_ERROR "daylight_add_gate: PLUGIN ${it_PLUGIN} is not a target")
  endif()
  set(json ${CMAKE_CURRENT_BINARY_DIR}/${it_NAME}.gate.json)
  if(it_PLUGIN)
    set(words gate --plugin $<TARGET_FILE:${it_PLUGIN}> --json ${json})
  else()
    set(words gate --command ${it_COMMAND} --json ${json})
  endif()
  if(it_AGAINST)  # the base has them, and the gate refuses others
    unset(it_PAIRS)
    unset(it_SEED)
  endif()
  foreach(option CLAIM PAIRS FOR SEED SUPPRESSIONS ANNOTATE AGAINST)
    if(it_${option})
      string(TOLOWER ${option} name)
      list(APPEND words --${name} ${it_${option}})
    endif()
  endforeach()
  # Wrong answers are for the other tests to report.
  add_test(NAME ${it_NAME}.gate WORKING_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR}
           COMMAND ${CMAKE_COMMAND} -P ${daylight_gate_folder}/run.cmake -- ${DAYLIGHT_PROGRAM} ${words})
  set_tests_properties(${it_NAME}.gate PROPERTIES FIXTURES_SETUP ${it_NAME}.gate TIMEOUT 1500)
  foreach(feature side-side side-rim rim-rim cap-side cap-rim cap-cap containment other)
    add_test(NAME ${it_NAME}.${feature}
             COMMAND ${CMAKE_COMMAND} -DJSON=${json} -DFEATURE=${feature} -P ${daylight_gate_folder}/feature.cmake)
    set_tests_properties(${it_NAME}.${feature} PROPERTIES FIXTURES_REQUIRED ${it_NAME}.gate
                         SKIP_REGULAR_EXPRESSION "not decided")
  endforeach()
endfunction()

function(daylight_add_fuzz)
  cmake_parse_arguments(it "" "NAME;PLUGIN;FOR" "" ${ARGN})
  if(it_UNPARSED_ARGUMENTS OR NOT it_NAME OR NOT TARGET "${it_PLUGIN}")
    message(FATAL_ERROR "daylight_add_fuzz: give NAME and PLUGIN, which is a target; unknown: ${it_UNPARSED_ARGUMENTS}")
  elseif(NOT it_FOR)
    set(it_FOR 1m)
  endif()
  if(CMAKE_CXX_COMPILER_ID MATCHES Clang)
    target_compile_options(${it_PLUGIN} PRIVATE -fsanitize=fuzzer-no-link)
  endif()
  # The next run in the same folder begins with the corpus of this one.
  add_test(NAME ${it_NAME}.fuzz WORKING_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}
           COMMAND ${DAYLIGHT_PROGRAM} fuzz --plugin $<TARGET_FILE:${it_PLUGIN}> --for ${it_FOR})
  set_tests_properties(${it_NAME}.fuzz PROPERTIES TIMEOUT 86400)
endfunction()
