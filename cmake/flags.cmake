# SPDX-License-Identifier: Apache-2.0
# The only place that names a compiler flag.
#
# Module interfaces (BMIs) do not record -D_GLIBCXX_ASSERTIONS, -fsanitize or -march, so a mismatch
# between two translation units is accepted silently and breaks the one-definition rule. Hence
# everything here is set for the whole build tree.

if(NOT CMAKE_CXX_COMPILER_ID STREQUAL "Clang" OR CMAKE_CXX_COMPILER_VERSION VERSION_LESS 19)
  message(FATAL_ERROR "abut needs clang 19 or newer, this is ${CMAKE_CXX_COMPILER_ID} ${CMAKE_CXX_COMPILER_VERSION}. "
                      "Use a preset, such as: cmake --preset release")
endif()

if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release)
endif()
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_CXX_SCAN_FOR_MODULES ON)
set(CMAKE_C_STANDARD 99)
set(CMAKE_C_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_C_VISIBILITY_PRESET hidden)
set(CMAKE_CXX_VISIBILITY_PRESET hidden)
set(CMAKE_VISIBILITY_INLINES_HIDDEN ON)

set(ABUT_ARCH "x86-64-v3" CACHE STRING "Target of -march; empty for the compiler's default")
set(ABUT_SANITIZE "" CACHE STRING
    "address (with undefined), thread, fuzzer (address and undefined), fuzzer-address, fuzzer-undefined, coverage, or empty")
set(ABUT_FUZZ_ENGINE "-fsanitize=fuzzer" CACHE STRING "Links the fuzzing engine, and with it main, to a fuzz target")

# Every warning is an error for those who work on abut. Others are spared the time.
if(ABUT_WARNINGS)
  add_compile_options(
    -Wall -Wextra -Wpedantic -Werror
    -Wdangling -Wdangling-gsl -Wdangling-field -Wdangling-assignment -Wreturn-stack-address
    -Wthread-safety -Wthread-safety-beta
    -Wswitch-enum -Wcovered-switch-default -Wimplicit-fallthrough -Wunused-result
    -Wconversion -Wsign-conversion -Wfloat-conversion -Wdouble-promotion
    -Wshadow-all -Wcast-align -Wcast-qual -Wcast-function-type-strict
    -Wconditional-uninitialized -Wcomma -Wdocumentation -Wmissing-variable-declarations
    "$<$<COMPILE_LANGUAGE:CXX>:-Wold-style-cast;-Wundefined-reinterpret-cast;-Wzero-as-null-pointer-constant>"
    "$<$<COMPILE_LANGUAGE:CXX>:-Wglobal-constructors;-Wexit-time-destructors;-Wnon-virtual-dtor;-Wextra-semi>")
endif()

# Warns in this folder where arrays are used without their bounds: in all that is installed. The compiler reads everything that
# a unit imports for it, which doubles the time of a unit of the library. So builds do it where ABUT_CHECK_BUFFERS says so, as in
# the presets dev and asan, and scripts/lint does it for changed lines. ALWAYS: in every build that stops at warnings.
function(abut_check_buffers)
  if(ABUT_WARNINGS AND (ABUT_CHECK_BUFFERS OR "ALWAYS" IN_LIST ARGN))
    add_compile_options("$<$<COMPILE_LANGUAGE:CXX>:-Wunsafe-buffer-usage;-Wunsafe-buffer-usage-in-container>")
  endif()
endfunction()

# An interface unit is read once for its object and for what importers see, not once for each, and importers see no bodies of
# functions that are not inline.
if(CMAKE_CXX_COMPILER_VERSION VERSION_LESS 20)
  add_compile_options($<$<COMPILE_LANGUAGE:CXX>:-fexperimental-modules-reduced-bmi>)
else()
  add_compile_options($<$<COMPILE_LANGUAGE:CXX>:-fmodules-reduced-bmi>)
endif()

# The same arithmetic on every target: the compiler fuses and reassociates nothing, and sets no errno.
add_compile_options(-ffp-contract=off -fno-math-errno)

# Hardening, also in release. Large scratch arrays of the kernels are written before they are read
# and are left out of the automatic initialisation, which would cost more than the kernels.
add_compile_definitions(_GLIBCXX_ASSERTIONS)
if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
  set(abut_guarded_jumps -fcf-protection=full)
