# SPDX-License-Identifier: Apache-2.0
# libabut_picking.so: picking.h on top of abut.h. Included by the CMakeLists.txt above.
file(GLOB sources CONFIGURE_DEPENDS picking/*.cpp)
add_library(abut_picking SHARED extension_arguments.cpp operator_new.cpp ${sources})
add_library(abut::picking ALIAS abut_picking)
target_link_libraries(abut_picking PUBLIC abut::abut PRIVATE abut_picking_modules)
target_include_directories(abut_picking PRIVATE ${CMAKE_CURRENT_SOURCE_DIR} ${PROJECT_SOURCE_DIR}/modules)
abut_wrap_memory(abut_picking)
abut_limit_exports(abut_picking ABUT_PICKING_0 picking_symbols.txt)
abut_keep_loaded(abut_picking)
set_target_properties(abut_picking PROPERTIES
  VERSION ${PROJECT_VERSION} SOVERSION ${abut_soversion})
