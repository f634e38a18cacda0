# SPDX-License-Identifier: Apache-2.0
# Builds the C library, and those for picking and response where a feature asks for them, with headers and the files for CMake
# and pkg-config. The C++20 modules are left out: each project compiles their interfaces by the compiler that built them.
vcpkg_check_linkage(ONLY_DYNAMIC_LIBRARY)

# scripts/recipes writes archive.cmake, which names the archive of a release. Without it this port builds the tree around it.
if(EXISTS "${CMAKE_CURRENT_LIST_DIR}/archive.cmake")
  include("${CMAKE_CURRENT_LIST_DIR}/archive.cmake")
  vcpkg_download_distfile(archive URLS "${abut_url}" FILENAME "abut-${VERSION}.tar.gz" SHA512 "${abut_sha512}")
  vcpkg_extract_source_archive(source ARCHIVE "${archive}")
else()
  get_filename_component(source "${CMAKE_CURRENT_LIST_DIR}/../../.." ABSOLUTE)
endif()

# Any compiler may use what only clang builds: the interface is C. A triplet that names a compiler has its way.
set(compiler "")
if(NOT VCPKG_CHAINLOAD_TOOLCHAIN_FILE)
  set(compiler -DCMAKE_C_COMPILER=clang-19 -DCMAKE_CXX_COMPILER=clang++-19)
endif()
set(chosen ${FEATURES})
list(REMOVE_ITEM chosen core default)
# For the same reason one build serves debug and release of the programs that use it.
set(VCPKG_BUILD_TYPE release)
vcpkg_cmake_configure(
  SOURCE_PATH "${source}"
  OPTIONS ${compiler} "-DABUT_FEATURES=${chosen}" -DABUT_WARNINGS=OFF -DABUT_TESTS=OFF -DABUT_TOOLS=OFF)

vcpkg_cmake_build(TARGET abut)
set(components library dev)
foreach(extension IN ITEMS picking response)
  if(extension IN_LIST chosen)
    vcpkg_cmake_build(TARGET abut_${extension})
    list(APPEND components ${extension})
  endif()
endforeach()
foreach(component IN LISTS components)
  vcpkg_execute_required_process(
    COMMAND "${CMAKE_COMMAND}" --install . --component ${component}
    WORKING_DIRECTORY "${CURRENT_BUILDTREES_DIR}/${TARGET_TRIPLET}-rel"
    LOGNAME install-${component}-${TARGET_TRIPLET})
endforeach()

vcpkg_cmake_config_fixup(CONFIG_PATH lib/cmake/abut)
vcpkg_fixup_pkgconfig()
file(INSTALL "${CMAKE_CURRENT_LIST_DIR}/usage" DESTINATION "${CURRENT_PACKAGES_DIR}/share/${PORT}")
vcpkg_install_copyright(FILE_LIST "${source}/LICENSE" "${source}/NOTICE")
