// SPDX-License-Identifier: Apache-2.0
// Steps that stop at impacts: bounces by closed forms, at any step.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "scene.hpp"

namespace {

using namespace response_test;

constexpr double touch = 1e-9;  // gap at which surfaces count as touching

void stop_at_impacts(abut_response_options& its) {
  its.flags = ABUT_RESPONSE_IMPACTS;
  its.tolerance = 1e-13;
}
void float_and_stop_at_impacts(abut_response_options& its) {
  stop_at_impacts(its);
  its.gravity = {0, 0, 0};
}

void make_fast(const Scene& scene, abut_part_id part) {
  std::array<abut_geometry_id, 2> geometries{};
  std::size_t count = 0;
  require(abut_part_geometries(scene.universe(), part, geometries.data(), geometries.size(), &count));
  for (const abut_geometry_id geometry : std::span(geometries).first(count)) {
    abut_geometry_info info;
    abut_geometry_info_init(&info, sizeof info);
    require(abut_geometry_describe(scene.universe(), geometry, &info));
    abut_geometry_options options;
    abut_geometry_options_init(&options, sizeof options);
    options.pose = info.local;
    options.flags = ABUT_GEOMETRY_FAST;
    options.tolerance = touch;
    require(abut_geometry_set_options(scene.universe(), geometry, &options));
  }
}

abut_part_id fast_body(Scene& scene, const Shape& shape, const abut_pose& pose, double mass,
                       const abut_velocity& velocity = {}) {
  const abut_part_id part = scene.body(shape, pose, mass, velocity);
  make_fast(scene, part);
  return part;
}

// Height of the lowest point of a ball that falls from `height` at rest, and bounces.
double height_after(double time, double height, double restitution) {
  double left = std::sqrt(2 * height / gravity), speed = gravity * left;
  if (time < left) return height - 0.5 * gravity * time * time;
  for (time -= left; speed > 1e-9; time -= left) {
    speed *= restitution;
    left = 2 * speed / gravity;
    if (time < left) return speed * time - 0.5 * gravity * time * time;
  }
  return 0;
}

TEST(Impact, KeepsTheEnergyOfABouncingBall) {
  for (const double step : {1e-3, 1e-2, 1e-1}) {
    Scene scene(stop_at_impacts, touch);
    scene.material([](abut_contact_material& row) { row.restitution = 1; });
    scene.floor();
    const abut_part_id part = fast_body(scene, ball(0.1), {{0, 0, 5}, no_turn}, 10);
    const double before = total_energy(scene);
    for (int i = 0; i < std::lround(20 / step); ++i) {
      scene.step(step);
      ASSERT_NEAR(total_energy(scene), before, 1e-12 * before) << step << " " << i;
    }
    EXPECT_NEAR(scene.pose(part).position.z - 0.1, height_after(20, 4.9, 1), 1e-6);
  }
}

// A block rests while a ball bounces beside it: what the floor gives to the block is its weight, however many impacts
// cut the step.
TEST(Impact, TellsImpulsesOfTheTimeThatHasPassed) {
  constexpr double step = 0.1;
  Scene scene(stop_at_impacts, touch);
  scene.material([](abut_contact_material& row) { row.restitution = 1; });
  scene.floor();
  fast_body(scene, block(0.5, 0.5, 0.5), {{3, 0, 0.5}, no_turn}, 2);
  fast_body(scene, ball(0.1), {{0, 0, 0.11}, no_turn}, 1);
  double all = 0;
  for (int i = 0; i < 10; ++i) {
    scene.step(step);
    for (const abut_response_contact& contact : scene.contacts()) {
      if (contact.point.x > 2) all += std::fabs(contact.impulse.z);
    }
  }
  EXPECT_NEAR(all, 2 * gravity * 10 * step, 1e-6);
}

TEST(Impact, BouncesLowerAndLowerAsTheClosedFormSays) {
  for (const double step : {1e-3, 1e-2, 1e-1}) {
    Scene scene(stop_at_impacts, touch);
    scene.material([](abut_contact_material& row) { row.restitution = 0.8; });
    scene.floor();
    const abut_part_id part = fast_body(scene, ball(0.1), {{0, 0, 5}, no_turn}, 10);
    for (int second = 1; second <= 8; ++second) {
      scene.step(step, static_cast<int>(std::lround(1 / step)));
      EXPECT_NEAR(scene.pose(part).position.z - 0.1, height_after(second, 4.9, 0.8), 1e-7) << step << " " << second;
    }
    // 42 impacts until 8.9946 s, and then approaches that are too slow to bounce.
    scene.step(step, static_cast<int>(std::lround(2 / step)));
    EXPECT_NEAR(scene.pose(part).position.z, 0.1, 1e-8);
    EXPECT_NEAR(scene.velocity(part).linear.z, 0, 1e-8);
    EXPECT_NEAR(scene.contacts().front().force.z, 10 * gravity, 1e-6);
  }
}

// Five balls with small gaps: each impact hands the speed on, and the last one leaves with it.
TEST(Impact, HandsASpeedThroughACradle) {
  Scene scene(float_and_stop_at_impacts, touch);
  scene.material([](abut_contact_material& row) { row.restitution = 1; });
  std::vector<abut_part_id> parts;
  for (int i = 0; i < 5; ++i) {
    const double x = i == 0 ? -1.0 : i * (1 + 1e-6);
    parts.push_back(fast_body(scene, ball(0.5), {{x, 0, 0}, no_turn}, 2, {{i == 0 ? 3.0 : 0.0, 0, 0}, {0, 0, 0}}));
  }
  scene.step(0.5, 2);
  for (int i = 0; i < 4; ++i) EXPECT_NEAR(scene.velocity(parts.at(static_cast<std::size_t>(i))).linear.x, 0, 1e-11);
  EXPECT_NEAR(scene.velocity(parts[4]).linear.x, 3, 1e-11);
}

// Newton's law for both contacts at once.
TEST(Impact, SharesASpeedAmongBallsThatTouch) {
  Scene scene(float_and_stop_at_impacts, touch);
  scene.material([](abut_contact_material& row) { row.restitution = 1; });
  const abut_part_id first = fast_body(scene, ball(0.5), {{-2, 0, 0}, no_turn}, 1, {{1, 0, 0}, {0, 0, 0}});
  const abut_part_id second = fast_body(scene, ball(0.5), {{0, 0, 0}, no_turn}, 1);
  const abut_part_id third = fast_body(scene, ball(0.5), {{1, 0, 0}, no_turn}, 1);
  scene.step(2);
  EXPECT_NEAR(scene.velocity(first).linear.x, -1.0 / 3, 1e-9);
  EXPECT_NEAR(scene.velocity(second).linear.x, 2.0 / 3, 1e-9);
  EXPECT_NEAR(scene.velocity(third).linear.x, 2.0 / 3, 1e-9);
}

// One bounces while others rest: they carry their weight all the time.
TEST(Impact, LeavesWhatRestsInPeace) {
  for (const double step : {1e-3, 2e-2}) {
    Scene scene(stop_at_impacts, touch);
    scene.material([](abut_contact_material& row) {
      row.restitution = 0.5;
      row.friction_primary = row.friction_secondary = 0.5;
    });
    scene.floor();
    const abut_part_id below = fast_body(scene, block(0.5, 0.5, 0.5), {{3, 0, 0.5}, no_turn}, 4);
    const abut_part_id above = fast_body(scene, block(0.5, 0.5, 0.5), {{3, 0, 1.5}, no_turn}, 1);
    const abut_part_id part = fast_body(scene, ball(0.1), {{0, 0, 1.1}, no_turn}, 1);
    for (int i = 1; i <= std::lround(1 / step); ++i) {
      scene.step(step);
      EXPECT_NEAR(scene.pose(part).position.z - 0.1, height_after(i * step, 1, 0.5), 1e-7) << i;
    }
    EXPECT_NEAR(scene.pose(below).position.z, 0.5, 1e-7);
    EXPECT_NEAR(scene.pose(above).position.z, 1.5, 1e-7);
    double weight = 0;
    for (const abut_response_contact& contact : scene.contacts()) {
      if (contact.point.z < 0.5 && contact.point.x > 1) weight += std::fabs(contact.force.z);
    }
    EXPECT_NEAR(weight, 5 * gravity, 1e-6);
  }
}

// A ball falls on a box that rests: the box is pressed on the ground, and the ball comes back.
TEST(Impact, BouncesOnWhatRests) {
  Scene scene(stop_at_impacts, touch);
  scene.material([](abut_contact_material& row) { row.restitution = 0.5; });
  scene.floor();
  const abut_part_id box = fast_body(scene, block(0.5, 0.5, 0.5), {{0, 0, 0.5}, no_turn}, 4);
  const abut_part_id part = fast_body(scene, ball(0.1), {{0, 0, 2.1}, no_turn}, 1);
  for (int i = 1; i <= 90; ++i) {
    scene.step(1e-2);
    EXPECT_NEAR(scene.pose(part).position.z - 1.1, height_after(i * 1e-2, 1, 0.5), 1e-7) << i;
  }
  EXPECT_NEAR(scene.pose(box).position.z, 0.5, 1e-7);
}

// A box that tumbles hits the ground with a corner, an edge, a face: one contact or several at a time.
TEST(Impact, KeepsTheEnergyOfABoxThatTumbles) {
  for (const double step : {1e-3, 1e-2, 1e-1}) {
    Scene scene(stop_at_impacts, touch);
    scene.material([](abut_contact_material& row) { row.restitution = 1; });
    scene.floor();
    fast_body(scene, block(0.5, 0.3, 0.1), {{0, 0, 3}, no_turn}, 2, {{0, 0, 0}, {1, 2, 3}});
    const double before = total_energy(scene);
    for (int i = 0; i < std::lround(5 / step); ++i) {
      scene.step(step);
      ASSERT_NEAR(total_energy(scene), before, 1e-11 * before) << step << " " << i;
    }
  }
}

// Not even where the part turns about a point far from its centre of mass.
TEST(Impact, FollowsTheCentreOfMass) {
  Scene scene(stop_at_impacts, touch);
  scene.material([](abut_contact_material& row) { row.restitution = 1; });
  scene.floor();
  const abut_part_id part = scene.place(ball(0.2), {{0, 0, 3}, no_turn}, ABUT_MOTION_DYNAMIC);
  scene.attach(part, ball(0.2), {{1, 0, 0}, no_turn});
  make_fast(scene, part);
  require(abut_response_add_bodies(scene.response(), &part, 1, nullptr));
  const abut_velocity turning{{1, 0, 0}, {0, 2, 0}};
  require(abut_part_set_velocity(scene.universe(), part, &turning));
  const abut_energy before = scene.energy();
  for (int i = 0; i < 200; ++i) {
    scene.step(1e-2);
    const abut_energy after = scene.energy();
    ASSERT_NEAR(after.kinetic + after.potential, before.kinetic + before.potential, 1e-9 * before.potential) << i;
    ASSERT_NEAR(after.linear_momentum.x, before.linear_momentum.x, 1e-9);
    // Touches are found on paths that are right to the third order.
    for (const abut_response_contact& contact : scene.contacts()) EXPECT_GE(contact.distance, -2e-5);
  }
}

// Bodies that bounce on each other and come to rest: what is gained is what moves apart lift, and here there are none.
TEST(Impact, GainsNoEnergyInAHeap) {
  for (const double restitution : {0.0, 0.3}) {
    for (const double friction : {0.0, 0.4}) {
      Scene scene(
          [](abut_response_options& its) {
            its.flags = ABUT_RESPONSE_IMPACTS;
            its.slop = 1;
          },
          touch);
      scene.material([&](abut_contact_material& row) {
        row.restitution = restitution;
        row.friction_primary = row.friction_secondary = friction;
      });
      scene.floor();
      for (const abut_part_id part : drop_twelve(scene)) make_fast(scene, part);
      const double start = total_energy(scene);
      double last = start;
      for (int i = 0; i < 200; ++i) {
        scene.step(1e-2);
        const double now = total_energy(scene);
        ASSERT_LE(now, last + 1e-11 * start) << restitution << " " << friction << " " << i;
        last = now;
      }
      EXPECT_LT(last, 0.6 * start);
    }
  }
}

// Without the flag contacts do not bounce.
TEST(Impact, IsOffByDefault) {
  Scene scene;
  scene.material([](abut_contact_material& row) { row.restitution = 1; });
  scene.floor();
  const abut_part_id part = scene.body(ball(0.1), {{0, 0, 0.3}, no_turn}, 1);
  scene.step(1e-2, 100);
  EXPECT_NEAR(scene.pose(part).position.z, 0.1, 1e-4);
  EXPECT_NEAR(scene.velocity(part).linear.z, 0, 1e-6);
}

}  // namespace
