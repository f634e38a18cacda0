# SPDX-License-Identifier: Apache-2.0
# libabut_response.so: response.h on top of abut.h. Included by CMakeLists.txt beside it.
add_library(abut_response SHARED extension_arguments.cpp operator_new.cpp problem_arguments.cpp response.cpp
            response_arguments.cpp response_elastic.cpp response_holes.cpp response_links.cpp response_manager.cpp response_mass.cpp response_memory.cpp response_particles.cpp
            response_problem.cpp response_report.cpp response_source.cpp response_surfaces.cpp)
add_library(abut::response ALIAS abut_response)
target_link_libraries(abut_response PUBLIC abut::abut PRIVATE abut_response_modules)
target_include_directories(abut_response PRIVATE ${CMAKE_CURRENT_SOURCE_DIR} ${PROJECT_SOURCE_DIR}/modules)
abut_wrap_memory(abut_response)
abut_wrap_foreign_memory(abut_response)
abut_limit_exports(abut_response ABUT_RESPONSE_0 response_symbols.txt)
set_target_properties(abut_response PROPERTIES
  VERSION ${PROJECT_VERSION} SOVERSION ${abut_soversion})
