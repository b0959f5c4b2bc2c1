# SPDX-License-Identifier: MIT
# The test planted_faults: the solver, and the other sources that a fault is planted in, compiled once more from copies with
# faults in them. The program links these objects first, so that of the ordinary libraries only others are taken.
set(copies ${CMAKE_BINARY_DIR}/planted)
set(table props/gate/planted_faults.jsonl)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${table})
file(READ ${table} faults)
string(REGEX MATCHALL "\"file\": \"[^\"]+\"" faulty "${faults}")
list(TRANSFORM faulty REPLACE "\"file\": \"(.+)\"" "\\1")
list(REMOVE_DUPLICATES faulty)
list(TRANSFORM faulty PREPEND ${copies}/ OUTPUT_VARIABLE faulty_copies)
add_custom_command(OUTPUT ${faulty_copies} ${copies}/planted_faults.cpp VERBATIM COMMENT "Planting faults"
  COMMAND Python3::Interpreter props/gate/plant_faults.py ${PROJECT_SOURCE_DIR} ${copies}
  WORKING_DIRECTORY ${PROJECT_SOURCE_DIR} DEPENDS props/gate/plant_faults.py ${table} ${faulty})

get_property(planted GLOBAL PROPERTY daylight_sources_daylight_solver)
list(APPEND planted ${faulty})
list(REMOVE_DUPLICATES planted)
list(FILTER planted INCLUDE REGEX "\\.cpp$")
add_executable(planted_faults props/gate/planted_faults_main.cpp ${copies}/planted_faults.cpp ${faulty_copies})
foreach(file ${planted})
  get_source_file_property(options ${file} COMPILE_OPTIONS)
  if(file IN_LIST faulty)
    set(file ${copies}/${file})
  endif()
  if(options)
    set_source_files_properties(${file} PROPERTIES COMPILE_OPTIONS "${options}")
  endif()
  target_sources(planted_faults PRIVATE ${file})
endforeach()
target_include_directories(planted_faults BEFORE PRIVATE ${copies})
target_compile_definitions(planted_faults PRIVATE DAYLIGHT_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
target_compile_options(planted_faults PRIVATE $<$<CONFIG:Release>:-O1>)
target_link_libraries(planted_faults PRIVATE daylight_props_gate)
