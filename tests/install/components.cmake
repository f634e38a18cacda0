# SPDX-License-Identifier: Apache-2.0
# The steps of the test install_components.
include(${CMAKE_CURRENT_LIST_DIR}/install.cmake)

# As on a machine without the development packages that only the modules need.
set(bare -D CMAKE_DISABLE_FIND_PACKAGE_PkgConfig=ON -D CMAKE_DISABLE_FIND_PACKAGE_Qhull=ON
         -D CMAKE_DISABLE_FIND_PACKAGE_TBB=ON)
set(project -S ${source}/components -D CMAKE_PREFIX_PATH=${prefix})

# C without a word about components.
run(${CMAKE_COMMAND} -G ${generator} ${project} -B ${work}/c ${bare} -D LANGUAGES=C -D LIBRARY=abut::abut
    -D PROGRAM=${source}/c/distance.c)
run(${CMAKE_COMMAND} --build ${work}/c)
run(${work}/c/consumer)
expect("distance 2\n")
set(program_of_picking pick)
set(program_of_response respond)
foreach(extension picking response)
  if(${extension})
    run(${CMAKE_COMMAND} -G ${generator} ${project} -B ${work}/${extension} ${bare} -D LANGUAGES=C
        -D LIBRARY=abut::${extension} -D COMPONENTS=c,${extension} -D PROGRAM=${source}/c/${program_of_${extension}}.c)
    run(${CMAKE_COMMAND} --build ${work}/${extension})
    run(${work}/${extension}/consumer)
    expect("distance 2\n")
  endif()
endforeach()

# A project that the package is not for gets one error of one sentence.
set(count 0)
function(refused sentence)
  math(EXPR count "${count} + 1")
  set(count ${count} PARENT_SCOPE)
  execute_process(COMMAND ${CMAKE_COMMAND} ${project} -B ${work}/${count} -D LANGUAGES=CXX -D COMPONENTS=modules -D LIBRARY=abut::modules
                          -D PROGRAM=${source}/modules/main.cpp -D CMAKE_CXX_STANDARD=20 ${ARGN}
                  RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  # CMake breaks lines where it likes.
  string(REGEX REPLACE "[ \n]+" " " words "${output}")
  string(REGEX MATCHALL "CMake (Error|Warning)" complaints "${words}")
  list(LENGTH complaints number)
  if(result EQUAL 0 OR NOT words MATCHES "${sentence}" OR NOT number EQUAL 1)
    message(FATAL_ERROR "expected one error \"${sentence}\", got ${number}:\n${output}")
  endif()
  message(STATUS "refused: ${sentence}")
endfunction()
set(ninja -G Ninja)
set(clang -D CMAKE_CXX_COMPILER=${cxx})
set(strict -D CMAKE_CXX_EXTENSIONS=OFF)

# The program make need not be there, so that no compiler can be tried.
refused("needs the generator Ninja, this is Unix Makefiles" -G "Unix Makefiles" -D CMAKE_MAKE_PROGRAM=true
        -D CMAKE_CXX_COMPILER_FORCED=ON ${clang} ${strict})
refused("needs clang 19 or newer, this is GNU [0-9.]+" ${ninja} -D CMAKE_CXX_COMPILER=g++ ${strict})
refused("needs the property CXX_EXTENSIONS of the target consumer to be OFF" ${ninja} ${clang})
refused("needs the property CXX_EXTENSIONS of the target consumer to be OFF" ${ninja} ${clang} -D CMAKE_CXX_EXTENSIONS=ON)
refused("compiled as C\\+\\+20 and the target consumer as C\\+\\+23" ${ninja} ${clang} ${strict} -D STANDARD=23)
refused("needs C\\+\\+; add CXX to the languages" ${ninja} -D LANGUAGES=C)
refused("needs cmake_minimum_required\\(VERSION 3\\.28\\)" ${ninja} ${clang} ${strict} -D MINIMUM=3.20)
refused("There is no component \"gpu\"; there are c, picking, response, modules" ${ninja} ${clang} ${strict} -D COMPONENTS=c,gpu)
if(threads)
  refused("needs the development files of oneTBB, which" ${ninja} ${clang} ${strict} -D CMAKE_DISABLE_FIND_PACKAGE_TBB=ON)
endif()
