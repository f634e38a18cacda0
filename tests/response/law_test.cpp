// SPDX-License-Identifier: Apache-2.0
// What one contact does, by closed forms.
#include <abut/response.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "world.hpp"

namespace {

using namespace response_test;

// A point mass in effect: the contact lies at the centre.
World point_mass(const Vector& velocity, const Contact& contact) {
  World world;
  world.add({.mass = 2, .inertia = {1, 1, 1}, .linear = velocity});
  world.contacts.push_back(contact);
  return world;
}

TEST(ContactLaw, StopsWhatApproachesAndLetsGoWhatLeaves) {
  const Answer stopped = point_mass({0, 0, -3}, {}).solve();
  EXPECT_NEAR(stopped.linear(0).z, 0, 3e-9);
  EXPECT_NEAR(stopped.impulse(0).z, 6, 6e-9);
  const Answer leaving = point_mass({0, 0, 3}, {}).solve();
  EXPECT_EQ(leaving.linear(0).z, 3);
  EXPECT_EQ(leaving.impulse(0).z, 0);
  EXPECT_EQ(leaving.residuals.rounds, 0U);
}

TEST(ContactLaw, PushesTheOtherSideBack) {
  World world;
  world.add({.mass = 1, .inertia = {1, 1, 1}, .centre = {0, 0, 0}, .linear = {0, 0, 2}});
  world.add({.mass = 3, .inertia = {1, 1, 1}, .centre = {0, 0, 2}});
  world.contacts.push_back({.a = 0, .b = 1, .point = {0, 0, 1}});
  const Answer answer = world.solve();
  EXPECT_NEAR(answer.linear(0).z, 0.5, 1e-8);
  EXPECT_NEAR(answer.linear(1).z, 0.5, 1e-8);
  EXPECT_NEAR(answer.impulse(0).z, 1.5, 1e-8);
}

TEST(ContactLaw, ClosesAGapInAStep) {
  const Answer closing = point_mass({0, 0, -3}, {.offset = 1}).solve();
  EXPECT_NEAR(closing.linear(0).z, -1, 3e-9);
  const Answer open = point_mass({0, 0, -3}, {.offset = 4}).solve();
  EXPECT_EQ(open.linear(0).z, -3);
}

// u + c f = 0 and 2 (u + 3) = f.
TEST(ContactLaw, YieldsByItsCompliance) {
  const Answer answer = point_mass({0, 0, -3}, {.compliance = 0.25}).solve();
  EXPECT_NEAR(answer.impulse(0).z, 4, 1e-8);
  EXPECT_NEAR(answer.linear(0).z, -1, 1e-8);
}

TEST(ContactLaw, SticksWithinTheConeAndSlidesOnIt) {
  const Answer stuck = point_mass({0.4, 0.3, -1}, {.friction = 0.51}).solve();
  EXPECT_NEAR(length(stuck.linear(0)), 0, 1e-8);
  const Answer sliding = point_mass({4, 3, -1}, {.friction = 0.5}).solve();
  EXPECT_NEAR(sliding.linear(0).x, 4 - 0.4, 1e-8);
  EXPECT_NEAR(sliding.linear(0).y, 3 - 0.3, 1e-8);
  EXPECT_NEAR(sliding.impulse(0).z, 2, 1e-8);
}

TEST(ContactLaw, DragsWhatLiesOnABelt) {
  const Answer answer = point_mass({0, 0, -1}, {.friction = 0.5, .surface = {-4, 0, 0}}).solve();
  EXPECT_NEAR(answer.linear(0).x, 0.5, 1e-8);
  EXPECT_NEAR(answer.linear(0).z, 0, 1e-8);
}

// The normal may point anywhere and have any length.
TEST(ContactLaw, HoldsForNormalsOfAnyDirectionAndLength) {
  for (const Vector& normal : {Vector{1, 1, 1}, Vector{0, 0, -1}, Vector{1e-3, 0, 0}, Vector{0, -1e20, 1e20}}) {
    World world = point_mass({0.3, -2, -1}, {.normal = normal, .friction = 0.5});
    const Answer answer = world.solve();
    ASSERT_EQ(answer.status, ABUT_OK) << abut_last_error_message();
    EXPECT_LE(world.worst_miss(answer), 1e-8);
  }
}

// Friction 0.5 along t and 0.2 along s: the impulse lies on the ellipse where it dissipates most.
TEST(ContactLaw, DissipatesMostOnAnEllipse) {
  constexpr std::array inertia{1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0};
  constexpr std::array centre{0.0, 0.0, 0.0}, normal{0.0, 0.0, 1.0}, tangent{0.6, 0.8, 5.0};
  constexpr std::array free{20.0, 10.0, -1.0, 0.0, 0.0, 0.0};
  constexpr std::array frictions{0.5, 0.2};
  constexpr double mass = 2;
  constexpr std::array<std::uint32_t, 2> sides{ABUT_NO_BODY, 0};
  abut_contact_problem problem;
  abut_contact_problem_init(&problem, sizeof problem);
  problem.body_count = problem.contact_count = 1;
  problem.masses = &mass;
  problem.inertias = inertia.data();
  problem.centres = problem.points = centre.data();
  problem.free_velocities = free.data();
  problem.bodies = sides.data();
  problem.normals = normal.data();
  problem.tangents = tangent.data();
  problem.frictions = frictions.data();
  std::array<double, 6> v{};
  std::array<double, 3> impulse{};
  abut_residuals residuals;
  ASSERT_EQ(abut_contact_problem_solve(&problem, nullptr, v.data(), impulse.data(), &residuals), ABUT_OK)
      << abut_last_error_message();
  const double along = 0.6 * v[0] + 0.8 * v[1], across = -0.8 * v[0] + 0.6 * v[1];
  const double size = std::hypot(0.5 * along, 0.2 * across);
  EXPECT_NEAR(0.6 * impulse[0] + 0.8 * impulse[1], -impulse[2] * 0.25 * along / size, 1e-7);
  EXPECT_NEAR(-0.8 * impulse[0] + 0.6 * impulse[1], -impulse[2] * 0.04 * across / size, 1e-7);
  EXPECT_NEAR(impulse[2], 2, 1e-7);
}

// A ball that is pressed down and pushed: sliding until its point of contact rests, then rolling with 5/7 of the speed.
TEST(ContactLaw, RollsABall) {
  World world;
  world.add({.mass = 1, .inertia = {0.4, 0.4, 0.4}, .centre = {0, 0, 1}, .linear = {7, 0, -100}});
  world.contacts.push_back({.friction = 0.5});
  const Answer answer = world.solve();
  EXPECT_NEAR(answer.linear(0).x, 5, 1e-6);
  EXPECT_NEAR(answer.angular(0).y, 5, 1e-6);
}

TEST(ContactLaw, HasNothingToDoWithoutContacts) {
  World world;
  const Answer nothing = world.solve();
  EXPECT_EQ(nothing.status, ABUT_OK);
  EXPECT_EQ(nothing.residuals.is_converged, 1U);
  world.add({.mass = 1, .inertia = {1, 1, 1}, .linear = {1, 2, 3}, .angular = {4, 5, 6}});
  EXPECT_EQ(world.solve().velocities, (std::vector<double>{1, 2, 3, 4, 5, 6}));
}

}  // namespace
