// SPDX-License-Identifier: Apache-2.0
// What the linker calls wherever this library uses operator new and delete: see abut_wrap_memory in cmake/flags.cmake.
// These forms are all that it uses, which tests/symbols watches; each tells the size of what is given back.
// This file is part of two libraries, of which one imports no modules.
#include <abut/abut.h>

#include <cstddef>
#include <new>

namespace {

constexpr std::size_t usual_alignment = __STDCPP_DEFAULT_NEW_ALIGNMENT__;

void* allocate(std::size_t size, std::size_t alignment) {
  void* const memory = abut_memory_allocate(size, alignment);
  if (memory == nullptr) [[unlikely]] {
    throw std::bad_alloc();
  }
  return memory;
}

}  // namespace

extern "C" {
void* abut_new(std::size_t size) __asm__("__wrap__Znwm");
void* abut_new_aligned(std::size_t size, std::align_val_t alignment) __asm__("__wrap__ZnwmSt11align_val_t");
void abut_delete(void* memory, std::size_t size) noexcept __asm__("__wrap__ZdlPvm");
void abut_delete_aligned(void* memory, std::size_t size, std::align_val_t alignment) noexcept
    __asm__("__wrap__ZdlPvmSt11align_val_t");
}

void* abut_new(std::size_t size) { return allocate(size, usual_alignment); }

void* abut_new_aligned(std::size_t size, std::align_val_t alignment) {
  return allocate(size, static_cast<std::size_t>(alignment));
}

void abut_delete(void* memory, std::size_t size) noexcept { abut_memory_release(memory, size, usual_alignment); }

void abut_delete_aligned(void* memory, std::size_t size, std::align_val_t alignment) noexcept {
  abut_memory_release(memory, size, static_cast<std::size_t>(alignment));
}
