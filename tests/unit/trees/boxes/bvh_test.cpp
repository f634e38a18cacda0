// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <vector>

#include "../../random_boxes.hpp"

import abut.math;
import abut.trees.boxes.bvh;
import abut.trees.volumes.eight_boxes;

namespace {

using abut::Aabb;
using abut::BoxSides;
using abut::Bvh;
using abut::EightBoxes;
using abut::Vec3;

std::vector<Aabb> boxes_in_space(std::size_t count, double size, test::Random& random) {
  std::vector<Aabb> boxes;
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3 centre = random.point(10),
               half{random.uniform(0, size), random.uniform(0, size), random.uniform(0, size)};
    boxes.push_back({centre - half, centre + half});
  }
  return boxes;
}

bool is_apart(const Aabb& a, const Aabb& b) {
  bool apart = false;
  for (int axis = 0; axis < 3; ++axis) {
    apart = apart || a.low[axis] > b.high[axis] || b.low[axis] > a.high[axis];
  }
  return apart;
}

// Where a ray enters a box, by trying the six planes: a point of the box's surface or the origin.
std::optional<double> entry(const Aabb& box, const Vec3& origin, const Vec3& direction) {
  const auto is_in = [&](const Vec3& p, int but) {
    for (int axis = 0; axis < 3; ++axis) {
      if (axis != but && (p[axis] < box.low[axis] || p[axis] > box.high[axis])) {
        return false;
      }
    }
    return true;
  };
  std::optional<double> first;
  if (is_in(origin, 3)) {
    first = 0;
  }
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {box.low[axis], box.high[axis]}) {
      const double at = (side - origin[axis]) / direction[axis];
      if (at >= 0 && is_in(origin + at * direction, axis) && (!first || at < *first)) {
        first = at;
      }
    }
  }
  return first;
}

TEST(Bvh, EmptyMeetsNothing) {
  const Bvh tree;
  int visits = 0;
  tree.visit_overlaps(Aabb::everything(), [&](std::uint32_t) { ++visits; });
  double limit = 10;
  tree.visit_ray({0, 0, 0}, {0.6, 0.48, 0.64}, limit, [&](std::uint32_t) { ++visits; });
  EXPECT_EQ(visits, 0);
  EXPECT_FALSE(tree.bounds().is_bounded());
}

TEST(Bvh, EverythingVisitsEachItemOnce) {
  test::Random random(211);
  for (const std::size_t count : {1u, 4u, 5u, 100u, 1000u}) {
    const Bvh tree(boxes_in_space(count, 1, random));
    std::map<std::uint32_t, int> visits;
    tree.visit_overlaps(Aabb::everything(), [&](std::uint32_t item) { ++visits[item]; });
    EXPECT_EQ(visits.size(), count);
    for (const auto& [item, times] : visits) {
      EXPECT_LT(item, count);
      EXPECT_EQ(times, 1);
    }
  }
}

// A tree may show items beside those that overlap, but not most of them.
TEST(Bvh, NoOverlapIsMissed) {
  test::Random random(212);
  std::size_t overlapping = 0, visited = 0, all = 0;
  for (const double size : {0.0, 0.3, 4.0}) {
    const std::vector<Aabb> boxes = boxes_in_space(500, size, random);
    const Bvh tree(boxes);
    for (int i = 0; i < 200; ++i) {
      const Vec3 centre = random.point(11), half{random.uniform(0, 2), random.uniform(0, 2), random.uniform(0, 2)};
      const Aabb query{centre - half, centre + half};
      std::map<std::uint32_t, int> visits;
      tree.visit_overlaps(query, [&](std::uint32_t item) { ++visits[item]; });
      for (std::uint32_t item = 0; item < boxes.size(); ++item) {
        if (!is_apart(boxes[item], query)) {
          ++overlapping;
          EXPECT_EQ(visits[item], 1) << item;
        }
      }
      visited += visits.size();
      all += boxes.size();
    }
  }
  EXPECT_GT(overlapping, 1000u);
  EXPECT_LT(visited, all / 3);
}

TEST(Bvh, TouchingCounts) {
  std::vector<Aabb> boxes;
  for (int i = 0; i < 50; ++i) {
    boxes.push_back({{2.0 * i, 0, 0}, {2.0 * i + 1, 1, 1}});
  }
  const Bvh tree(boxes);
  for (std::uint32_t i = 0; i < 50; ++i) {
    bool found = false;
    tree.visit_overlaps({{2.0 * i + 1, 1, 1}, {2.0 * i + 1.5, 2, 2}},
                        [&](std::uint32_t item) { found = found || item == i; });
    EXPECT_TRUE(found) << i;
  }
}

