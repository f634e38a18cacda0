# SPDX-License-Identifier: Apache-2.0
# The steps of the test install_consumer.
include(${CMAKE_CURRENT_LIST_DIR}/install.cmake)

# Documents and licences come along, and no file names the folder that it was built in.
foreach(file README.md LICENSE NOTICE docs/conventions.md examples/c/first_query.c)
  if(NOT EXISTS ${prefix}/share/doc/abut/${file})
    message(FATAL_ERROR "${file} was not installed")
  endif()
endforeach()
file(GLOB_RECURSE package_files ${lib_dir}/cmake/*.cmake ${lib_dir}/pkgconfig/*.pc)
cmake_path(SET tree NORMALIZE ${source}/../..)
foreach(file IN LISTS package_files)
  file(READ ${file} text)
  string(FIND "${text}" "${tree}" place)
  if(NOT place EQUAL -1)
    message(FATAL_ERROR "${file} names the folder ${tree}")
  endif()
endforeach()

# The program finds the library from where it lies.
if(program)
  run(${prefix}/bin/abut --version)
  expect("^abut [0-9.]+\n$")
endif()

# import abut;
run(${CMAKE_COMMAND} -G ${generator} -S ${source}/modules -B ${work}/modules -D CMAKE_CXX_COMPILER=${cxx}
    -D CMAKE_BUILD_TYPE=${config} -D CMAKE_PREFIX_PATH=${prefix})
run(${CMAKE_COMMAND} --build ${work}/modules)
run(${work}/modules/consumer)
expect("distance 2\n")

# C, by pkg-config and whatever compiler is called cc.
file(MAKE_DIRECTORY ${work}/c)
set(ENV{PKG_CONFIG_PATH} ${pkgconfig_dir})
set(ENV{LD_LIBRARY_PATH} ${lib_dir})
# Before 1.0 each minor version has an ABI, and so a soname, of its own.
run(readelf -d ${lib_dir}/libabut.so)
expect("SONAME[^\n]*libabut\\.so\\.0\\.[0-9]+]")
set(programs distance)
if(picking)
  list(APPEND programs pick)
endif()
if(response)
  list(APPEND programs respond)
endif()
set(package_of_distance abut)
set(package_of_pick abut_picking)
set(package_of_respond abut_response)
foreach(program IN LISTS programs)
  execute_process(COMMAND pkg-config --cflags --libs ${package_of_${program}} OUTPUT_VARIABLE flags
                  OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
  separate_arguments(flags UNIX_COMMAND "${flags}")
  run(cc ${source}/c/${program}.c -o ${work}/c/${program} ${flags})
  run(${work}/c/${program})
  expect("distance 2\n")
endforeach()
