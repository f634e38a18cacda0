// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <set>
#include <vector>

#include "../../random_boxes.hpp"

import abut.math;
import abut.trees.boxes.bvh;
import abut.trees.boxes.furthest_first;

namespace {

using abut::Aabb;
using abut::Vec3;

double reach_of(const Aabb& box) { return norm(maximum(absolute(box.low), absolute(box.high))); }

// Compared with a look at every box.
TEST(FurthestFirst, FindsWhatReachesBeyondALimit) {
  test::Random random(3);
  for (const std::size_t count : {1U, 7U, 300U, 3000U}) {
    std::vector<Aabb> boxes;
    for (std::size_t i = 0; i < count; ++i) {
      boxes.push_back(Aabb::around(random.point(4), {0.1, 0.2, 0.05}));
    }
    const abut::Bvh tree(boxes);
    const double limit = 4.2;
    std::set<std::uint32_t> found, expected;
    abut::visit_furthest_first(tree, reach_of, limit, [&](std::uint32_t item) { found.insert(item); });
    for (std::uint32_t i = 0; i < count; ++i) {
      if (reach_of(boxes.at(i)) > limit) expected.insert(i);
    }
    EXPECT_TRUE(std::ranges::includes(found, expected));
    EXPECT_LE(found.size(), expected.size() + 2) << "boxes are rounded outward";
    // With a limit that rises few are looked at, and the furthest is among them.
    double most = 0;
    std::size_t visits = 0;
    abut::visit_furthest_first(tree, reach_of, most, [&](std::uint32_t item) {
      most = std::max(most, reach_of(boxes.at(item)));
      ++visits;
    });
    EXPECT_EQ(most, reach_of(*std::ranges::max_element(boxes, {}, reach_of)));
    EXPECT_LE(visits, 24U);
  }
}

}  // namespace
