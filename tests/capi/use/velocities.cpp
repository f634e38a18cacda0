// SPDX-License-Identifier: Apache-2.0
// Velocities of parts: stored, measured and handed out, and without any effect.
#include <cmath>

#include "support.hpp"

namespace {

using namespace abut_test;

constexpr abut_velocity some{{1, 2, 3}, {0.5, -0.25, 4}};

abut_velocity velocity_of(const abut_universe* universe, abut_part_id part, abut_velocity_source expected) {
  abut_velocity out{};
  abut_velocity_source source = 7;
  require(abut_part_velocity(universe, part, &out, &source));
  EXPECT_EQ(source, expected);
  return out;
}
void expect_velocity(const abut_velocity& found, const abut_vec3& linear, const abut_vec3& angular) {
  EXPECT_NEAR(found.linear.x, linear.x, 1e-13);
  EXPECT_NEAR(found.linear.y, linear.y, 1e-13);
  EXPECT_NEAR(found.linear.z, linear.z, 1e-13);
  EXPECT_NEAR(found.angular.x, angular.x, 1e-13);
  EXPECT_NEAR(found.angular.y, angular.y, 1e-13);
  EXPECT_NEAR(found.angular.z, angular.z, 1e-13);
}

TEST(Velocities, StayAsTheyAreGiven) {
  Universe universe;
  const abut_part_id part = universe.add_part(identity), other = universe.add_part(identity);
  expect_velocity(velocity_of(universe, part, ABUT_VELOCITY_NONE), {0, 0, 0}, {0, 0, 0});
  require(abut_part_set_velocity(universe, part, &some));
  universe.move(part, at(5, 0, 0));
  require(abut_universe_step(universe, 0.1));
  expect_velocity(velocity_of(universe, part, ABUT_VELOCITY_GIVEN), some.linear, some.angular);
  expect_velocity(velocity_of(universe, other, ABUT_VELOCITY_NONE), {0, 0, 0}, {0, 0, 0});
  require(abut_part_set_velocity(universe, part, nullptr));
  expect_velocity(velocity_of(universe, part, ABUT_VELOCITY_NONE), {0, 0, 0}, {0, 0, 0});
}

TEST(Velocities, FollowFromTwoPosesAndTheTime) {
  Universe universe;
  const abut_part_id part = universe.add_part(at(1, 0, 0));
  require(abut_part_measure_velocity(universe, part));
  expect_velocity(velocity_of(universe, part, ABUT_VELOCITY_FROM_POSES), {0, 0, 0}, {0, 0, 0});
  const double angle = 0.6;
  universe.move(part, {{1, 3, 0}, {std::cos(angle / 2), 0, std::sin(angle / 2), 0}});
  require(abut_universe_step(universe, 0.5));
  expect_velocity(velocity_of(universe, part, ABUT_VELOCITY_FROM_POSES), {0, 6, 0}, {0, angle / 0.5, 0});
  universe.move(part, at(9, 9, 9));
  require(abut_universe_step(universe, 0));
  require(abut_universe_detect_all(universe));
  expect_velocity(velocity_of(universe, part, ABUT_VELOCITY_FROM_POSES), {0, 6, 0}, {0, angle / 0.5, 0});
  require(abut_universe_step(universe, 2));
  expect_velocity(velocity_of(universe, part, ABUT_VELOCITY_FROM_POSES), {4, 3, 4.5}, {0, -angle / 2, 0});
  require(abut_universe_step(universe, 2));
  expect_velocity(velocity_of(universe, part, ABUT_VELOCITY_FROM_POSES), {0, 0, 0}, {0, 0, 0});
  require(abut_part_set_velocity(universe, part, &some));
  universe.move(part, identity);
  require(abut_universe_step(universe, 1));
  expect_velocity(velocity_of(universe, part, ABUT_VELOCITY_GIVEN), some.linear, some.angular);
}

TEST(Velocities, OfManyPartsAreThoseOfEach) {
  Universe universe;
  std::vector<abut_part_id> parts;
  std::vector<abut_velocity> given;
  for (int i = 0; i < 10; ++i) {
    parts.push_back(universe.add_part(at(i, 0, 0)));
    given.push_back({{1.0 * i, 0, 0}, {0, 0, 2.0 * i}});
  }
  require(abut_parts_set_velocities(universe, parts.data(), given.data(), parts.size()));
  OutArray<abut_velocity> out(10);
  require(abut_parts_velocities(universe, parts.data(), 10, out.data()));
  for (std::size_t i = 0; i < 10; ++i) expect_velocity(out[i], given.at(i).linear, given.at(i).angular);
  require(abut_part_destroy(universe, parts[4]));
  const abut_part_id next = universe.add_part(identity);
  EXPECT_EQ(next.slot, parts[4].slot);
  expect_velocity(velocity_of(universe, next, ABUT_VELOCITY_NONE), {0, 0, 0}, {0, 0, 0});
  require(abut_parts_measure_velocities(universe, parts.data(), 4));
  for (int i = 0; i < 4; ++i) universe.move(parts.at(static_cast<std::size_t>(i)), at(i, i, 0));
  require(abut_part_destroy(universe, parts[1]));
  require(abut_universe_step(universe, 0.5));
  for (const int i : {0, 2, 3}) {
    expect_velocity(velocity_of(universe, parts.at(static_cast<std::size_t>(i)), ABUT_VELOCITY_FROM_POSES),
                    {0, 2.0 * i, 0}, {0, 0, 0});
  }
  require(abut_parts_set_velocities(universe, &parts[2], nullptr, 1));
  expect_velocity(velocity_of(universe, parts[2], ABUT_VELOCITY_NONE), {0, 0, 0}, {0, 0, 0});
  expect_velocity(velocity_of(universe, parts[5], ABUT_VELOCITY_GIVEN), {5, 0, 0}, {0, 0, 10});
}

// Contacts, events and what sleeps are the same bits with and without.
TEST(Velocities, ChangeNothingElse) {
  std::array<std::uint64_t, 2> hashes{};
  std::array<std::uint64_t, 2> bytes{};
  for (const std::size_t has_velocities : {0U, 1U}) {
    Universe universe;
    const Shape box = make_box(0.5, 0.5, 0.5);
    const abut_sleep sleep = default_sleep();
    std::vector<abut_part_id> parts;
    for (int i = 0; i < 8; ++i) {
      parts.push_back(universe.add_part(at(0.98 * i, 0, 0)));
      universe.add_geometry(parts.back(), box);
      require(abut_part_set_sleep(universe, parts.back(), &sleep));
      if (has_velocities == 1 && i % 2 == 0) require(abut_part_set_velocity(universe, parts.back(), &some));
      if (has_velocities == 1 && i % 2 == 1) require(abut_part_measure_velocity(universe, parts.back()));
    }
    for (int step = 0; step < 30; ++step) {
      if (step == 20) universe.move(parts[3], at(3, 0.25, 0));
      require(abut_universe_step(universe, 0.01));
      hashes.at(has_velocities) = hashes.at(has_velocities) * 31 + universe.hash();
    }
    bytes.at(has_velocities) = universe.stats().bytes;
  }
  EXPECT_EQ(hashes[0], hashes[1]);
  EXPECT_LT(bytes[0], bytes[1]) << "nothing is held without any";
}

}  // namespace
