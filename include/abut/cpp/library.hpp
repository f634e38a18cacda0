// SPDX-License-Identifier: Apache-2.0
// The library that was loaded: its version, its features, the layout of its structs.
#ifndef ABUT_CPP_LIBRARY_HPP
#define ABUT_CPP_LIBRARY_HPP

#include <abut/abut.h>
#include <abut/cpp/answer.hpp>
#include <abut/cpp/values.hpp>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace abut {
inline namespace ABUT_ANSWERS {

// Such as "0.2.0".
[[nodiscard]] inline std::string version() { return abut_version_string(); }

// Whether the loaded library understands the header that this was compiled with.
inline Answer<void> check_version() {
  return detail::answer(abut_check_version(ABUT_VERSION_MAJOR, ABUT_VERSION_MINOR));
}

[[nodiscard]] inline bool has_feature(const std::string& name) { return abut_has_feature(name.c_str()) != 0; }

// Hears of failures in the whole process; null for nothing. It may be called by several threads at once.
inline Answer<void> set_log(abut_log log, void* context = nullptr, abut_log_level most = ABUT_LOG_WARNING) {
  return detail::answer(abut_set_log(log, context, most));
}

// Where the memory of the library comes from in the whole process; two times null for operator new. Before the first
// shape and universe, or after the last one.
inline Answer<void> set_allocator(abut_allocate allocate, abut_release release, void* context = nullptr) {
  return detail::answer(abut_set_allocator(allocate, release, context));
}

struct Memory {
  std::uint64_t bytes = 0;
  std::uint64_t blocks = 0;
};

// What the library has.
[[nodiscard]] inline Answer<Memory> memory_in_use() {
  Memory memory;
  const abut_status status = abut_memory_in_use(&memory.bytes, &memory.blocks);
  return detail::answer(status, memory);
}

// For extension libraries: memory from where the library has its own; null where there is none.
[[nodiscard]] inline void* allocate_memory(std::size_t size,
                                           std::size_t alignment = alignof(std::max_align_t)) noexcept {
  return abut_memory_allocate(size, alignment);
}
// With the size and the alignment that it was asked for.
inline void release_memory(void* memory, std::size_t size,
                           std::size_t alignment = alignof(std::max_align_t)) noexcept {
  abut_memory_release(memory, size, alignment);
}

// Offsets and sizes of all structs, for bindings that check their own.
[[nodiscard]] inline Answer<std::vector<LayoutEntry>> layout() {
  std::vector<LayoutEntry> entries(abut_layout_count());
  abut_status status = ABUT_OK;
  for (std::size_t i = 0; i < entries.size() && status == ABUT_OK; ++i) status = abut_layout_at(i, &entries[i]);
  return detail::answer(status, entries);
}

}  // namespace ABUT_ANSWERS
}  // namespace abut

#endif
