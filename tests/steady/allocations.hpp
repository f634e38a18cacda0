// SPDX-License-Identifier: Apache-2.0
// Counts what is asked of the allocator: malloc and its like are those of this program, and hand on to those of the C
// library.
#pragma once

#include <cstddef>
#include <string>

namespace steady {

struct Allocations {
  std::size_t calls = 0;     // of everyone but oneTBB, on all threads
  std::size_t of_tbb = 0;    // by its scheduler, which keeps its tasks in pools that grow when they have to
  std::string first_places;  // where the first ones came from, as addresses of the callers and their objects
};

// What is asked for from here to the call of `stop`. One at a time.
class AllocationCounter {
 public:
  AllocationCounter();
  ~AllocationCounter();
  AllocationCounter(const AllocationCounter&) = delete;
  AllocationCounter& operator=(const AllocationCounter&) = delete;
  Allocations stop();
};

// While it lives, one request is refused: the one that comes after so many others. Single-threaded.
class RefusedAllocation {
 public:
  explicit RefusedAllocation(std::size_t after);
  ~RefusedAllocation();
  RefusedAllocation(const RefusedAllocation&) = delete;
  RefusedAllocation& operator=(const RefusedAllocation&) = delete;
};

// Bytes that are handed out and not given back at present, by all threads.
std::size_t live_bytes();

}  // namespace steady
