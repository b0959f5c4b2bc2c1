# SPDX-License-Identifier: MIT
# The Python module, where pybind11-dev, python3-dev and python3-numpy are installed and the interpreter need not know sanitizers. It is compiled on its own: a shared
# library wants position-independent code.
set(PYBIND11_FINDPYTHON ON)
if(NOT Python_EXECUTABLE AND EXISTS /usr/bin/python3)
  set(Python_EXECUTABLE /usr/bin/python3)  # whose packages these are, whatever python3 comes first
endif()
find_package(Python 3.9 QUIET COMPONENTS Interpreter OPTIONAL_COMPONENTS Development.Module NumPy)
if(Python_Development.Module_FOUND AND Python_NumPy_FOUND AND NOT CMAKE_CXX_FLAGS MATCHES "-fsanitize")
  find_package(pybind11 2.6 QUIET CONFIG)
endif()
if(pybind11_FOUND)
  # The solver is compiled for it; of the other rooms' libraries it takes what it needs.
  file(GLOB sources CONFIGURE_DEPENDS solver/*.cpp solver/detail/*.cpp)
  list(FILTER sources EXCLUDE REGEX "_test\\.cpp$")
  pybind11_add_module(daylight_python MODULE NO_EXTRAS python/module.cpp ${sources})
  set_target_properties(daylight_python PROPERTIES OUTPUT_NAME daylight CXX_VISIBILITY_PRESET hidden
                        LIBRARY_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/python)
  target_include_directories(daylight_python PRIVATE ${PROJECT_SOURCE_DIR})
  target_link_libraries(daylight_python PRIVATE daylight_oracles_trial)
  target_link_options(daylight_python PRIVATE -Wl,--as-needed -Wl,--exclude-libs,ALL)
  # Where the interpreter of the prefix looks: Debian's has names of its own below /usr and /usr/local, a virtual
  # environment and everybody else's this one.
  set(version python${Python_VERSION_MAJOR}.${Python_VERSION_MINOR})
  install(CODE "
    set(python_folder lib/${version}/site-packages)
    if(EXISTS /etc/debian_version AND CMAKE_INSTALL_PREFIX MATCHES \"/usr/local/?$\")
      set(python_folder lib/${version}/dist-packages)
    elseif(EXISTS /etc/debian_version AND CMAKE_INSTALL_PREFIX MATCHES \"^/usr/?$\")
      set(python_folder lib/python3/dist-packages)
    endif()" COMPONENT python)
  install(TARGETS daylight_python LIBRARY DESTINATION "\${python_folder}" COMPONENT python)
  install(FILES python/daylight.pyi DESTINATION "\${python_folder}/daylight-stubs" RENAME __init__.pyi COMPONENT python)
  add_custom_target(wheel COMMAND Python::Interpreter ${PROJECT_SOURCE_DIR}/python/wheel.py $<TARGET_FILE:daylight_python>
                    ${PROJECT_VERSION} ${CMAKE_BINARY_DIR}/python)
  add_test(NAME python_test COMMAND Python::Interpreter ${PROJECT_SOURCE_DIR}/python/module_test.py)
  set_tests_properties(python_test PROPERTIES ENVIRONMENT "PYTHONPATH=${CMAKE_BINARY_DIR}/python" TIMEOUT 480 LABELS library)
elseif(NOT CMAKE_CXX_FLAGS MATCHES "-fsanitize")
  message(STATUS "no Python module: apt-get install pybind11-dev python3-dev python3-numpy")
  add_test(NAME python_test COMMAND ${PROJECT_SOURCE_DIR}/.ci/skip
           "no Python module: apt-get install pybind11-dev python3-dev python3-numpy, then configure again")
  set_tests_properties(python_test PROPERTIES LABELS library SKIP_RETURN_CODE 77)
endif()
