# SPDX-License-Identifier: Apache-2.0
# For tests that are a sequence of programs: runs one and ends the test where it fails. `output` is what it wrote.
function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  list(JOIN ARGN " " command)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "failed (${result}): ${command}\n${output}")
  endif()
  message(STATUS "ok: ${command}\n${output}")
  set(output "${output}" PARENT_SCOPE)
endfunction()
