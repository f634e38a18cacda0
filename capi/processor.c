/* SPDX-License-Identifier: Apache-2.0 */
/* Ends the process with a sentence where the processor lacks instructions that the library was compiled for. Without it
 * the process would end with an illegal instruction. All else of abut needs this library, so the loader runs this
 * first. */
#include <stdio.h>
#include <stdlib.h>

#define TEXT(text) #text
/* True where the compiler defines the macro: it does so as 1, for each set of instructions that it may use. */
#define USES(macro) (TEXT(macro)[0] == '1')
#define REQUIRE(macro, name)                                                 \
  if (USES(macro) && __builtin_cpu_supports(name) == 0) {                    \
    fputs(lacking ? ", " name : "abut: this processor lacks " name, stderr); \
    lacking = 1;                                                             \
  }

/* Compiled for every processor of the family, unlike the rest. 101 is the first priority that is not reserved. */
__attribute__((target("arch=x86-64"), constructor(101))) static void refuse_lesser_processors(void) {
  int lacking = 0;
  __builtin_cpu_init();
  REQUIRE(__SSE3__, "sse3")
  REQUIRE(__SSSE3__, "ssse3")
  REQUIRE(__SSE4_1__, "sse4.1")
  REQUIRE(__SSE4_2__, "sse4.2")
  REQUIRE(__POPCNT__, "popcnt")
  REQUIRE(__AVX__, "avx")
  REQUIRE(__AVX2__, "avx2")
  REQUIRE(__BMI__, "bmi")
  REQUIRE(__BMI2__, "bmi2")
  REQUIRE(__F16C__, "f16c")
  REQUIRE(__FMA__, "fma")
  REQUIRE(__LZCNT__, "lzcnt")
  REQUIRE(__MOVBE__, "movbe")
  REQUIRE(__AVX512F__, "avx512f")
  REQUIRE(__AVX512BW__, "avx512bw")
  REQUIRE(__AVX512CD__, "avx512cd")
  REQUIRE(__AVX512DQ__, "avx512dq")
  REQUIRE(__AVX512VL__, "avx512vl")
  if (lacking) {
    fputs(", which libabut was built for (ABUT_ARCH is " ABUT_PROJECT_ARCH
          "); configure abut with -D ABUT_ARCH=x86-64 to build it for every 64-bit x86 processor.\n",
          stderr);
    _Exit(EXIT_FAILURE);
  }
}
