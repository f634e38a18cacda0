// Both broad phases find the pairs that a plain double loop finds, whatever happens to the boxes.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <optional>
#include <random>
#include <vector>

import abut.broadphase;
import abut.math;

namespace {

using abut::CompactAabb;
using abut::Mobility;
using abut::ProxyPair;

constexpr float unbounded = std::numeric_limits<float>::infinity();

struct Known {
  CompactAabb box;
  Mobility mobility;
  std::uint32_t group;
};

CompactAabb box_at(float x, float y, float z, float half) {
  return {{x - half, y - half, z - half}, {x + half, y + half, z + half}};
}

std::vector<std::array<std::uint32_t, 2>> numbers(const std::vector<ProxyPair>& pairs) {
  std::vector<std::array<std::uint32_t, 2>> all;
  for (const ProxyPair& pair : pairs) {
    all.push_back({pair.low, pair.high});
  }
  return all;
}

// Written without any of the code under test: closed intervals on each axis.
std::vector<std::array<std::uint32_t, 2>> expected(const std::vector<std::optional<Known>>& scene) {
  std::vector<std::array<std::uint32_t, 2>> all;
  for (std::uint32_t i = 0; i < scene.size(); ++i) {
    for (std::uint32_t j = i + 1; j < scene.size(); ++j) {
      if (!scene[i] || !scene[j] || scene[i]->group == scene[j]->group) {
        continue;
      }
      if (scene[i]->mobility == Mobility::still && scene[j]->mobility == Mobility::still) {
        continue;
      }
      bool apart = false;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        apart = apart || scene[i]->box.high[axis] < scene[j]->box.low[axis] ||
                scene[j]->box.high[axis] < scene[i]->box.low[axis];
      }
      if (!apart) {
        all.push_back({i, j});
      }
    }
  }
  return all;
}

template <class BroadPhase>
class BroadPhases : public testing::Test {};
using Implementations = testing::Types<abut::Brute, abut::Tree>;
TYPED_TEST_SUITE(BroadPhases, Implementations);

TYPED_TEST(BroadPhases, EmptyHasNoPairs) {
  TypeParam broad_phase;
  std::vector<ProxyPair> pairs{{1, 2}};
  broad_phase.find_pairs(pairs);
  EXPECT_TRUE(pairs.empty());
}

TYPED_TEST(BroadPhases, TouchingBoxesPair) {
  TypeParam broad_phase;
  broad_phase.insert(5, box_at(0, 0, 0, 1), Mobility::moving, 1);
  broad_phase.insert(2, box_at(2, 0, 0, 1), Mobility::moving, 2);
  std::vector<ProxyPair> pairs;
  broad_phase.find_pairs(pairs);
  EXPECT_EQ(pairs, (std::vector<ProxyPair>{{2, 5}}));
  broad_phase.update(2, box_at(std::nextafter(2.0f, 3.0f), 0, 0, 1));
  broad_phase.find_pairs(pairs);
  EXPECT_TRUE(pairs.empty());
}

TYPED_TEST(BroadPhases, OneGroupNeverPairs) {
  TypeParam broad_phase;
  broad_phase.insert(0, box_at(0, 0, 0, 1), Mobility::moving, 7);
  broad_phase.insert(1, box_at(0, 0, 0, 1), Mobility::moving, 7);
  broad_phase.insert(2, box_at(0, 0, 0, 1), Mobility::moving, 8);
  std::vector<ProxyPair> pairs;
  broad_phase.find_pairs(pairs);
  EXPECT_EQ(pairs, (std::vector<ProxyPair>{{0, 2}, {1, 2}}));
}

TYPED_TEST(BroadPhases, StillBoxesPairWithMovingOnesOnly) {
  TypeParam broad_phase;
  broad_phase.insert(0, box_at(0, 0, 0, 1), Mobility::still, 0);
  broad_phase.insert(1, box_at(0, 0, 0, 1), Mobility::still, 1);
  broad_phase.insert(2, box_at(0, 0, 0, 1), Mobility::moving, 2);
  broad_phase.insert(3, {{-unbounded, -unbounded, -unbounded}, {unbounded, unbounded, 0}}, Mobility::still, 3);
  std::vector<ProxyPair> pairs;
  broad_phase.find_pairs(pairs);
  EXPECT_EQ(pairs, (std::vector<ProxyPair>{{0, 2}, {1, 2}, {2, 3}}));
  broad_phase.update(0, box_at(0.5f, 0, 0, 1));
  broad_phase.find_pairs(pairs);
  EXPECT_EQ(pairs, (std::vector<ProxyPair>{{0, 2}, {1, 2}, {2, 3}}));
}

