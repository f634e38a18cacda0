// SPDX-License-Identifier: Apache-2.0
// Where memory comes from: operator new of the process, or the functions that the host has set.
//
// The allocator of the host replaces operator new inside the shared library only, by the linker (abut_wrap_memory).
// Types need no allocators. A private copy of libstdc++ would add hundreds of kB, and its exceptions would pass through
// oneTBB from a second runtime. The replacement is sound because strings and containers of C++20 are compiled into this
// library: its calls into libstdc++.so neither take nor give memory. tests/symbols checks that only the four forms of
// operator new and delete are imported, and tests/steady that nothing calls malloc. If the host sets nothing, the
// process's own operator new is called, so hosts that replace it, and sanitizers, work as before.
//
// The host's two functions can only be set while no block is in use, since each block has to return to its allocator. A
// word before each block would record that but cost 16 bytes a block, so blocks are counted instead, by thread.
#include "border.hpp"
#include "guard.hpp"

import abut.core.memory.spare_blocks;

// Those of the process. The linker knows them by these names; every other use of operator new and delete in this
// library is a call of operator_new.cpp. An alignment passes as the number that it is.
extern "C" {
void* abut_process_new(std::size_t size) __asm__("__real__Znwm");
void* abut_process_new_aligned(std::size_t size, std::size_t alignment) __asm__("__real__ZnwmSt11align_val_t");
void abut_process_delete(void* memory, std::size_t size) noexcept __asm__("__real__ZdlPvm");
void abut_process_delete_aligned(void* memory, std::size_t size, std::size_t alignment) noexcept
    __asm__("__real__ZdlPvmSt11align_val_t");
}

namespace abut::capi {
namespace {

// What operator new gives without being asked for more.
constexpr std::size_t usual_alignment = __STDCPP_DEFAULT_NEW_ALIGNMENT__;

void* allocate_from_process(void* /*context*/, std::size_t size, std::size_t alignment) noexcept {
  try {
    return alignment <= usual_alignment ? abut_process_new(size) : abut_process_new_aligned(size, alignment);
  } catch (...) {
    return nullptr;
  }
}

void release_to_process(void* /*context*/, void* memory, std::size_t size, std::size_t alignment) noexcept {
  if (alignment <= usual_alignment) {
    abut_process_delete(memory, size);
  } else {
    abut_process_delete_aligned(memory, size, alignment);
  }
}

// Written while no memory is in use. So whoever has a block has seen which functions gave it.
constinit std::atomic<abut_allocate> present_allocate{allocate_from_process};
constinit std::atomic<abut_release> present_release{release_to_process};
constinit std::atomic<void*> present_context{nullptr};

// What a thread has asked for and not given back. Another thread may give it back, so that a share may be negative.
// Each has a line of the cache, or threads would wait for each other.
struct alignas(64) Share {
  std::atomic<std::int64_t> bytes{0};
  std::atomic<std::int64_t> blocks{0};
};
constexpr std::size_t share_count = 256;
constinit std::array<Share, share_count> shares{};
// The last share is that of all threads that came too late for one of their own.
constexpr std::size_t common_share = share_count - 1;
constinit std::atomic<std::size_t> seen_threads{0};
constinit thread_local Share* own_share = nullptr;

// Alone on a share, a thread adds without a locked instruction, each of which takes 5 ns.
void add(std::atomic<std::int64_t>& sum, std::int64_t more, bool is_alone) noexcept {
  if (is_alone) [[likely]] {
    sum.store(sum.load(std::memory_order_relaxed) + more, std::memory_order_relaxed);
  } else {
    sum.fetch_add(more, std::memory_order_relaxed);
  }
}

void count(std::int64_t bytes, std::int64_t blocks) noexcept {
  Share* its = own_share;
  if (its == nullptr) [[unlikely]] {
    its = own_share = &shares[std::min(seen_threads.fetch_add(1, std::memory_order_relaxed), common_share)];
  }
  const bool is_alone = its != &shares[common_share];
  add(its->bytes, bytes, is_alone);
  add(its->blocks, blocks, is_alone);
}

struct InUse {
  std::uint64_t bytes;
  std::uint64_t blocks;
};

// While threads ask and give back this is about right, and never below zero.
InUse in_use() noexcept {
  std::int64_t bytes = 0;
  std::int64_t blocks = 0;
  for (const Share& share : shares) {
    bytes += share.bytes.load(std::memory_order_relaxed);
    blocks += share.blocks.load(std::memory_order_relaxed);
  }
  return {static_cast<std::uint64_t>(std::max<std::int64_t>(bytes, 0)),
          static_cast<std::uint64_t>(std::max<std::int64_t>(blocks, 0))};
}

std::int64_t signed_size(std::size_t size) noexcept { return static_cast<std::int64_t>(size); }

bool is_alignment(std::size_t number) noexcept { return number != 0 && (number & (number - 1)) == 0; }

// Two requests have two addresses, also where nothing is asked for. In steps blocks of one size serve each other, and
// allocators hand out no smaller ones anyway.
std::size_t size_of_block(std::size_t asked) noexcept {
  constexpr std::size_t unit = 16, largest = std::numeric_limits<std::size_t>::max() / unit * unit;
  return asked == 0 ? unit : asked > largest ? asked : (asked + (unit - 1)) / unit * unit;
}

bool is_aligned(const void* memory, std::size_t alignment) noexcept {
  return (std::bit_cast<std::uintptr_t>(memory) & (alignment - 1)) == 0;
}

}  // namespace
}  // namespace abut::capi

