// SPDX-License-Identifier: Apache-2.0
// How bodies go from step to step: orders of error, bounds of stability, and which integrator counts.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "scene.hpp"

namespace {

using namespace response_test;

constexpr std::array integrators{ABUT_INTEGRATOR_STATIC, ABUT_INTEGRATOR_EULER, ABUT_INTEGRATOR_RK4,
                                 ABUT_INTEGRATOR_MIDPOINT, ABUT_INTEGRATOR_IMPLICIT};

Scene weightless() {
  return Scene(
      [](abut_response_options& its) {
        its.gravity = {0, 0, 0};
        its.tolerance = 1e-14;
      },
      0.1);
}
abut_part_id body(Scene& scene, const Shape& shape, const abut_pose& pose, double mass, abut_integrator integrator,
                  const abut_velocity& velocity = {}) {
  const abut_part_id part = scene.body(shape, pose, mass, velocity);
  abut_body_options options;
  abut_body_options_init(&options, sizeof options);
  options.integrator = integrator;
  require(abut_response_body(scene.response(), part, &options.mass));
  require(abut_response_add_bodies(scene.response(), &part, 1, &options));
  return part;
}

// A spring to the origin for each body, of the stiffness of its mass, and one that turns it back.
void spring(void*, abut_part_id, const abut_pose* pose, const abut_velocity*, double, abut_vec3* force, abut_vec3*) {
  force->x -= pose->position.x;
}

double error_of_oscillator(abut_integrator integrator, double step) {
  Scene scene = weightless();
  const abut_part_id part = body(scene, ball(0.1), {{1, 0, 0}, no_turn}, 1, integrator);
  require(abut_response_set_force_callback(scene.response(), spring, nullptr));
  scene.step(step, static_cast<int>(std::lround(1 / step)));
  return std::fabs(scene.pose(part).position.x - std::cos(1.0)) +
         std::fabs(scene.velocity(part).linear.x + std::sin(1.0));
}

// Halving the step divides the error by 2 to the order.
TEST(Integrator, HasTheOrderThatItTells) {
  struct Row {
    abut_integrator integrator;
    double order;
  };
  for (const Row& row : {Row{ABUT_INTEGRATOR_EULER, 1}, Row{ABUT_INTEGRATOR_IMPLICIT, 1},
                         Row{ABUT_INTEGRATOR_MIDPOINT, 2}, Row{ABUT_INTEGRATOR_RK4, 4}}) {
    const double coarse = error_of_oscillator(row.integrator, 1.0 / 32),
                 fine = error_of_oscillator(row.integrator, 1.0 / 64);
    EXPECT_NEAR(std::log2(coarse / fine), row.order, 0.1) << row.integrator << " " << coarse << " " << fine;
  }
}

// A spring of a contact in compression, from its touch to its greatest depth: cos and sin of omega t.
TEST(Integrator, FollowsASpringOfAContactByItsOrder) {
  const auto error = [](abut_integrator integrator, double step) {
    Scene scene = weightless();
    scene.material([](abut_contact_material& row) { row.compliance = 1e-2; });
    scene.floor();
    const abut_part_id part = body(scene, ball(0.5), {{0, 0, 0.5}, no_turn}, 1, integrator, {{0, 0, -0.5}, {}});
    scene.step(step, static_cast<int>(std::lround(0.25 / step)));
    // omega is 10.
    return std::fabs(0.5 - scene.pose(part).position.z - 0.05 * std::sin(2.5)) +
           0.1 * std::fabs(scene.velocity(part).linear.z + 0.5 * std::cos(2.5));
  };
  for (const auto& [integrator, order] :
       {std::pair(ABUT_INTEGRATOR_EULER, 1.0), std::pair(ABUT_INTEGRATOR_IMPLICIT, 1.0),
        std::pair(ABUT_INTEGRATOR_MIDPOINT, 2.0)}) {
    const double coarse = error(integrator, 0.25 / 128), fine = error(integrator, 0.25 / 256);
    EXPECT_NEAR(std::log2(coarse / fine), order, 0.1) << integrator << " " << coarse << " " << fine;
  }
}

// Two balls that are pressed together: stable up to dt = 2 / sqrt(2 k / m) by explicit Euler, and at 100 times that
// by implicit Euler.
TEST(Integrator, IsStableAsFarAsItTells) {
  constexpr double mass = 2, stiffness = 1e4;
  const auto largest_energy = [](abut_integrator integrator, double part_of_limit) {
    Scene scene = weightless();
    scene.material([](abut_contact_material& row) { row.compliance = 1 / stiffness; });
    const abut_part_id a = body(scene, ball(0.5), {{0, 0, 0}, no_turn}, mass, integrator),
                       b = body(scene, ball(0.5), {{0.98, 0, 0}, no_turn}, mass, integrator);
    double largest = 0;
    for (int i = 0; i < 400; ++i) {
      // At rest the balls overlap by 0.021, so contact is never lost by small swings.
      const abut_vec3 right{210, 0, 0}, left{-210, 0, 0};
      require(abut_response_apply_force(scene.response(), a, &right, nullptr));
      require(abut_response_apply_force(scene.response(), b, &left, nullptr));
      scene.step(part_of_limit * 2 / std::sqrt(2 * stiffness / mass));
      largest = std::max(largest, scene.energy().kinetic);
    }
    return largest;
  };
  // The spring holds 10000 * 0.001^2 / 2 more than at rest.
  EXPECT_LT(largest_energy(ABUT_INTEGRATOR_EULER, 0.95), 0.5);
  EXPECT_GT(largest_energy(ABUT_INTEGRATOR_EULER, 1.05), 10);
  EXPECT_LT(largest_energy(ABUT_INTEGRATOR_IMPLICIT, 0.95), 0.01);
  EXPECT_LT(largest_energy(ABUT_INTEGRATOR_IMPLICIT, 100), 0.01);
}

// Of an explicit pair: that at the start of the step, constant over it.
TEST(Integrator, HoldsExplicitForcesOverTheStep) {
  Scene scene = weightless();
  scene.material([](abut_contact_material& row) { row.compliance = 1e-4; });
  const abut_part_id a = body(scene, ball(0.5), {{0, 0, 0}, no_turn}, 2, ABUT_INTEGRATOR_RK4);
  body(scene, ball(0.5), {{0.98, 0, 0}, no_turn}, 2, ABUT_INTEGRATOR_EULER);
  scene.step(1e-2);
  ASSERT_EQ(scene.contacts().size(), 1U);
  EXPECT_NEAR(scene.contacts()[0].force.x, 0.02 * 1e4, 1e-9);
  EXPECT_NEAR(scene.velocity(a).linear.x, -200.0 / 2 * 1e-2, 1e-12);
  // Runge-Kutta goes by the parabola of a constant force.
  EXPECT_NEAR(scene.pose(a).position.x, -0.5 * 200 / 2 * 1e-4, 1e-12);
}

// 1/2 k g^2 and 1/2 m v^2 add up to the same in each step, while the spring is in compression. A step that begins
// outside, and one that ends there, gain nothing.
TEST(Integrator, KeepsEnergyByTheMidpoint) {
  for (const double step : {1e-3, 1e-2, 0.05}) {
    for (const double gap : {0.0, 0.0023}) {
      Scene scene = weightless();
      scene.material([](abut_contact_material& row) { row.compliance = 1e-2; });
      scene.floor();
      const abut_part_id part =
          body(scene, ball(0.5), {{0, 0, 0.5 + gap}, no_turn}, 1, ABUT_INTEGRATOR_MIDPOINT, {{0, 0, -0.5}, {}});
      const auto energy = [&] {
        const double depth = std::max(0.0, 0.5 - scene.pose(part).position.z);
        return scene.energy().kinetic + 0.5 * 100 * depth * depth;
      };
      double last = energy();
      for (int i = 0; i < 0.8 / step; ++i) {
        const bool was_inside = scene.pose(part).position.z <= 0.5;
        scene.step(step);
        const double now = energy();
        EXPECT_LE(now, last + 1e-13) << step << " " << gap << " " << i;
        if (was_inside && scene.pose(part).position.z < 0.5) {
          EXPECT_NEAR(now, last, 1e-13) << step << " " << gap << " " << i;
        }
        last = now;
      }
      EXPECT_GT(last, 0.125 * (1 - 200 * step * step));
    }
  }
}

// Implicit Euler of two balls by hand: (m + h (h k + d) [1 -1; -1 1]) v1 = m v0 - h k g [-1; 1].
TEST(Integrator, SolvesAnIslandOfTwoAsOneSystem) {
  constexpr double m1 = 1, m2 = 3, k = 1e5, d = 40, h = 1e-2, gap = -0.02, v1 = 0.3, v2 = -0.1;
  Scene scene = weightless();
  scene.material([](abut_contact_material& row) {
    row.compliance = 1 / k;
    row.damping = d;
  });
  const abut_part_id a = body(scene, ball(0.5), {{0, 0, 0}, no_turn}, m1, ABUT_INTEGRATOR_IMPLICIT, {{v1, 0, 0}, {}}),
                     b = body(scene, ball(0.5), {{1 + gap, 0, 0}, no_turn}, m2, ABUT_INTEGRATOR_EULER,
                              {{v2, 0, 0}, {}});
  scene.step(h);
  const double s = h * (h * k + d), right1 = m1 * v1 + h * k * gap, right2 = m2 * v2 - h * k * gap;
  const double determinant = (m1 + s) * (m2 + s) - s * s;
  EXPECT_NEAR(scene.velocity(a).linear.x, ((m2 + s) * right1 + s * right2) / determinant, 1e-10);
  EXPECT_NEAR(scene.velocity(b).linear.x, ((m1 + s) * right2 + s * right1) / determinant, 1e-10);
}

// Each pair of integrators: the greater one counts for both, and what is static joins nobody.
TEST(Integrator, IsTheGreatestOfThoseThatTouch) {
  for (const abut_integrator one : integrators) {
    for (const abut_integrator other : integrators) {
      Scene scene = weightless();
      const abut_part_id a = body(scene, ball(0.5), {{0, 0, 0}, no_turn}, 1, one, {{0.1, 0, 0}, {}});
      body(scene, ball(0.5), {{0.999, 0, 0}, no_turn}, 1, other);
      scene.step(1e-3);
      if (one == ABUT_INTEGRATOR_STATIC) EXPECT_EQ(scene.pose(a).position.x, 0);
      const bool both_static = one == ABUT_INTEGRATOR_STATIC && other == ABUT_INTEGRATOR_STATIC;
      ASSERT_EQ(scene.islands().size(), both_static ? 0U : 1U) << one << " " << other;
      if (both_static) continue;
      const bool is_one_static = one == ABUT_INTEGRATOR_STATIC || other == ABUT_INTEGRATOR_STATIC;
      EXPECT_EQ(scene.islands()[0].integrator, std::max(one, other)) << one << " " << other;
      EXPECT_EQ(scene.islands()[0].body_count, is_one_static ? 1U : 2U);
    }
  }
}

void faulty(void*, abut_part_id, const abut_pose*, const abut_velocity*, double, abut_vec3* force, abut_vec3*) {
  force->y = std::nan("");
}
void whirl(void* context, abut_part_id, const abut_pose*, const abut_velocity*, double time, abut_vec3*,
           abut_vec3* torque) {
  static_cast<std::vector<double>*>(context)->push_back(time);
  torque->z += 0.4;
}

TEST(Integrator, AsksTheFieldForTorqueAndTime) {
  Scene scene = weightless();
  const abut_part_id part = body(scene, ball(1), {{0, 0, 0}, no_turn}, 1, ABUT_INTEGRATOR_RK4);
  std::vector<double> times;
  require(abut_response_set_force_callback(scene.response(), whirl, &times));
  scene.step(0.5, 2);
  EXPECT_EQ(times, (std::vector<double>{0, 0.25, 0.25, 0.5, 0.5, 0.75, 0.75, 1}));
  EXPECT_NEAR(scene.velocity(part).angular.z, 1, 1e-12);
  require(abut_response_set_force_callback(scene.response(), faulty, nullptr));
  const abut_pose before = scene.pose(part);
  EXPECT_EQ(abut_response_step(scene.response(), 0.5), ABUT_NOT_FINITE);
  EXPECT_EQ(scene.pose(part).orientation.z, before.orientation.z);
}

}  // namespace