TEST(Bvh, VisitorMayShrinkTheQuery) {
  test::Random random(213);
  const std::vector<Aabb> boxes = boxes_in_space(1000, 0.2, random);
  const Bvh tree(boxes);
  Aabb query = Aabb::everything();
  std::size_t visits = 0;
  tree.visit_overlaps(query, [&](std::uint32_t) {
    ++visits;
    query = {{100, 100, 100}, {101, 101, 101}};  // away from all of them
  });
  EXPECT_GE(visits, 1u);
  EXPECT_LE(visits, 8u);  // what is left of one node
}

TEST(Bvh, NoBoxOnARayIsMissed) {
  test::Random random(214);
  const std::vector<Aabb> boxes = boxes_in_space(500, 2, random);
  const Bvh tree(boxes);
  std::size_t met = 0, visited = 0;
  for (int i = 0; i < 500; ++i) {
    const Vec3 origin = random.point(15), direction = random.rotation().x;
    double limit = random.uniform(1, 40);
    std::map<std::uint32_t, int> visits;
    tree.visit_ray(origin, direction, limit, [&](std::uint32_t item) { ++visits[item]; });
    for (std::uint32_t item = 0; item < boxes.size(); ++item) {
      const auto at = entry(boxes[item], origin, direction);
      if (at && *at <= limit) {
        ++met;
        EXPECT_EQ(visits[item], 1) << item;
      }
    }
    visited += visits.size();
  }
  EXPECT_GT(met, 500u);
  EXPECT_LT(visited, 500 * boxes.size() / 4);
}

TEST(Bvh, ShorterLimitEndsTheRay) {
  std::vector<Aabb> boxes;
  for (int i = 0; i < 64; ++i) {
    boxes.push_back({{2.0 * i, -1, -1}, {2.0 * i + 1, 1, 1}});
  }
  const Bvh tree(boxes);
  double limit = 1000;
  std::size_t visits = 0;
  tree.visit_ray({-1, 0.1, 0.2}, {1, 0, 0}, limit, [&](std::uint32_t item) {
    ++visits;
    limit = std::fmin(limit, 2.0 * item + 1);
  });
  EXPECT_EQ(limit, 1);
  EXPECT_LT(visits, 64u);
}

// Centres that coincide leave nothing to split by.
TEST(Bvh, EqualBoxesAreNoTrouble) {
  const std::vector<Aabb> boxes(300, Aabb{{0, 0, 0}, {1, 1, 1}});
  const Bvh tree(boxes);
  std::map<std::uint32_t, int> visits;
  tree.visit_overlaps({{0.5, 0.5, 0.5}, {0.5, 0.5, 0.5}}, [&](std::uint32_t item) { ++visits[item]; });
  EXPECT_EQ(visits.size(), 300u);
}

TEST(Bvh, BoundsAreOfAllBoxes) {
  const Bvh tree(std::vector<Aabb>{{{0, 1, 2}, {1, 2, 3}}, {{-5, 1.5, 0}, {-4, 7, 1}}});
  EXPECT_EQ(tree.bounds().low, (Vec3{-5, 1, 0}));
  EXPECT_EQ(tree.bounds().high, (Vec3{1, 7, 3}));
}

// "Close" is no more than a hint: most of the time it must be about as close as the closest.
TEST(Bvh, ItemNearAPointIsClose) {
  test::Random random(215);
  const std::vector<Aabb> boxes = boxes_in_space(500, 0.1, random);
  const Bvh tree(boxes);
  int close = 0;
  for (int i = 0; i < 500; ++i) {
    const Vec3 point = random.point(10);
    const std::uint32_t item = tree.item_near(point);
    ASSERT_LT(item, boxes.size());
    close += boxes[item].squared_distance(point) < 36 ? 1 : 0;
  }
  EXPECT_GT(close, 450);
}

TEST(Bvh, RayInAFaceOfABoxMeetsIt) {
  const std::vector<Aabb> boxes{{{0, 0, 0}, {1, 1, 1}}};
  const Bvh tree(boxes);
  for (const double x : {0.0, 1.0}) {
    for (const double zero : {0.0, -0.0}) {
      bool met = false;
      double limit = 10;
      tree.visit_ray({x, 0.5, 3}, {zero, zero, -1}, limit, [&](std::uint32_t) { met = true; });
      EXPECT_TRUE(met) << x << " " << zero;
    }
  }
}

