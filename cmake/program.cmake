# SPDX-License-Identifier: MIT
# The program `daylight`, and what it says of itself.
target_compile_definitions(daylight_oracles_methods PRIVATE DAYLIGHT_VERSION="${PROJECT_VERSION}"
                           DAYLIGHT_CCD_VERSION="${ccd_VERSION}")

# The page goes into the program as it is committed; reports/web/build.mjs makes it.
set(page_template ${PROJECT_SOURCE_DIR}/reports/web/page_template.html)
set_source_files_properties(reports/run/page_template.cpp PROPERTIES OBJECT_DEPENDS ${page_template}
  COMPILE_DEFINITIONS DAYLIGHT_PAGE_TEMPLATE="${page_template}")

# The programs that `daylight export` writes are templates; they go into the program as an array of names and texts.
file(GLOB templates CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/reports/export/templates/*
     ${PROJECT_SOURCE_DIR}/vectors/exact.py ${PROJECT_SOURCE_DIR}/oracles/methods/ccd_support.inc)
set(export_templates "")
foreach(template ${templates})
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${template})
  cmake_path(GET template FILENAME name)
  file(READ ${template} text)
  string(APPEND export_templates "    {\"${name}\", R\"~~~(${text})~~~\"},\n")
endforeach()
set(export_templates_source ${CMAKE_BINARY_DIR}/generated/reports/export/templates.cpp)
configure_file(cmake/templates.cpp.in ${export_templates_source} @ONLY)
target_sources(daylight_reports_export PRIVATE ${export_templates_source})

# Looked up at each build, since a commit touches no source.
get_directory_property(flags COMPILE_OPTIONS)
list(FILTER flags EXCLUDE REGEX "^-W|^-ffile-prefix-map")
string(TOUPPER "${CMAKE_BUILD_TYPE}" type)
list(JOIN flags " " flags)
string(STRIP "${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_${type}} ${flags}" flags)
list(JOIN missing_libraries " " missing)
add_custom_target(built_from BYPRODUCTS ${CMAKE_BINARY_DIR}/generated/cli/built_from.hpp VERBATIM
  COMMAND ${CMAKE_COMMAND} -D SOURCE=${PROJECT_SOURCE_DIR} -D HEADER=${CMAKE_BINARY_DIR}/generated/cli/built_from.hpp
          -D VERSION=${PROJECT_VERSION} -D FLAGS=${flags} -D MISSING=${missing} -P ${PROJECT_SOURCE_DIR}/cmake/built_from.cmake)
add_dependencies(daylight_cli built_from)
target_include_directories(daylight_cli PRIVATE ${CMAKE_BINARY_DIR}/generated)

add_executable(daylight cli/daylight_main.cpp cli/coverage_stubs_main.cpp)
target_link_libraries(daylight PRIVATE daylight_cli)
# Nothing else, or a plug-in with a function named like one of ours would call ours.
target_link_options(daylight PRIVATE -Wl,--export-dynamic-symbol=__sanitizer_cov_* -Wl,--export-dynamic-symbol=__sancov_*)

