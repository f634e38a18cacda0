// SPDX-License-Identifier: Apache-2.0
// A picker has its memory from where abut has it.
#include "picking_support.hpp"

#include <memory_resource>

namespace {

using namespace picking_test;

std::size_t given = 0, taken = 0;
void* give(void*, std::size_t size, std::size_t alignment) {
  ++given;
  return std::pmr::new_delete_resource()->allocate(size, alignment);
}
void take(void*, void* memory, std::size_t size, std::size_t alignment) {
  ++taken;
  std::pmr::new_delete_resource()->deallocate(memory, size, alignment);
}

TEST(PickerMemory, ComesFromTheAllocatorOfTheHost) {
  ASSERT_EQ(abut_set_allocator(give, take, nullptr), ABUT_OK) << abut_last_error_message();
  {
    abut_universe* created = nullptr;
    ASSERT_EQ(abut_universe_create(nullptr, &created), ABUT_OK);
    const Universe universe(created);
    const std::size_t before = given;
    abut_picker* made = nullptr;
    ASSERT_EQ(abut_picker_create(universe.get(), &made), ABUT_OK) << abut_last_error_message();
    const PickerHandle picker(made);
    EXPECT_GT(given, before);
    std::uint64_t bytes = 0, blocks = 0;
    ASSERT_EQ(abut_memory_in_use(&bytes, &blocks), ABUT_OK);
    EXPECT_EQ(blocks, given - taken);
  }
  EXPECT_EQ(given, taken);
  EXPECT_EQ(abut_set_allocator(nullptr, nullptr, nullptr), ABUT_OK) << abut_last_error_message();
}

}  // namespace
