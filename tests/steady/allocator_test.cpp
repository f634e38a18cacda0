// SPDX-License-Identifier: Apache-2.0
// Where the host gives the memory, abut asks nobody else.
#include "allocations.hpp"
#include "life.hpp"
#include "support.hpp"

#include <array>
#include <atomic>
#include <cstddef>

namespace {

using namespace abut_test;
using steady::AllocationCounter;
using steady::Allocations;

// Memory that is there from the beginning and used once, so that the allocator itself asks for none.
alignas(4096) std::array<unsigned char, std::size_t{1} << 26> room;
std::atomic<std::size_t> used = 0, given = 0, taken = 0;

void* give(void*, std::size_t size, std::size_t alignment) {
  ++given;
  const std::size_t end = used.fetch_add(size + alignment) + size + alignment;
  return end > room.size() ? nullptr : &room.at((end - size) / alignment * alignment);
}
void take(void*, void*, std::size_t, std::size_t) { ++taken; }

class HostMemory : public testing::Test {
 protected:
  // What other libraries ask for once is theirs by now. One thread: oneTBB has its lists from elsewhere.
  void SetUp() override {
    ASSERT_EQ(live_once(true, 1), ABUT_OK);
    require(abut_set_allocator(give, take, nullptr));
  }
  void TearDown() override { require(abut_set_allocator(nullptr, nullptr, nullptr)); }
};

TEST_F(HostMemory, IsAllThatIsAskedFor) {
  AllocationCounter counter;
  const int status = live_once(false, 1);
  const Allocations around = counter.stop();
  EXPECT_EQ(status, ABUT_OK);
  EXPECT_EQ(around.calls, 0U) << around.first_places;
  EXPECT_GT(given, 100U);
  EXPECT_EQ(given, taken);
}

// Qhull asks the C library while a hull is made; the hull itself is of the host's memory.
TEST_F(HostMemory, HoldsHullsAsWell) {
  AllocationCounter counter;
  const std::size_t before = steady::live_bytes();
  const Shape hull = make_octahedron(1);
  EXPECT_GT(counter.stop().calls, 0U) << "if Qhull asks for nothing, it belongs to the test above";
  EXPECT_EQ(steady::live_bytes(), before);
  EXPECT_GT(given, taken);
}

}  // namespace
