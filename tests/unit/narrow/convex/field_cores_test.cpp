// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <optional>

#include "../../made.hpp"
#include "../../random_boxes.hpp"
#include "../../random_shapes.hpp"

import abut.capability;
import abut.math;
import abut.narrow.convex.field_cores;
import abut.narrow.convex.separation;
import abut.shapes.box;
import abut.shapes.capsule;
import abut.shapes.cone;
import abut.shapes.cylinder;
import abut.shapes.ellipsoid;

namespace {

using abut::Vec3;

// What is found lies within the bounds of a search, belongs to both cores, and is nothing for cores that overlap.
template <class A, class B>
void expect_distances_of_a_search(std::uint64_t seed) {
  test::Random random(seed);
  std::size_t apart = 0, proven = 0, overlapping = 0;
  for (int i = 0; i < 2000; ++i) {
    SCOPED_TRACE(i);
    const A a = test::random_shape<A>(random, 0.2);
    const B b = test::random_shape<B>(random, 0.2);
    const abut::Pose ab{random.rotation(), random.point(2)};
    const std::optional<abut::CoreSeparation> found = separate_fields(a, b, ab, {});
    const abut::CoreSeparation expected = separate_cores(a, b, ab, {}, abut::infinity);
    (expected.overlap ? overlapping : apart) += 1;
    if (!found) {
      continue;
    }
    ++proven;
    ASSERT_FALSE(expected.overlap);
    const double size = core_size(a, b, ab), error = error_of(a, b, size, {});
    EXPECT_LE(found->upper - found->lower, error);
    EXPECT_LE(found->lower, expected.upper + expected.rounding);
    EXPECT_GE(found->upper, expected.lower - expected.rounding);
    EXPECT_NEAR(dot(found->point_b - found->point_a, found->normal), found->distance, 1e-14);
    EXPECT_LE(largest_magnitude(nearest_in(a, found->point_a) - found->point_a), 1e-13);
    EXPECT_LE(largest_magnitude(ab * nearest_in(b, ab.undo(found->point_b)) - found->point_b), 1e-13);
  }
  EXPECT_GT(overlapping, 40u);
  EXPECT_GT(10 * proven, 8 * apart);
}

TEST(FieldCores, Cylinders) { expect_distances_of_a_search<abut::Cylinder, abut::Cylinder>(461); }
TEST(FieldCores, BoxAndCylinder) { expect_distances_of_a_search<abut::Box, abut::Cylinder>(462); }
TEST(FieldCores, CapsuleAndCone) { expect_distances_of_a_search<abut::Capsule, abut::Cone>(463); }
TEST(FieldCores, ConeAndEllipsoid) { expect_distances_of_a_search<abut::Cone, abut::Ellipsoid>(464); }

// Cores that nearly touch are left to the search: the line between their points is rounding.
TEST(FieldCores, NothingForCoresThatNearlyTouch) {
  const auto can = test::made<abut::Cylinder>({0.5, 1});
  EXPECT_FALSE(separate_fields(can, can, {abut::Rotation::identity(), {1 + 1e-9, 0, 0}}, {}).has_value());
  EXPECT_TRUE(separate_fields(can, can, {abut::Rotation::identity(), {1.5, 0, 0.25}}, {}).has_value());
}

}  // namespace
