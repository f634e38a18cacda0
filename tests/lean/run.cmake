# SPDX-License-Identifier: Apache-2.0
# The steps of the test lean.
cmake_minimum_required(VERSION 3.28)

include(${CMAKE_CURRENT_LIST_DIR}/../run_step.cmake)

set(build ${work}/build)
run(${CMAKE_COMMAND} -E chdir ${root} ${CMAKE_COMMAND} --preset lean -B ${build}
    -D CMAKE_C_COMPILER=${c} -D CMAKE_CXX_COMPILER=${cxx})

# Spheres and boxes need no surfaces, no holes, no discs, no composites and no trees of triangles.
file(READ ${build}/compile_commands.json commands)
foreach(unneeded IN ITEMS two_surfaces/crossing_surfaces walls/rim_point discs/disc_depth composites/composites boxes/bvh shapes/hull)
  if(commands MATCHES "/modules/[a-z_/]*${unneeded}[a-z_]*\\.cpp")
    message(FATAL_ERROR "the preset lean compiles ${CMAKE_MATCH_0}")
  endif()
endforeach()
string(REGEX MATCHALL "\"file\":" units "${commands}")
list(LENGTH units count)
message(STATUS "${count} units")
if(count GREATER ${most_units})
  message(FATAL_ERROR "the preset lean compiles ${count} units; ${most_units} are allowed")
endif()

run(${CMAKE_COMMAND} --build ${build} --target abut)
file(REAL_PATH ${build}/capi/libabut.so library)
file(SIZE ${library} bytes)
message(STATUS "${bytes} bytes")
if(bytes GREATER most_bytes)
  message(FATAL_ERROR "libabut.so has ${bytes} bytes; ${most_bytes} are allowed")
endif()

run(${c} -I ${root}/include ${source}/lean.c -o ${work}/lean -L ${build}/capi -labut)
run(${CMAKE_COMMAND} -E env LD_LIBRARY_PATH=${build}/capi ${work}/lean)