using namespace abut::capi;

void* abut_memory_allocate(size_t size, size_t alignment) {
  if (!is_alignment(alignment)) {
    return nullptr;
  }
  const std::size_t whole = size_of_block(size);
  const std::size_t at_least = std::max(alignment, usual_alignment);
  if (void* const spare = abut::SpareBlocks::take(whole, at_least)) {
    return spare;
  }
  void* const context = present_context.load(std::memory_order_relaxed);
  void* const memory = present_allocate.load(std::memory_order_acquire)(context, whole, at_least);
  if (memory == nullptr) [[unlikely]] {
    return nullptr;
  }
  if (!is_aligned(memory, at_least)) [[unlikely]] {
    present_release.load(std::memory_order_acquire)(context, memory, whole, at_least);
    return nullptr;
  }
  count(signed_size(whole), 1);
  return memory;
}

void abut_memory_release(void* memory, size_t size, size_t alignment) {
  if (memory == nullptr) {
    return;
  }
  const std::size_t whole = size_of_block(size), at_least = std::max(alignment, usual_alignment);
  if (abut::SpareBlocks::keep(memory, whole, at_least)) {
    return;
  }
  void* const context = present_context.load(std::memory_order_relaxed);
  present_release.load(std::memory_order_acquire)(context, memory, whole, at_least);
  count(-signed_size(whole), -1);
}

abut_status abut_memory_in_use(uint64_t* bytes, uint64_t* blocks) {
  return guard([&] {
    // Before a message is put together.
    const InUse found = in_use();
    const abut_status status = check_none_null(NamedPointers<2>{{{"bytes", bytes}, {"blocks", blocks}}});
    if (status == ABUT_OK) {
      *bytes = found.bytes;
      *blocks = found.blocks;
    }
    return status;
  });
}

abut_status abut_set_allocator(abut_allocate allocate, abut_release release, void* context) {
  return guard([&]() -> abut_status {
    if ((allocate == nullptr) != (release == nullptr)) {
      return check_not_null(allocate == nullptr ? "allocate" : "release", nullptr);
    }
    if (const InUse found = in_use(); found.blocks != 0) {
      return refuse(ABUT_BUSY, "abut still has " + std::to_string(found.blocks) + " blocks of memory, " +
                                   std::to_string(found.bytes) +
                                   " bytes: release all shapes and destroy all universes and pickers first");
    }
    present_context.store(context, std::memory_order_relaxed);
    present_allocate.store(allocate == nullptr ? allocate_from_process : allocate, std::memory_order_release);
    present_release.store(release == nullptr ? release_to_process : release, std::memory_order_release);
    return ABUT_OK;
  });
}
