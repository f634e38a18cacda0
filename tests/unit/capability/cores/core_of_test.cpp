// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <type_traits>

#include "../../made.hpp"
#include "../../random_boxes.hpp"

import abut.capability;
import abut.math;
import abut.shapes.box;
import abut.shapes.capsule;
import abut.shapes.point;
import abut.shapes.segment;
import abut.shapes.sphere;
import abut.shapes.triangle;

namespace {

using abut::CoreOf;
using abut::Pose;

template <class... Shapes>
constexpr bool have_one_core = (std::is_same_v<CoreOf<Shapes>, CoreOf<abut::Ball>> && ...);

// Shapes of one core share all searches.
static_assert(have_one_core<abut::Point, abut::Sphere, abut::Ball, abut::PointCore>);
static_assert(std::is_same_v<CoreOf<abut::Segment>, CoreOf<abut::Capsule>>);
static_assert(std::is_same_v<CoreOf<abut::FreeTriangle>, CoreOf<abut::Triangle>>);
static_assert(std::is_same_v<CoreOf<abut::Box>, abut::Box>);

TEST(CoreOf, KeepsTheRadius) {
  EXPECT_EQ(core_of(test::made<abut::Sphere>({0.25})).radius(), 0.25);
  EXPECT_EQ(core_of(test::made<abut::Point>({})).radius(), 0);
  EXPECT_EQ(core_of(test::made<abut::Capsule>({0.25, 2})).radius(), 0.25);
  EXPECT_EQ(core_of(test::made<abut::Capsule>({0.25, 2})).half_length(), 2);
  EXPECT_EQ(core_of(test::made<abut::Segment>({3})).radius(), 0);
}

// A box around a rounded core holds its furthest points, and no more.
TEST(CoreOf, BoxIsThatOfTheRoundedCore) {
  test::Random random(331);
  for (int i = 0; i < 200; ++i) {
    const abut::SegmentCore core(abut::norm(random.point(1)), abut::norm(random.point(1)));
    const Pose pose{random.rotation(), random.point(5)};
    const abut::Aabb box = core.aabb(pose);
    for (int axis = 0; axis < 3; ++axis) {
      const abut::Vec3 direction{axis == 0 ? 1.0 : 0.0, axis == 1 ? 1.0 : 0.0, axis == 2 ? 1.0 : 0.0};
      const auto furthest = [&](double side) {
        return (pose * core.support(pose.rotation.undo(side * direction)).point)[axis] + side * core.radius();
      };
      EXPECT_NEAR(box.high[axis], furthest(1), 1e-14);
      EXPECT_NEAR(box.low[axis], furthest(-1), 1e-14);
    }
  }
}

}  // namespace
