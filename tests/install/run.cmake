# SPDX-License-Identifier: Apache-2.0
# The steps of the test install_consumer.
cmake_minimum_required(VERSION 3.28)

include(${CMAKE_CURRENT_LIST_DIR}/../run_step.cmake)

# Of the program that ran last.
function(expect text)
  if(NOT output MATCHES "${text}")
    message(FATAL_ERROR "expected \"${text}\", got\n${output}")
  endif()
endfunction()

file(REMOVE_RECURSE ${work}/first ${work}/moved ${work}/modules ${work}/c)
run(${CMAKE_COMMAND} --install ${build} --config ${config} --prefix ${work}/first)
file(RENAME ${work}/first ${work}/moved)
set(prefix ${work}/moved)

# import abut;
run(${CMAKE_COMMAND} -G ${generator} -S ${source}/modules -B ${work}/modules -D CMAKE_CXX_COMPILER=${cxx}
    -D CMAKE_BUILD_TYPE=${config} -D CMAKE_PREFIX_PATH=${prefix})
run(${CMAKE_COMMAND} --build ${work}/modules)
run(${work}/modules/consumer)
expect("distance 2\n")

# C, by pkg-config and whatever compiler is called cc.
file(MAKE_DIRECTORY ${work}/c)
file(GLOB_RECURSE pc ${prefix}/abut.pc)
cmake_path(GET pc PARENT_PATH pkgconfig_dir)
cmake_path(GET pkgconfig_dir PARENT_PATH lib_dir)
set(ENV{PKG_CONFIG_PATH} ${pkgconfig_dir})
set(ENV{LD_LIBRARY_PATH} ${lib_dir})
# Before 1.0 each minor version has an ABI, and so a soname, of its own.
run(readelf -d ${lib_dir}/libabut.so)
expect("SONAME[^\n]*libabut\\.so\\.0\\.[0-9]+]")
set(programs distance)
if(picking)
  list(APPEND programs pick)
endif()
set(package_of_distance abut)
set(package_of_pick abut_picking)
foreach(program IN LISTS programs)
  execute_process(COMMAND pkg-config --cflags --libs ${package_of_${program}} OUTPUT_VARIABLE flags
                  OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
  separate_arguments(flags UNIX_COMMAND "${flags}")
  run(cc ${source}/c/${program}.c -o ${work}/c/${program} ${flags})
  run(${work}/c/${program})
  expect("distance 2\n")
endforeach()
