# SPDX-License-Identifier: Apache-2.0
# The steps of the test install_processor: the program on emulated processors, one too old and one that will do.
if(NOT program OR NOT arch STREQUAL "x86-64-v3")
  message("skipped: needs the program abut, built for x86-64-v3")
  return()
endif()
find_program(qemu qemu-x86_64)
if(NOT qemu)
  message("skipped: qemu-x86_64 is missing; scripts/setup installs it")
  return()
endif()
include(${CMAKE_CURRENT_LIST_DIR}/install.cmake)

execute_process(COMMAND ${qemu} -cpu Nehalem ${prefix}/bin/abut --version
                RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE error)
set(sentence "abut: this processor lacks avx, avx2, bmi, bmi2, f16c, fma, lzcnt, movbe, which libabut was built for ")
if(NOT result EQUAL 1 OR NOT error MATCHES "${sentence}\\(ABUT_ARCH is x86-64-v3\\); [^\n]*\n$")
  message(FATAL_ERROR "expected \"${sentence}\" and status 1, got status ${result} and\n${output}${error}")
endif()
run(${qemu} -cpu Haswell ${prefix}/bin/abut --version)
expect("abut [0-9.]+\n$")
