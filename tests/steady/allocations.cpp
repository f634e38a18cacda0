// SPDX-License-Identifier: Apache-2.0
#include "allocations.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <cstddef>
#include <cstdlib>
#include <sstream>
#include <string_view>

#include <dlfcn.h>
#include <execinfo.h>
#include <malloc.h>

// The allocator of glibc under the names that it keeps for those who define malloc themselves.
extern "C" {
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* old, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);
void __libc_free(void* given);
}

namespace steady {
namespace {

std::atomic<bool> is_counting = false;
std::atomic<std::size_t> calls = 0, of_tbb = 0;
std::atomic<std::size_t> bytes = 0;

// The callers of the first few.
constexpr std::size_t most_traces = 4;
using Trace = std::array<void*, 24>;
std::array<Trace, most_traces> traces;

// dladdr looks it up in the lists of the loader and allocates nothing.
bool is_tbb(const void* caller) {
  Dl_info object;
  return dladdr(caller, &object) != 0 && std::string_view(object.dli_fname).find("libtbb") != std::string_view::npos;
}

// Called by the functions below, each of which has the code that asks as its caller.
void note(void* given, const void* caller) {
  if (given == nullptr) {
    return;
  }
  bytes.fetch_add(malloc_usable_size(given), std::memory_order_relaxed);
  if (!is_counting.load(std::memory_order_relaxed)) {
    return;
  }
  if (is_tbb(caller)) {
    of_tbb.fetch_add(1, std::memory_order_relaxed);
    return;
  }
  const std::size_t number = calls.fetch_add(1, std::memory_order_relaxed);
  if (number < most_traces) {
    Trace& trace = traces.at(number);
    trace.fill(nullptr);
    // It was called once before, so that it has nothing to load any more.
    backtrace(trace.data(), static_cast<int>(trace.size()));
  }
}

// Requests that are still granted; none is refused while it is negative.
std::atomic<std::ptrdiff_t> grants = -1;
bool is_refused() {
  return grants.load(std::memory_order_relaxed) >= 0 && grants.fetch_sub(1, std::memory_order_relaxed) == 0;
}

void forget(void* given) { bytes.fetch_sub(malloc_usable_size(given), std::memory_order_relaxed); }

void* aligned(std::size_t alignment, std::size_t size, const void* caller) {
  void* given = is_refused() ? nullptr : __libc_memalign(alignment, size);
  note(given, caller);
  return given;
}

}  // namespace

AllocationCounter::AllocationCounter() {
  Trace first;
  backtrace(first.data(), static_cast<int>(first.size()));
  calls = of_tbb = 0;
  is_counting = true;
}

AllocationCounter::~AllocationCounter() { is_counting = false; }

Allocations AllocationCounter::stop() {
  is_counting = false;
  std::ostringstream places;
  for (std::size_t i = 0; i < std::min(calls.load(), most_traces); ++i) {
    places << "allocation " << i << ":\n";
    for (void* address : traces.at(i)) {
      Dl_info object;
      if (address != nullptr && dladdr(address, &object) != 0) {
        places << "  " << address << " in " << object.dli_fname << " at " << object.dli_fbase << "\n";
      }
    }
  }
  return {calls, of_tbb, places.str()};
}

RefusedAllocation::RefusedAllocation(std::size_t after) { grants = static_cast<std::ptrdiff_t>(after); }
RefusedAllocation::~RefusedAllocation() { grants = -1; }

std::size_t live_bytes() { return bytes; }

}  // namespace steady

// Seen by all libraries of the process, or they would call the C library's own.
#pragma GCC visibility push(default)
extern "C" {

void* malloc(std::size_t size) {
  void* given = steady::is_refused() ? nullptr : __libc_malloc(size);
  steady::note(given, __builtin_return_address(0));
  return given;
}

void* calloc(std::size_t count, std::size_t size) {
  void* given = steady::is_refused() ? nullptr : __libc_calloc(count, size);
  steady::note(given, __builtin_return_address(0));
  return given;
}

void* realloc(void* old, std::size_t size) {
  if (steady::is_refused()) {
    return nullptr;
  }
  if (old != nullptr) {
    steady::forget(old);
  }
  void* given = __libc_realloc(old, size);
  steady::note(given, __builtin_return_address(0));
  return given;
}

void free(void* given) {
  if (given != nullptr) {
    steady::forget(given);
  }
  __libc_free(given);
}

void* memalign(std::size_t alignment, std::size_t size) {
  return steady::aligned(alignment, size, __builtin_return_address(0));
}

void* aligned_alloc(std::size_t alignment, std::size_t size) {
  return steady::aligned(alignment, size, __builtin_return_address(0));
}

int posix_memalign(void** out, std::size_t alignment, std::size_t size) {
  void* given = steady::aligned(alignment, size, __builtin_return_address(0));
  if (given == nullptr) {
    return ENOMEM;
  }
  *out = given;
  return 0;
}

}  // extern "C"
#pragma GCC visibility pop
