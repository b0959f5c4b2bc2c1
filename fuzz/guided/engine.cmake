# SPDX-License-Identifier: MIT
# The fuzz targets as programs that search: fuzz_X_libfuzzer for each X of `fuzz_targets`. Needs clang.
set(top ${CMAKE_CURRENT_LIST_DIR}/../..)
set(foreign "/(all_methods|(bullet|ccd|fcl|mujoco|nlopt|ode)_method)\\.cpp$")
# What triage and campaigns ask.
set(unused "/(algorithm_groups|mechanism|cells)\\.cpp$")
set(guided ${top}/fuzz/guided/counters.cpp ${top}/fuzz/guided/mutator_target.cpp)
file(GLOB tested CONFIGURE_DEPENDS ${top}/solver/*.cpp ${top}/solver/detail/*.cpp ${top}/solver/literature/*.cpp)
file(GLOB checking CONFIGURE_DEPENDS ${top}/oracles/*/*.cpp ${top}/props/laws/*laws.cpp ${top}/props/laws/examine.cpp)
set(adapters ${checking})
list(FILTER tested EXCLUDE REGEX "_test\\.cpp$")
list(FILTER checking EXCLUDE REGEX "(_test|_main)\\.cpp$|${foreign}|${unused}")
list(FILTER adapters INCLUDE REGEX "${foreign}")
if(sources_without)
  list(TRANSFORM sources_without PREPEND ${top}/ OUTPUT_VARIABLE absent)
  list(REMOVE_ITEM adapters ${absent})
endif()
foreach(part base/json base/spelling base/process/child base/process/confine
             base/process/line_program base/process/supervised_process base/process/process corpus/pairs/method_answer corpus/pairs/pair_io
             corpus/pairs/size_range corpus/pairs/touch_plane corpus/pairs/truth_io
             fuzz/guided/record fuzz/guided/finding_sink fuzz/guided/fuzz_judge fuzz/guided/mutator)
  list(APPEND checking ${top}/${part}.cpp)
endforeach()

# Rooms whose sources are compiled as one, which takes half the time.
foreach(room base/process corpus/pairs fuzz/guided oracles/trial props/laws)
  set(sources ${checking})
  list(FILTER sources INCLUDE REGEX "/${room}/[^/]*\\.cpp$")
  string(MAKE_C_IDENTIFIER ${room} group)
  set_source_files_properties(${sources} PROPERTIES UNITY_GROUP ${group})
endforeach()

function(fuzz_part part)
  set_target_properties(${part} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  target_include_directories(${part} PRIVATE ${top})
  target_link_libraries(${part} PRIVATE Eigen3::Eigen nlohmann_json::nlohmann_json fmt::fmt-header-only)
  target_compile_definitions(${part} PRIVATE DAYLIGHT_VERSION="${PROJECT_VERSION}" DAYLIGHT_CCD_VERSION="${ccd_VERSION}")
  target_compile_options(${part} PRIVATE -gline-tables-only -fsanitize=address,undefined -fno-sanitize-recover=all)
endfunction()

set(foreign_libraries NLopt::nlopt ${FCL_LIBRARY} ${BULLET_LIBRARY} ${CCD_LIBRARY} ${ODE_LIBRARY} ${MUJOCO_LIBRARY})
add_library(fuzz_tested OBJECT EXCLUDE_FROM_ALL ${tested})
add_library(fuzz_checking OBJECT EXCLUDE_FROM_ALL ${checking})
fuzz_part(fuzz_tested)
fuzz_part(fuzz_checking)
set_target_properties(fuzz_checking PROPERTIES DISABLE_PRECOMPILE_HEADERS OFF)
target_precompile_headers(fuzz_checking PRIVATE ${daylight_common_headers})
# Edges of the tested code alone are counted: those of the referee tell nothing of it. Comparisons are not traced: the
# engine sees integers only, and they are a fifth of the time.
target_compile_options(fuzz_tested PRIVATE -fsanitize-coverage=inline-8bit-counters,pc-table)
foreach(target ${fuzz_targets})
  add_executable(fuzz_${target}_libfuzzer ${top}/fuzz/guided/fuzz_${target}_target.cpp ${guided})
  fuzz_part(fuzz_${target}_libfuzzer)
  target_link_libraries(fuzz_${target}_libfuzzer PRIVATE fuzz_tested fuzz_checking ${MPFI} ${MPFR} ${GMP} ${SECCOMP})
  target_link_options(fuzz_${target}_libfuzzer PRIVATE -fsanitize=fuzzer,address,undefined)
endforeach()
target_sources(fuzz_xcheck_libfuzzer PRIVATE ${adapters})
target_link_libraries(fuzz_xcheck_libfuzzer PRIVATE ${foreign_libraries} ${CMAKE_DL_LIBS})
# For the counters of a plug-in.
target_link_options(fuzz_xcheck_libfuzzer PRIVATE -Wl,--export-dynamic-symbol=__sanitizer_cov_*
                    -Wl,--export-dynamic-symbol=__sancov_*)
