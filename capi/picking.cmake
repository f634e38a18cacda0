# libabut_picking.so: picking.h on top of abut.h. Included by CMakeLists.txt beside it.
add_library(abut_picking SHARED picking.cpp picking_arguments.cpp picking_source.cpp)
add_library(abut::picking ALIAS abut_picking)
target_link_libraries(abut_picking PUBLIC abut::abut PRIVATE abut_picking_modules)
target_include_directories(abut_picking PRIVATE ${CMAKE_CURRENT_SOURCE_DIR} ${PROJECT_SOURCE_DIR}/modules)
target_link_options(abut_picking PRIVATE
  -Wl,--version-script=${CMAKE_CURRENT_SOURCE_DIR}/picking.map -Wl,--exclude-libs,ALL)
set_target_properties(abut_picking PROPERTIES
  LINK_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/picking.map
  VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR})
