// SPDX-License-Identifier: Apache-2.0
// Velocities where jobs look for them: by the places of geometries, before pairs are examined.
#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

import abut.pairs.any_shape;
import abut.universe;

namespace {

using namespace abut;

TEST(VelocityOfJobs, IsThatOfThisStepByThePlaceOfAGeometry) {
  Universe universe({}, 1);
  const Placement far{{9, 0, 0}, {1, 0, 0, 0}};
  const std::array<PartOptions, 2> options{PartOptions{}, PartOptions{MotionKind::dynamic, far, 0}};
  const std::vector<PartId> parts = universe.create_parts(options).value();
  const ShapeHandle ball(make_shape(find_kind("sphere").value(), std::array{1.0}, {}, {}).value());
  const std::array shapes{ball, ball};
  ASSERT_TRUE(universe.create_geometries(parts, shapes, {}).has_value());
  const Velocity given{{1, 2, 3}, {4, 5, 6}};
  const std::optional<Velocity> wanted(given);
  ASSERT_TRUE(universe.set_velocities(std::span(parts).first(1), std::span(&wanted, 1)).has_value());
  ASSERT_TRUE(universe.measure_velocities(std::span(parts).last(1)).has_value());
  ASSERT_TRUE(universe.step(0.5).has_value());
  std::vector<Velocity> seen;
  universe.set_filter([&](GeometryId a, GeometryId b) {
    seen = {universe.velocity_at(a.slot - 1), universe.velocity_at(b.slot - 1)};
    return true;
  });
  const Placement near{{1, 0, 0}, {1, 0, 0, 0}};
  ASSERT_TRUE(universe.set_poses(std::span(parts).last(1), std::span(&near, 1)).has_value());
  ASSERT_TRUE(universe.step(0.5).has_value());
  ASSERT_EQ(seen.size(), 2U);
  EXPECT_EQ(seen[0], given);
  EXPECT_EQ(seen[1], (Velocity{{-16, 0, 0}, {0, 0, 0}}));
}

}  // namespace
