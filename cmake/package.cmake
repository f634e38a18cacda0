# SPDX-License-Identifier: Apache-2.0
# Debian packages by CPack: libabut0.2, libabut-picking0.2, libabut-response0.2, libabut-dev and abut-tools. `scripts/package` builds them.
# A runtime package has the soname in its name, so packages of two minor versions can be installed side by side.
find_program(abut_dpkg dpkg)
mark_as_advanced(abut_dpkg)
if(NOT abut_dpkg)
  return()
endif()

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME abut)
set(CPACK_PACKAGE_CONTACT "The maintainers of abut <maintainers@abut.invalid>" CACHE STRING "Maintainer of packages")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_COMPONENTS_GROUPING ONE_PER_GROUP)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_PACKAGE_SECTION libs)
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${PROJECT_BINARY_DIR}/capi)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS_POLICY "=")

set(abut_runtime libabut${abut_soversion})
set(abut_picking_runtime libabut-picking${abut_soversion})
set(abut_response_runtime libabut-response${abut_soversion})
string(TIMESTAMP abut_package_date "%a, %d %b %Y %H:%M:%S +0000" UTC)

# Tells the system that the list of libraries has changed.
file(WRITE ${PROJECT_BINARY_DIR}/package/triggers "activate-noawait ldconfig\n")

# abut_package(name component... DESCRIPTION text SECTION section [DEPENDS text] [SUGGESTS text])
# Variables of CPack are of the including file, hence a macro.
macro(abut_package name)
  cmake_parse_arguments(package "" "DESCRIPTION;SECTION;DEPENDS;SUGGESTS" "" ${ARGN})
  string(MAKE_C_IDENTIFIER ${name} group)
  string(TOUPPER ${group} group_upper)
  # Licence and history of each package, which Debian asks for and a plain installation has elsewhere.
  set(documents ${PROJECT_BINARY_DIR}/package/${name})
  configure_file(cmake/package-copyright.in ${documents}/copyright @ONLY)
  configure_file(cmake/package-changelog.in ${documents}/changelog @ONLY)
  file(ARCHIVE_CREATE OUTPUT ${documents}/changelog.gz PATHS ${documents}/changelog FORMAT raw COMPRESSION GZip
       COMPRESSION_LEVEL 9)
  install(FILES ${documents}/copyright ${documents}/changelog.gz DESTINATION share/doc/${name}
          COMPONENT ${group}_documents EXCLUDE_FROM_ALL)
  list(APPEND CPACK_COMPONENTS_ALL ${package_UNPARSED_ARGUMENTS} ${group}_documents)
  foreach(component ${package_UNPARSED_ARGUMENTS} ${group}_documents)
    string(TOUPPER ${component} component_upper)
    set(CPACK_COMPONENT_${component_upper}_GROUP ${group})
  endforeach()
  set(CPACK_DEBIAN_${group_upper}_PACKAGE_NAME ${name})
  set(CPACK_DEBIAN_${group_upper}_DESCRIPTION "${package_DESCRIPTION}")
  set(CPACK_DEBIAN_${group_upper}_PACKAGE_SECTION ${package_SECTION})
  set(CPACK_DEBIAN_${group_upper}_PACKAGE_DEPENDS "${package_DEPENDS}")
  set(CPACK_DEBIAN_${group_upper}_PACKAGE_SUGGESTS "${package_SUGGESTS}")
  if("${package_SECTION}" STREQUAL libs)
    set(CPACK_DEBIAN_${group_upper}_PACKAGE_CONTROL_EXTRA ${PROJECT_BINARY_DIR}/package/triggers)
  endif()
endmacro()

set(abut_dev_depends "${abut_runtime} (= ${PROJECT_VERSION})")
set(CPACK_COMPONENTS_ALL "")
abut_package(${abut_runtime} library SECTION libs
             DESCRIPTION "The C library: signed distances, contacts and rays for two shapes, or for\na universe of many moving ones.")
if(TARGET abut_picking)
  abut_package(${abut_picking_runtime} picking SECTION libs DEPENDS "${abut_runtime} (= ${PROJECT_VERSION})"
               DESCRIPTION "The picking library: rays, the mouse and pictures against the universes\nof abut, through Embree.")
  string(APPEND abut_dev_depends ", ${abut_picking_runtime} (= ${PROJECT_VERSION})")
endif()
if(TARGET abut_response)
  abut_package(${abut_response_runtime} response SECTION libs DEPENDS "${abut_runtime} (= ${PROJECT_VERSION})"
               DESCRIPTION "The response library: impulses of contacts and velocities of bodies, with\nthe error of each answer.")
  string(APPEND abut_dev_depends ", ${abut_response_runtime} (= ${PROJECT_VERSION})")
endif()
abut_package(libabut-dev dev modules docs SECTION libdevel DEPENDS "${abut_dev_depends}"
             SUGGESTS "cmake (>= 3.28), clang-19, clang-tools-19, ninja-build, libccd-dev, libqhull-dev, libtbb-dev"
             DESCRIPTION "Development files: C headers, files for pkg-config and CMake, C++\nmodules with their static library, documents. Importing the modules needs\nthe suggested packages.")
if(TARGET abut_cli)
  abut_package(abut-tools tools SECTION science DEPENDS "${abut_runtime} (= ${PROJECT_VERSION})"
               DESCRIPTION "The program abut: steps scenes that are written as JSON, writes their\ncontacts, and explains what was done.")
endif()
include(CPack)
