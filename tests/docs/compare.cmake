# SPDX-License-Identifier: Apache-2.0
# Fails when PROGRAM prints something else than the file EXPECTED holds.
execute_process(COMMAND ${PROGRAM} OUTPUT_VARIABLE printed COMMAND_ERROR_IS_FATAL ANY)
file(READ ${EXPECTED} expected)
if(NOT printed STREQUAL expected)
  message(FATAL_ERROR "${EXPECTED} is out of date; write it anew: ${PROGRAM} > ${EXPECTED}")
endif()
