# SPDX-License-Identifier: Apache-2.0
# libabut_response.so: response.h on top of abut.h. Included by the CMakeLists.txt above.
file(GLOB sources CONFIGURE_DEPENDS response/*.cpp)
add_library(abut_response SHARED extension_arguments.cpp operator_new.cpp ${sources})
add_library(abut::response ALIAS abut_response)
target_link_libraries(abut_response PUBLIC abut::abut PRIVATE abut_response_modules)
target_include_directories(abut_response PRIVATE ${CMAKE_CURRENT_SOURCE_DIR} ${PROJECT_SOURCE_DIR}/modules)
abut_wrap_memory(abut_response)
abut_wrap_foreign_memory(abut_response)
abut_limit_exports(abut_response ABUT_RESPONSE_0 response_symbols.txt)
set_target_properties(abut_response PROPERTIES
  VERSION ${PROJECT_VERSION} SOVERSION ${abut_soversion})
