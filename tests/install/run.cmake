# The steps of the test install_consumer.
cmake_minimum_required(VERSION 3.28)

function(run)
  cmake_parse_arguments(arg "" "EXPECT" "COMMAND" ${ARGN})
  execute_process(COMMAND ${arg_COMMAND} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  list(JOIN arg_COMMAND " " command)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "failed (${result}): ${command}\n${output}")
  endif()
  if(arg_EXPECT AND NOT output MATCHES "${arg_EXPECT}")
    message(FATAL_ERROR "expected \"${arg_EXPECT}\" of: ${command}\n${output}")
  endif()
  message(STATUS "ok: ${command}")
endfunction()

file(REMOVE_RECURSE ${work}/first ${work}/moved ${work}/modules ${work}/c)
run(COMMAND ${CMAKE_COMMAND} --install ${build} --config ${config} --prefix ${work}/first)
file(RENAME ${work}/first ${work}/moved)
set(prefix ${work}/moved)

# import abut;
run(COMMAND ${CMAKE_COMMAND} -G ${generator} -S ${source}/modules -B ${work}/modules -D CMAKE_CXX_COMPILER=${cxx}
            -D CMAKE_BUILD_TYPE=${config} -D CMAKE_PREFIX_PATH=${prefix})
run(COMMAND ${CMAKE_COMMAND} --build ${work}/modules)
run(COMMAND ${work}/modules/consumer EXPECT "distance 2\n")

# C, by pkg-config and whatever compiler is called cc.
file(MAKE_DIRECTORY ${work}/c)
file(GLOB_RECURSE pc ${prefix}/abut.pc)
cmake_path(GET pc PARENT_PATH pkgconfig_dir)
cmake_path(GET pkgconfig_dir PARENT_PATH lib_dir)
set(ENV{PKG_CONFIG_PATH} ${pkgconfig_dir})
set(ENV{LD_LIBRARY_PATH} ${lib_dir})
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
  run(COMMAND cc ${source}/c/${program}.c -o ${work}/c/${program} ${flags})
  run(COMMAND ${work}/c/${program} EXPECT "distance 2\n")
endforeach()
