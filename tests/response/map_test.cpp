// SPDX-License-Identifier: Apache-2.0
// One mass on a spring, for all stiffnesses and steps: what bounces off, what is gained, what rests. The table of
// docs/response.md.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "scene.hpp"

namespace {

using namespace response_test;

struct Bounce {
  double left = 0;  // speed after the contact, of an approach at 1 m/s
  double gain = 0;  // the most that the energy of mass and spring has been above that of the approach, as a part of it
  std::uint32_t rounds = 0;
};

Bounce bounce(double stiffness, double step, abut_integrator integrator) {
  Scene scene(
      [](abut_response_options& its) {
        its.gravity = {0, 0, 0};
        its.tolerance = 1e-13;
      },
      1e-9);
  scene.material([&](abut_contact_material& row) { row.compliance = 1 / stiffness; });
  scene.floor();
  const abut_part_id part = scene.body(ball(0.5), {{0, 0, 0.5}, no_turn}, 1);
  abut_body_options options;
  abut_body_options_init(&options, sizeof options);
  options.integrator = integrator;
  require(abut_response_body(scene.response(), part, &options.mass));
  require(abut_response_add_bodies(scene.response(), &part, 1, &options));
  const abut_velocity approach{{0, 0, -1}, {}};
  require(abut_part_set_velocity(scene.universe(), part, &approach));
  Bounce out;
  const double period = 2 * 3.1416 / std::sqrt(stiffness);
  const int steps = static_cast<int>(1.2 * period / step) + 40;
  for (int i = 0; i < steps; ++i) {
    scene.step(step);
    const double depth = std::max(0.0, 0.5 - scene.pose(part).position.z), speed = scene.velocity(part).linear.z;
    out.gain = std::max(out.gain, speed * speed + stiffness * depth * depth - 1);
    for (const abut_response_island& island : scene.islands())
      out.rounds = std::max(out.rounds, island.residuals.rounds);
    if (speed > 0 && depth == 0) break;
  }
  out.left = scene.velocity(part).linear.z;
  return out;
}

constexpr double stiffnesses = 11, steps = 9;

// Implicit Euler loses exp(-pi h omega / 2) to first order, and never gains.
TEST(Map, HasNoHoleByImplicitEuler) {
  for (int i = 0; i < stiffnesses; ++i) {
    for (int j = 0; j < steps; ++j) {
      const double stiffness = std::pow(10, 2 + i), step = std::pow(10, -5 + j / 2.0);
      const double turn = step * std::sqrt(stiffness);
      const Bounce found = bounce(stiffness, step, ABUT_INTEGRATOR_IMPLICIT);
      ASSERT_TRUE(std::isfinite(found.left)) << stiffness << " " << step;
      // Rounding of a place of half a metre is 1e-16, of which the spring makes energy.
      const double rounding = 1e-12 + 1e-15 * std::sqrt(stiffness);
      EXPECT_LE(found.gain, rounding) << stiffness << " " << step;
      EXPECT_GE(found.left, -1e-9) << stiffness << " " << step;
      EXPECT_LE(found.rounds, 30U) << stiffness << " " << step;
      if (turn <= 0.3) {
        EXPECT_LE(std::fabs(std::log(found.left) + 3.14159265 * turn / 2), turn) << stiffness << " " << step;
      }
      if (turn > 10) {
        EXPECT_LE(found.left, 0.02) << stiffness << " " << step;
      }
    }
  }
}

// The midpoint rule keeps all but what the last step of a contact leaves in the spring.
TEST(Map, HasNoHoleByTheMidpoint) {
  for (int i = 0; i < stiffnesses; ++i) {
    for (int j = 0; j < steps; ++j) {
      const double stiffness = std::pow(10, 2 + i), step = std::pow(10, -5 + j / 2.0);
      const double turn = step * std::sqrt(stiffness);
      const Bounce found = bounce(stiffness, step, ABUT_INTEGRATOR_MIDPOINT);
      ASSERT_TRUE(std::isfinite(found.left)) << stiffness << " " << step;
      EXPECT_LE(found.gain, 1e-12 + 1e-15 * std::sqrt(stiffness)) << stiffness << " " << step;
      EXPECT_LE(found.rounds, 30U) << stiffness << " " << step;
      if (turn <= 0.3) {
        EXPECT_GE(found.left, 1 - turn * turn) << stiffness << " " << step;
      }
    }
  }
}

}  // namespace
