// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <random>
#include <string>
#include <vector>

import abut.math;
import abut.trees.boxes.box_tree;

namespace {

using abut::BoxTree;
using abut::CompactAabb;

CompactAabb box_at(float x, float y, float z, float half) {
  return {{x - half, y - half, z - half}, {x + half, y + half, z + half}};
}

std::vector<std::uint32_t> visited(const BoxTree& tree, const CompactAabb& box) {
  std::vector<std::uint32_t> leaves;
  tree.visit(box, [&](std::uint32_t leaf) { leaves.push_back(leaf); });
  std::sort(leaves.begin(), leaves.end());
  return leaves;
}

// Closed intervals on each axis, in order of numbers.
std::vector<std::uint32_t> expected(const std::map<std::uint32_t, CompactAabb>& boxes, const CompactAabb& query) {
  std::vector<std::uint32_t> leaves;
  for (const auto& [leaf, box] : boxes) {
    bool apart = false;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      apart = apart || box.low[axis] > query.high[axis] || box.high[axis] < query.low[axis];
    }
    if (!apart) {
      leaves.push_back(leaf);
    }
  }
  return leaves;
}

TEST(BoxTree, EmptyShowsNothing) {
  const BoxTree tree;
  EXPECT_TRUE(visited(tree, box_at(0, 0, 0, 1000)).empty());
}

TEST(BoxTree, OneLeafIsShownWhereItIs) {
  BoxTree tree;
  tree.insert(9, box_at(1, 2, 3, 1));
  EXPECT_EQ(visited(tree, box_at(1, 2, 3, 0)), (std::vector<std::uint32_t>{9}));
  EXPECT_TRUE(visited(tree, box_at(4, 2, 3, 0)).empty());
  tree.move(9, box_at(4, 2, 3, 1));
  EXPECT_EQ(visited(tree, box_at(4, 2, 3, 0)), (std::vector<std::uint32_t>{9}));
  EXPECT_TRUE(visited(tree, box_at(1, 2, 3, 0)).empty());
  tree.erase(9);
  EXPECT_TRUE(visited(tree, box_at(4, 2, 3, 100)).empty());
}

TEST(BoxTree, TouchingCounts) {
  BoxTree tree;
  for (std::uint32_t i = 0; i < 20; ++i) {
    tree.insert(i, box_at(static_cast<float>(4 * i), 0, 0, 1));
  }
  EXPECT_EQ(visited(tree, {{5, 1, -1}, {7, 1, -1}}), (std::vector<std::uint32_t>{1, 2}));
  EXPECT_TRUE(visited(tree, {{5.5f, 1, -1}, {6.5f, 1, -1}}).empty());
  EXPECT_TRUE(visited(tree, {{5, 1.0001f, -1}, {7, 2, -1}}).empty());
}

TEST(BoxTree, NumbersCanBeUsedAgain) {
  BoxTree tree;
  for (int round = 0; round < 20; ++round) {
    for (std::uint32_t leaf : {0u, 5u, 17u}) {
      tree.insert(leaf, box_at(static_cast<float>(leaf), 0, 0, 0.25f));
    }
    EXPECT_EQ(visited(tree, box_at(0, 0, 0, 50)), (std::vector<std::uint32_t>{0, 5, 17}));
    for (std::uint32_t leaf : {5u, 0u, 17u}) {
      tree.erase(leaf);
    }
    EXPECT_TRUE(visited(tree, box_at(0, 0, 0, 50)).empty());
  }
}

