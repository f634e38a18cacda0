// SPDX-License-Identifier: Apache-2.0
// Where memory comes from.
#include "ledger.hpp"

namespace {

using namespace abut_test;

TEST(SetAllocator, RefusesNullForOneOfTheTwo) {
  const auto give = [](void*, std::size_t, std::size_t) -> void* { return nullptr; };
  const auto take = [](void*, void*, std::size_t, std::size_t) {};
  EXPECT_TRUE(refused(abut_set_allocator(give, nullptr, nullptr), ABUT_NULL_ARGUMENT, {"release is null"}));
  EXPECT_TRUE(refused(abut_set_allocator(nullptr, take, nullptr), ABUT_NULL_ARGUMENT, {"allocate is null"}));
  // Nothing has changed: memory still comes from the process.
  const Shape ball = make_sphere(1);
  EXPECT_NE(ball, nullptr);
}

TEST(SetAllocator, RefusesToChangeWhileMemoryIsInUse) {
  Ledger ledger;
  {
    const Shape ball = make_sphere(1);
    std::uint64_t bytes = 0, blocks = 0;
    require(abut_memory_in_use(&bytes, &blocks));
    EXPECT_TRUE(refused(abut_set_allocator(nullptr, nullptr, nullptr), ABUT_BUSY,
                        {std::to_string(blocks) + " blocks", std::to_string(bytes) + " bytes", "release all shapes"}));
    const std::size_t asked = ledger.asked();
    const Shape other = make_sphere(1);
    EXPECT_GT(ledger.asked(), asked) << "the allocator is still the one that was set";
  }
  EXPECT_TRUE(succeeded(abut_set_allocator(nullptr, nullptr, nullptr)));
  const std::size_t asked = ledger.asked();
  {
    const Shape ball = make_sphere(1);
  }
  EXPECT_EQ(ledger.asked(), asked) << "and no longer";
}

TEST(MemoryAllocate, GivesNothingForWhatIsNoAlignment) {
  for (const std::size_t alignment : {std::size_t{0}, std::size_t{3}, std::size_t{48}, ~std::size_t{0}}) {
    EXPECT_EQ(abut_memory_allocate(10, alignment), nullptr) << alignment;
  }
}

TEST(MemoryAllocate, IsCountedAndAligned) {
  std::uint64_t bytes_before = 0, blocks_before = 0, bytes = 0, blocks = 0;
  require(abut_memory_in_use(&bytes_before, &blocks_before));
  for (const std::size_t alignment : {1U, 16U, 64U, 4096U}) {
    void* memory = abut_memory_allocate(100, alignment);
    ASSERT_NE(memory, nullptr);
    EXPECT_EQ(std::bit_cast<std::uintptr_t>(memory) % alignment, 0U);
    require(abut_memory_in_use(&bytes, &blocks));
    EXPECT_EQ(bytes, bytes_before + 112) << "in units of 16";
    EXPECT_EQ(blocks, blocks_before + 1);
    abut_memory_release(memory, 100, alignment);
  }
  require(abut_memory_in_use(&bytes, &blocks));
  EXPECT_EQ(bytes, bytes_before);
  EXPECT_EQ(blocks, blocks_before);
}

TEST(MemoryAllocate, GivesTwoAddressesForNothing) {
  void* const one = abut_memory_allocate(0, 16);
  void* const other = abut_memory_allocate(0, 16);
  EXPECT_NE(one, nullptr);
  EXPECT_NE(one, other);
  abut_memory_release(one, 0, 16);
  abut_memory_release(other, 0, 16);
}

TEST(MemoryRelease, AllowsNull) {
  std::uint64_t bytes_before = 0, blocks_before = 0, bytes = 0, blocks = 0;
  require(abut_memory_in_use(&bytes_before, &blocks_before));
  abut_memory_release(nullptr, 100, 16);
  require(abut_memory_in_use(&bytes, &blocks));
  EXPECT_EQ(bytes, bytes_before);
  EXPECT_EQ(blocks, blocks_before);
}

}  // namespace
