// SPDX-License-Identifier: Apache-2.0
// One body, by closed forms.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "scene.hpp"

namespace {

using namespace response_test;

double size(const abut_vec3& v) { return std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z); }

// Constant forces are exact, whatever the step.
TEST(Body, FallsOnItsParabola) {
  for (const double step : {1e-3, 0.125, 0.5}) {
    Scene scene;
    const abut_part_id part = scene.body(ball(0.1), {{0, 0, 5}, no_turn}, 2, {{3, 0, 4}, {0, 0, 0}});
    scene.step(step, static_cast<int>(std::lround(1 / step)));
    EXPECT_NEAR(scene.pose(part).position.x, 3, 1e-12);
    EXPECT_NEAR(scene.pose(part).position.z, 5 + 4 - 0.5 * gravity, 1e-11);
    EXPECT_NEAR(scene.velocity(part).linear.z, 4 - gravity, 1e-11);
  }
}

TEST(Body, KeepsEnergyAndMomentumWhereItTumbles) {
  Scene scene([](abut_response_options& its) { its.gravity = {0, 0, 0}; });
  scene.body(block(0.5, 0.3, 0.1), {{1, 2, 3}, {0.8, 0.6, 0, 0}}, 7, {{0.1, 0, 0}, {0.2, 9, 0.1}});
  const abut_energy before = scene.energy();
  scene.step(1e-2, 10000);
  const abut_energy after = scene.energy();
  EXPECT_NEAR(after.kinetic, before.kinetic, 1e-9 * before.kinetic);
  // The centre has gone far, so its part of the momentum has rounded more often.
  const abut_vec3 lost{after.angular_momentum.x - before.angular_momentum.x,
                       after.angular_momentum.y - before.angular_momentum.y,
                       after.angular_momentum.z - before.angular_momentum.z};
  EXPECT_LE(size(lost), 1e-11 * size(before.angular_momentum));
}

// Each step of the midpoint rule is off by the cube of the angle.
TEST(Body, TurnsAsFastAsItIsTold) {
  Scene scene([](abut_response_options& its) { its.gravity = {0, 0, 0}; });
  const abut_part_id part = scene.body(ball(1), {{0, 0, 0}, no_turn}, 1, {{0, 0, 0}, {0, 0, 1}});
  scene.step(1e-3, 1000);
  const abut_quat turn = scene.pose(part).orientation;
  EXPECT_NEAR(2 * std::atan2(turn.z, turn.w), 1, 1e-7);
}

// m g / k for any stiffness and step, where dampers have brought the body to rest.
TEST(Body, RestsAsDeepAsItsWeightSays) {
  constexpr double mass = 2, size = 0.5;
  for (const double stiffness : {1e2, 1e4, 1e6, 1e8, 1e10}) {
    for (const double step : {1e-4, 1e-3, 1e-2, 1e-1}) {
      Scene scene([](abut_response_options& its) { its.tolerance = 1e-14; }, 0.1);
      scene.material([&](abut_contact_material& row) {
        row.compliance = 1 / stiffness;
        row.damping = 2 * std::sqrt(stiffness * mass);
      });
      scene.floor();
      const double depth = mass * gravity / stiffness;
      const abut_part_id part = scene.body(ball(size), {{0, 0, size - 0.9 * depth}, no_turn}, mass);
      scene.step(step, static_cast<int>(std::ceil(50 / (step * std::sqrt(stiffness / mass)))) + 10);
      // Rounding of coordinates is all that is left.
      EXPECT_NEAR(size - scene.pose(part).position.z, depth, 1e-9 * depth + 2e-15) << stiffness << " " << step;
      EXPECT_NEAR(scene.contacts().front().force.z, mass * gravity, 1e-8 + 2e-15 * stiffness);
    }
  }
}

// Implicit Euler by hand: v1 (m + h h k) = m (v0 - g h) - h k x0.
TEST(Body, MeetsASpringAsImplicitEulerDoes) {
  constexpr double stiffness = 1e4, mass = 1, step = 1e-4;
  Scene scene(
      [](abut_response_options& its) {
        its.gravity = {0, 0, 0};
        its.tolerance = 1e-13;
      },
      0.1);
  scene.material([](abut_contact_material& row) { row.compliance = 1 / stiffness; });
  scene.floor();
  const abut_part_id part = scene.body(ball(0.5), {{0, 0, 0.5}, no_turn}, mass, {{0, 0, -1}, {0, 0, 0}});
  double deepest = 0;
  for (int i = 0; i < 400; ++i) {
    scene.step(step);
    deepest = std::max(deepest, 0.5 - scene.pose(part).position.z);
  }
  // exp(-pi h omega / 2) of an approach, and nearly v / omega: h omega is 0.01.
  EXPECT_NEAR(scene.velocity(part).linear.z, 0.98441, 1e-4);
  EXPECT_NEAR(deepest, 0.00992, 1e-5);
}