// Leaves come, go, drift and jump; queries of every size are those of a plain loop.
TEST(BoxTree, ShowsExactlyWhatOverlaps) {
  for (std::uint32_t seed = 1; seed <= 6; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    const auto uniform = [&](float low, float high) {
      return std::uniform_real_distribution<float>(low, high)(random);
    };
    const auto somewhere = [&](float half) {
      return box_at(uniform(-9, 9), uniform(-9, 9), uniform(-9, 9), uniform(0, half));
    };
    BoxTree tree;
    std::map<std::uint32_t, CompactAabb> boxes;
    std::size_t most = 0;
    for (int step = 0; step < 4000; ++step) {
      const auto leaf = static_cast<std::uint32_t>(random() % 150);
      const auto known = boxes.find(leaf);
      if (known == boxes.end()) {
        boxes[leaf] = somewhere(1.5f);
        tree.insert(leaf, boxes[leaf]);
      } else if (random() % 4 == 0) {
        tree.erase(leaf);
        boxes.erase(known);
      } else if (random() % 4 == 0) {
        known->second = somewhere(1.5f);
        tree.move(leaf, known->second);
      } else {
        const float drift = uniform(-0.2f, 0.2f);
        for (std::size_t axis = 0; axis < 3; ++axis) {
          known->second.low[axis] += drift;
          known->second.high[axis] += drift;
        }
        tree.move(leaf, known->second);
      }
      const CompactAabb query = somewhere(step % 20 == 0 ? 20.0f : 2.0f);
      const std::vector<std::uint32_t> all = expected(boxes, query);
      ASSERT_EQ(visited(tree, query), all) << "step " << step;
      most = std::max(most, all.size());
    }
    EXPECT_GT(most, 50u);
  }
}

// Deep enough for leaves to go elsewhere below nodes of several levels.
TEST(BoxTree, LeavesThatDriftAreFoundWhereTheyAre) {
  std::mt19937 random(269);
  const auto uniform = [&](float low, float high) { return std::uniform_real_distribution<float>(low, high)(random); };
  BoxTree tree;
  std::map<std::uint32_t, CompactAabb> boxes;
  for (std::uint32_t leaf = 0; leaf < 3000; ++leaf) {
    boxes[leaf] = box_at(uniform(-9, 9), uniform(-9, 9), uniform(-9, 9), uniform(0.1f, 0.5f));
    tree.insert(leaf, boxes[leaf]);
  }
  for (int step = 0; step < 20; ++step) {
    for (auto& [leaf, box] : boxes) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const float drift = uniform(-0.4f, 0.4f);
        box.low[axis] += drift;
        box.high[axis] += drift;
      }
      tree.move(leaf, box);
    }
    if (step % 4 == 3) {
      tree.tidy();
    }
    for (int i = 0; i < 100; ++i) {
      const CompactAabb query = box_at(uniform(-9, 9), uniform(-9, 9), uniform(-9, 9), uniform(0, 2));
      ASSERT_EQ(visited(tree, query), expected(boxes, query)) << "step " << step;
    }
  }
}

TEST(BoxTree, MemoryStaysConstantWhenNumbersDo) {
  std::mt19937 random(271);
  std::uniform_real_distribution<float> place(-10, 10);
  BoxTree tree;
  for (std::uint32_t leaf = 0; leaf < 100; ++leaf) {
    tree.insert(leaf, box_at(place(random), place(random), place(random), 0.5f));
  }
  const std::size_t bytes = tree.bytes();
  for (int step = 0; step < 5000; ++step) {
    const auto leaf = static_cast<std::uint32_t>(random() % 100);
    tree.erase(leaf);
    tree.insert(leaf, box_at(place(random), place(random), place(random), 0.5f));
  }
  EXPECT_EQ(tree.bytes(), bytes);
}

// Equal boxes leave the surface no choice.
TEST(BoxTree, EqualBoxesAreNoTrouble) {
  BoxTree tree;
  for (std::uint32_t leaf = 0; leaf < 300; ++leaf) {
    tree.insert(leaf, box_at(1, 1, 1, 0));
  }
  EXPECT_EQ(visited(tree, box_at(1, 1, 1, 0)).size(), 300u);
  EXPECT_TRUE(visited(tree, box_at(2, 1, 1, 0.5f)).empty());
}

}  // namespace
