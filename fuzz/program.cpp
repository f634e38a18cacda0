// SPDX-License-Identifier: Apache-2.0
// The program of all pairs. Its main function is that of the engine; what the engine calls lies in a shared library, so
// that a copy of the program for each pair stays small.
#include <cstddef>
#include <cstdint>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

// Names the target, which others look for in a program, and makes the linker load the library of an engine without it.
[[gnu::used]] static int (*const target)(const std::uint8_t*, std::size_t) = LLVMFuzzerTestOneInput;
