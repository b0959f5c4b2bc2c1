# SPDX-License-Identifier: MIT
# What can be installed, a component at a time. `program` is the program with what it reads. What other programs may link
# are three libraries of the objects of the folders, each with its headers, a component of the CMake package `daylight` and
# a pkg-config file:
#   solver    the decision and the distance; needs Eigen alone
#   exact     decide_exactly and the referee; GMP, MPFR and MPFI too
#   oracles   every method, compare and the readers behind them; everything
# The fifth, `python`, is in cli/python/python.cmake.
# Headers go under include/daylight, which is on the include path as is its parent: <daylight/solver/decide.hpp> and the
# "solver/cylinder.hpp" in it are both found.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/daylight)
file(RELATIVE_PATH prefix_from_pc /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)

# daylight_library(NAME OBJECTS .. HEADERS .. LINKS .. [PC_REQUIRES "a b"] [PC_LIBS "-la -lb"])
function(daylight_library name)
  cmake_parse_arguments(it "" "PC_REQUIRES;PC_LIBS" "OBJECTS;HEADERS;LINKS" ${ARGN})
  set(library installed_${name})
  add_library(${library} STATIC ${it_OBJECTS})
  set_target_properties(${library} PROPERTIES LINKER_LANGUAGE CXX EXPORT_NAME ${name} OUTPUT_NAME daylight_${name}
                        ARCHIVE_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/library)
  target_link_libraries(${library} INTERFACE ${it_LINKS})
  target_compile_features(${library} INTERFACE cxx_std_20)
  target_include_directories(${library} INTERFACE $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>
                                                  $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/daylight>)
  install(TARGETS ${library} EXPORT ${name} ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT ${name})
  install(EXPORT ${name} NAMESPACE daylight:: FILE daylight-${name}.cmake DESTINATION ${package_folder} COMPONENT ${name})
  foreach(header ${it_HEADERS})
    get_filename_component(folder ${header} DIRECTORY)
    install(FILES ${header} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/daylight/${folder} COMPONENT ${name})
  endforeach()
  configure_file(install/daylight.pc.in ${CMAKE_BINARY_DIR}/library/daylight-${name}.pc @ONLY)
  install(FILES ${CMAKE_BINARY_DIR}/library/daylight-${name}.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig
          COMPONENT ${name})
endfunction()

set(solver_objects $<TARGET_OBJECTS:daylight_solver>)
set(oracles_objects $<TARGET_OBJECTS:daylight_oracles>)
set(corpus_objects $<TARGET_OBJECTS:daylight_corpus>)
set(exact_ones "/(exact|referee|certificate|search|tangency|enclosure|root_sum|pair_io)\\.cpp\\.")

daylight_library(solver OBJECTS ${solver_objects} LINKS Eigen3::Eigen PC_REQUIRES eigen3
  HEADERS solver/cylinder.hpp solver/sections.hpp solver/decide.hpp solver/distance.hpp solver/intersect_batch.hpp)
daylight_library(exact LINKS installed_solver mpfi mpfr gmpxx gmp
  OBJECTS $<FILTER:${oracles_objects},INCLUDE,${exact_ones}> $<FILTER:${corpus_objects},INCLUDE,${exact_ones}>
  PC_REQUIRES daylight-solver PC_LIBS "-lmpfi -lmpfr -lgmpxx -lgmp"
  HEADERS oracles/exact.hpp oracles/referee.hpp oracles/method.hpp)
daylight_library(oracles LINKS installed_exact NLopt::nlopt fcl PkgConfig::BULLETD ccd PkgConfig::ODE PkgConfig::URDF
                               SQLiteCpp fmt::fmt mujoco
  OBJECTS $<FILTER:${oracles_objects},EXCLUDE,${exact_ones}> $<FILTER:${corpus_objects},EXCLUDE,${exact_ones}>
  PC_REQUIRES "daylight-exact nlopt fcl bullet-float64 ccd ode urdfdom tinyxml fmt" PC_LIBS "-lSQLiteCpp -lsqlite3 -lmujoco"
  HEADERS oracles/compare.hpp oracles/contained.hpp oracles/adapter.hpp oracles/guest.hpp oracles/plugin.h
          corpus/pair_io.hpp corpus/families.hpp)

configure_file(install/daylight-config.cmake.in ${CMAKE_BINARY_DIR}/library/daylight-config.cmake @ONLY)
write_basic_package_version_file(${CMAKE_BINARY_DIR}/library/daylight-config-version.cmake
                                 VERSION ${PROJECT_VERSION} COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_BINARY_DIR}/library/daylight-config.cmake ${CMAKE_BINARY_DIR}/library/daylight-config-version.cmake
        DESTINATION ${package_folder} COMPONENT solver)

# The program finds these by their names in the source tree (cli/source_tree.hpp). Its page is inside it. Not installed: what
# plants faults and what fuzzes, which are made of the sources and tell so when they are asked for.
install(TARGETS daylight RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT program)
file(GLOB data RELATIVE ${PROJECT_SOURCE_DIR} CONFIGURE_DEPENDS corpus/*.jsonl corpus/scenes/*)
list(APPEND data oracles/plugin.h reports/kill_matrix.jsonl reports/builds.jsonl reports/page/chart.mjs)
foreach(file ${data})
  get_filename_component(folder ${file} DIRECTORY)
  install(FILES ${file} DESTINATION ${CMAKE_INSTALL_DATADIR}/daylight/${folder} COMPONENT program)
endforeach()
install(FILES README.md DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT program)
install(DIRECTORY guides DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT program FILES_MATCHING PATTERN *.md)
