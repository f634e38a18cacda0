// What is kept of pairs from detection to detection.
#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

import abut.broadphase;
import abut.universe.pairs;

namespace {

using namespace abut;

class Store : public testing::Test {
 protected:
  Store() {
    for (std::uint32_t i = 0; i < infos.size(); ++i) {
      infos[i].generation = 100 + i;
    }
  }
  void merge(const std::vector<ProxyPair>& near) {
    store.forget_lost();
    store.merge(near, infos);
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
  merge({{0, 1}});
  ASSERT_EQ(store.lost().size(), 1U);
  EXPECT_EQ(store.lost()[0].generation_high, 101U);
  ASSERT_EQ(store.all().size(), 1U);
  EXPECT_EQ(store.all()[0].generation_high, 777U);
  EXPECT_TRUE(store.all()[0].is_unasked);
}

TEST_F(Store, LostPairsComeInOrder) {
  merge({{0, 1}, {2, 3}, {4, 5}});
  for (Pair& pair : store.all()) pair.is_touching = true;
  merge({{2, 3}});
  store.lose(store.all()[0]);
  store.sort_lost();
  ASSERT_EQ(store.lost().size(), 3U);
  EXPECT_EQ(store.lost()[0].low, 0U);
  EXPECT_EQ(store.lost()[1].low, 2U);
  EXPECT_EQ(store.lost()[2].low, 4U);
}

}  // namespace
