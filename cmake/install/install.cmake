# SPDX-License-Identifier: MIT
# What can be installed beside the solver, a component at a time. `program` is the program with what it reads. Other programs
# may link the solver (library.cmake) and `exact`: decide_exactly and the referee, which need GMP, MPFR and MPFI too.
# Headers go under include/daylight, which is on the include path as is its parent: <daylight/solver/decide.hpp> and the
# "solver/solid.hpp" in it are both found.

daylight_library(exact LINKS installed_solver mpfi mpfr gmpxx gmp fmt::fmt
  OBJECTS $<TARGET_OBJECTS:daylight_corpus_pairs> $<TARGET_OBJECTS:daylight_oracles_referee>
  HEADERS oracles/referee/decide_exactly.hpp oracles/referee/referee.hpp corpus/pairs/method_answer.hpp
          corpus/pairs/certificate.hpp corpus/pairs/pair_numbers.hpp corpus/pairs/size_range.hpp corpus/pairs/solid_kind.hpp
          base/enum_words.hpp)

# The program finds these by their names in the source tree (base/source_tree.hpp). Its page is inside it. Not installed: what
# fuzzes, which is made of the sources and tells so when it is asked for.
install(TARGETS daylight RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT program)
file(GLOB data RELATIVE ${PROJECT_SOURCE_DIR} CONFIGURE_DEPENDS corpus/cases/*.jsonl corpus/scenes/*.* corpus/scenes/meshes/*
     oracles/guests/*.mjs oracles/guests/package.json oracles/guests/.npmrc)
list(APPEND data oracles/plugin.h reports/web/chart.mjs
     reports/web/page_template.html)
foreach(file ${data})
  get_filename_component(folder ${file} DIRECTORY)
  install(FILES ${file} DESTINATION ${CMAKE_INSTALL_DATADIR}/daylight/${folder} COMPONENT program)
endforeach()

# The portable archive (ninja portable): the program with the libraries that it needs, except those of the C and C++
# compilers, which plug-ins share; vectors. It runs on any machine with a glibc as new as this one's.
set(bundle ${CMAKE_INSTALL_LIBDIR}/daylight)
# Libraries look for each other by the path of the program: its RPATH, not its RUNPATH.
set_target_properties(daylight PROPERTIES INSTALL_RPATH "$ORIGIN/../${bundle}")
target_link_options(daylight PRIVATE -Wl,--disable-new-dtags)
install(TARGETS daylight RUNTIME_DEPENDENCY_SET bundled RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT portable)
install(RUNTIME_DEPENDENCY_SET bundled PRE_EXCLUDE_REGEXES "^(ld-linux|libc|libdl|libm|libpthread|librt|libgcc_s|libstdc\\+\\+)[-.]"
        LIBRARY DESTINATION ${bundle} COMPONENT portable)
install(DIRECTORY vectors DESTINATION ${CMAKE_INSTALL_DATADIR}/daylight COMPONENT portable
        PATTERN __pycache__ EXCLUDE PATTERN *_test.py EXCLUDE)
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DATADIR}/daylight COMPONENT portable)
install(FILES cmake/install/portable.md RENAME README.md DESTINATION . COMPONENT portable)
install(FILES README.md DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT program)
install(DIRECTORY docs DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT program FILES_MATCHING PATTERN *.md PATTERN *.svg PATTERN *.png)

# The licences of the libraries that the portable archive bundles, and of those that are compiled into it.
set(licences "")
set(bundled bullet ccd console-bridge fcl fmt gmp lodepng mpfi mpfr mujoco nlopt octomap ode pugixml qhull-r seccomp sqlite3- tinyxml
    urdfdom-model)
list(TRANSFORM bundled REPLACE "(.+)" "/usr/share/doc/lib\\1*[0-9]/copyright")
set(compiled_in libcli11-dev libeigen3-dev libsqlitecpp-dev nlohmann-json3-dev zlib1g)
list(TRANSFORM compiled_in REPLACE "(.+)" "/usr/share/doc/\\1/copyright")
file(GLOB copyrights ${bundled} ${compiled_in})
foreach(file ${copyrights})
  file(READ ${file} text)
  string(APPEND licences "${file}\n\n${text}\n\n")
endforeach()
file(WRITE ${CMAKE_BINARY_DIR}/library/bundled-libraries.txt "${licences}")
install(FILES ${CMAKE_BINARY_DIR}/library/bundled-libraries.txt DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT portable)

set(CPACK_GENERATOR TGZ)
set(CPACK_COMPONENTS_ALL program portable solver)
set(CPACK_COMPONENTS_GROUPING ALL_COMPONENTS_IN_ONE)
set(CPACK_ARCHIVE_COMPONENT_INSTALL ON)
set(CPACK_COMPONENT_INCLUDE_TOPLEVEL_DIRECTORY ON)
set(CPACK_PACKAGING_INSTALL_PREFIX /)
set(CPACK_STRIP_FILES ON)
include(CPack)
# Builds what the portable archive holds, and nothing else.
add_custom_target(portable COMMAND ${CMAKE_CPACK_COMMAND} -B ${PROJECT_SOURCE_DIR}/build USES_TERMINAL)
add_dependencies(portable daylight installed_solver)

# Installs into a clean prefix and builds the example of docs/library-use.md against it. Not of libraries with sanitizers
# in them, which want a program that has them too.
if(NOT CMAKE_CXX_FLAGS MATCHES "-fsanitize")
  add_test(NAME install_test COMMAND ${PROJECT_SOURCE_DIR}/cmake/install/install_test.sh ${CMAKE_BINARY_DIR} ${CMAKE_CXX_COMPILER})
  add_test(NAME amalgamate_test COMMAND ${PROJECT_SOURCE_DIR}/solver/amalgamate_test.sh ${CMAKE_BINARY_DIR} ${CMAKE_CXX_COMPILER})
  set_tests_properties(install_test amalgamate_test PROPERTIES LABELS library TIMEOUT 2400)
endif()