// What a query costs: the surfaces of all boxes of the tree, relative to the box around all.
double cost_of(const Bvh& tree) {
  const auto surface_of = [](const abut::BoxSides& sides) {
    const double x = -(static_cast<double>(sides[0]) + static_cast<double>(sides[3])),
                 y = -(static_cast<double>(sides[1]) + static_cast<double>(sides[4])),
                 z = -(static_cast<double>(sides[2]) + static_cast<double>(sides[5]));
    return x * y + y * z + z * x;
  };
  double sum = 0, root = 0;
  std::vector<std::uint32_t> waiting{0};
  while (!waiting.empty()) {
    const std::uint32_t node = waiting.back();
    waiting.pop_back();
    tree.visit_children(node, [&](const abut::EightBoxes& eight) {
      root = node == 0 ? surface_of(eight.sides_around()) : root;
      for (std::size_t lane = 0; lane < abut::EightBoxes::width; ++lane) {
        const std::uint32_t child = eight.numbers.at(lane);
        if (child == abut::EightBoxes::nobody) continue;
        sum += surface_of(eight.sides_of_lane(lane));
        if (!abut::EightBoxes::is_item(child)) waiting.push_back(child);
      }
    });
  }
  return sum / root;
}

// Boxes on rolling ground.
std::vector<Aabb> ground(std::size_t side) {
  std::vector<Aabb> boxes;
  for (std::size_t j = 0; j < side; ++j) {
    for (std::size_t i = 0; i < side; ++i) {
      const double x = static_cast<double>(i), y = static_cast<double>(j);
      boxes.push_back(Aabb::around({x, y, 3 * std::sin(0.1 * x) * std::cos(0.13 * y)}, {0.6, 0.6, 0.2}));
    }
  }
  return boxes;
}

// Many places are torn up one after the other: the tree stays about as good as one that is made anew, and misses
// nothing.
TEST(Bvh, StaysGoodUnderLocalChanges) {
  test::Random random(219);
  const std::size_t side = 120;
  std::vector<Aabb> boxes = ground(side);
  Bvh tree(boxes);
  tree.make_room();
  double worst = 0;
  for (int edit = 0; edit < 150; ++edit) {
    const Vec3 middle{random.uniform(0, 120), random.uniform(0, 120), 0};
    const double reach = random.uniform(2, 15);
    for (std::uint32_t i = 0; i < boxes.size(); ++i) {
      const Vec3 centre = boxes.at(i).centre();
      if (std::hypot(centre.x - middle.x, centre.y - middle.y) < reach) {
        const double size = random.uniform(0.1, 0.8);
        boxes.at(i) = Aabb::around(
            middle + Vec3{random.uniform(-reach, reach), random.uniform(-reach, reach), random.uniform(0, 4)},
            {size, size, 0.3});
        tree.move(i, boxes.at(i));
      }
    }
    const Aabb changed = tree.settle();
    EXPECT_LE(changed.low.x, middle.x);
    worst = std::fmax(worst, cost_of(tree) / cost_of(Bvh(boxes)));
    const Aabb query = Aabb::around(middle, {3, 2, 1});
    std::map<std::uint32_t, int> visits;
    tree.visit_overlaps(query, [&](std::uint32_t item) { ++visits[item]; });
    for (std::uint32_t item = 0; item < boxes.size(); ++item) {
      if (!is_apart(boxes.at(item), query)) EXPECT_EQ(visits[item], 1) << item;
    }
  }
  EXPECT_LT(worst, 1.3);
  EXPECT_FALSE(tree.is_worn());
  std::map<std::uint32_t, int> visits;
  tree.visit_overlaps(Aabb::everything(), [&](std::uint32_t item) { ++visits[item]; });
  EXPECT_EQ(visits.size(), boxes.size());
  for (const auto& [item, times] : visits) EXPECT_EQ(times, 1) << item;
}

