# SPDX-License-Identifier: Apache-2.0
# Fails when the file EXPECTED does not hold what PROGRAM prints.
execute_process(COMMAND ${PROGRAM} OUTPUT_VARIABLE printed COMMAND_ERROR_IS_FATAL ANY)
file(READ ${EXPECTED} expected)
string(FIND "${expected}" "${printed}" place)
if(printed STREQUAL "" OR place EQUAL -1)
  message(FATAL_ERROR "${EXPECTED} is out of date; put in place of its table what ${PROGRAM} prints")
endif()
