# SPDX-License-Identifier: MIT
# The only files compiled for more than the machine's baseline; solver/intersect_batch.cpp asks the processor before it calls
# them.
if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
  foreach(level v3 v4)
    set_source_files_properties(solver/detail/intersect_batch_${level}.cpp PROPERTIES COMPILE_OPTIONS -march=x86-64-${level})
  endforeach()
endif()
