# SPDX-License-Identifier: Apache-2.0
# Installs the C library, the picking library, the C headers, and the modules as sources: compiled
# module interfaces are not portable, so each consumer compiles them again. The C ABI is the stable
# product.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(abut_package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/abut)
set(abut_modules_dir ${CMAKE_INSTALL_LIBDIR}/abut/modules)
set(abut_installed abut_modules abut)
if(TARGET abut_picking)
  list(APPEND abut_installed abut_picking)
  set_target_properties(abut_picking PROPERTIES EXPORT_NAME picking INSTALL_RPATH "$ORIGIN")
endif()
if(TARGET abut_cli)
  set_target_properties(abut_cli PROPERTIES INSTALL_RPATH "$ORIGIN/../${CMAKE_INSTALL_LIBDIR}")
  install(TARGETS abut_cli RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
endif()
set_target_properties(abut_modules PROPERTIES EXPORT_NAME modules)
abut_export_flags(abut_modules)

install(TARGETS ${abut_installed} EXPORT abut_targets FILE_SET CXX_MODULES DESTINATION ${abut_modules_dir})
install(EXPORT abut_targets NAMESPACE abut:: FILE abut_targets.cmake
        DESTINATION ${abut_package_dir} CXX_MODULES_DIRECTORY modules)
# Interface units include the headers beside them.
install(DIRECTORY ${PROJECT_SOURCE_DIR}/modules/ DESTINATION ${abut_modules_dir} FILES_MATCHING PATTERN "*.hpp")
foreach(header abut picking)
  if(NOT header STREQUAL picking OR TARGET abut_picking)
    install(FILES include/abut/${header}.h include/abut/${header}.hpp DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/abut)
  endif()
endforeach()

install(DIRECTORY include/abut/cpp DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/abut FILES_MATCHING PATTERN "*.hpp")

# What linking the static modules needs, as far as it was built.
set(abut_dependencies "")
if(ABUT_WITH_LIBCCD)
  target_link_libraries(abut_modules INTERFACE $<INSTALL_INTERFACE:PkgConfig::CCD>)
  string(APPEND abut_dependencies "find_dependency(PkgConfig)\npkg_check_modules(CCD REQUIRED IMPORTED_TARGET ccd)\n")
endif()
if(ABUT_WITH_HULL)
  target_link_libraries(abut_modules INTERFACE $<INSTALL_INTERFACE:Qhull::qhull_r>)
  string(APPEND abut_dependencies "find_dependency(Qhull CONFIG)\n")
endif()
if(ABUT_WITH_THREADS)
  target_link_libraries(abut_modules INTERFACE $<INSTALL_INTERFACE:TBB::tbb>)
  string(APPEND abut_dependencies "find_dependency(TBB CONFIG)\n")
endif()
configure_package_config_file(cmake/abut-config.cmake.in ${PROJECT_BINARY_DIR}/install/abut-config.cmake
                              INSTALL_DESTINATION ${abut_package_dir} PATH_VARS abut_modules_dir
                              NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/install/abut-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/install/abut-config.cmake ${PROJECT_BINARY_DIR}/install/abut-config-version.cmake
        DESTINATION ${abut_package_dir})

# pkg-config files find the prefix from where they lie, so an installed tree can be moved.
set(abut_pkgconfig_dir ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
file(RELATIVE_PATH abut_prefix_from_pkgconfig /${abut_pkgconfig_dir} /)
string(REGEX REPLACE "/$" "" abut_prefix_from_pkgconfig ${abut_prefix_from_pkgconfig})
foreach(package abut abut_picking)
  if(TARGET ${package})
    configure_file(cmake/${package}.pc.in ${PROJECT_BINARY_DIR}/install/${package}.pc @ONLY)
    install(FILES ${PROJECT_BINARY_DIR}/install/${package}.pc DESTINATION ${abut_pkgconfig_dir})
  endif()
endforeach()
