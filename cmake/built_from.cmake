# SPDX-License-Identifier: MIT
# Writes HEADER, only where it changes: VERSION, FLAGS, MISSING and the commit of the sources in SOURCE.
cmake_minimum_required(VERSION 3.25)
execute_process(COMMAND git -C ${SOURCE} describe --always --dirty
                OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
if(NOT commit)
  set(commit unknown)
endif()
file(CONFIGURE OUTPUT ${HEADER} @ONLY CONTENT "#define BUILT_FROM_COMMIT \"@commit@\"
#define BUILT_FROM_VERSION \"@VERSION@\"
#define BUILT_WITH_FLAGS \"@FLAGS@\"
#define BUILT_WITHOUT \"@MISSING@\"
")
