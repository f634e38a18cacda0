// Marks the few places of these tests that read through a pointer and a count of the C interface.
#pragma once

#if defined(__clang__)
#define ABUT_TEST_UNSAFE_BEGIN \
  _Pragma("clang diagnostic push") _Pragma("clang diagnostic ignored \"-Wunsafe-buffer-usage\"") \
      _Pragma("clang diagnostic ignored \"-Wunsafe-buffer-usage-in-container\"")
#define ABUT_TEST_UNSAFE_END _Pragma("clang diagnostic pop")
#else
#define ABUT_TEST_UNSAFE_BEGIN
#define ABUT_TEST_UNSAFE_END
#endif
