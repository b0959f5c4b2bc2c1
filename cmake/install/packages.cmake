# SPDX-License-Identifier: MIT
# Debian packages, one a component: cpack -G DEB --config build/release/CPackConfig.cmake, after everything is built. Wants
# dpkg-dev, which finds the shared libraries that a program needs; what the static ones need is listed here.
set(DAYLIGHT_MAINTAINER "the daylight authors <root@localhost>" CACHE STRING
    "The Maintainer that the Debian packages name: who builds them for others says who answers for them, Name <address>")
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_CONTACT ${DAYLIGHT_MAINTAINER})
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
# Folders for everybody, whatever the umask of who packs.
set(CPACK_PRE_BUILD_SCRIPTS ${CMAKE_BINARY_DIR}/packages/open_folders.cmake)
file(WRITE ${CPACK_PRE_BUILD_SCRIPTS} "file(CHMOD_RECURSE \${CPACK_TEMPORARY_DIRECTORY} DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
")

# daylight_package(COMPONENT PACKAGE SECTION SUMMARY TEXT [SHLIBDEPS] [DEPENDS ..] [BUILT_IN package..])
# BUILT_IN: whose code is compiled in; their licences go with ours.
function(daylight_package component package section summary text)
  cmake_parse_arguments(it SHLIBDEPS "" "DEPENDS;SUGGESTS;BUILT_IN" ${ARGN})
  file(READ ${PROJECT_SOURCE_DIR}/LICENSE licence)
  foreach(other ${it_BUILT_IN})
    if(EXISTS /usr/share/doc/${other}/copyright)
      file(READ /usr/share/doc/${other}/copyright theirs)
      string(APPEND licence "\n\nIt holds code of ${other}, of which Debian says:\n\n${theirs}")
    endif()
  endforeach()
  file(WRITE ${CMAKE_BINARY_DIR}/packages/${component}/copyright "${licence}")
  install(FILES ${CMAKE_BINARY_DIR}/packages/${component}/copyright
          DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${package} COMPONENT ${component})
  list(JOIN it_DEPENDS ", " depends)
  list(JOIN it_SUGGESTS ", " suggests)
  string(TOUPPER ${component} upper)
  foreach(name NAME=${package} SECTION=${section} DEPENDS=${depends} SUGGESTS=${suggests} SHLIBDEPS=${it_SHLIBDEPS})
    string(REGEX MATCH "^([A-Z]+)=(.*)" all "${name}")
    set(CPACK_DEBIAN_${upper}_PACKAGE_${CMAKE_MATCH_1} "${CMAKE_MATCH_2}" PARENT_SCOPE)
  endforeach()
  set(CPACK_DEBIAN_${upper}_DESCRIPTION "${summary}\n${text}" PARENT_SCOPE)
  set(CPACK_COMPONENTS_ALL ${CPACK_COMPONENTS_ALL} ${component} PARENT_SCOPE)
endfunction()

set(what "daylight decides with a proof whether two finite solid cylinders intersect.\n\
It also tests other solvers and libraries (NLopt, FCL, Bullet, libccd, ODE,\n\
MuJoCo). For each wrong answer it gives a certificate that anyone can check in\n\
exact arithmetic.\n\n")
set(same_version "(= ${PROJECT_VERSION})")
daylight_package(program daylight science "decide with proofs whether cylinders intersect, and test libraries"
  "${what}This package holds the program and its cases. Its commands check pairs, run\n\
campaigns, replay and explain findings, check scenes (URDF, MJCF), time\n\
methods, and guard merges. `daylight fuzz` and `daylight mutants` need the\n\
source tree."
  SHLIBDEPS SUGGESTS nodejs BUILT_IN libcli11-dev libeigen3-dev librapidcheck-dev libsqlitecpp-dev nlohmann-json3-dev)
daylight_package(solver libdaylight-solver-dev libdevel "intersection and distance of two cylinders (C++ library)"
  "${what}This package holds the solver as a static library with its headers. It has\n\
yes or no, verdicts with proofs, signed distances and batches. It needs only\n\
Eigen, and never allocates, prints or throws."
  DEPENDS "libeigen3-dev (>= 3.4)" BUILT_IN libeigen3-dev)
daylight_package(exact libdaylight-exact-dev libdevel "exact intersection predicate of two cylinders (C++ library)"
  "${what}This package holds the exact predicate and the referee as a static library\n\
with its headers. It distinguishes touching, in rational arithmetic if needed."
  DEPENDS "libdaylight-solver-dev ${same_version}" libgmp-dev libmpfr-dev libmpfi-dev libfmt-dev BUILT_IN libeigen3-dev nlohmann-json3-dev)
daylight_package(oracles libdaylight-oracles-dev libdevel "compare collision libraries on cylinders (C++ library)"
  "${what}This package holds every method that daylight tests, the comparison of answers\n\
with the proved truth, and the readers, as a static library with its headers."
  DEPENDS "libdaylight-exact-dev ${same_version}" libnlopt-dev libfcl-dev libbullet-dev libccd-dev libode-dev libmujoco-dev
          libsqlitecpp-dev libsqlite3-dev libfmt-dev libseccomp-dev pkg-config
  BUILT_IN libeigen3-dev libsqlitecpp-dev nlohmann-json3-dev)
if(TARGET daylight_python)
  math(EXPR next "${Python_VERSION_MINOR} + 1")
  daylight_package(python python3-daylight python "decide whether cylinders intersect, with proofs (Python 3 module)"
    "${what}This package holds the Python module. It has verdicts, proofs and signed\n\
distances on NumPy arrays, and campaigns that test a Python callable."
    SHLIBDEPS DEPENDS "python3 (>= 3.${Python_VERSION_MINOR})" "python3 (<< 3.${next})" python3-numpy
    BUILT_IN libeigen3-dev nlohmann-json3-dev pybind11-dev)
endif()
# The licences of the libraries that the portable archive bundles.
set(bundled_licences "")
set(bundled bullet ccd console-bridge fcl fmt gmp lodepng mpfi mpfr mujoco nlopt octomap ode pugixml qhull-r seccomp sqlite3- tinyxml
    urdfdom-model)
list(TRANSFORM bundled REPLACE "(.+)" "/usr/share/doc/lib\\1*[0-9]/copyright")
file(GLOB copyrights ${bundled} /usr/share/doc/zlib1g/copyright)
foreach(file ${copyrights})
  file(READ ${file} text)
  string(APPEND bundled_licences "${file}\n\n${text}\n\n")
endforeach()
file(WRITE ${CMAKE_BINARY_DIR}/packages/portable/bundled-libraries.txt "${bundled_licences}")
install(FILES ${CMAKE_BINARY_DIR}/packages/portable/bundled-libraries.txt DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/daylight
        COMPONENT portable)
include(CPack)
# Builds what the portable archive holds, and nothing else, in the folder of the preset `release`.
add_custom_target(portable COMMAND ${CMAKE_CPACK_COMMAND} --preset portable WORKING_DIRECTORY ${PROJECT_SOURCE_DIR} USES_TERMINAL)
add_dependencies(portable daylight daylight-mutants installed_solver)

# Installs into a clean prefix and builds the example of docs/library-use.md against it, by both ways. Not of libraries with
# sanitizers in them, which want a program that has them too.
if(NOT CMAKE_CXX_FLAGS MATCHES "-fsanitize")
  add_test(NAME install_test COMMAND ${PROJECT_SOURCE_DIR}/cmake/install/install_test.sh ${CMAKE_BINARY_DIR} ${CMAKE_CXX_COMPILER})
  set_tests_properties(install_test PROPERTIES LABELS library TIMEOUT 2400)
endif()