// All items move at once, by a little or to anywhere: the tree misses nothing, and stays about as good as one that is
// made anew.
TEST(Bvh, StaysGoodWhereAllMove) {
  test::Random random(221);
  std::vector<Aabb> boxes = ground(70);
  Bvh tree(boxes);
  tree.make_room();
  std::set<std::uint32_t> gone{5, 77, 1234};
  for (const std::uint32_t item : gone) tree.move(item, Aabb::empty());
  static_cast<void>(tree.settle());
  for (int edit = 0; edit < 30; ++edit) {
    const Aabb before = boxes.at(0);
    const bool is_far = edit % 10 == 9;
    for (Aabb& box : boxes) {
      box = is_far ? Aabb::around(random.point(40), {0.3, 0.3, 0.3})
                   : Aabb::around(box.centre() + random.point(0.3), {0.6, 0.6, 0.2});
    }
    tree.move_all([&](std::uint32_t item) { return boxes.at(item); });
    const Aabb changed = tree.settle();
    EXPECT_LE(changed.low.x, std::fmin(before.low.x, boxes.at(0).low.x));
    std::vector<Aabb> present;
    for (std::uint32_t item = 0; item < boxes.size(); ++item) {
      if (gone.count(item) == 0) present.push_back(boxes.at(item));
    }
    EXPECT_LT(cost_of(tree) / cost_of(Bvh(present)), 1.3) << edit;
    for (int query = 0; query < 20; ++query) {
      const Aabb asked = Aabb::around(boxes.at(static_cast<std::size_t>(random.uniform(0, 4899))).centre(), {2, 2, 1});
      std::map<std::uint32_t, int> visits;
      tree.visit_overlaps(asked, [&](std::uint32_t item) { ++visits[item]; });
      for (std::uint32_t item = 0; item < boxes.size(); ++item) {
        const int wanted = gone.count(item) == 0 && !is_apart(boxes.at(item), asked) ? 1 : 0;
        EXPECT_GE(visits[item], wanted) << item;
        EXPECT_LE(visits[item], gone.count(item) == 0 ? 1 : 0) << item;
      }
    }
  }
}

// The box of each item as the tree holds it.
std::map<std::uint32_t, BoxSides> sides_of(const Bvh& tree) {
  std::map<std::uint32_t, BoxSides> sides;
  std::vector<std::uint32_t> waiting{0};
  while (!waiting.empty()) {
    const std::uint32_t node = waiting.back();
    waiting.pop_back();
    tree.visit_children(node, [&](const EightBoxes& its) {
      for (std::size_t lane = 0; lane < EightBoxes::width; ++lane) {
        const std::uint32_t child = its.numbers.at(lane);
        if (EightBoxes::is_item(child)) {
          sides[EightBoxes::item_of(child)] = its.sides_of_lane(lane);
        } else if (child != EightBoxes::nobody) {
          waiting.push_back(child);
        }
      }
    });
  }
  return sides;
}

// Eight at once get the bits that they get one by one, also far from the origin, and where a side is infinite.
TEST(Bvh, MovesAllAsOneByOne) {
  test::Random random(222);
  for (const double far : {0.0, 1e3, 1e9}) {
    std::vector<Aabb> boxes = ground(30);
    for (Aabb& box : boxes) box = {box.low + Vec3{far, -far, far}, box.high + Vec3{far, -far, far}};
    Bvh at_once(boxes), one_by_one(boxes);
    at_once.make_room();
    one_by_one.make_room();
    for (Aabb& box : boxes) box = Aabb::around(box.centre() + random.point(2), {0.3, 0.2, 0.1});
    boxes.at(7).high.y = std::numeric_limits<double>::infinity();
    at_once.move_all([&](std::uint32_t item) { return boxes.at(item); });
    for (std::uint32_t item = 0; item < boxes.size(); ++item) one_by_one.move(item, boxes.at(item));
    static_cast<void>(at_once.settle());
    static_cast<void>(one_by_one.settle());
    EXPECT_EQ(sides_of(at_once), sides_of(one_by_one)) << far;
    EXPECT_EQ(sides_of(at_once).size(), boxes.size());
  }
}

// Items go, and the rest is made anew without them.
TEST(Bvh, IsMadeAnewWithoutItemsThatWent) {
  test::Random random(220);
  std::vector<Aabb> boxes = ground(60);
  Bvh tree(boxes);
  tree.make_room();
  std::set<std::uint32_t> present;
  for (std::uint32_t i = 0; i < boxes.size(); ++i) present.insert(i);
  for (int edit = 0; edit < 40; ++edit) {
    const Vec3 middle{random.uniform(0, 60), random.uniform(0, 60), 0};
    for (const std::uint32_t i : std::vector<std::uint32_t>(present.begin(), present.end())) {
      const Vec3 centre = boxes.at(i).centre();
      if (std::hypot(centre.x - middle.x, centre.y - middle.y) > 6) continue;
      if (random.uniform(0, 1) < 0.3) {
        tree.move(i, Aabb::empty());
        present.erase(i);
      } else {
        boxes.at(i) = Aabb::around(middle + random.point(6), {0.3, 0.3, 0.3});
        tree.move(i, boxes.at(i));
      }
    }
    static_cast<void>(tree.settle());
    std::set<std::uint32_t> found;
    tree.visit_overlaps(Aabb::everything(), [&](std::uint32_t item) { EXPECT_TRUE(found.insert(item).second); });
    ASSERT_EQ(found, present) << edit;
  }
}

}  // namespace
