// SPDX-License-Identifier: Apache-2.0
// Springs, rigid links and the mouse, by closed forms.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "scene.hpp"

namespace {

using namespace response_test;

abut_link_options link_of(abut_part_id a, abut_part_id b, const abut_vec3& point_a, const abut_vec3& point_b) {
  abut_link_options options;
  abut_link_options_init(&options, sizeof options);
  options.a = a;
  options.b = b;
  options.point_a = point_a;
  options.point_b = point_b;
  return options;
}
std::uint64_t add(const Scene& scene, const abut_link_options& options) {
  std::uint64_t number = 0;
  require(abut_response_add_link(scene.response(), &options, &number));
  return number;
}
abut_vec3 force_of(const Scene& scene, std::uint64_t link) {
  abut_vec3 out{};
  require(abut_response_link_force(scene.response(), link, &out));
  return out;
}

// m g / k below its point, whatever the stiffness and the step.
TEST(Link, HangsABodyAsDeepAsItsWeightSays) {
  for (const double stiffness : {1e2, 1e6, 1e10}) {
    for (const double step : {1e-3, 1e-1}) {
      Scene scene([](abut_response_options& its) { its.tolerance = 1e-14; });
      const abut_part_id part = scene.body(ball(0.5), {{0, 0, 2}, no_turn}, 3);
      abut_link_options options = link_of({}, part, {0, 0, 2}, {0, 0, 2});
      options.stiffness = stiffness;
      options.damping = 2 * std::sqrt(3 * stiffness);
      const std::uint64_t link = add(scene, options);
      scene.step(step, static_cast<int>(50 * std::sqrt(3 / stiffness) / step) + 30);
      EXPECT_NEAR(2 - scene.pose(part).position.z, 3 * gravity / stiffness, 1e-9 * gravity / stiffness + 2e-15);
      EXPECT_NEAR(force_of(scene, link).z, 3 * gravity, 1e-6 * gravity + 1e-15 * stiffness);
    }
  }
}

// A point mass on a rigid arm: small swings last 2 pi sqrt((l + 2 r^2 / 5 l) / g), as the ball turns with its arm.
TEST(Link, SwingsAsAPendulum) {
  constexpr double arm = 1, radius = 0.1, angle = 0.01, dt = 1e-3;
  Scene scene;
  const abut_vec3 place{arm * std::sin(angle), 0, -arm * std::cos(angle)};
  const abut_part_id part = scene.body(ball(radius), {place, no_turn}, 2);
  add(scene, link_of({}, part, {0, 0, 0}, {0, 0, 0}));
  const double period = 2 * std::numbers::pi * std::sqrt((arm + 0.4 * radius * radius / arm) / gravity);
  double last = place.x, crossing = 0;
  for (int i = 1; crossing == 0 && i < 2000; ++i) {
    scene.step(dt);
    const double now = scene.pose(part).position.x;
    if (now <= 0) crossing = (i - 1) * dt + dt * last / (last - now);
    last = now;
  }
  EXPECT_NEAR(crossing, period / 4, 2e-3 * period);
  scene.step(dt, 5000);
  const abut_vec3 end = scene.pose(part).position;
  EXPECT_NEAR(std::sqrt(end.x * end.x + end.y * end.y + end.z * end.z), arm, 1e-6);
}

TEST(Link, KeepsMomentumOfTwoBodies) {
  Scene scene([](abut_response_options& its) { its.gravity = {0, 0, 0}; });
  const abut_part_id a = scene.body(ball(0.5), {{0, 0, 0}, no_turn}, 2, {{1, 0, 0}, {0, 1, 2}});
  const abut_part_id b = scene.body(block(0.2, 0.3, 0.4), {{2, 0, 0}, no_turn}, 1, {{0, 2, 0}, {1, 0, 0}});
  for (const double stiffness : {0.0, 1e3}) {
    abut_link_options options = link_of(a, b, {1, 0, 0}, {1, 0, 0});
    options.stiffness = stiffness;
    add(scene, options);
  }
  const abut_energy before = scene.energy();
  scene.step(1e-3, 500);
  const abut_energy after = scene.energy();
  EXPECT_NEAR(after.linear_momentum.x, before.linear_momentum.x, 1e-10);
  EXPECT_NEAR(after.linear_momentum.y, before.linear_momentum.y, 1e-10);
  EXPECT_NEAR(after.angular_momentum.z, before.angular_momentum.z, 1e-2);
  ASSERT_EQ(scene.islands().size(), 1U);
  EXPECT_EQ(scene.islands()[0].body_count, 2U);
}

// A mouse pulls with its largest force, and no more, until the body is near.
TEST(Link, DragsWithALargestForce) {
  Scene scene([](abut_response_options& its) { its.gravity = {0, 0, 0}; });
  const abut_part_id part = scene.body(ball(0.5), {{0, 0, 0}, no_turn}, 2);
  abut_link_options options = link_of({}, part, {0, 0, 0}, {0, 0, 0});
  options.stiffness = 1e4;
  options.damping = 300;
  options.most_force = 10;
  const std::uint64_t mouse = add(scene, options);
  const abut_vec3 target{3, 4, 0};
  require(abut_response_move_link(scene.response(), mouse, &target));
  scene.step(1e-2);
  EXPECT_NEAR(scene.velocity(part).linear.x, 0.6 * 10 / 2 * 1e-2, 1e-8);
  EXPECT_NEAR(scene.velocity(part).linear.y, 0.8 * 10 / 2 * 1e-2, 1e-8);
  EXPECT_NEAR(force_of(scene, mouse).y, 8, 1e-6);
  EXPECT_EQ(scene.islands()[0].residuals.is_converged, 1U);
  require(abut_response_remove_link(scene.response(), mouse));
  abut_vec3 force{};
  EXPECT_EQ(abut_response_link_force(scene.response(), mouse, &force), ABUT_STALE_ID);
  EXPECT_EQ(abut_response_move_link(scene.response(), mouse, &target), ABUT_STALE_ID);
  EXPECT_EQ(abut_response_remove_link(scene.response(), mouse), ABUT_STALE_ID);
}

TEST(Link, BreaksAndEndsWithItsParts) {
  Scene scene;
  const abut_part_id part = scene.body(ball(0.5), {{0, 0, 2}, no_turn}, 2);
  abut_link_options options = link_of({}, part, {0, 0, 2}, {0, 0, 2});
  options.break_force = 19;
  const std::uint64_t weak = add(scene, options);
  scene.step(1e-2);
  EXPECT_NEAR(scene.velocity(part).linear.z, 0, 1e-9);
  abut_vec3 force{};
  EXPECT_EQ(abut_response_link_force(scene.response(), weak, &force), ABUT_STALE_ID);
  options.break_force = 20;
  const std::uint64_t strong = add(scene, options);
  EXPECT_GT(strong, weak);
  scene.step(1e-2, 10);
  EXPECT_NEAR(force_of(scene, strong).z, 2 * gravity, 1e-6);
  require(abut_part_destroy(scene.universe(), part));
  scene.step(1e-2);
  EXPECT_EQ(abut_response_link_force(scene.response(), strong, &force), ABUT_STALE_ID);
}

TEST(Link, RefusesWhatIsNone) {
  Scene scene;
  const abut_part_id part = scene.body(ball(0.5), {{0, 0, 2}, no_turn}, 2);
  const abut_part_id still = scene.place(ball(0.5), {{9, 0, 0}, no_turn}, ABUT_MOTION_STATIC);
  std::uint64_t number = 0;
  abut_link_options options = link_of({}, still, {}, {});
  EXPECT_EQ(abut_response_add_link(scene.response(), &options, &number), ABUT_INVALID_ARGUMENT);
  options = link_of(part, part, {}, {});
  EXPECT_EQ(abut_response_add_link(scene.response(), &options, &number), ABUT_INVALID_ARGUMENT);
  options = link_of(still, part, {}, {0, 0, std::nan("")});
  EXPECT_EQ(abut_response_add_link(scene.response(), &options, &number), ABUT_NOT_FINITE);
  options.point_b = {};
  options.stiffness = -1;
  EXPECT_EQ(abut_response_add_link(scene.response(), &options, &number), ABUT_OUT_OF_RANGE);
  options.stiffness = 0;
  options.struct_size = 3;
  EXPECT_EQ(abut_response_add_link(scene.response(), &options, &number), ABUT_WRONG_STRUCT_SIZE);
  EXPECT_EQ(abut_response_add_link(scene.response(), nullptr, &number), ABUT_NULL_ARGUMENT);
  options = link_of(still, part, {}, {});
  number = add(scene, options);
  const abut_vec3 target{};
  EXPECT_EQ(abut_response_move_link(scene.response(), number, &target), ABUT_INVALID_ARGUMENT);
}

}  // namespace
