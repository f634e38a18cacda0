// SPDX-License-Identifier: Apache-2.0
// The macros of abut, for the global module fragment of modules and for capi/.
#ifndef ABUT_CORE_CHECK_HPP
#define ABUT_CORE_CHECK_HPP

// Brackets the few lines that need raw pointers. The line above says `// SAFETY:` and why.
#define ABUT_UNSAFE_BEGIN _Pragma("clang unsafe_buffer_usage begin")
#define ABUT_UNSAFE_END _Pragma("clang unsafe_buffer_usage end")

// An invariant of ours. A broken one leaves by an exception that only the C border catches, which
// then poisons the universe: a defect of ours must not end the program of our host.
#define ABUT_CHECK(condition)                                  \
  do {                                                         \
    if (!(condition)) [[unlikely]] {                           \
      ::abut::report_bug(#condition, __FILE_NAME__, __LINE__); \
    }                                                          \
  } while (false)

#endif
