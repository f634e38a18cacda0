// SPDX-License-Identifier: Apache-2.0
// Two trees find what all pairs of boxes, one by one, would. Points judge that: boxes that hold a point each of two
// that are near are near.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <set>
#include <utility>
#include <vector>

#include "../../random_boxes.hpp"

import abut.math;
import abut.trees.boxes.bvh;
import abut.trees.boxes.two_trees;

namespace {

using abut::Aabb;
using abut::Bvh;
using abut::Pose;
using abut::Vec3;
using Pairs = std::set<std::pair<std::uint32_t, std::uint32_t>>;

// A box of some size around each of many places; of size 0, a point.
struct Cloud {
  std::vector<Vec3> points;
  std::vector<Aabb> boxes;

  Cloud(std::size_t count, double size, test::Random& random) {
    for (std::size_t i = 0; i < count; ++i) {
      const Vec3 point = random.point(10);
      const auto side = [&] { return size * random.uniform(0, 1); };
      points.push_back(point);
      boxes.push_back({point - Vec3{side(), side(), side()}, point + Vec3{side(), side(), side()}});
    }
  }
};

Pose random_pose(test::Random& random) { return {random.rotation(), random.point(4)}; }

template <class Order>
Pairs visited(const Bvh& a, const Bvh& b, const Order& order, double most) {
  Pairs pairs;
  abut::visit_two(a, b, order, most, [&](std::uint32_t of_a, std::uint32_t of_b) {
    EXPECT_TRUE(pairs.emplace(of_a, of_b).second) << "twice: " << of_a << ", " << of_b;
    return most;
  });
  return pairs;
}

// A tree of very few, of one node and of several.
constexpr std::array<std::array<std::size_t, 2>, 5> counts{{{1, 1}, {1, 700}, {5, 9}, {300, 60}, {400, 250}}};

TEST(TwoTrees, VisitThePointsWithinAReach) {
  test::Random random(3);
  for (const auto& count : counts) {
    const Cloud a(count[0], 0, random), b(count[1], 0, random);
    const Bvh tree_a(a.boxes), tree_b(b.boxes);
    for (const double reach : {-1.0, 0.0, 0.4, 3.0, 100.0}) {
      const Pose ab = random_pose(random);
      const Pairs found = visited(tree_a, tree_b, abut::GapOrder(tree_a.origin(), tree_b.origin(), ab), reach);
      constexpr double rounding = 1e-5;  // of boxes in single precision
      for (std::uint32_t i = 0; i < count[0]; ++i) {
        for (std::uint32_t j = 0; j < count[1]; ++j) {
          const double distance = norm(ab * b.points[j] - a.points[i]);
          if (std::fabs(distance - reach) > rounding) {
            ASSERT_EQ(found.contains({i, j}), distance < reach) << i << ", " << j << " of " << reach;
          }
        }
      }
    }
  }
}

TEST(TwoTrees, VisitEveryTwoBoxesOfWhichPointsAreNear) {
  test::Random random(4);
  const Cloud a(800, 1.5, random), b(500, 0.7, random);
  const Bvh tree_a(a.boxes), tree_b(b.boxes);
  for (int turn = 0; turn < 5; ++turn) {
    const Pose ab = random_pose(random);
    const double reach = 0.3 * turn;
    const Pairs found = visited(tree_a, tree_b, abut::GapOrder(tree_a.origin(), tree_b.origin(), ab), reach);
    EXPECT_LT(found.size(), a.points.size() * b.points.size() / 4);
    const auto any_of = [&](const Aabb& box) {
      const Vec3 size = box.high - box.low;
      return box.low +
             Vec3{size.x * random.uniform(0, 1), size.y * random.uniform(0, 1), size.z * random.uniform(0, 1)};
    };
    for (std::uint32_t i = 0; i < a.boxes.size(); ++i) {
      for (std::uint32_t j = 0; j < b.boxes.size(); ++j) {
        if (norm(ab * any_of(b.boxes[j]) - any_of(a.boxes[i])) <= reach) {
          ASSERT_TRUE(found.contains({i, j})) << i << ", " << j;
        }
      }
    }
  }
}

TEST(TwoTrees, FindTheNearestPointsAfterFewVisits) {
  test::Random random(5);
  const Cloud a(1200, 0, random), b(900, 0, random);
  const Bvh tree_a(a.boxes), tree_b(b.boxes);
  for (int turn = 0; turn < 10; ++turn) {
    Pose ab = random_pose(random);
    ab.position = (turn % 2 == 0 ? 1.0 : 10.0) * ab.position;
    double least = abut::infinity, nearest = abut::infinity;
    for (const Vec3& p : a.points) {
      for (const Vec3& q : b.points) {
        least = std::fmin(least, norm(ab * q - p));
      }
    }
    std::size_t visits = 0;
    abut::visit_two(tree_a, tree_b, abut::GapOrder(tree_a.origin(), tree_b.origin(), ab), abut::infinity,
                    [&](std::uint32_t of_a, std::uint32_t of_b) {
                      ++visits;
                      nearest = std::fmin(nearest, norm(ab * b.points[of_b] - a.points[of_a]));
                      return nearest;
                    });
    EXPECT_EQ(nearest, least);
    EXPECT_LT(visits, 500u);
  }
}

TEST(TwoTrees, VisitEveryTwoBoxesThatMeetOnAWay) {
  test::Random random(6);
  const Cloud a(400, 0.4, random), b(300, 0.3, random);
  const Bvh tree_a(a.boxes), tree_b(b.boxes);
  for (int turn = 0; turn < 8; ++turn) {
    const Pose ab = random_pose(random);
    // Along an axis of either side as well.
    const Vec3 any = random.point(1), direction = turn == 0   ? Vec3{0, 1, 0}
                                                  : turn == 1 ? ab.rotation.x
                                                              : 1 / norm(any) * any;
    constexpr double length = 6, slack = 0.01;
    const Pairs found =
        visited(tree_a, tree_b, abut::PassageOrder(tree_a.origin(), tree_b.origin(), ab, direction, slack), length);
    EXPECT_LT(found.size(), a.points.size() * b.points.size() / 4);
    std::size_t met = 0;
    for (std::uint32_t i = 0; i < a.boxes.size(); ++i) {
      for (std::uint32_t j = 0; j < b.boxes.size(); ++j) {
        // Where the point comes nearest to that of the other box.
        const Vec3 start = ab * b.points[j];
        const double way = std::fmin(std::fmax(dot(direction, a.points[i] - start), 0), length);
        const Vec3 place = start + way * direction;
        if (a.boxes[i].overlaps({place, place})) {
          ++met;
          ASSERT_TRUE(found.contains({i, j})) << i << ", " << j;
        }
      }
    }
    EXPECT_GT(met, 3u);
  }
}

// Nearer boxes are met first, so that the first touch ends the search.
TEST(TwoTrees, MeetTheNearestBoxesOnAWayFirst) {
  std::vector<Aabb> row;
  for (int i = 0; i < 1000; ++i) {
    row.push_back({{2.0 * i, 0, 0}, {2.0 * i + 1, 1, 1}});
  }
  const Bvh tree(row), moving(std::vector<Aabb>{{{0, 0, 0}, {1, 1, 1}}});
  const Pose ab{abut::Rotation::identity(), {-5, 0.25, 0.25}};
  std::vector<std::uint32_t> order;
  abut::visit_two(tree, moving, abut::PassageOrder(tree.origin(), moving.origin(), ab, {1, 0, 0}, 0), 1e4,
                  [&](std::uint32_t item, std::uint32_t) {
                    order.push_back(item);
                    return 4.5 + 2.0 * item;  // before the next one is met
                  });
  EXPECT_EQ(order, std::vector<std::uint32_t>{0});
}

}  // namespace
