// SPDX-License-Identifier: Apache-2.0
// What is kept of pairs from detection to detection.
#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

import abut.broadphase;
import abut.core.workers;
import abut.detect.pairs;
import abut.scene.state.places;

namespace {

using namespace abut;

class Store : public testing::Test {
 protected:
  Store() {
    for (std::uint32_t i = 0; i < infos.size(); ++i) {
      infos[i].generation = 100 + i;
    }
  }
  void merge(const std::vector<ProxyPair>& near, bool are_slots_reused = false) {
    store.forget_lost();
    store.merge(Workers(1), near, infos, are_slots_reused);
  }

  std::array<PlaceInfo, 8> infos{};
  PairStore store;
};

TEST_F(Store, NewPairsAreUnaskedAndStale) {
  merge({{0, 1}, {0, 5}, {2, 3}});
  ASSERT_EQ(store.all().size(), 3U);
  EXPECT_EQ(store.all()[1].high, 5U);
  EXPECT_EQ(store.all()[1].generation_high, 105U);
  EXPECT_TRUE(store.all()[1].is_unasked && store.all()[1].is_stale && store.all()[1].is_new);
  EXPECT_FALSE(store.all()[1].is_touching);
}

TEST_F(Store, KnownPairsKeepWhatTheyHave) {
  merge({{0, 1}, {0, 5}, {2, 3}});
  for (Pair& pair : store.all()) {
    pair.is_unasked = pair.is_new = false;
    pair.first_contact = 10 * pair.high;
  }
  merge({{0, 5}, {1, 2}, {2, 3}, {2, 4}});
  ASSERT_EQ(store.all().size(), 4U);
  EXPECT_EQ(store.all()[0].first_contact, 50U);
  EXPECT_FALSE(store.all()[0].is_unasked);
  EXPECT_TRUE(store.all()[1].is_unasked);
  EXPECT_EQ(store.all()[2].first_contact, 30U);
  EXPECT_TRUE(store.all()[3].is_unasked);
}

TEST_F(Store, OnlyPairsThatTouchedAreLost) {
  merge({{0, 1}, {0, 5}, {2, 3}});
  store.all()[0].is_touching = true;
  store.all()[2].is_touching = true;
  merge({{0, 1}});
  ASSERT_EQ(store.lost().size(), 1U);
  EXPECT_EQ(store.lost()[0].low, 2U);
  EXPECT_TRUE(store.all()[0].is_touching);
  merge({});
  ASSERT_EQ(store.lost().size(), 1U);
  EXPECT_EQ(store.lost()[0].high, 1U);
  EXPECT_TRUE(store.all().empty());
}

TEST_F(Store, OthersInTheSameSlotsAreAnotherPair) {
  merge({{0, 1}});
  store.all()[0].is_touching = true;
  store.all()[0].is_unasked = false;
  infos[1].generation = 777;
  merge({{0, 1}}, true);
  ASSERT_EQ(store.lost().size(), 1U);
  EXPECT_EQ(store.lost()[0].generation_high, 101U);
  ASSERT_EQ(store.all().size(), 1U);
  EXPECT_EQ(store.all()[0].generation_high, 777U);
  EXPECT_TRUE(store.all()[0].is_unasked);
}

// The same pairs, the same lost ones in the same order, and memories that go to the same pairs.
TEST(Merge, IsTheSameOnAnyNumberOfThreads) {
  constexpr std::uint32_t count = 3000;
  std::vector<PlaceInfo> infos(count + 8);
  const auto near_in = [&](std::uint32_t round) {
    std::vector<ProxyPair> near;
    for (std::uint32_t low = 0; low < count; ++low) {
      for (std::uint32_t step = 1; step < 8; ++step) {
        if ((low * 7 + step * 5 + round * 3) % 4 != 0) near.push_back({low, low + step});
      }
    }
    return near;
  };
  PairStore one, many;
  const Workers single(1), several(4);
  for (std::uint32_t round = 0; round < 5; ++round) {
    const std::vector<ProxyPair> near = round == 3 ? std::vector<ProxyPair>{} : near_in(round);
    for (std::uint32_t i = round; i < count; i += 17) ++infos[i].generation;
    for (PairStore* store : {&one, &many}) {
      store->forget_lost();
      store->merge(store == &one ? single : several, near, infos, true);
      for (Pair& pair : store->all()) {
        pair.is_touching = (pair.low + pair.high) % 3 == 0;
        pair.is_unasked = false;
        if (pair.low % 5 == 0) store->give_memory(pair);
      }
    }
    const auto expect_same = [](std::span<const Pair> a, std::span<const Pair> b) {
      ASSERT_EQ(a.size(), b.size());
      for (std::size_t i = 0; i < a.size(); ++i) {
        ASSERT_TRUE(a[i].low == b[i].low && a[i].high == b[i].high && a[i].generation_low == b[i].generation_low &&
                    a[i].generation_high == b[i].generation_high && a[i].memory == b[i].memory)
            << i;
      }
    };
    ASSERT_EQ(one.all().size(), near.size());
    ASSERT_TRUE(round == 0 || round == 4 || !one.lost().empty());
    expect_same(one.all(), many.all());
    expect_same(one.lost(), many.lost());
    EXPECT_EQ(one.memories().size(), many.memories().size());
  }
}

TEST_F(Store, LostPairsComeInOrder) {
  merge({{0, 1}, {2, 3}, {4, 5}});
  for (Pair& pair : store.all()) pair.is_touching = true;
  merge({{2, 3}});
  store.lose(store.all().first(1));
  ASSERT_EQ(store.lost().size(), 3U);
  EXPECT_EQ(store.lost()[0].low, 0U);
  EXPECT_EQ(store.lost()[1].low, 2U);
  EXPECT_EQ(store.lost()[2].low, 4U);
}

}  // namespace
