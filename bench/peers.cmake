# SPDX-License-Identifier: Apache-2.0
# Box3D, Jolt and Coal as contenders, where ABUT_PEERS names a folder with their sources. They are built as a project
# of its own, whose libraries are loaded like those of the other peers.
set(ABUT_PEERS "" CACHE PATH "Folder with the sources of further libraries to measure: box3d, JoltPhysics, coal")
set(abut_peers_found)
if(ABUT_PEERS)
  include(peers/sources.cmake)
  set(abut_peers_built)
  foreach(name IN LISTS abut_peers_found)
    list(APPEND abut_peers_built ${CMAKE_CURRENT_BINARY_DIR}/peers/libabut_bench_pairs_${name}.so)
  endforeach()
  include(ExternalProject)
  ExternalProject_Add(abut_bench_peers
    SOURCE_DIR ${CMAKE_CURRENT_SOURCE_DIR}/peers
    PREFIX peers_steps
    BINARY_DIR peers
    CMAKE_ARGS -D CMAKE_BUILD_TYPE=Release -D CMAKE_C_COMPILER=${CMAKE_C_COMPILER}
               -D CMAKE_CXX_COMPILER=${CMAKE_CXX_COMPILER} -D ABUT_PEERS=${ABUT_PEERS}
    BUILD_ALWAYS ON
    BUILD_BYPRODUCTS ${abut_peers_built}
    INSTALL_COMMAND "")
  # Read by the report.
  list(JOIN abut_peers_versions ", " text)
  file(WRITE ${CMAKE_CURRENT_BINARY_DIR}/peers.txt "${text}\n")
else()
  file(REMOVE ${CMAKE_CURRENT_BINARY_DIR}/peers.txt)
endif()

foreach(name box3d jolt coal)
  if(name IN_LIST abut_peers_found)
    add_library(abut_bench_pairs_${name} SHARED IMPORTED)
    set_target_properties(abut_bench_pairs_${name} PROPERTIES
      IMPORTED_LOCATION ${CMAKE_CURRENT_BINARY_DIR}/peers/libabut_bench_pairs_${name}.so)
    add_dependencies(abut_bench_pairs_${name} abut_bench_peers)
  else()
    # Has no answer to anything.
    configure_file(pairs_absent.cpp.in ${CMAKE_CURRENT_BINARY_DIR}/pairs_${name}_absent.cpp @ONLY)
    abut_bench_peer(abut_bench_pairs_${name} ${CMAKE_CURRENT_BINARY_DIR}/pairs_${name}_absent.cpp)
    target_include_directories(abut_bench_pairs_${name} PRIVATE ${CMAKE_CURRENT_SOURCE_DIR})
  endif()
endforeach()
