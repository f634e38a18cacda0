# SPDX-License-Identifier: Apache-2.0
# Reads a portfile with functions of vcpkg that print what they are asked for: cmake -D FEATURES=... -D PORTFILE=... -P
cmake_minimum_required(VERSION 3.28)
set(VERSION 0)
set(PORT abut)
set(TARGET_TRIPLET triplet)
set(CURRENT_BUILDTREES_DIR ${CMAKE_CURRENT_LIST_DIR})
foreach(step IN ITEMS vcpkg_check_linkage vcpkg_cmake_configure vcpkg_cmake_build vcpkg_execute_required_process
                      vcpkg_cmake_config_fixup vcpkg_fixup_pkgconfig vcpkg_install_copyright file)
  # The last is a command of CMake, which writes nothing here.
  cmake_language(EVAL CODE "function(${step})\n list(JOIN ARGN \"|\" words)\n message(NOTICE \"${step} \${words}\")\nendfunction()")
endforeach()
include(${PORTFILE})