// By f >= 0 the contact ends before it would pull.
TEST(Body, LosesToADamperWhatTheClosedFormSays) {
  constexpr double stiffness = 1e4, mass = 1, zeta = 0.1;
  Scene scene([](abut_response_options& its) { its.gravity = {0, 0, 0}; }, 0.1);
  scene.material([](abut_contact_material& row) {
    row.compliance = 1 / stiffness;
    row.damping = 2 * zeta * std::sqrt(stiffness * mass);
  });
  scene.floor();
  const abut_part_id part = scene.body(ball(0.5), {{0, 0, 0.5}, no_turn}, mass, {{0, 0, -1}, {0, 0, 0}});
  scene.step(1e-5, 4000);
  EXPECT_NEAR(scene.velocity(part).linear.z, 0.74408, 2e-3);
}

Scene incline(double friction, double degrees, double tolerance) {
  Scene scene([&](abut_response_options& its) {
    const double angle = degrees * std::numbers::pi / 180;
    its.gravity = {gravity * std::sin(angle), 0, -gravity * std::cos(angle)};
    its.tolerance = tolerance;
  });
  scene.material([&](abut_contact_material& row) { row.friction_primary = row.friction_secondary = friction; });
  scene.floor();
  return scene;
}

TEST(Body, SticksOnAnInclineOfEnoughFriction) {
  Scene scene = incline(0.6, 30, 1e-13);
  const abut_part_id part = scene.body(block(0.5, 0.5, 0.2), {{0, 0, 0.2}, no_turn}, 3);
  scene.step(1e-2, 10);
  const abut_vec3 before = scene.pose(part).position;
  scene.step(1e-2, 1000);
  EXPECT_NEAR(scene.pose(part).position.x, before.x, 1e-12);
  EXPECT_NEAR(scene.pose(part).position.z, before.z, 1e-12);
  for (const abut_response_contact& contact : scene.contacts()) {
    EXPECT_NE(contact.state, abut_contact_state{ABUT_CONTACT_STATE_SLIDING});
  }
}

TEST(Body, SlidesDownAnInclineOfLittleFriction) {
  Scene scene = incline(0.5, 30, 1e-12);
  const abut_part_id part = scene.body(block(0.5, 0.5, 0.2), {{0, 0, 0.2}, no_turn}, 3);
  scene.step(1e-2, 100);
  EXPECT_NEAR(scene.velocity(part).linear.x, 0.6571454, 1e-6);
  EXPECT_NEAR(scene.velocity(part).linear.z, 0, 1e-9);
  bool is_one_sliding = false;
  for (const abut_response_contact& contact : scene.contacts()) {
    is_one_sliding = is_one_sliding || contact.state == ABUT_CONTACT_STATE_SLIDING;
  }
  EXPECT_TRUE(is_one_sliding);
}

// Sliding until 2 v0 / (7 mu g) = 1.01937 s, then rolling with 5/7 of the speed.
TEST(Body, RollsAfterItHasSlid) {
  Scene scene([](abut_response_options& its) { its.tolerance = 1e-12; });
  scene.material([](abut_contact_material& row) { row.friction_primary = row.friction_secondary = 0.2; });
  scene.floor();
  const abut_part_id part = scene.body(ball(0.25), {{0, 0, 0.25}, no_turn}, 2, {{7, 0, 0}, {0, 0, 0}});
  scene.step(1e-3, 1015);
  EXPECT_GT(scene.velocity(part).linear.x, 5.005);
  scene.step(1e-3, 10);
  EXPECT_NEAR(scene.velocity(part).linear.x, 5, 1e-9);
  scene.step(1e-3, 1000);
  EXPECT_NEAR(scene.velocity(part).linear.x, 5, 1e-9);
  EXPECT_NEAR(scene.velocity(part).angular.y, 20, 1e-8);
}

