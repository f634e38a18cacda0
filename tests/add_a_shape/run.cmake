# SPDX-License-Identifier: Apache-2.0
# The steps of the test add_a_shape.
cmake_minimum_required(VERSION 3.28)

include(${CMAKE_CURRENT_LIST_DIR}/../run_step.cmake)

# Copies keep their times and the build folder stays, so that a second run compiles what changed.
set(tree ${work}/tree)
file(REMOVE_RECURSE ${tree})
file(COPY ${root}/CMakeLists.txt ${root}/capi ${root}/cmake ${root}/fuzz ${root}/include ${root}/modules DESTINATION ${tree})

# The file, and the line among those of its kind.
file(COPY ${source}/rounded_cone.cppm DESTINATION ${tree}/modules/shapes)
file(READ ${tree}/cmake/registry.cmake registry)
string(FIND "${registry}" "\nabut_shape(" last REVERSE)
string(SUBSTRING "${registry}" 0 ${last} before)
string(SUBSTRING "${registry}" ${last} -1 after)
file(WRITE ${tree}/cmake/registry.cmake "${before}\nabut_shape(rounded_cone RoundedCone 60000)${after}")

set(features universe)
if(hull)
  set(features "universe\\;hull")
endif()
# One kind of each capability: a ball and a box (closed forms), a half-space, a hull, a curved solid, a surface, many solids,
# an assembly and a hole. All kinds would make four times as many pairs, which take minutes to compile.
set(representatives sphere box plane hull cylinder mesh particles composite box_hole)
foreach(shape IN LISTS representatives)
  if(NOT shape IN_LIST shapes)
    list(REMOVE_ITEM representatives ${shape})
  endif()
endforeach()
# A list stays one argument on its way through run().
list(APPEND representatives rounded_cone)
string(REPLACE ";" "\\;" shapes "${representatives}")
# A build type without optimisation and without debug information compiles fastest. ABUT_FUZZ is for the replay: its
# live targets are not built.
run(${CMAKE_COMMAND} -G ${generator} -S ${tree} -B ${work}/build -D CMAKE_C_COMPILER=${c} -D CMAKE_CXX_COMPILER=${cxx}
    -D CMAKE_BUILD_TYPE=None "-D ABUT_SHAPES=${shapes}" "-D ABUT_FEATURES=${features}"
    -D ABUT_WARNINGS=OFF -D ABUT_TESTS=OFF -D ABUT_TOOLS=OFF -D ABUT_BENCH=OFF -D ABUT_FUZZ=ON)
run(${CMAKE_COMMAND} --build ${work}/build --target abut abut_fuzz_replay)

file(GLOB_RECURSE library ${work}/build/libabut.so)
cmake_path(GET library PARENT_PATH library_dir)
foreach(program exact collide)
  run(${c} -I ${tree}/include ${source}/${program}.c -o ${work}/${program} -L ${library_dir} -labut -lm)
  run(${CMAKE_COMMAND} -E env LD_LIBRARY_PATH=${library_dir} ${work}/${program})
endforeach()

run(${work}/build/fuzz/abut_fuzz_replay ${tree}/fuzz 100 1 rounded_cone)
