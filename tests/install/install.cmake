# SPDX-License-Identifier: Apache-2.0
# Installs into `work` and moves the result: `prefix` is where it lies then, `lib_dir` where its libraries do.
cmake_minimum_required(VERSION 3.28)

include(${CMAKE_CURRENT_LIST_DIR}/../run_step.cmake)

# Of the program that ran last.
function(expect text)
  if(NOT output MATCHES "${text}")
    message(FATAL_ERROR "expected \"${text}\", got\n${output}")
  endif()
endfunction()

file(REMOVE_RECURSE ${work})
run(${CMAKE_COMMAND} --install ${build} --config ${config} --prefix ${work}/first)
file(RENAME ${work}/first ${work}/moved)
set(prefix ${work}/moved)
file(GLOB_RECURSE pc ${prefix}/abut.pc)
cmake_path(GET pc PARENT_PATH pkgconfig_dir)
cmake_path(GET pkgconfig_dir PARENT_PATH lib_dir)
