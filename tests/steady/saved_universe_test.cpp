// SPDX-License-Identifier: Apache-2.0
// Saving and loading without enough memory: each request is refused in turn, and the call says so and changes nothing.
#include "allocations.hpp"
#include "archive_support.hpp"
#include "crowd.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace {

using namespace abut_test;
using steady::Crowd;
using steady::RefusedAllocation;

std::uint64_t hash_of(const abut_universe* universe) {
  std::uint64_t hash = 0;
  require(abut_universe_hash(universe, &hash));
  return hash;
}

TEST(OutOfMemory, OfSavingChangesNothing) {
  Crowd crowd(default_universe_options(), steady::make_moving_shapes(), 2);
  crowd.step();
  const std::vector<std::uint8_t> before = saved(crowd.universe());
  std::size_t refused = 0;
  for (abut_status status = ABUT_OUT_OF_MEMORY; status != ABUT_OK; ++refused) {
    std::size_t size = 7;
    {
      const RefusedAllocation refusal(refused);
      status = abut_universe_save(crowd.universe(), nullptr, 0, &size);
    }
    ASSERT_TRUE(status == ABUT_OUT_OF_MEMORY || status == ABUT_OK) << abut_last_error_message();
    EXPECT_EQ(size, status == ABUT_OK ? before.size() : 7U);
  }
  EXPECT_GT(refused, 20U);
  EXPECT_EQ(saved(crowd.universe()), before);
}

TEST(OutOfMemory, OfLoadingMakesNothing) {
  Crowd crowd(default_universe_options(), steady::make_moving_shapes(), 2);
  crowd.step();
  const std::vector<std::uint8_t> bytes = saved(crowd.universe());
  std::size_t refused = 0;
  for (abut_status status = ABUT_OUT_OF_MEMORY; status != ABUT_OK; ++refused) {
    abut_universe* made = nullptr;
    {
      const RefusedAllocation refusal(refused);
      status = abut_universe_load(bytes.data(), bytes.size(), &made);
    }
    const Owned owner(made);
    ASSERT_TRUE(status == ABUT_OUT_OF_MEMORY || status == ABUT_OK) << abut_last_error_message();
    ASSERT_EQ(made == nullptr, status != ABUT_OK);
    if (status == ABUT_OK) EXPECT_EQ(hash_of(made), hash_of(crowd.universe()));
  }
  EXPECT_GT(refused, 50U);
}

}  // namespace
