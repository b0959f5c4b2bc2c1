# SPDX-License-Identifier: MIT
# The mutants: every source that a fault is planted in, or that includes a header with one, compiled once more from copies
# with switches in them (props/mutants/make_mutants.py). The program links these objects first and the ordinary libraries
# behind them, of which only whole objects that no fault reaches are then taken: nothing can come in unmutated.
set(mutants_table props/mutants/mutants.jsonl)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${mutants_table} props/mutants/make_mutants.py)
set(copies ${CMAKE_BINARY_DIR}/mutated)
set(mutated_rooms solver solver/literature corpus/pairs corpus/store oracles/methods oracles/referee oracles/trial props/laws props/gate
    props/shrink props/mutants fuzz/campaign)
set(candidates "")
foreach(room ${mutated_rooms})
  daylight_target_of(${room} target)
  get_property(sources GLOBAL PROPERTY daylight_sources_${target})
  list(APPEND candidates ${sources})
endforeach()
set(test_candidates
    oracles/trial/compare_test.cpp oracles/methods/contained_test.cpp oracles/referee/referee_test.cpp
    oracles/referee/arithmetic_test.cpp oracles/referee/certificates_test.cpp oracles/referee/searches_test.cpp
    oracles/referee/touching_test.cpp solver/batches_test.cpp solver/promises_test.cpp
    oracles/trial/proofs_test.cpp oracles/referee/enclosed_distance_test.cpp oracles/methods/literature_test.cpp
    oracles/methods/errata_test.cpp
    corpus/store/run_store_test.cpp corpus/pairs/pair_io_test.cpp
    props/laws/laws_test.cpp props/laws/exact_laws_test.cpp props/laws/one_sided_laws_test.cpp
    props/laws/approximate_laws_test.cpp props/laws/answer_laws_test.cpp props/laws/examine_test.cpp
    fuzz/campaign/batch_test.cpp
    solver/intersect_batch_test.cpp solver/intersect_test.cpp solver/distance_test.cpp
    solver/distance_rims_test.cpp)

# daylight_reached(RESULT SOURCE..): those of the sources that a fault reaches.
function(daylight_reached result)
  execute_process(COMMAND ${Python3_EXECUTABLE} props/mutants/make_mutants.py --reached ${PROJECT_SOURCE_DIR} ${ARGN}
                  WORKING_DIRECTORY ${PROJECT_SOURCE_DIR} OUTPUT_VARIABLE reached OUTPUT_STRIP_TRAILING_WHITESPACE
                  COMMAND_ERROR_IS_FATAL ANY)
  string(REPLACE "\n" ";" reached "${reached}")
  set(${result} ${reached} PARENT_SCOPE)
endfunction()

file(READ ${mutants_table} entries)
string(REGEX MATCHALL "\"file\": *\"[^\"]+\"" mutated "${entries}")
list(TRANSFORM mutated REPLACE "\"file\": *\"([^\"]+)\"" "\\1")
list(REMOVE_DUPLICATES mutated)
list(TRANSFORM mutated PREPEND ${copies}/ OUTPUT_VARIABLE mutated_copies)
set(mutant_table ${copies}/props/mutants/mutant_table.cpp)
add_custom_command(OUTPUT ${mutated_copies} ${mutant_table} VERBATIM COMMENT "Planting faults"
  COMMAND Python3::Interpreter props/mutants/make_mutants.py ${PROJECT_SOURCE_DIR} ${copies}
  WORKING_DIRECTORY ${PROJECT_SOURCE_DIR} DEPENDS props/mutants/make_mutants.py ${mutants_table} ${mutated})

daylight_reached(reached ${candidates})
set(mutant_sources "")
foreach(file ${reached})
  set(source ${file})
  if(file IN_LIST mutated)
    set(source ${copies}/${file})
  endif()
  get_source_file_property(options ${file} COMPILE_OPTIONS)
  if(options)
    set_source_files_properties(${source} PROPERTIES COMPILE_OPTIONS "${options}" SKIP_PRECOMPILE_HEADERS ON)
  endif()
  list(APPEND mutant_sources ${source})
endforeach()

function(daylight_mutated target)
  target_include_directories(${target} BEFORE PRIVATE ${copies})
  target_compile_definitions(${target} PRIVATE DAYLIGHT_SOURCE_DIR="${PROJECT_SOURCE_DIR}" DAYLIGHT_VERSION="${PROJECT_VERSION}")
endfunction()
add_library(daylight_mutants OBJECT ${mutant_sources} ${mutated_copies} ${mutant_table})
daylight_mutated(daylight_mutants)
target_compile_options(daylight_mutants PRIVATE $<$<CONFIG:Release>:-O1>)
set_target_properties(daylight_mutants PROPERTIES POSITION_INDEPENDENT_CODE ON)
daylight_precompiled(daylight_mutants)
target_link_libraries(daylight_mutants PRIVATE daylight_fuzz_campaign daylight_props_gate daylight_props_mutants)

function(daylight_mutant_program name)
  add_executable(${name} ${ARGN} $<TARGET_OBJECTS:daylight_mutants>)
  daylight_mutated(${name})
  target_compile_options(${name} PRIVATE $<$<CONFIG:Release>:-O1>)
  target_link_libraries(${name} PRIVATE daylight_fuzz_campaign daylight_props_gate daylight_props_mutants)
endfunction()
daylight_mutant_program(daylight-mutants cli/mutants_main.cpp cli/options.cpp)
target_link_libraries(daylight-mutants PRIVATE CLI11::CLI11)

# Not selected, the switches change no bit of any answer; and the executable for users has none.
add_executable(answers EXCLUDE_FROM_ALL props/mutants/answers_main.cpp)
target_link_libraries(answers PRIVATE daylight_props_mutants)
daylight_mutant_program(mutant_answers props/mutants/answers_main.cpp)
set_target_properties(answers mutant_answers PROPERTIES EXCLUDE_FROM_ALL OFF)
