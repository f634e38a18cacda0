// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>

#include "../../random_boxes.hpp"
#include "../../random_shapes.hpp"

import abut.capability;
import abut.math;
import abut.narrow.convex.placed_pair;
import abut.narrow.convex;
import abut.narrow.points.lane_contact;
import abut.shapes.box;
import abut.shapes.capsule;
import abut.shapes.cylinder;
import abut.shapes.sphere;

namespace {

using abut::Box;
using abut::Capsule;
using abut::Cylinder;
using abut::Sphere;

struct Placed {
  abut::Pose pose_a, pose_b;
  abut::QuerySettings settings;
};
Placed random_placed(test::Random& random) {
  Placed placed{{random.rotation(), random.point(10)}, {random.rotation(), {}}, {}};
  placed.pose_b.position = placed.pose_a.position + random.point(1.5);
  placed.settings.margin = random.uniform(-0.3, 0.3);
  return placed;
}

// Two shapes in the world have the contacts that they have in the frame of the first one.
template <class A, class B>
void expect_contacts_of_frame(std::uint64_t seed) {
  test::Random random(seed);
  std::size_t touching = 0, apart = 0, open = 0;
  for (int i = 0; i < 2000; ++i) {
    SCOPED_TRACE(i);
    const A a = test::random_shape<A>(random, 0.1);
    const B b = test::random_shape<B>(random, 0.1);
    const Placed placed = random_placed(random);
    abut::Manifold found, expected;
    const auto append = [&](const abut::LaneContact& contact) { append_contact(contact, found); };
    if (!contacts_of_placed(a, b, placed.pose_a, placed.pose_b, placed.settings, append)) {
      EXPECT_TRUE(found.empty());
      ++open;
      continue;
    }
    const abut::Pose ab = relative(placed.pose_a, placed.pose_b);
    ASSERT_EQ(abut::convex_contacts(a, b, ab, placed.settings, expected), abut::Outcome::ok);
    ASSERT_EQ(found.size(), expected.size());
    (found.empty() ? apart : touching) += 1;
    for (std::size_t k = 0; k < found.size(); ++k) {
      move_by(expected[k], placed.pose_a);
      EXPECT_NEAR(found[k].distance, expected[k].distance, 1e-12);
      EXPECT_NEAR(dot(found[k].point_b - found[k].point_a, found[k].normal), found[k].distance, 1e-13);
      EXPECT_NEAR(squared_norm(found[k].normal), 1, 1e-14);
      EXPECT_EQ(found[k].feature_a, expected[k].feature_a);
      EXPECT_EQ(found[k].id, abut::contact_id(found[k].feature_a, found[k].feature_b));
      EXPECT_LE(largest_magnitude(found[k].point_a - expected[k].point_a), 1e-9);
      EXPECT_LE(largest_magnitude(found[k].point_b - expected[k].point_b), 1e-9);
    }
  }
  EXPECT_GT(touching, 300u);
  EXPECT_GT(apart, 300u);
  EXPECT_LT(open, 20u);
}

TEST(PlacedPair, SpheresTouchAsInTheFrameOfOne) { expect_contacts_of_frame<Sphere, Sphere>(451); }
TEST(PlacedPair, SphereAndCapsuleTouchAsInTheFrameOfOne) { expect_contacts_of_frame<Sphere, Capsule>(452); }
TEST(PlacedPair, CapsulesTouchAsInTheFrameOfOne) { expect_contacts_of_frame<Capsule, Capsule>(453); }

// A point that is told to be beyond a reach is so, and most of those that are far are told.
template <class S>
void expect_beyond_as_nearest(std::uint64_t seed) {
  test::Random random(seed);
  std::size_t told = 0, far = 0;
  for (int i = 0; i < 5000; ++i) {
    SCOPED_TRACE(i);
    const S shape = test::random_shape<S>(random, 0.1);
    const abut::Vec3 point = random.point(2);
    const double distance = shape.nearest(point).distance;
    EXPECT_FALSE(shape.is_beyond(point, distance + 1e-14));
    const double reach = random.uniform(-0.5, 1);
    far += distance > reach ? 1 : 0;
    if (shape.is_beyond(point, reach)) {
      ++told;
      EXPECT_GT(distance, reach);
    }
  }
  EXPECT_GT(2 * told, far);
}
TEST(PlacedPair, BoxTellsWhatIsBeyondReach) { expect_beyond_as_nearest<Box>(454); }
TEST(PlacedPair, CylinderTellsWhatIsBeyondReach) { expect_beyond_as_nearest<Cylinder>(455); }

TEST(PlacedPair, CylinderTellsThatItIsShortOfAReach) {
  test::Random random(456);
  std::size_t told = 0, is_short = 0;
  for (int i = 0; i < 5000; ++i) {
    SCOPED_TRACE(i);
    const auto can = test::random_shape<Cylinder>(random, 0.1);
    const abut::Vec3 direction = random.rotation().z;
    const double most = dot(can.support(direction).point, direction);
    EXPECT_FALSE(can.is_short_of(direction, most));
    const double reach = random.uniform(-0.5, 2);
    is_short += most < reach ? 1 : 0;
    if (can.is_short_of(direction, reach)) {
      ++told;
      EXPECT_LT(most, reach);
    }
  }
  EXPECT_GT(100 * told, 99 * is_short);
}

}  // namespace
