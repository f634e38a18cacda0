// SPDX-License-Identifier: Apache-2.0
// What a tree finds in a slab, against the heights of all corners of all boxes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <set>
#include <string>
#include <vector>

#include "../random_boxes.hpp"

import abut.math;
import abut.trees.bvh;
import abut.trees.eight_boxes;
import abut.trees.slab;

namespace {

using abut::Aabb;
using abut::Vec3;

struct Heights {
  double low = std::numeric_limits<double>::infinity(), high = -low;
};
Heights heights_of(const Aabb& box, const Vec3& normal) {
  Heights found;
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 p{(corner & 1) != 0 ? box.high.x : box.low.x, (corner & 2) != 0 ? box.high.y : box.low.y,
                 (corner & 4) != 0 ? box.high.z : box.low.z};
    found.low = std::min(found.low, dot(normal, p));
    found.high = std::max(found.high, dot(normal, p));
  }
  return found;
}

std::set<std::uint32_t> found_in(const abut::Bvh& tree, const abut::Slab& slab) {
  std::set<std::uint32_t> found;
  const abut::Slab from_origin = slab.from(tree.origin());
  tree.visit_overlaps(
      Aabb::everything(), [&](std::uint32_t item) { EXPECT_TRUE(found.insert(item).second); },
      [&](const abut::EightBoxes& boxes) { return from_origin.reached_by(boxes); });
  return found;
}

TEST(Slab, FindsWhatReachesIntoItAndHardlyMore) {
  test::Random random(41);
  for (int i = 0; i < 60; ++i) {
    SCOPED_TRACE("case " + std::to_string(i));
    // From the origin to far away from it; every third one along an axis.
    const double far = i % 4 == 0 ? 0 : std::pow(10, random.uniform(0, 6));
    const Vec3 middle = random.point(far);
    std::vector<Aabb> boxes;
    for (int box = 0; box < 300; ++box) {
      const Vec3 centre = middle + random.point(10),
                 half{random.uniform(0, 1), random.uniform(0, 1), i % 5 == 0 ? 0 : random.uniform(0, 1)};
      boxes.push_back({centre - half, centre + half});
    }
    const Vec3 normal = i % 3 == 0 ? Vec3{0, 0, i % 2 == 0 ? 1.0 : -1.0} : random.rotation().x;
    // Every other one has no thickness, and lies at a corner of a box.
    const double base = heights_of(boxes[0], normal).low, thickness = i % 2 == 0 ? 0 : random.uniform(0, 3);
    const double rounding = 1e-15 * (far + 20), single = 3e-6;
    const std::set<std::uint32_t> found =
        found_in(abut::Bvh(boxes), {normal, base - rounding, base + thickness + rounding});
    std::size_t outside = 0;
    for (std::uint32_t box = 0; box < boxes.size(); ++box) {
      const Heights its = heights_of(boxes[box], normal);
      const bool reaches = its.low <= base + thickness && its.high >= base;
      EXPECT_TRUE(!reaches || found.contains(box)) << "box " << box;
      const bool is_near = its.low <= base + thickness + single && its.high >= base - single;
      EXPECT_TRUE(is_near || !found.contains(box)) << "box " << box;
      outside += is_near ? 0 : 1;
    }
    EXPECT_GT(outside, 100u);
  }
}

// A triangle without area has no normal: nothing is passed over.
TEST(Slab, WithoutANormalHoldsEverything) {
  test::Random random(43);
  std::vector<Aabb> boxes;
  for (int box = 0; box < 100; ++box) {
    const Vec3 centre = random.point(10);
    boxes.push_back({centre, centre + Vec3{1, 1, 1}});
  }
  EXPECT_EQ(found_in(abut::Bvh(boxes), {{0, 0, 0}, -0.0, 0.0}).size(), boxes.size());
}

}  // namespace
