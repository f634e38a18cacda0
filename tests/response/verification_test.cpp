// SPDX-License-Identifier: Apache-2.0
// Bodies against closed forms of mechanics: tops, tables, cards, and the rolling of the public benchmark.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "scene.hpp"

namespace {

using namespace response_test;

Vector vector_of(const abut_vec3& v) { return {v.x, v.y, v.z}; }
abut_vec3 vector_of(const Vector& v) { return {v.x, v.y, v.z}; }
abut_quat turn_about_y(double angle) { return {std::cos(angle / 2), 0, std::sin(angle / 2), 0}; }

// A heavy symmetric top whose tip is held: I1 cos(tilt) W^2 - I3 w W + m g l = 0, of which the slow root.
TEST(Verification, PrecessesAsATopDoes) {
  constexpr double about_tip = 0.005, along = 0.005, mass = 1, arm = 0.05, spin = 200, tilt = std::numbers::pi / 6;
  const double a = about_tip * std::cos(tilt), b = along * spin, c = mass * gravity * arm;
  const double slow = 2 * c / (b + std::sqrt(b * b - 4 * a * c));
  EXPECT_NEAR(slow, 0.4915462, 1e-6);
  std::vector<double> errors;
  for (const double step : {2e-4, 1e-4}) {
    Scene scene([](abut_response_options& its) { its.tolerance = 1e-12; });
    const Vector axis{std::sin(tilt), 0, std::cos(tilt)}, up{0, 0, 1};
    const Vector angular = spin * axis + slow * (up - std::cos(tilt) * axis), centre = arm * axis;
    const abut_part_id part = scene.place(ball(0.01), {vector_of(centre), turn_about_y(tilt)}, ABUT_MOTION_DYNAMIC);
    abut_body_options options;
    abut_body_options_init(&options, sizeof options);
    const double across = about_tip - mass * arm * arm;
    options.mass = {.mass = mass, .centre = {}, .inertia = {across, 0, 0, 0, across, 0, 0, 0, along}};
    require(abut_response_add_bodies(scene.response(), &part, 1, &options));
    const abut_velocity velocity{vector_of(cross(angular, centre)), vector_of(angular)};
    require(abut_part_set_velocity(scene.universe(), part, &velocity));
    abut_link_options link;
    abut_link_options_init(&link, sizeof link);
    link.b = part;
    std::uint64_t number = 0;
    require(abut_response_add_link(scene.response(), &link, &number));
    scene.step(step, static_cast<int>(std::lround(0.5 / step)));
    const abut_vec3 at = scene.pose(part).position;
    errors.push_back(std::fabs(std::atan2(at.y, at.x) - 0.5 * slow));
    EXPECT_NEAR(at.z, arm * std::cos(tilt), 2e-3 * arm);
    EXPECT_NEAR(length(vector_of(at)), arm, 1e-6);
  }
  EXPECT_LE(errors[1], 5e-3 * 0.5 * slow);
  EXPECT_LE(errors[1], 0.7 * errors[0]);
}

// Without friction nothing pushes sideways, however it turns.
TEST(Verification, KeepsATopOnIceAboveItsPlace) {
  Scene scene;
  scene.floor();
  const Shape cone = shape_from([](abut_shape** out) { return abut_cone_create(0.2, 0.15, out); });
  const double tilt = std::numbers::pi - 0.3;
  // The tip of the cone is at +0.15 of its axis, which points down.
  scene.body(cone, {{0, 0, 0.15 * std::cos(0.3)}, turn_about_y(tilt)}, 1,
             {{}, {30 * std::sin(tilt), 0, 30 * std::cos(tilt)}});
  const abut_energy before = scene.energy();
  scene.step(1e-3, 300);
  const abut_energy after = scene.energy();
  EXPECT_NEAR(after.linear_momentum.x, before.linear_momentum.x, 1e-12);
  EXPECT_NEAR(after.linear_momentum.y, before.linear_momentum.y, 1e-12);
  EXPECT_FALSE(scene.contacts().empty());
}

// A table whose legs are small balls; what each leg bears.
std::vector<double> forces_of_legs(const std::vector<abut_vec3>& legs, const abut_vec3& centre, int steps) {
  constexpr double mass = 6;
  Scene scene([](abut_response_options& its) { its.tolerance = 1e-13; });
  scene.floor();
  const abut_part_id part = scene.place(ball(0.1), {{0, 0, 0.1}, no_turn}, ABUT_MOTION_DYNAMIC);
  abut_geometry_id top{};
  std::size_t count = 0;
  require(abut_part_geometries(scene.universe(), part, &top, 1, &count));
  require(abut_geometry_destroy(scene.universe(), top));
  for (const abut_vec3& leg : legs) scene.attach(part, ball(0.1), {leg, no_turn});
  abut_body_options options;
  abut_body_options_init(&options, sizeof options);
  options.mass = {.mass = mass, .centre = centre, .inertia = {1, 0, 0, 0, 1, 0, 0, 0, 1}};
  require(abut_response_add_bodies(scene.response(), &part, 1, &options));
  scene.step(1e-2, steps);
  std::vector<double> forces(legs.size());
  for (const abut_response_contact& contact : scene.contacts()) {
    for (std::size_t i = 0; i < legs.size(); ++i) {
      if (std::hypot(contact.point.x - legs[i].x, contact.point.y - legs[i].y) < 0.05)
        forces[i] += std::fabs(contact.force.z) / (mass * gravity);
    }
  }
  return forces;
}

TEST(Verification, SharesAWeightAmongThreeLegsByTheirLevers) {
  const std::array shares{0.5, 0.3, 0.2};
  const std::vector<abut_vec3> legs{{0, 0, 0}, {2, 0, 0}, {0.5, 1.5, 0}};
  abut_vec3 centre{0, 0, 0.4};
  for (std::size_t i = 0; i < legs.size(); ++i) {
    centre.x += shares[i] * legs[i].x;
    centre.y += shares[i] * legs[i].y;
  }
  for (const int steps : {1, 200}) {
    const std::vector<double> forces = forces_of_legs(legs, centre, steps);
    for (std::size_t i = 0; i < legs.size(); ++i) EXPECT_NEAR(forces[i], shares[i], 1e-9) << i;
  }
}

// Four legs can bear a weight in many ways: 1/4 (1 +- x/a +- y/b), and any part of (1, -1, 1, -1). From cold it is that
// of the least sum of mobility times force squared. The mobility along z is 1/m + (x^2 + y^2)/I.
TEST(Verification, FindsTheLeastForcesOfFourLegs) {
  constexpr double a = 1, b = 0.7, x = 0.3, y = -0.2, mass = 6;
  const std::vector<abut_vec3> legs{{-a, -b, 0}, {a, -b, 0}, {a, b, 0}, {-a, b, 0}};
  const std::vector<double> forces = forces_of_legs(legs, {x, y, 0.4}, 1);
  double sum = 0, size = 0;
  for (std::size_t i = 0; i < legs.size(); ++i) {
    const double sign = i % 2 == 0 ? 1 : -1;
    const double square = std::pow(legs[i].x - x, 2) + std::pow(legs[i].y - y, 2);
    sum += sign * (1 / mass + square) * forces[i];
    size += 0.25 * (1 / mass + square);
    const double plain = 0.25 * (1 + x / a * (legs[i].x > 0 ? 1 : -1) + y / b * (legs[i].y > 0 ? 1 : -1));
    EXPECT_NEAR(sign * (forces[i] - plain), forces[0] - 0.25 * (1 - x / a - y / b), 1e-9) << i;
  }
  EXPECT_NEAR(sum, 0, 1e-6 * size);
}

// A card that leans on a smooth wall, which is half of a house of two: on the ground it needs
// mu >= (tan(angle) - thickness / length) / 2.
double height_of_card_after(double friction, double seconds) {
  constexpr double size = 1, thickness = 0.02, angle = std::numbers::pi / 6, step = 2e-3;
  Scene scene([](abut_response_options& its) { its.tolerance = 1e-11; }, 1e-4);
  const abut_part_id ground = scene.floor(), wall = scene.floor({-1, 0, 0});
  const abut_response_side side{ABUT_RESPONSE_SIDE_PART, wall.slot, wall.generation},
      other{ABUT_RESPONSE_SIDE_PART, ground.slot, ground.generation};
  const std::string rough = "mu=" + std::to_string(friction);
  require(abut_response_add_rule(scene.response(), &side, nullptr, "friction", "mu=0", nullptr));
  require(abut_response_add_rule(scene.response(), &other, nullptr, "friction", rough.c_str(), nullptr));
  const double x = thickness / 2 * std::cos(angle) + size / 2 * std::sin(angle);
  const double z = thickness / 2 * std::sin(angle) + size / 2 * std::cos(angle);
  const abut_part_id card = scene.body(block(thickness / 2, 0.4, size / 2), {{-x, 0, z}, turn_about_y(angle)}, 1);
  scene.step(step, static_cast<int>(seconds / step));
  return scene.pose(card).position.z / z;
}

TEST(Verification, LetsACardStandBySoMuchFriction) {
  const double least = (std::tan(std::numbers::pi / 6) - 0.02) / 2;
  EXPECT_GT(height_of_card_after(1.01 * least, 5), 1 - 1e-6);
  EXPECT_LT(height_of_card_after(0.99 * least, 5), 0.9);
}

// Each step of a stack whose masses differ by so much converges, and within the steps that a light stack takes: the
// search sees that rounding is all that is left.
TEST(Verification, MovesAStackOfGreatRatiosOfMassesAsFastAsOthers) {
  for (const double ratio : {1e8, 1e10}) {
    for (const bool is_in_turns : {false, true}) {
      Scene scene({}, 0.03);
      scene.material([](abut_contact_material& row) { row.friction_primary = row.friction_secondary = 0.5; });
      scene.floor();
      for (int i = 0; i < 10; ++i) {
        const double mass = is_in_turns ? (i % 2 == 0 ? 1 : ratio) : std::pow(ratio, i / 9.0);
        scene.body(block(0.5, 0.5, 0.5), {{0, 0, 0.5 + i}, no_turn}, mass);
      }
      constexpr int steps = 60;
      std::uint32_t newton_steps = 0;
      for (int i = 0; i < steps; ++i) {
        scene.step(0.01);
        for (const abut_response_island& island : scene.islands()) {
          EXPECT_EQ(island.residuals.is_converged, 1U) << ratio << " " << is_in_turns << " " << i;
          newton_steps += island.residuals.newton_steps;
        }
      }
      EXPECT_LE(newton_steps, 30U * steps) << ratio << " " << is_in_turns;
    }
  }
}

// Two cards that lean on each other, edge on edge. Their faces meet the level force of the joint at the angle of the
// lean, whichever of them the contact takes: mu >= tan(angle). The ground asks for less.
double height_of_house_after(double friction, double seconds) {
  constexpr double size = 1, thickness = 0.02, angle = std::numbers::pi / 6, step = 2e-3;
  Scene scene([](abut_response_options& its) { its.tolerance = 1e-11; }, 1e-4);
  scene.material([&](abut_contact_material& row) { row.friction_primary = row.friction_secondary = friction; });
  scene.floor();
  const double x = thickness / 2 * std::cos(angle) + size / 2 * std::sin(angle);
  const double z = thickness / 2 * std::sin(angle) + size / 2 * std::cos(angle);
  abut_part_id card{};
  for (const double side : {-1.0, 1.0})
    card = scene.body(block(thickness / 2, 0.4, size / 2), {{side * x, 0, z}, turn_about_y(-side * angle)}, 1);
  scene.step(step, static_cast<int>(seconds / step));
  return scene.pose(card).position.z / z;
}

TEST(Verification, LetsTwoCardsStandEdgeOnEdgeBySoMuchFriction) {
  const double least = std::tan(std::numbers::pi / 6);
  EXPECT_NEAR(height_of_house_after(1.01 * least, 5), 1, 1e-9);
  EXPECT_LT(height_of_house_after(0.99 * least, 5), 0.9);
}

// The public benchmark of Kang and Hwangbo, "rolling": a box of 10 kg slides under 25 balls of 1 kg that roll on it.
// The friction of the ground is 0.4 (35 g), so a_ball = (150 - 137.34) / 60. The box is 3.5 times as fast.
TEST(Verification, RollsBallsOnABoxThatSlides) {
  for (const abut_vec3& force : {abut_vec3{0, 150, 0}, abut_vec3{75, 150 * std::sqrt(0.75), 0}}) {
    for (const double step : {1e-2, 0.1}) {
      Scene scene([](abut_response_options& its) { its.tolerance = 1e-13; });
      const abut_part_id ground = scene.floor();
      const abut_part_id box = scene.body(block(10, 10, 0.5), {{0, 0, 0.5}, no_turn}, 10);
      abut_response_side side{ABUT_RESPONSE_SIDE_PART, ground.slot, ground.generation};
      require(abut_response_add_rule(scene.response(), &side, nullptr, "friction", "mu=0.4", nullptr));
      require(abut_response_add_rule(scene.response(), nullptr, nullptr, "friction", "mu=0.8", nullptr));
      std::vector<abut_part_id> balls;
      for (int i = 0; i < 25; ++i) {
        const abut_vec3 place{2.0 * (i % 5 - 2), 2.0 * (i / 5 - 2), 1.5};
        balls.push_back(scene.body(ball(0.5), {place, no_turn}, 1));
      }
      const double ball_gain = (150 - 0.4 * 35 * gravity) / 60, size = std::hypot(force.x, force.y);
      double sum = 0, worst = 0;
      const int steps = static_cast<int>(std::lround(4 / step));
      for (int i = 1; i <= steps; ++i) {
        require(abut_response_apply_force(scene.response(), box, &force, nullptr));
        scene.step(step);
        const double along = i * step * ball_gain / size;
        const Vector way{along * force.x, along * force.y, 0};
        const Vector of_box = vector_of(scene.velocity(box).linear) - 3.5 * way,
                     of_ball = vector_of(scene.velocity(balls[0]).linear) - way;
        sum += (dot(of_box, of_box) + dot(of_ball, of_ball)) / steps;
        for (const abut_part_id part : balls)
          worst = std::max(worst, length(vector_of(scene.velocity(part).linear) - way));
      }
      EXPECT_LE(sum, 1e-16) << force.x << " " << step;
      EXPECT_LE(worst, 1e-7) << force.x << " " << step;
    }
  }
}

}  // namespace
