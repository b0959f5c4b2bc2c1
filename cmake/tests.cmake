# SPDX-License-Identifier: MIT
# Every x_test.cpp of a top folder and the folders below it is compiled into one program, <folder>_tests; every x_test.sh is
# run with the executable as its argument.
if(NOT PROJECT_IS_TOP_LEVEL)
  return()
endif()
include(CTest)
include(GoogleTest)
find_package(GTest REQUIRED)
find_package(rapidcheck REQUIRED CONFIG)
daylight_precompiled_set(tests Eigen3::Eigen nlohmann_json::nlohmann_json fmt::fmt GTest::gtest rapidcheck rapidcheck_gtest)
target_precompile_headers(daylight_precompiled_tests PRIVATE ${daylight_common_headers}
                          <gtest/gtest.h> <rapidcheck.h> <rapidcheck/gtest.h>)
target_compile_options(daylight_precompiled_tests PRIVATE $<$<CONFIG:Release>:-O0>)

function(daylight_test_program name)
  add_executable(${name} ${ARGN})
  target_link_libraries(${name} PRIVATE GTest::gtest_main rapidcheck rapidcheck_gtest)
  target_compile_options(${name} PRIVATE $<$<CONFIG:Release>:-O0>)
  target_compile_definitions(${name} PRIVATE DAYLIGHT_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
  target_precompile_headers(${name} REUSE_FROM daylight_precompiled_tests)
endfunction()

# Suites with a test that starts processes, of any folder. The label of all others ends in _quick: ctest -L quick runs
# them, ctest -L FOLDER both.
set(process_suites Batch Bench Campaign Child Confine Contained
    Examine Export Fuzzing Gate GateJunit Guest* *SupervisedProcess* Kin
    LawSearch Mechanism Methods Misbehaving Mujoco Ode SceneJson Shards Store Triage Worker
    Worst)
list(TRANSFORM process_suites APPEND ".*")
list(JOIN process_suites ":" process_suites)

# daylight_tests(FOLDER ROOM..): tests in FOLDER and below, linked with the rooms. Fixed seeds in tests, fresh ones in
# campaigns.
function(daylight_tests folder)
  file(GLOB tests RELATIVE ${PROJECT_SOURCE_DIR} CONFIGURE_DEPENDS ${folder}/*_test.cpp ${folder}/*/*_test.cpp)
  daylight_test_program(${folder}_tests ${tests})
  add_dependencies(unit_tests ${folder}_tests)
  foreach(room ${ARGN})
    daylight_target_of(${room} library)
    target_link_libraries(${folder}_tests PRIVATE ${library})
  endforeach()
  set(always ENVIRONMENT "RC_PARAMS=seed=20261121 max_success=500" TIMEOUT 1200)
  gtest_discover_tests(${folder}_tests DISCOVERY_TIMEOUT 240 TEST_FILTER "-${process_suites}"
                       PROPERTIES LABELS ${folder}_quick ${always})
  gtest_discover_tests(${folder}_tests DISCOVERY_TIMEOUT 240 TEST_FILTER "${process_suites}"
                       TEST_LIST ${folder}_tests_of_processes PROPERTIES LABELS ${folder} ${always})
endfunction()

add_custom_target(unit_tests) # all that `./daylight test --quick` builds

daylight_tests(base base base/process)
daylight_tests(solver solver solver/literature corpus/pairs)
daylight_tests(corpus corpus/pairs corpus/store)
daylight_tests(oracles oracles/trial props/laws corpus/store)
daylight_tests(props props/laws props/gate props/shrink)
daylight_tests(bench bench reports/run)
daylight_tests(scenes scenes/read scenes/study)
target_link_libraries(scenes_tests PRIVATE ${MUJOCO_LIBRARY})
daylight_tests(fuzz fuzz/campaign fuzz/guided fuzz/worst props/shrink)
daylight_tests(reports reports/gate reports/triage reports/export reports/run reports/scene scenes/read)

# daylight_deep(FOLDER FILTER AMOUNT..): the same tests with more of what they draw: ctest -L deep.
function(daylight_deep folder filter)
  add_test(NAME ${folder}_deep COMMAND ${folder}_tests --gtest_filter=${filter})
  set_tests_properties(${folder}_deep PROPERTIES LABELS deep ENVIRONMENT "${ARGN}" TIMEOUT 2400)
endfunction()
daylight_deep(fuzz *.KilledAtAnyMoment* DAYLIGHT_KILLED_BATCHES=100)
daylight_deep(props *FamilyLaws.* DAYLIGHT_LAW_PAIRS=200)
daylight_deep(oracles EnclosedDistance.*:CloseContact.*:Referee.ProvesEveryFamily DAYLIGHT_DISTANCE_PAIRS=300
              DAYLIGHT_CLOSE_ROUNDS=12 DAYLIGHT_PROOF_PAIRS=1000)

# daylight_script(NAME LABEL SECONDS COMMAND..): a test that is a script. Status 77 says what was missing; CI takes none.
function(daylight_script name label seconds)
  add_test(NAME ${name} COMMAND ${ARGN})
  # What is recorded of guests outside of runs is the test's own.
  set_tests_properties(${name} PROPERTIES LABELS "${label}" TIMEOUT ${seconds} SKIP_RETURN_CODE 77
                       ENVIRONMENT "XDG_STATE_HOME=${CMAKE_BINARY_DIR}/state/${name}")
endfunction()
set(program $<TARGET_FILE:daylight>)
file(GLOB scripts RELATIVE ${PROJECT_SOURCE_DIR} CONFIGURE_DEPENDS cli/*_test.sh)
foreach(script ${scripts})
  get_filename_component(name ${script} NAME_WE)
  daylight_script(${name} cli 2400 ${PROJECT_SOURCE_DIR}/${script} ${program})
endforeach()
daylight_script(guides_test cli 2400 ${PROJECT_SOURCE_DIR}/docs/guides/guides_test.sh ${program})
daylight_script(guides_whole_test "cli;deep" 2400 ${PROJECT_SOURCE_DIR}/docs/guides/guides_test.sh ${program} whole)
daylight_script(docs_test cli 2400 ${Python3_EXECUTABLE} ${PROJECT_SOURCE_DIR}/docs/docs_test.py ${program})
daylight_script(exact_test cli 600 ${Python3_EXECUTABLE} ${PROJECT_SOURCE_DIR}/vectors/exact_test.py)
daylight_script(exact_boxes_test cli 600 ${Python3_EXECUTABLE} ${PROJECT_SOURCE_DIR}/vectors/exact_boxes_test.py)
daylight_script(vectors_test cli 600 ${Python3_EXECUTABLE} ${PROJECT_SOURCE_DIR}/vectors/vectors_test.py ${program})
daylight_script(compare_test bench 600 ${Python3_EXECUTABLE} ${PROJECT_SOURCE_DIR}/bench/compare_test.py)
daylight_script(schemas_test reports 2400 ${Python3_EXECUTABLE} ${PROJECT_SOURCE_DIR}/reports/schemas/schemas_test.py ${program})
foreach(part data browser build)
  daylight_script(page_${part} reports 2400 ${PROJECT_SOURCE_DIR}/reports/web/run_test.sh ${part})
endforeach()
daylight_script(hostile_test oracles 2400 ${Python3_EXECUTABLE} ${PROJECT_SOURCE_DIR}/oracles/methods/hostile_test.py
                ${program})
daylight_script(engines_test oracles 2400 ${PROJECT_SOURCE_DIR}/oracles/guests/engines_test.sh ${program})

daylight_script(planted_faults props 600 planted_faults)
daylight_script(naive_boxes_test props 600 ${PROJECT_SOURCE_DIR}/props/gate/naive_boxes_test.sh ${program})
daylight_script(naive_boxes_whole_test "props;deep" 2400 ${PROJECT_SOURCE_DIR}/props/gate/naive_boxes_test.sh ${program} all)

# The cases and the first pairs of every family, through every fuzz target. Methods as printed and foreign libraries are
# wrong on some of them: that must be found, and must end nothing.
foreach(target ${fuzz_targets})
  daylight_script(fuzz_${target}_seeds fuzz 2400 fuzz_${target} --cases ${PROJECT_SOURCE_DIR}/corpus/cases)
endforeach()
set_tests_properties(fuzz_xcheck_seeds PROPERTIES ENVIRONMENT "DAYLIGHT_FUZZ_ABORT="
                     PASS_REGULAR_EXPRESSION "fcl-distance-libccd/crash/.*[0-9]+ inputs")
if(CMAKE_CXX_COMPILER_ID STREQUAL Clang)
  daylight_script(fuzz_engine_test "fuzz;deep" 2400 ${PROJECT_SOURCE_DIR}/fuzz/guided/engine_test.sh ${program})
endif()