elseif(CMAKE_SYSTEM_PROCESSOR MATCHES "aarch64|arm64")
  set(abut_guarded_jumps -mbranch-protection=standard)
endif()
add_compile_options(-fstack-protector-strong -fstack-clash-protection ${abut_guarded_jumps}
                    -ftrivial-auto-var-init-max-size=256
                    $<IF:$<CONFIG:Debug>,-ftrivial-auto-var-init=pattern,-ftrivial-auto-var-init=zero>)
add_link_options(-fuse-ld=lld -Wl,-z,relro,-z,now)

if(ABUT_ARCH AND CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
  add_compile_options(-march=${ABUT_ARCH})
endif()
# Without AVX, clang says that vectors of four numbers pass differently than with it. They pass between functions of one build only.
if(NOT ABUT_ARCH MATCHES "^x86-64-v[34]$")
  add_compile_options(-Wno-psabi)
endif()

set(CMAKE_CXX_FLAGS_RELEASE "-O3 -DNDEBUG")
# The linker leaves out functions that nobody calls or that are the same as others, and names that are not exported.
set(CMAKE_CXX_FLAGS_MINSIZEREL "-Os -DNDEBUG -ffunction-sections -fdata-sections")
set(CMAKE_SHARED_LINKER_FLAGS_MINSIZEREL "-Wl,--gc-sections -Wl,--icf=safe -Wl,-O2 -Wl,--strip-all")
set(CMAKE_CXX_FLAGS_RELWITHDEBINFO "-O1 -g1")

set(abut_known_sanitizers address thread fuzzer fuzzer-address fuzzer-undefined coverage)
if(ABUT_SANITIZE AND NOT ABUT_SANITIZE IN_LIST abut_known_sanitizers)
  message(FATAL_ERROR "ABUT_SANITIZE is '${ABUT_SANITIZE}'; known are: ${abut_known_sanitizers}")
endif()
set(abut_undefined_checks
    undefined,float-divide-by-zero,implicit-integer-truncation,implicit-integer-sign-change,nullability,local-bounds)
set(abut_sanitize_checks address,${abut_undefined_checks})
if(ABUT_SANITIZE STREQUAL "fuzzer-address")
  set(abut_sanitize_checks address)
elseif(ABUT_SANITIZE STREQUAL "fuzzer-undefined")
  set(abut_sanitize_checks ${abut_undefined_checks})
endif()
if(ABUT_SANITIZE MATCHES "address|fuzzer")
  add_compile_options(-fsanitize-ignorelist=${CMAKE_CURRENT_LIST_DIR}/sanitize_ignore.txt)
endif()
if(ABUT_SANITIZE STREQUAL "address")
  add_compile_options(-fsanitize=${abut_sanitize_checks} -fno-sanitize-recover=all -fno-omit-frame-pointer)
  # Programs in C need the part of the runtime that checks C++ as well: the library that they link has it.
  add_link_options(-fsanitize=${abut_sanitize_checks} -fsanitize-link-c++-runtime)
  string(APPEND CMAKE_C_STANDARD_LIBRARIES " -lstdc++ -lm")
elseif(ABUT_SANITIZE STREQUAL "thread")
  add_compile_options(-fsanitize=thread -fno-omit-frame-pointer)
  add_link_options(-fsanitize=thread)
elseif(ABUT_SANITIZE MATCHES "^fuzzer")
  # The library is instrumented; only the targets link libFuzzer's main function.
  add_compile_options(-fsanitize=fuzzer-no-link,${abut_sanitize_checks} -fno-sanitize-recover=all -fno-omit-frame-pointer)
  add_link_options(-fsanitize=${abut_sanitize_checks})
elseif(ABUT_SANITIZE STREQUAL "coverage")
  # Counts for llvm-cov, which shows the lines that a corpus reaches.
  add_compile_options(-fprofile-instr-generate -fcoverage-mapping)
  add_link_options(-fprofile-instr-generate)
else()
  # A shared library that leaves symbols undefined is found when it is linked, not when it is loaded.
  add_link_options($<$<STREQUAL:$<TARGET_PROPERTY:TYPE>,SHARED_LIBRARY>:-Wl,-z,defs>)
endif()

# The source tells at load time whether the processor has what ABUT_ARCH asks of it.
function(abut_check_processor target source)
  if(ABUT_ARCH AND CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
    target_sources(${target} PRIVATE ${source})
    set_source_files_properties(${source} PROPERTIES COMPILE_DEFINITIONS "ABUT_PROJECT_ARCH=\"${ABUT_ARCH}\"")
  endif()
endfunction()

# A source that speaks to ThreadSanitizer for a library that it does not see into.
function(abut_speak_for_thread_sanitizer source)
  if(ABUT_SANITIZE STREQUAL "thread")
    set_source_files_properties(${source} PROPERTIES COMPILE_OPTIONS -fno-sanitize=thread COMPILE_DEFINITIONS ABUT_TSAN)
  endif()
endfunction()
# Code of others, and tests, that the warnings above are not meant for.
function(abut_relax_for_tests target)
  target_compile_options(${target} PRIVATE -Wno-global-constructors -Wno-exit-time-destructors)
endfunction()
# Sources that compute in more digits than they are given: there promotion is wanted.
function(abut_compute_in_more_digits)
  set_source_files_properties(${ARGN} PROPERTIES COMPILE_OPTIONS -Wno-double-promotion)
endfunction()
function(abut_link_fuzzer target)
  target_link_options(${target} PRIVATE ${ABUT_FUZZ_ENGINE})
endfunction()
# A shared library that calls back into the engine of the program that loads it.
function(abut_call_fuzzer target)
  target_link_options(${target} PRIVATE LINKER:-z,undefs)
endfunction()
# What consumers of the installed modules must share with us: layout, arithmetic, and what clang
# compares between a module and its importer. The rest of the options stays here.
function(abut_export_flags target)
  set(options -ffp-contract=off -fno-math-errno)
  if(ABUT_ARCH AND CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
    list(APPEND options -march=${ABUT_ARCH})
  endif()
  target_compile_options(${target} INTERFACE "$<INSTALL_INTERFACE:${options}>")
  target_compile_definitions(${target} INTERFACE $<INSTALL_INTERFACE:_GLIBCXX_ASSERTIONS>)
endfunction()
# A shared library exports what its list of symbols names, under one version, and nothing of the archives inside it.
function(abut_limit_exports target version symbols_file)
  set(list ${CMAKE_CURRENT_SOURCE_DIR}/${symbols_file})
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${list})
  file(STRINGS ${list} symbols)
  list(JOIN symbols "; " symbols)
  set(script ${CMAKE_CURRENT_BINARY_DIR}/${target}.map)
  file(CONFIGURE OUTPUT ${script} CONTENT "${version} { global: ${symbols}; local: *; };\n" @ONLY)
  target_link_options(${target} PRIVATE LINKER:--version-script=${script} LINKER:--exclude-libs,ALL)
  set_property(TARGET ${target} APPEND PROPERTY LINK_DEPENDS ${script})
endfunction()

# Threads of oneTBB sleep in a library after its calls are over, and wake up in it when the process ends. A host that
# unloads the library must not take it from under them.
function(abut_keep_loaded target)
  target_link_options(${target} PRIVATE LINKER:-z,nodelete)
endfunction()

# Uses of operator new and delete inside a shared library become calls of its own functions, which operator_new.cpp defines
# as __wrap_ and the name. What the process has under the name stays as it is, and is called __real_ and the name. These are
# the forms without an exception of their own and with a size, of targets where a size has 64 bits.
function(abut_wrap_memory target)
  foreach(name _Znwm _ZnwmSt11align_val_t _ZdlPvm _ZdlPvmSt11align_val_t)
    target_link_options(${target} PRIVATE LINKER:--wrap=${name})
  endforeach()
endfunction()

# The same for memory of Eigen, which comes from malloc and from arrays and whose size is not told when it is given back.
function(abut_wrap_foreign_memory target)
  foreach(name malloc calloc realloc free _Znam _ZdaPv)
    target_link_options(${target} PRIVATE LINKER:--wrap=${name})
  endforeach()
endfunction()

# Rarely run, and large where calls are taken apart.
function(abut_compile_smallest source)
  set_property(SOURCE ${source} APPEND PROPERTY COMPILE_OPTIONS $<$<CONFIG:MinSizeRel>:-Oz>)
endfunction()

# For tests that spend their time in the library; none that imports a module, whose options have to be alike.
function(abut_compile_unoptimised target)
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O0>)
endfunction()

# For programs whose compiling takes longer than their running.
function(abut_compile_quickly target)
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
endfunction()
