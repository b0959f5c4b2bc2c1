# SPDX-License-Identifier: MIT
# What other programs may link: three libraries of the objects of the folders, each with its headers, a component of the
# CMake package `daylight` and a pkg-config file:
#   solver    the decision and the distance; needs Eigen alone
#   exact     decide_exactly and the referee; GMP, MPFR and MPFI too
#   oracles   every method, compare and the readers behind them; everything
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

# Debian packages, one a component: cpack -G DEB --config build/release/CPackConfig.cmake. The libraries are static, so what
# theirs need is listed here and not found by dpkg-shlibdeps.
set(CPACK_GENERATOR DEB)
set(CPACK_COMPONENTS_ALL solver exact oracles)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_PACKAGE_CONTACT "the authors of daylight <daylight@invalid>")
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION libdevel)
set(depends_solver "libeigen3-dev (>= 3.4)")
set(depends_exact "libdaylight-solver-dev (= ${PROJECT_VERSION}), libgmp-dev, libmpfr-dev, libmpfi-dev")
set(depends_oracles "libdaylight-exact-dev (= ${PROJECT_VERSION}), libnlopt-dev, libfcl-dev, libbullet-dev, \
libccd-dev, libode-dev, libmujoco-dev, liburdfdom-dev, libtinyxml-dev, libsqlitecpp-dev, libsqlite3-dev, libfmt-dev, pkg-config")
set(summary_solver "Do two cylinders intersect? Decision, proof and distance")
set(summary_exact "Do two cylinders intersect? The exact predicate and the referee")
set(summary_oracles "Do two cylinders intersect? Every method and what compares them")
foreach(name ${CPACK_COMPONENTS_ALL})
  string(TOUPPER ${name} upper)
  set(CPACK_DEBIAN_${upper}_PACKAGE_NAME libdaylight-${name}-dev)
  set(CPACK_DEBIAN_${upper}_PACKAGE_DEPENDS ${depends_${name}})
  set(CPACK_COMPONENT_${upper}_DESCRIPTION ${summary_${name}})
endforeach()
include(CPack)

# Installs into a clean prefix and builds the example of README.md against it, by both ways. Not of libraries with
# sanitizers in them, which want a program that has them too.
if(CMAKE_CXX_FLAGS MATCHES "-fsanitize")
  add_test(NAME install_test COMMAND sh -c "echo 'skipped: the libraries have sanitizers in them'; exit 77")
else()
  add_test(NAME install_test COMMAND ${PROJECT_SOURCE_DIR}/install/install_test.sh ${CMAKE_BINARY_DIR} ${CMAKE_CXX_COMPILER})
endif()
set_tests_properties(install_test PROPERTIES LABELS library TIMEOUT 600 SKIP_RETURN_CODE 77)
