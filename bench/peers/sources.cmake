# SPDX-License-Identifier: Apache-2.0
# What ABUT_PEERS, a folder with the sources of further libraries, holds. Sets abut_peers_found to the names of the
# libraries that are there, and abut_peers_versions to names with versions. A library that is named and incomplete, and
# a folder without any, are errors. Also a script, for the test: cmake -D ABUT_PEERS=FOLDER -P sources.cmake
set(abut_peer_names box3d jolt coal)
set(abut_peer_box3d_folder box3d)
set(abut_peer_jolt_folder JoltPhysics)
set(abut_peer_coal_folder coal)
# The first holds the version.
set(abut_peer_box3d_files CMakeLists.txt src/CMakeLists.txt include/box3d/collision.h)
set(abut_peer_jolt_files Build/CMakeLists.txt Jolt/Jolt.h)
set(abut_peer_coal_files package.xml include/coal/collision.h src/collision.cpp)

if(NOT IS_DIRECTORY "${ABUT_PEERS}")
  message(FATAL_ERROR "ABUT_PEERS is '${ABUT_PEERS}', which is no folder; expected one with the sources of libraries in "
                      "the folders box3d, JoltPhysics or coal.")
endif()
set(abut_peers_found)
set(abut_peers_versions)
foreach(name IN LISTS abut_peer_names)
  set(folder "${ABUT_PEERS}/${abut_peer_${name}_folder}")
  if(NOT IS_DIRECTORY "${folder}")
    message(STATUS "ABUT_PEERS has no ${abut_peer_${name}_folder}: the benchmarks run without that library")
    continue()
  endif()
  foreach(file IN LISTS abut_peer_${name}_files)
    if(NOT EXISTS "${folder}/${file}")
      message(FATAL_ERROR "ABUT_PEERS is '${ABUT_PEERS}': its ${abut_peer_${name}_folder} has no ${file}; expected the "
                          "whole sources of the library, or no such folder.")
    endif()
  endforeach()
  list(GET abut_peer_${name}_files 0 file)
  file(READ "${folder}/${file}" text)
  string(REGEX MATCH "(project\\([^)]*VERSION +|<version>)([0-9.]+)" ignored "${text}")
  list(APPEND abut_peers_found ${name})
  list(APPEND abut_peers_versions "${name} ${CMAKE_MATCH_2}")
endforeach()
if(NOT abut_peers_found)
  message(FATAL_ERROR "ABUT_PEERS is '${ABUT_PEERS}', which holds none of the folders box3d, JoltPhysics and coal.")
endif()
list(JOIN abut_peers_versions ", " text)
message(STATUS "Peers from sources: ${text}")
