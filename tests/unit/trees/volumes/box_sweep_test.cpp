// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>

#include "../../broadphase/box_scene.hpp"
#include "../../random_boxes.hpp"

import abut.math;
import abut.trees.volumes.box_sweep;
import abut.trees.volumes.eight_boxes;

namespace {

using Numbers = std::array<double, 3>;

abut::Vec3 vector(const Numbers& p) { return {p[0], p[1], p[2]}; }

struct Motion {
  Numbers centre, half, displacement;
};

abut::CompactSweep compact_sweep(const Motion& motion) {
  return abut::CompactSweep(abut::BoxSweep(vector(motion.centre), vector(motion.half), vector(motion.displacement)));
}

abut::EightBoxes blocks_of(const std::array<box_scene::Box, 8>& boxes) {
  abut::EightBoxes block;
  for (std::size_t lane = 0; lane < boxes.size(); ++lane) {
    block.set_sides(lane, abut::sides_of({boxes[lane].low, boxes[lane].high}));
  }
  return block;
}

// Any power of ten between the two, either sign, sometimes zero.
double any_size(test::Random& random, double least, double most) {
  const double size = std::pow(10, random.uniform(least, most));
  const double choice = random.uniform(0, 1);
  return choice < 0.1 ? 0 : choice < 0.55 ? size : -size;
}

TEST(CompactSweep, NeverMeetsABoxLaterThanInExactArithmetic) {
  test::Random random(1);
  std::size_t met = 0;
  for (int round = 0; round < 40'000; ++round) {
    const double scale = random.uniform(-300, 300), place = random.uniform(-30, 17);
    Motion motion{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      motion.centre[axis] = any_size(random, place - 3, place + 3);
      motion.half[axis] = std::fabs(any_size(random, place - 5, place));
      motion.displacement[axis] = any_size(random, scale - (round % 4 == 0 ? 50 : 3), scale);
    }
    std::array<box_scene::Box, 8> boxes{};
    for (box_scene::Box& box : boxes) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto middle = static_cast<float>(any_size(random, place - 3, place + 1));
        const auto half = static_cast<float>(std::fabs(any_size(random, place - 2, place + 3)));
        box.low[axis] = middle - half;
        box.high[axis] = middle + half;
      }
    }
    const double most = round % 2 == 0 ? abut::infinity : std::pow(10, place - scale);
    const abut::CompactSweep sweep = compact_sweep(motion);
    const auto ways = blocks_of(boxes).entries(sweep, sweep.way_of(most));
    for (std::size_t lane = 0; lane < boxes.size(); ++lane) {
      const auto time = box_scene::time_of_meeting(boxes[lane], motion.centre, motion.half, motion.displacement, most);
      // Times that are no normal double cannot be compared.
      using Limits = std::numeric_limits<double>;
      const bool is_normal = time && *time < static_cast<long double>(Limits::max()) &&
                             (*time == 0 || *time > static_cast<long double>(Limits::min()));
      if (is_normal) {
        ++met;
        ASSERT_LT(ways[lane], std::numeric_limits<float>::infinity()) << round << " " << lane;
        ASSERT_LE(ways[lane], sweep.way_of(static_cast<double>(*time))) << round << " " << lane;
      }
    }
  }
  EXPECT_GT(met, 40'000U);
}

// Along x the way exceeds the largest float, along y it does not.
TEST(CompactSweep, MeetsBoxesBeyondTheLargestFloat) {
  const Motion motion{{1e60, -2e60, 0}, {0, 0, 0}, {-0.5, 1, 0}};
  std::array<box_scene::Box, 8> boxes{};
  boxes.fill(box_scene::box_at(0, 0, 0, 1));
  ASSERT_TRUE(box_scene::time_of_meeting(boxes[0], motion.centre, motion.half, motion.displacement, abut::infinity));
  const abut::CompactSweep sweep = compact_sweep(motion);
  const auto ways = blocks_of(boxes).entries(sweep, sweep.way_of(abut::infinity));
  EXPECT_LT(ways[0], std::numeric_limits<float>::infinity());
}

TEST(CompactSweep, MeetsBoxesWithinRoundingOfSinglePrecision) {
  test::Random random(2);
  for (int round = 0; round < 2000; ++round) {
    const Motion motion{{random.uniform(-9, 9), random.uniform(-9, 9), random.uniform(-9, 9)},
                        {0.1, 0.2, 0.3},
                        {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(1, 2)}};
    std::array<box_scene::Box, 8> boxes{};
    for (box_scene::Box& box : boxes) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        box.low[axis] = static_cast<float>(random.uniform(-9, 9));
        box.high[axis] = box.low[axis] + 1;
      }
    }
    const abut::CompactSweep sweep = compact_sweep(motion);
    const auto ways = blocks_of(boxes).entries(sweep, sweep.way_of(abut::infinity));
    Numbers wider = motion.half;
    for (double& side : wider) {
      side += 1e-4;
    }
    for (std::size_t lane = 0; lane < boxes.size(); ++lane) {
      const auto time =
          box_scene::time_of_meeting(boxes[lane], motion.centre, wider, motion.displacement, abut::infinity);
      if (!time) {
        EXPECT_EQ(ways[lane], std::numeric_limits<float>::infinity()) << round << " " << lane;
      } else if (ways[lane] < std::numeric_limits<float>::infinity()) {
        EXPECT_GE(ways[lane], static_cast<float>(*time) - 1e-4F) << round << " " << lane;
      }
    }
  }
}

}  // namespace
