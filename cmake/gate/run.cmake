# SPDX-License-Identifier: MIT
# cmake -P run.cmake -- COMMAND..: runs a gate. Its exit codes 0, 2 and 3 say that its file holds the result.
set(words "")
foreach(index RANGE 4 ${CMAKE_ARGC})
  if(index LESS CMAKE_ARGC)
    list(APPEND words "${CMAKE_ARGV${index}}")
  endif()
endforeach()
execute_process(COMMAND ${words} RESULT_VARIABLE code)
if(NOT code MATCHES "^[023]$")
  message(FATAL_ERROR "exit code ${code}")
endif()
