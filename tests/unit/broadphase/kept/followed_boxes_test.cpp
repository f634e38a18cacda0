// SPDX-License-Identifier: Apache-2.0
// The memory of the broad phases that keep pairs from call to call.
#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

import abut.broadphase;
import abut.core.workers;
import abut.math;

namespace {

using abut::CompactAabb;

// A row in which each meets its neighbours.
template <class BroadPhase>
class Row {
 public:
  explicit Row(std::uint32_t count) : numbers_(count) {
    std::iota(numbers_.begin(), numbers_.end(), 0u);
    for (const std::uint32_t i : numbers_) {
      const auto x = static_cast<float>(i);
      boxes_.push_back({{x, 0, 0}, {x + 1.25f, 1, 1}});
      broad_phase_.insert(i, boxes_.back(), abut::Mobility::moving, i);
    }
  }

  void shift(float by) {
    for (CompactAabb& box : boxes_) {
      box.low[1] += by;
      box.high[1] += by;
    }
    broad_phase_.update_all(workers_, numbers_, boxes_);
  }
  std::size_t pairs() {
    broad_phase_.find_pairs(workers_, pairs_);
    return pairs_.size();
  }
  std::size_t bytes() const { return broad_phase_.bytes(); }

 private:
  abut::Workers workers_{1};
  BroadPhase broad_phase_;
  std::vector<std::uint32_t> numbers_;
  std::vector<CompactAabb> boxes_;
  std::vector<abut::ProxyPair> pairs_;
};

template <class BroadPhase>
class FollowedBoxes : public testing::Test {};
using Implementations = testing::Types<abut::Tree, abut::Grid>;
TYPED_TEST_SUITE(FollowedBoxes, Implementations);

// All leave their larger boxes at once, and then none does for some steps.
TYPED_TEST(FollowedBoxes, WavesOfThoseThatLeaveAskForNoMemory) {
  constexpr std::uint32_t count = 8192;
  constexpr int warm = 160, steps = 640, steps_of_way = 40;
  Row<TypeParam> row(count);
  std::size_t bytes = 0;
  for (int step = 0; step < steps; ++step) {
    row.shift(step / steps_of_way % 2 == 0 ? 0.0625f : -0.0625f);
    ASSERT_EQ(row.pairs(), count - 1);
    bytes = step == warm ? row.bytes() : bytes;
    ASSERT_TRUE(step < warm || row.bytes() == bytes) << "step " << step;
  }
}

// When nothing moves afterwards, what the search for all pairs needed would lie idle for ever.
TYPED_TEST(FollowedBoxes, TheFirstSearchOfManyGivesBackItsScratch) {
  constexpr std::uint32_t count = 70'000;
  constexpr std::size_t bytes_of_pair = 8;
  Row<TypeParam> row(count);
  ASSERT_EQ(row.pairs(), count - 1);
  const std::size_t after_first = row.bytes();
  row.shift(100);
  ASSERT_EQ(row.pairs(), count - 1);
  EXPECT_GT(row.bytes(), after_first + 3 * count * bytes_of_pair)
      << "a search of all needs room to ask, to find and to sort";
}

}  // namespace
