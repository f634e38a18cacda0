// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <random>
#include <tuple>
#include <utility>
#include <vector>

import abut.broadphase.kept.pair_order;
import abut.broadphase.proxy;

namespace {

using abut::ProxyPair;

TEST(PairOrder, NoneStayNone) {
  std::vector<ProxyPair> pairs, scratch{{1, 2}};
  abut::put_in_order(pairs, scratch);
  EXPECT_TRUE(pairs.empty());
}

// Few are compared, many counted; numbers may be far apart.
TEST(PairOrder, EachComesOnceInOrderOfBothNumbers) {
  std::mt19937 random(261);
  std::vector<ProxyPair> scratch;
  for (const std::uint32_t count : {2u, 3u, 40u, 500u, 3000u}) {
    for (const std::uint32_t gap : {1u, 300u, 70'000u, 1'000'000u}) {
      std::vector<ProxyPair> pairs;
      for (std::uint32_t i = 0; i < 5 * count; ++i) {
        const auto a = static_cast<std::uint32_t>(random() % count), b = static_cast<std::uint32_t>(random() % count);
        if (a != b) {
          pairs.push_back({gap * std::min(a, b), gap * std::max(a, b)});
        }
      }
      pairs.insert(pairs.end(), pairs.begin(), pairs.begin() + static_cast<std::ptrdiff_t>(pairs.size() / 2));
      std::vector<ProxyPair> expected = pairs;
      std::sort(expected.begin(), expected.end(), [](const ProxyPair& a, const ProxyPair& b) {
        return std::tie(a.low, a.high) < std::tie(b.low, b.high);
      });
      expected.erase(std::unique(expected.begin(), expected.end()), expected.end());
      abut::put_in_order(pairs, scratch);
      EXPECT_EQ(pairs, expected);
    }
  }
}

// Those with much the same lower number come together; nothing is lost, and the order in which they came is kept within
// a run.
TEST(PairOrder, GatheringKeepsAllAndTheirOrderWithinARun) {
  std::mt19937 random(263);
  std::vector<ProxyPair> scratch;
  for (const std::uint32_t most : {1u, 1000u, 100'000u, 4'000'000'000u}) {
    std::vector<ProxyPair> pairs;
    for (std::uint32_t i = 0; i < 5000; ++i) {
      pairs.push_back({static_cast<std::uint32_t>(random()) % most, i});
    }
    std::uint32_t shift = 0;
    while ((most - 1) >> shift >= 2048) {
      ++shift;
    }
    std::vector<ProxyPair> expected = pairs;
    // The higher numbers are those of their places.
    std::sort(expected.begin(), expected.end(), [&](const ProxyPair& a, const ProxyPair& b) {
      return std::pair(a.low >> shift, a.high) < std::pair(b.low >> shift, b.high);
    });
    abut::gather_by_lower(pairs, scratch);
    EXPECT_EQ(pairs, expected);
  }
}

TEST(PairOrder, GatheringNoneOrOneIsNoTrouble) {
  std::vector<ProxyPair> pairs, scratch;
  abut::gather_by_lower(pairs, scratch);
  EXPECT_TRUE(pairs.empty());
  pairs = {{0, 7}};
  abut::gather_by_lower(pairs, scratch);
  EXPECT_EQ(pairs, (std::vector<ProxyPair>{{0, 7}}));
}

}  // namespace
