# SPDX-License-Identifier: Apache-2.0
# The steps of the test fuzz.live. `-D chosen=a;b;c` takes these kinds instead of those that the commit stands for.
cmake_minimum_required(VERSION 3.28)

include(${CMAKE_CURRENT_LIST_DIR}/../run_step.cmake)

if(NOT chosen)
  execute_process(COMMAND ${git} -C ${root} rev-parse HEAD OUTPUT_VARIABLE commit ERROR_QUIET OUTPUT_STRIP_TRAILING_WHITESPACE)
  # An archive without history always has the same kinds.
  string(SUBSTRING "${commit}000000000000" 0 12 digits)
  math(EXPR number "0x${digits}")
  list(SORT kinds)
  foreach(choice RANGE 1)
    list(LENGTH kinds count)
    if(count GREATER 0)
      math(EXPR place "${number} % ${count}")
      math(EXPR number "${number} / ${count}")
      list(GET kinds ${place} kind)
      list(REMOVE_AT kinds ${place})
      list(APPEND chosen ${kind})
    endif()
  endforeach()
endif()
list(SORT chosen)
message(STATUS "kinds: ${chosen}")

set(features libccd)
if(hull)
  list(APPEND features hull)
endif()
# A composite of the records is made of solids.
set(shapes ${chosen})
if(composite IN_LIST shapes AND NOT sphere IN_LIST shapes)
  list(APPEND shapes sphere)
endif()
string(REPLACE ";" "\\;" shapes "${shapes}")
string(REPLACE ";" "\\;" features "${features}")
# A build type without optimisation and without debug information compiles fastest; the corpus is small. Libraries are
# found beside the programs, as those that are gathered need it.
# Targets of kinds that were chosen before would be gathered with the new ones.
file(GLOB former LIST_DIRECTORIES false ${work}/build/fuzz/fuzz_*)
if(former)
  file(REMOVE ${former})
endif()
run(${CMAKE_COMMAND} -G ${generator} -S ${root} -B ${work}/build -D CMAKE_C_COMPILER=${c} -D CMAKE_CXX_COMPILER=${cxx}
    -D CMAKE_BUILD_TYPE=None -D ABUT_SANITIZE=fuzzer "-D ABUT_SHAPES=${shapes}" "-D ABUT_FEATURES=${features}"
    -D ABUT_WARNINGS=OFF -D ABUT_TESTS=OFF -D ABUT_TOOLS=OFF -D ABUT_BENCH=OFF -D ABUT_FUZZ=ON
    -D CMAKE_BUILD_RPATH_USE_ORIGIN=ON "-D CMAKE_BUILD_RPATH=$ORIGIN/lib\\;$ORIGIN")
run(${CMAKE_COMMAND} --build ${work}/build --target abut_fuzz_pairs)

set(others ${chosen})
foreach(a IN LISTS chosen)
  foreach(b IN LISTS others)
    # Without mutations: what these find depends on every change of the library.
    run(${work}/build/fuzz/fuzz_${a}_${b} -runs=0 -artifact_prefix=${work}/build/ -verbosity=0 ${root}/fuzz/corpus/pairs)
    message(STATUS "${a} and ${b}: no finding in the corpus")
  endforeach()
  list(POP_FRONT others)
endforeach()

run(${root}/tests/fuzz_live/gathered.sh ${root} ${work}/build/fuzz ${work}/gathered)
