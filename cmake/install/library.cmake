# SPDX-License-Identifier: MIT
# The library of the solver, which needs Eigen alone, and the CMake package `daylight`, of which each library is a component.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/daylight)

# daylight_library(NAME OBJECTS .. HEADERS .. LINKS ..)
function(daylight_library name)
  cmake_parse_arguments(it "" "" "OBJECTS;HEADERS;LINKS" ${ARGN})
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
endfunction()

daylight_library(solver OBJECTS $<TARGET_OBJECTS:daylight_solver> LINKS Eigen3::Eigen
  HEADERS solver/solid.hpp solver/decide.hpp solver/detail/iteration_cap.hpp solver/distance.hpp solver/intersect_batch.hpp)

configure_file(cmake/install/daylight-config.cmake.in ${CMAKE_BINARY_DIR}/library/daylight-config.cmake @ONLY)
write_basic_package_version_file(${CMAKE_BINARY_DIR}/library/daylight-config-version.cmake
                                 VERSION ${PROJECT_VERSION} COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_BINARY_DIR}/library/daylight-config.cmake ${CMAKE_BINARY_DIR}/library/daylight-config-version.cmake
        DESTINATION ${package_folder} COMPONENT solver)
