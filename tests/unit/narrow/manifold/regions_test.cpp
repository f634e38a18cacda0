// SPDX-License-Identifier: Apache-2.0
// Regions are those that a search through all pairs of contacts finds.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <set>
#include <vector>

#include "../../random_boxes.hpp"

import abut.math;
import abut.narrow.manifold.regions;

namespace {

using abut::Real;
using abut::Vec3;
using Region = std::set<std::uint32_t>;

struct Scene {
  std::vector<Vec3> points;
  std::vector<std::uint64_t> parts;

  [[nodiscard]] abut::Regions regions() const {
    return abut::Regions(points, [&](std::uint32_t number) { return parts[number]; });
  }
};

// Those that hang together with the first one, and so on.
std::set<Region> by_search(const Scene& scene, Real gap) {
  const auto hang_together = [&](std::uint32_t i, std::uint32_t j) {
    return scene.parts[i] == scene.parts[j] || squared_norm(scene.points[i] - scene.points[j]) <= gap * gap;
  };
  std::set<Region> regions;
  Region left;
  for (std::uint32_t i = 0; i < scene.points.size(); ++i) {
    left.insert(i);
  }
  while (!left.empty()) {
    std::vector<std::uint32_t> region{*left.begin()};
    left.erase(left.begin());
    for (std::size_t next = 0; next < region.size(); ++next) {
      for (auto it = left.begin(); it != left.end();) {
        const bool joins = hang_together(region[next], *it);
        if (joins) {
          region.push_back(*it);
        }
        it = joins ? left.erase(it) : std::next(it);
      }
    }
    regions.emplace(region.begin(), region.end());
  }
  return regions;
}

TEST(Regions, AreThoseOfASearchThroughAllPairs) {
  test::Random random(37);
  std::size_t most = 0, several = 0;
  for (int i = 0; i < 300; ++i) {
    Scene scene;
    const auto count = static_cast<std::uint32_t>(random.uniform(1, 120));
    // Around the 27 points of a small grid, which are a little farther apart than a gap is wide.
    const Real jitter = random.uniform(0, 1) < 0.5 ? random.uniform(0, 0.1) : random.uniform(0, 1);
    abut::Aabb box = abut::Aabb::empty();
    for (std::uint32_t number = 0; number < count; ++number) {
      const Vec3 crowd{std::floor(random.uniform(-1, 2)), std::floor(random.uniform(-1, 2)),
                       std::floor(random.uniform(-1, 2))};
      scene.points.push_back(crowd + jitter * random.point(1));
      // Every tenth one belongs to the part of another one, wherever that is.
      scene.parts.push_back(random.uniform(0, 10) < 1 ? number / 2 : number);
      box.include(scene.points.back());
    }
    const Real gap = abut::region_gap_share * norm(box.high - box.low);
    std::set<Region> found;
    Region region;
    const abut::Regions regions = scene.regions();
    regions.visit([&](std::uint32_t number) { EXPECT_TRUE(region.insert(number).second); },
                  [&] {
                    found.insert(region);
                    region.clear();
                  });
    EXPECT_EQ(found, by_search(scene, gap)) << "case " << i << ", gap " << gap;
    EXPECT_EQ(found.size(), regions.count()) << "case " << i;
    most = std::max(most, found.size());
    several += found.size() > 1 ? 1u : 0u;
  }
  EXPECT_GT(most, 20u);
  EXPECT_GT(several, 100u);
}

TEST(Regions, AreOneWhereAllIsAtOnePlace) {
  Scene scene;
  for (std::uint32_t number = 0; number < 20; ++number) {
    scene.points.push_back({3, -1, 2});
    scene.parts.push_back(number);
  }
  EXPECT_EQ(scene.regions().count(), 1u);
}

}  // namespace