TYPED_TEST(BroadPhases, ErasedNumberCanBeUsedAgain) {
  TypeParam broad_phase;
  broad_phase.insert(0, box_at(0, 0, 0, 1), Mobility::moving, 0);
  broad_phase.insert(1, box_at(0, 0, 0, 1), Mobility::moving, 1);
  std::vector<ProxyPair> pairs;
  broad_phase.find_pairs(pairs);
  EXPECT_EQ(pairs.size(), 1u);
  broad_phase.erase(1);
  broad_phase.insert(1, box_at(9, 0, 0, 1), Mobility::moving, 1);
  broad_phase.find_pairs(pairs);
  EXPECT_TRUE(pairs.empty());
  broad_phase.erase(0);
  broad_phase.erase(1);
  broad_phase.find_pairs(pairs);
  EXPECT_TRUE(pairs.empty());
}

// Boxes come, go, drift, jump and grow without bounds; after every change both agree with the loop.
TYPED_TEST(BroadPhases, PairsAreThoseOfADoubleLoop) {
  for (std::uint32_t seed = 1; seed <= 8; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    const auto uniform = [&](float low, float high) { return std::uniform_real_distribution<float>(low, high)(random); };
    const auto somewhere = [&] { return box_at(uniform(-6, 6), uniform(-6, 6), uniform(-6, 6), uniform(0.1f, 1.5f)); };
    std::vector<std::optional<Known>> scene(120);
    TypeParam broad_phase;
    std::vector<ProxyPair> pairs;
    std::size_t most = 0;
    for (int frame = 0; frame < 60; ++frame) {
      for (std::uint32_t i = 0; i < scene.size(); ++i) {
        const float dice = uniform(0, 1);
        if (!scene[i]) {
          if (dice < 0.3f) {
            const bool is_plane = dice < 0.01f;
            scene[i] = {is_plane ? CompactAabb{{-unbounded, -unbounded, -unbounded}, {unbounded, unbounded, uniform(-6, 6)}}
                                 : somewhere(),
                        uniform(0, 1) < 0.7f ? Mobility::moving : Mobility::still, i / 3};
            broad_phase.insert(i, scene[i]->box, scene[i]->mobility, scene[i]->group);
          }
          continue;
        }
        if (dice < 0.02f) {
          broad_phase.erase(i);
          scene[i].reset();
        } else if (dice < 0.06f) {
          scene[i]->box = somewhere();
          broad_phase.update(i, scene[i]->box);
        } else if (dice < 0.065f) {
          scene[i]->box.high[2] = unbounded;
          broad_phase.update(i, scene[i]->box);
        } else if (dice < 0.7f && scene[i]->box.high[2] < unbounded) {
          for (std::size_t axis = 0; axis < 3; ++axis) {
            const float step = uniform(-0.1f, 0.1f);
            scene[i]->box.low[axis] += step;
            scene[i]->box.high[axis] += step;
          }
          broad_phase.update(i, scene[i]->box);
        }
      }
      broad_phase.find_pairs(pairs);
      ASSERT_EQ(numbers(pairs), expected(scene)) << "frame " << frame;
      most = std::max(most, pairs.size());
    }
    EXPECT_GT(most, 100u);  // the scene is crowded enough to mean something
  }
}

TYPED_TEST(BroadPhases, MemoryStaysConstantWhenNumbersDo) {
  TypeParam broad_phase;
  std::mt19937 random(3);
  std::uniform_real_distribution<float> place(-10, 10);
  std::vector<CompactAabb> boxes;
  for (std::uint32_t i = 0; i < 200; ++i) {
    boxes.push_back(box_at(place(random), place(random), place(random), 0.7f));
    broad_phase.insert(i, boxes.back(), Mobility::moving, i);
  }
  std::vector<ProxyPair> pairs;
  std::size_t bytes = 0;
  for (int frame = 0; frame < 300; ++frame) {
    // All boxes go round the same circle, so that the pairs stay the same.
    const float x = frame % 2 == 0 ? 0.4f : -0.4f;
    for (std::uint32_t i = 0; i < 200; ++i) {
      boxes[i].low[0] += x;
      boxes[i].high[0] += x;
      broad_phase.update(i, boxes[i]);
    }
    broad_phase.find_pairs(pairs);
    if (frame == 100) {
      bytes = broad_phase.bytes();
    }
  }
  EXPECT_EQ(broad_phase.bytes(), bytes);
}

}  // namespace
