// SPDX-License-Identifier: Apache-2.0
// Memory comes from where abut has its own, all of it, and goes back. Where there is none, calls say so.
#include <gtest/gtest.h>

#include <cstdint>
#include <cstdlib>
#include <limits>

#include "scene.hpp"

namespace {

using namespace response_test;

// Refuses after a number of requests.
struct Allocator {
  std::uint64_t left = std::numeric_limits<std::uint64_t>::max();
  std::uint64_t requests = 0;

  Allocator() {
    require(abut_set_allocator(
        [](void* context, std::size_t size, std::size_t alignment) -> void* {
          auto& its = *static_cast<Allocator*>(context);
          ++its.requests;
          if (its.left == 0) return nullptr;
          --its.left;
          return std::aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment);
        },
        [](void*, void* memory, std::size_t, std::size_t) { std::free(memory); }, this));
  }
  Allocator(const Allocator&) = delete;
  Allocator& operator=(const Allocator&) = delete;
  // Fails where memory is still in use.
  ~Allocator() { require(abut_set_allocator(nullptr, nullptr, nullptr)); }
};

std::uint64_t bytes_in_use() {
  std::uint64_t bytes = 0, blocks = 0;
  require(abut_memory_in_use(&bytes, &blocks));
  return bytes;
}

TEST(Memory, OfAProblemComesFromTheHostAndGoesBack) {
  Allocator allocator;
  World world = stack({1, 2, 3}, 0.5);
  world.fall({0, 0, -gravity}, 1e-2);
  const std::uint64_t before = bytes_in_use();
  EXPECT_EQ(world.solve().status, ABUT_OK);
  EXPECT_GT(allocator.requests, 50U);
  EXPECT_EQ(bytes_in_use(), before);
}

TEST(Memory, OfAProblemMayBeRefusedAtAnyTime) {
  Allocator allocator;
  World world = stack({1, 2, 3}, 0.5);
  world.fall({1, 0, -gravity}, 1e-2);
  const std::uint64_t before = bytes_in_use();
  const Answer whole = world.solve();
  ASSERT_EQ(whole.status, ABUT_OK);
  const std::uint64_t requests = allocator.requests;
  for (std::uint64_t i = 0; i < requests; ++i) {
    allocator.left = i;
    EXPECT_EQ(world.solve().status, ABUT_OUT_OF_MEMORY) << i;
    EXPECT_EQ(bytes_in_use(), before) << i;
  }
  allocator.left = std::numeric_limits<std::uint64_t>::max();
  EXPECT_EQ(world.solve().velocities, whole.velocities);
}

TEST(Memory, OfBodiesGoesWithThem) {
  const Allocator allocator;
  const std::uint64_t before = bytes_in_use();
  {
    Scene scene;
    scene.floor();
    scene.body(block(0.5, 0.5, 0.5), {{0, 0, 0.5}, no_turn}, 1);
    scene.step(1e-2, 10);
    EXPECT_GT(bytes_in_use(), before);
  }
  EXPECT_EQ(bytes_in_use(), before);
}

}  // namespace
