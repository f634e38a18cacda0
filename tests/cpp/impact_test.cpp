// SPDX-License-Identifier: Apache-2.0
// Shapes that move and turn.
#include <abut/abut.hpp>
#include <gtest/gtest.h>

#include <vector>

namespace {

const abut::Movement no_movement{};
const abut::Pose unturned = abut::pose({0, 0, 0}), five_away = abut::pose({5, 0, 0});

abut::Movement towards() {
  abut::Movement movement{};
  movement.velocity = {-6, 0, 0};
  return movement;
}

TEST(Impact, TellsWhenTwoShapesTouch) {
  const abut::Shape box = abut::Shape::box(1, 1, 1);
  const abut::Impact impact = abut::pair_time_of_impact(box, unturned, no_movement, box, five_away, towards(), 1);
  EXPECT_EQ(impact.state, ABUT_IMPACT_TOUCHES);
  EXPECT_NEAR(impact.upper, 0.5, 1e-12);
  EXPECT_NEAR(impact.contact.normal.x, 1, 1e-12);
  const abut::Impact near = abut::pair_time_of_impact(box, unturned, no_movement, box, five_away, towards(), 1,
                                                      abut::ImpactOptions().with_margin(0.6));
  EXPECT_NEAR(near.upper, 0.4, 1e-12);
}

TEST(Impact, TellsThemOfMany) {
  const abut::Shape box = abut::Shape::box(1, 1, 1);
  const std::vector<abut::Pose> poses_a{unturned, unturned}, poses_b{five_away, unturned};
  const std::vector<abut::Movement> movements_a{no_movement, no_movement}, movements_b{towards(), towards()};
  std::vector<abut::Impact> impacts(2);
  abut::pairs_time_of_impact(box, poses_a, movements_a, box, poses_b, movements_b, 1, impacts);
  EXPECT_NEAR(impacts[0].upper, 0.5, 1e-12);
  EXPECT_EQ(impacts[1].state, ABUT_IMPACT_STARTS_TOGETHER);
  EXPECT_NEAR(impacts[1].contact.distance, -2, 1e-12);
}

TEST(Impact, MakesAMovementOfTwoPoses) {
  const abut::Movement made = abut::movement_between(unturned, five_away, {0, 0, 0}, 0.5);
  EXPECT_EQ(made.velocity.x, 10);
  EXPECT_EQ(made.angular_velocity.z, 0);
  EXPECT_THROW(static_cast<void>(abut::movement_between(unturned, five_away, {0, 0, 0}, 0)), abut::Error);
}

TEST(Impact, IsCastThroughAUniverse) {
  abut::Universe universe;
  const abut::Shape box = abut::Shape::box(1, 1, 1), ball = abut::Shape::sphere(1);
  const abut::PartId part = universe.create_part(abut::PartOptions().with_pose(five_away));
  const abut::GeometryId wall = universe.create_geometry(part, box);
  universe.refresh();
  abut::Movement roll{};
  roll.velocity = {6, 0, 0};
  roll.angular_velocity = {0, 3, 0};
  const auto hit = universe.cast_movement(ball, unturned, roll, 1);
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->geometry, wall);
  EXPECT_NEAR(hit->impact.upper, 0.5, 1e-12);
  EXPECT_EQ(universe.cast_movement_all(ball, unturned, roll, 1).size(), 1U);
  EXPECT_FALSE(universe.cast_movement(ball, unturned, roll, 0.25));
  const auto hits = universe.cast_movements({ball, ball}, {unturned, abut::pose({0, 9, 0})}, {roll, roll}, 1);
  EXPECT_EQ(hits[0].geometry, wall);
  EXPECT_TRUE(abut::is_null(hits[1].geometry));
  EXPECT_THROW(static_cast<void>(universe.cast_movements({ball}, {unturned}, {}, 1)), abut::Error);
}

}  // namespace
