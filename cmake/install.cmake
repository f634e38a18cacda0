# SPDX-License-Identifier: Apache-2.0
# Installs the C library, the libraries that stand on it, the C headers, the program, the documents, and the modules as sources:
# compiled module interfaces are not portable, so each consumer compiles them again. The C ABI is the stable product.
# Components: library, picking, response, tools; dev has what a C program is compiled with, modules what a C++ one imports; docs.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(abut_package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/abut)
set(abut_modules_dir ${CMAKE_INSTALL_LIBDIR}/abut/modules)
set(abut_generated_dir ${PROJECT_BINARY_DIR}/install)

# What is installed finds the libraries from where it lies, so an installed tree can be moved. In /usr the loader does.
function(abut_find_libraries_in target folder)
  if(NOT CMAKE_INSTALL_PREFIX STREQUAL "/usr")
    set_target_properties(${target} PROPERTIES INSTALL_RPATH "${folder}")
  endif()
endfunction()

install(TARGETS abut EXPORT abut_c LIBRARY COMPONENT library NAMELINK_COMPONENT dev)
set(abut_exports c)
set(abut_left_out "")
foreach(extension picking response)
  if(TARGET abut_${extension})
    set_target_properties(abut_${extension} PROPERTIES EXPORT_NAME ${extension})
    abut_find_libraries_in(abut_${extension} "$ORIGIN")
    install(TARGETS abut_${extension} EXPORT abut_${extension} LIBRARY COMPONENT ${extension} NAMELINK_COMPONENT dev)
    list(APPEND abut_exports ${extension})
  else()
    list(APPEND abut_left_out PATTERN "${extension}.*" EXCLUDE)
  endif()
endforeach()
install(DIRECTORY include/abut DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT dev
        FILES_MATCHING PATTERN "*.h" PATTERN "*.hpp" ${abut_left_out})
foreach(name IN LISTS abut_exports)
  install(EXPORT abut_${name} NAMESPACE abut:: FILE abut-${name}.cmake DESTINATION ${abut_package_dir} COMPONENT dev)
endforeach()

set_target_properties(abut_modules PROPERTIES EXPORT_NAME modules)
abut_export_flags(abut_modules)
install(TARGETS abut_modules EXPORT abut_modules ARCHIVE COMPONENT modules
        FILE_SET CXX_MODULES DESTINATION ${abut_modules_dir} COMPONENT modules)
install(EXPORT abut_modules NAMESPACE abut:: FILE abut-modules-targets.cmake DESTINATION ${abut_package_dir}
        CXX_MODULES_DIRECTORY modules COMPONENT modules)
configure_file(cmake/installed-sources.cmake.in ${abut_generated_dir}/installed-sources.cmake @ONLY)
install(SCRIPT ${abut_generated_dir}/installed-sources.cmake COMPONENT modules)
# Interface units include the headers beside them. Those of libraries that stand on the C interface are not installed.
install(DIRECTORY ${PROJECT_SOURCE_DIR}/modules/ DESTINATION ${abut_modules_dir} COMPONENT modules
        FILES_MATCHING PATTERN "*.hpp" PATTERN picking EXCLUDE PATTERN response EXCLUDE)

# What linking the static modules needs, as far as it was built: a target and the package that has it.
set(abut_modules_need "")
if(ABUT_WITH_LIBCCD)
  list(APPEND abut_modules_need PkgConfig::CCD libccd)
endif()
if(ABUT_WITH_HULL)
  list(APPEND abut_modules_need Qhull::qhull_r Qhull)
endif()
if(ABUT_WITH_THREADS)
  list(APPEND abut_modules_need TBB::tbb oneTBB)
endif()
foreach(library IN LISTS abut_modules_need)
  if(library MATCHES "::")
    target_link_libraries(abut_modules INTERFACE $<INSTALL_INTERFACE:${library}>)
  endif()
endforeach()

configure_package_config_file(cmake/abut-config.cmake.in ${abut_generated_dir}/abut-config.cmake
                              INSTALL_DESTINATION ${abut_package_dir} NO_SET_AND_CHECK_MACRO)
file(RELATIVE_PATH abut_modules_from_package /${abut_package_dir} /${abut_modules_dir})
configure_file(cmake/abut-modules.cmake.in ${abut_generated_dir}/abut-modules.cmake @ONLY)
write_basic_package_version_file(${abut_generated_dir}/abut-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${abut_generated_dir}/abut-config.cmake ${abut_generated_dir}/abut-config-version.cmake
        DESTINATION ${abut_package_dir} COMPONENT dev)
install(FILES ${abut_generated_dir}/abut-modules.cmake DESTINATION ${abut_package_dir} COMPONENT modules)

# pkg-config files find the prefix from where they lie.
set(abut_pkgconfig_dir ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
file(RELATIVE_PATH abut_prefix_from_pkgconfig /${abut_pkgconfig_dir} /)
string(REGEX REPLACE "/$" "" abut_prefix_from_pkgconfig ${abut_prefix_from_pkgconfig})
foreach(package abut abut_picking abut_response)
  if(TARGET ${package})
    configure_file(cmake/${package}.pc.in ${abut_generated_dir}/${package}.pc @ONLY)
    install(FILES ${abut_generated_dir}/${package}.pc DESTINATION ${abut_pkgconfig_dir} COMPONENT dev)
  endif()
endforeach()

if(TARGET abut_cli)
  abut_find_libraries_in(abut_cli "$ORIGIN/../${CMAKE_INSTALL_LIBDIR}")
  install(TARGETS abut_cli RUNTIME COMPONENT tools)
  set(abut_texts $<TARGET_FILE_DIR:abut_cli>)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/tools/report DESTINATION ${CMAKE_INSTALL_DATADIR}/abut COMPONENT tools
          PATTERN __pycache__ EXCLUDE)
  install(FILES ${abut_texts}/abut.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT tools)
  install(FILES ${abut_texts}/abut.bash DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions RENAME abut COMPONENT tools)
  install(FILES ${abut_texts}/_abut DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/site-functions COMPONENT tools)
  install(FILES ${abut_texts}/abut.fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d COMPONENT tools)
endif()

# Folders are as in the source, so that links from one document to another hold.
install(FILES README.md CHANGELOG.md LICENSE NOTICE SECURITY.md DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT docs)
install(DIRECTORY docs examples DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT docs
        PATTERN CMakeLists.txt EXCLUDE PATTERN __pycache__ EXCLUDE)

# Builds what is installed and nothing else.
add_custom_target(abut_product DEPENDS abut abut_modules)
foreach(target abut_picking abut_response abut_cli)
  if(TARGET ${target})
    add_dependencies(abut_product ${target})
  endif()
endforeach()
