// SPDX-License-Identifier: Apache-2.0
// A triangle is passed over only where another one that holds its nearest point comes nearer. All triangles, one by
// one, judge that.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <set>
#include <vector>

#include "../../made.hpp"
#include "../../random_boxes.hpp"

import abut.capability;
import abut.math;
import abut.narrow.many.four_nearest;
import abut.narrow.many.point_ghosts;
import abut.narrow.many.triangle_point;
import abut.shapes.height_field;

namespace {

using abut::TriangleCorners;
using abut::Vec3;

constexpr std::uint32_t side = 8, triangle_count = 2 * (side - 1) * (side - 1);

bool has_nearer_neighbour(const abut::HeightField& field, std::uint32_t index, const Vec3& point) {
  const Vec3 nearest = abut::nearest_on(field.part(index).corners(), point);
  for (std::uint32_t other = 0; other < triangle_count; ++other) {
    const TriangleCorners corners = field.part(other).corners();
    if (norm(abut::nearest_on(corners, nearest) - nearest) < 1e-12 &&
        norm(abut::nearest_on(corners, point) - point) < norm(nearest - point)) {
      return true;
    }
  }
  return false;
}

TEST(PointGhosts, HaveANeighbourThatIsNearer) {
  test::Random random(812);
  std::vector<double> heights(side * side);
  std::generate(heights.begin(), heights.end(), [&] { return random.uniform(-0.4, 0.4); });
  const auto field = test::made<abut::HeightField>({side, side, 1, 1, 2, 0}, heights);
  int passed_over = 0, kept = 0;
  for (int i = 0; i < 200; ++i) {
    const Vec3 point{random.uniform(1, 6), random.uniform(1, 6), random.uniform(-1, 1.5)};
    abut::PointGhosts<abut::HeightField> ghosts(field, point);
    std::set<std::uint32_t> all;
    for (std::uint32_t first = 0; first + 4 <= triangle_count; first += 4) {
      std::array<TriangleCorners, 4> corners;
      std::array<std::uint32_t, 4> numbers{};
      for (std::uint32_t lane = 0; lane < 4; ++lane) {
        corners.at(lane) = field.part(first + lane).corners();
        numbers.at(lane) = first + lane;
      }
      const abut::FourTriangles four = abut::FourTriangles::of(corners, numbers);
      const std::uint64_t left = ghosts.without(four, abut::FourNearest(four, point), 15);
      for (std::uint32_t lane = 0; lane < 4; ++lane) {
        if ((left >> lane & 1) != 0) {
          all.insert(first + lane);
          ++kept;
        }
      }
    }
    ghosts.visit([&](const abut::Triangle& part, std::uint32_t index) {
      EXPECT_EQ(part.index(), index);
      EXPECT_TRUE(has_nearer_neighbour(field, index, point)) << "triangle " << index << " of point " << i;
      EXPECT_TRUE(all.insert(index).second) << "kept and passed over";
      ++passed_over;
    });
    EXPECT_EQ(all.size(), triangle_count / 4 * 4);
  }
  EXPECT_GT(passed_over, 12000);
  EXPECT_GT(kept, 200);
}

}  // namespace
