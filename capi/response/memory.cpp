// SPDX-License-Identifier: Apache-2.0
// Functions that the linker calls wherever Eigen asks for memory: see abut_wrap_foreign_memory in cmake/flags.cmake.
// The size stands in front of each block.
#include <abut/abut.h>

#include "core/check.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <memory>
#include <new>
#include <span>

namespace {

struct alignas(__STDCPP_DEFAULT_NEW_ALIGNMENT__) Head {
  std::size_t size;  // of the head and of what follows it
};

[[nodiscard]] void* allocate(std::size_t size) noexcept {
  if (size > std::numeric_limits<std::size_t>::max() - sizeof(Head)) return nullptr;
  const std::size_t whole = size + sizeof(Head);
  void* const memory = abut_memory_allocate(whole, alignof(Head));
  if (memory == nullptr) return nullptr;
  Head* const head = std::construct_at(static_cast<Head*>(memory), Head{whole});
  // SAFETY: the block holds a head and `size` bytes behind it.
  ABUT_UNSAFE_BEGIN
  return head + 1;
  ABUT_UNSAFE_END
}

[[nodiscard]] Head* head_of(void* memory) noexcept {
  // SAFETY: all blocks are those of `allocate`.
  ABUT_UNSAFE_BEGIN
  return static_cast<Head*>(memory) - 1;
  ABUT_UNSAFE_END
}

void release(void* memory) noexcept {
  if (memory == nullptr) return;
  Head* const head = head_of(memory);
  abut_memory_release(head, head->size, alignof(Head));
}

[[nodiscard]] void* reallocate(void* memory, std::size_t size) noexcept {
  void* const larger = allocate(size);
  if (larger == nullptr || memory == nullptr) return larger;
  const std::size_t kept = std::min(size, head_of(memory)->size - sizeof(Head));
  // SAFETY: both blocks have as many bytes.
  ABUT_UNSAFE_BEGIN
  const std::span<const std::byte> from(static_cast<const std::byte*>(memory), kept);
  std::ranges::copy(from, static_cast<std::byte*>(larger));
  ABUT_UNSAFE_END
  release(memory);
  return larger;
}

}  // namespace

extern "C" {
void* abut_malloc(std::size_t size) noexcept __asm__("__wrap_malloc");
void* abut_calloc(std::size_t count, std::size_t size) noexcept __asm__("__wrap_calloc");
void* abut_realloc(void* memory, std::size_t size) noexcept __asm__("__wrap_realloc");
void abut_free(void* memory) noexcept __asm__("__wrap_free");
void* abut_new_array(std::size_t size) __asm__("__wrap__Znam");
void abut_delete_array(void* memory) noexcept __asm__("__wrap__ZdaPv");
}

void* abut_malloc(std::size_t size) noexcept { return allocate(size); }
// The compiler makes this of asking for memory and filling it with zeros.
void* abut_calloc(std::size_t count, std::size_t size) noexcept {
  if (size != 0 && count > std::numeric_limits<std::size_t>::max() / size) return nullptr;
  void* const memory = allocate(count * size);
  if (memory == nullptr) return nullptr;
  // SAFETY: the block has as many bytes.
  ABUT_UNSAFE_BEGIN
  std::ranges::fill(std::span(static_cast<std::byte*>(memory), count * size), std::byte{0});
  ABUT_UNSAFE_END
  return memory;
}
void* abut_realloc(void* memory, std::size_t size) noexcept { return reallocate(memory, size); }
void abut_free(void* memory) noexcept { release(memory); }
void* abut_new_array(std::size_t size) {
  void* const memory = allocate(size);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}
void abut_delete_array(void* memory) noexcept { release(memory); }
