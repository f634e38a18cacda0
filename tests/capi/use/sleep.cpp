// SPDX-License-Identifier: Apache-2.0
// Parts that fall asleep where they have come to rest: VX-23 of the specification.
#include <cmath>

#include "sleep_room.hpp"

namespace {

using namespace abut_test;

TEST(Sleep, AStackFallsAsleepInTheStepThatMakesTenCalmOnes) {
  Room room;
  const auto stack = room.add_stack(4);
  for (int step = 1; step < until_asleep; ++step) {
    room.step();
    EXPECT_TRUE(room.changes().empty()) << step;
    EXPECT_EQ(room.asleep(), 0U);
  }
  room.step();
  EXPECT_EQ(room.changed(true), slots_of(stack));
  EXPECT_EQ(room.asleep(), 4U);
  room.step();
  EXPECT_TRUE(room.changes().empty());
  EXPECT_EQ(room.asleep(), 4U);
}

TEST(Sleep, NobodySleepsWhoIsNotAskedTo) {
  Room room;
  const abut_part_id part = room.universe.add_part(at(0, 0, 0.49));
  room.universe.add_geometry(part, room.box);
  room.step(50);
  EXPECT_EQ(room.asleep(), 0U);
  EXPECT_FALSE(room.is_asleep(part));
}

TEST(Sleep, ARestlessMemberKeepsItsIslandAwake) {
  Room room;
  const auto stack = room.add_stack(3);
  abut_pose pose = at(0, 0, 0.49);
  for (int step = 0; step < 40; ++step) {
    pose.position.x += 0.15 * dt;
    room.universe.move(stack[0], pose);
    room.step();
    ASSERT_EQ(room.asleep(), 0U);
  }
  room.step(10);
  EXPECT_EQ(room.asleep(), 0U) << "it has braked in the first of them";
  room.step();
  EXPECT_EQ(room.changed(true), slots_of(stack));
}

// The speeds of uniform motion, and of one that gains as much in each step, a little below and above what is allowed.
enum class Way { linear_speed, linear_acceleration, angular_speed, angular_acceleration };

bool falls_asleep(Way way, double factor) {
  Room room;
  const abut_part_id part = room.add_box(at(0, 0, 5));
  abut_sleep sleep = default_sleep();
  // Accelerations are tried while speeds are free, for as many steps as it takes.
  if (way == Way::linear_acceleration) sleep.linear_speed = 10;
  if (way == Way::angular_acceleration) sleep.angular_speed = 10;
  room.set_sleep(part, sleep);
  const bool is_turning = way == Way::angular_speed || way == Way::angular_acceleration;
  const bool is_faster = way == Way::linear_acceleration || way == Way::angular_acceleration;
  const double limit = way == Way::linear_speed ? 0.14 : way == Way::angular_speed ? 0.03 : 0.045;
  for (int step = 0; step < 40; ++step) {
    const double time = step * dt;
    const double way_so_far = factor * limit * (is_faster ? 0.5 * time * time : time);
    abut_pose pose = at(is_turning ? 0 : way_so_far, 0, 5);
    if (is_turning) pose.orientation = {std::cos(way_so_far / 2), 0, std::sin(way_so_far / 2), 0};
    room.universe.move(part, pose);
    room.step();
    if (room.asleep() > 0) return true;
  }
  return false;
}

TEST(Sleep, EachThresholdHolds) {
  for (const Way way : {Way::linear_speed, Way::linear_acceleration, Way::angular_speed, Way::angular_acceleration}) {
    EXPECT_TRUE(falls_asleep(way, 0.999)) << int(way);
    EXPECT_FALSE(falls_asleep(way, 1.001)) << int(way);
  }
}

TEST(Sleep, ThresholdsOfZeroAskForStandingStill) {
  Room room;
  const abut_part_id part = room.add_box({{0, 0, 5}, {0.5, 0.5, -0.5, 0.5}});
  abut_sleep sleep = default_sleep();
  sleep.linear_speed = sleep.linear_acceleration = sleep.angular_speed = sleep.angular_acceleration = 0;
  sleep.steps = 3;
  room.set_sleep(part, sleep);
  room.step(4);
  EXPECT_EQ(room.asleep(), 0U);
  room.step();
  EXPECT_EQ(room.asleep(), 1U);
}

TEST(Sleep, SensorsJoinNobody) {
  Room room;
  const auto stack = room.add_stack(1), restless = room.add_stack(1, 5);
  abut_geometry_options sensor = default_geometry_options();
  sensor.flags = ABUT_GEOMETRY_SENSOR;
  const Shape zone = make_sphere(8);
  room.universe.add_geometry(restless[0], zone, sensor);
  for (int step = 1; step <= until_asleep; ++step) {
    room.universe.move(restless[0], at(5 + 0.1 * step, 0, 0.49));
    room.step();
  }
  EXPECT_TRUE(room.is_asleep(stack[0]));
  EXPECT_FALSE(room.is_asleep(restless[0]));
  room.universe.move(restless[0], at(50, 0, 0.49));
  room.step();
  EXPECT_TRUE(room.is_asleep(stack[0])) << "the end of a touch of a sensor";
}

TEST(Sleep, BoxesOfPoliciesJoinNobody) {
  Room room;
  const abut_part_id one = room.universe.add_part(at(0, 0, 5)), other = room.universe.add_part(at(0, 0, 5));
  room.universe.add_geometry(one, room.ball);
  room.universe.add_geometry(other, room.ball);
  abut_policy policy = default_policy();
  policy.detail = ABUT_DETAIL_BOX;
  require(abut_policy_set(room.universe, 0, 0, &policy));
  room.set_sleep(one, default_sleep());
  room.step(until_asleep);
  EXPECT_EQ(room.universe.stats().touching_pairs, 3U) << "the box of the floor is without bounds";
  EXPECT_TRUE(room.is_asleep(one));
}

TEST(Sleep, StepsWithoutTimeNeitherCountNorWake) {
  Room room;
  const auto stack = room.add_stack(2);
  room.step(until_asleep - 1);
  for (int i = 0; i < 30; ++i) {
    require(abut_universe_step(room.universe, 0));
    require(abut_universe_detect_all(room.universe));
    require(abut_universe_detect_changed(room.universe));
    require(abut_universe_refresh(room.universe));
    ASSERT_EQ(room.asleep(), 0U);
  }
  room.step();
  ASSERT_EQ(room.asleep(), 2U);
  const abut_aabb everywhere{{-infinity, -infinity, -infinity}, {infinity, infinity, infinity}};
  require(abut_universe_step(room.universe, 0));
  EXPECT_TRUE(room.changes().empty()) << "of the last step";
  require(abut_universe_detect_all(room.universe));
  require(abut_universe_detect_region(room.universe, &everywhere));
  require(abut_universe_detect_pairs(room.universe, room.boxes.data(), room.boxes.data(), 2));
  EXPECT_EQ(room.asleep(), 2U);
}

TEST(Sleep, EventsSayThatAPairIsAsleep) {
  Room room;
  const auto stack = room.add_stack(2);
  const abut_part_id zone = room.universe.add_part(at(0, 0, 1.2), ABUT_MOTION_STATIC);
  abut_geometry_options sensor = default_geometry_options();
  sensor.flags = ABUT_GEOMETRY_SENSOR;
  const abut_geometry_id trigger = room.universe.add_geometry(zone, room.ball, sensor);
  room.step(until_asleep - 1);
  EXPECT_EQ(room.universe.events().size(), 4U);
  for (const abut_event& event : room.universe.events()) EXPECT_EQ(event.flags & ABUT_EVENT_ASLEEP, 0U);
  room.step();
  for (const abut_event& event : room.universe.events())
    EXPECT_EQ(event.flags & ABUT_EVENT_ASLEEP, std::uint32_t{ABUT_EVENT_ASLEEP});
  room.universe.park(trigger, ABUT_PARKING_SHORT_TERM);
  room.step();
  EXPECT_EQ(letters_of(room.universe.events()), "ppee") << "the sensor leaves, and nobody wakes";
  for (const abut_event& event : room.universe.events()) {
    EXPECT_EQ((event.flags & ABUT_EVENT_ASLEEP) != 0, event.kind != ABUT_EVENT_END);
  }
  require(abut_part_destroy(room.universe, stack[1]));
  room.step();
  EXPECT_EQ(letters_of(room.universe.events()), "pe");
  for (const abut_event& event : room.universe.events()) EXPECT_EQ(event.flags & ABUT_EVENT_ASLEEP, 0U);
}

TEST(Sleep, ChangesAreTheSameOnAnyNumberOfThreads) {
  Room one(1), two(2);
  std::size_t changes = 0;
  for (Room* room : {&one, &two}) {
    for (int x = 0; x < 20; ++x) room->add_stack(8, 3.0 * x);
  }
  for (int step = 0; step < 60; ++step) {
    for (Room* room : {&one, &two}) {
      if (step % 7 == 3)
        room->universe.move({static_cast<std::uint32_t>(2 + step), room->floor.generation}, at(3.0 * step, 9, 20));
      room->step();
    }
    ASSERT_EQ(one.changed(true), two.changed(true));
    ASSERT_EQ(one.changed(false), two.changed(false));
    ASSERT_EQ(one.universe.hash(), two.universe.hash());
    changes += one.changes().size();
  }
  EXPECT_GT(changes, 160U);
}

TEST(Sleep, TheHashHoldsTheChangesOfAStep) {
  abut_universe_options silent = default_universe_options();
  silent.events = 0;
  const Universe plain(&silent), sleeping(&silent);
  abut_part_id part{};
  for (const Universe* universe : {&plain, &sleeping}) require(abut_part_create(*universe, nullptr, &part));
  const abut_sleep sleep = default_sleep();
  require(abut_part_set_sleep(sleeping, part, &sleep));
  for (int step = 1; step <= until_asleep + 1; ++step) {
    for (const Universe* universe : {&plain, &sleeping}) require(abut_universe_step(*universe, dt));
    EXPECT_EQ(plain.hash() != sleeping.hash(), step == until_asleep) << step;
  }
}

TEST(Sleep, IsInThePlan) {
  Room room;
  const auto explained = [&] {
    std::array<char, 8192> text{};
    std::size_t needed = 0;
    require(abut_universe_explain(room.universe, text.data(), text.size(), &needed));
    return std::string(text.data());
  };
  EXPECT_NE(explained().find("sleep: set for no part"), std::string::npos);
  room.add_stack(2);
  room.step(until_asleep);
  EXPECT_EQ(explained().find("sleep: set"), std::string::npos);
  EXPECT_NE(explained().find("3 parts (2 asleep)"), std::string::npos);
}

}  // namespace