TEST(Body, RollsDownAnInclineByFiveSeventhsOfTheSlope) {
  Scene scene = incline(0.3, 30, 1e-12);
  const abut_part_id part = scene.body(ball(0.25), {{0, 0, 0.25}, no_turn}, 2);
  scene.step(1e-3, 1000);
  EXPECT_NEAR(scene.velocity(part).linear.x, 3.5035714, 1e-6);
}

// The frame of a part need not lie at the centre of mass.
TEST(Body, TurnsAboutItsCentreOfMass) {
  Scene scene([](abut_response_options& its) { its.gravity = {0, 0, 0}; });
  const abut_part_id part = scene.place(ball(1), {{0, 0, 0}, no_turn}, ABUT_MOTION_DYNAMIC);
  scene.attach(part, ball(1), {{4, 0, 0}, no_turn});
  require(abut_response_add_bodies(scene.response(), &part, 1, nullptr));
  abut_mass_properties mass{};
  require(abut_response_body(scene.response(), part, &mass));
  const double one = 4000 * std::numbers::pi / 3;
  EXPECT_NEAR(mass.mass, 2 * one, 1e-9);
  EXPECT_NEAR(mass.centre.x, 2, 1e-12);
  EXPECT_NEAR(mass.inertia[4], 2 * one * (0.4 + 4), 1e-7);
  // A turn about the centre: the origin of the part, 2 m away, moves by it.
  const abut_velocity turning{{0, -2, 0}, {0, 0, 1}};
  require(abut_part_set_velocity(scene.universe(), part, &turning));
  scene.step(1e-3, 3142);
  EXPECT_NEAR(scene.pose(part).position.x, 4, 1e-5);
  EXPECT_NEAR(scene.pose(part).position.y, 0, 2e-3);
}

TEST(Body, AnswersForcesAndTorquesOnce) {
  Scene scene([](abut_response_options& its) { its.gravity = {0, 0, 0}; });
  const abut_part_id part = scene.body(ball(1), {{1, 2, 3}, no_turn}, 5);
  const abut_vec3 force{10, 0, 0}, at{1, 3, 3}, torque{0, 0, 4};
  require(abut_response_apply_force(scene.response(), part, &force, nullptr));
  require(abut_response_apply_force(scene.response(), part, &force, &at));
  require(abut_response_apply_torque(scene.response(), part, &torque));
  scene.step(0.1, 2);
  EXPECT_NEAR(scene.velocity(part).linear.x, 20 * 0.1 / 5, 1e-15);
  EXPECT_NEAR(scene.velocity(part).angular.z, (4 - 10) * 0.1 / 2, 1e-15);
}

// A ball that is put into the ground comes out by no more than it has to, and gains no speed.
TEST(Body, IsMovedApartWithoutSpeed) {
  Scene scene([](abut_response_options& its) { its.gravity = {0, 0, 0}; });
  scene.floor();
  const abut_part_id part = scene.body(ball(0.5), {{0, 0, 0.3}, no_turn}, 2);
  scene.step(1e-2);
  EXPECT_NEAR(scene.pose(part).position.z, 0.5 - 1e-5, 1e-6);
  EXPECT_EQ(scene.energy().kinetic, 0);
}

TEST(Body, RidesOnABeltAndOnALift) {
  Scene scene;
  scene.material([](abut_contact_material& row) { row.friction_primary = row.friction_secondary = 0.5; });
  const abut_part_id belt = scene.place(block(50, 1, 1), {{0, 0, -1}, no_turn}, ABUT_MOTION_ANIMATED);
  const abut_velocity moving{{2, 0, 0.5}, {0, 0, 0}};
  require(abut_part_set_velocity(scene.universe(), belt, &moving));
  const abut_part_id part = scene.body(block(0.2, 0.2, 0.2), {{0, 0, 0.2}, no_turn}, 3);
  for (int i = 0; i < 200; ++i) {
    scene.step(1e-2);
    abut_pose pose = scene.pose(belt);
    pose.position.x += 2e-2;
    pose.position.z += 0.5e-2;
    require(abut_part_set_pose(scene.universe(), belt, &pose));
  }
  EXPECT_NEAR(scene.velocity(part).linear.x, 2, 1e-6);
  EXPECT_NEAR(scene.velocity(part).linear.z, 0.5, 1e-6);
}

}  // namespace
