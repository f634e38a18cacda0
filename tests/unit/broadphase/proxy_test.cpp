#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <random>
#include <tuple>
#include <vector>

import abut.broadphase;

namespace {

using abut::ProxyPair;

TEST(ProxyPairs, NoneStayNone) {
  std::vector<std::uint32_t> starts{1, 2, 3};
  std::vector<ProxyPair> out{{1, 2}};
  abut::put_in_order({}, 10, starts, out);
  EXPECT_TRUE(out.empty());
}

TEST(ProxyPairs, ComeInOrderOfBothNumbers) {
  std::mt19937 random(261);
  std::vector<std::uint32_t> starts;
  std::vector<ProxyPair> out;
  for (const std::uint32_t count : {2u, 3u, 40u, 500u}) {
    std::vector<ProxyPair> pairs;
    for (std::uint32_t i = 0; i < 3 * count; ++i) {
      const auto [low, high] = std::minmax({static_cast<std::uint32_t>(random() % count), static_cast<std::uint32_t>(random() % count)});
      if (low != high) {
        pairs.push_back({low, high});
      }
    }
    abut::put_in_order(pairs, count, starts, out);
    std::sort(pairs.begin(), pairs.end(),
              [](const ProxyPair& a, const ProxyPair& b) { return std::tie(a.low, a.high) < std::tie(b.low, b.high); });
    EXPECT_EQ(out, pairs);
  }
}

}  // namespace
