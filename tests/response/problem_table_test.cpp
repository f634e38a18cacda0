// SPDX-License-Identifier: Apache-2.0
// Problems on which solvers of contacts usually fail: mass ratios, any stiffness with any step, sliding stacks, arches,
// and rods that jam (Painleve).
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "world.hpp"

namespace {

using namespace response_test;

std::vector<double> growing(double ratio) {
  std::vector<double> masses;
  for (int i = 0; i < 10; ++i) masses.push_back(std::pow(ratio, i / 9.0));
  return masses;
}
std::vector<double> in_turns(double heavy) {
  std::vector<double> masses;
  for (int i = 0; i < 10; ++i) masses.push_back(i % 2 == 0 ? 1 : heavy);
  return masses;
}

void expect_solved(const World& world, const abut_solver_options& options, double bound) {
  const Answer answer = world.solve(&options);
  ASSERT_EQ(answer.status, ABUT_OK) << abut_last_error_message();
  EXPECT_EQ(answer.residuals.is_converged, 1U);
  EXPECT_LE(world.worst_miss(answer), bound);
}

TEST(ContactProblem, SolvesMassRatiosOfAMillionInEitherOrder) {
  constexpr double step = 1e-3;
  for (const std::vector<double>& masses : {growing(1e6), growing(1e-6), in_turns(1e6)}) {
    World world = stack(masses, 0.5);
    world.fall({0, 0, -gravity}, step);
    const Answer answer = world.solve();
    ASSERT_EQ(answer.status, ABUT_OK);
    EXPECT_EQ(answer.residuals.is_converged, 1U);
    EXPECT_LE(answer.residuals.newton_steps, 100U);
    EXPECT_LE(world.worst_miss(answer), 1e-9 * gravity * step);
  }
}

// Impulses have 16 digits, so the light bodies are moved by what the last one of the heavy ones is. From cold, and from
// the answer: there the search must see that rounding is all that is left.
TEST(ContactProblem, SolvesMassRatiosUpToWhatDigitsTell) {
  constexpr double step = 1e-2;
  for (const double ratio : {1e8, 1e10}) {
    for (const std::vector<double>& masses : {growing(ratio), growing(1 / ratio), in_turns(ratio)}) {
      for (const double friction : {0.0, 0.5}) {
        World world = stack(masses, friction);
        world.fall({0, 0, -gravity}, step);
        const abut_solver_options options = options_of(1e-9, 100);
        const Answer answer = world.solve(&options);
        ASSERT_EQ(answer.status, ABUT_OK);
        EXPECT_EQ(answer.residuals.is_converged, 1U) << ratio;
        EXPECT_LE(answer.residuals.newton_steps, 100U) << ratio;
        EXPECT_LE(world.worst_miss(answer), 1e-14 * ratio * gravity * step) << ratio;
        const Answer again = world.solve(&options, &answer);
        EXPECT_LE(again.residuals.newton_steps, 5U) << ratio;
      }
    }
  }
}

// The weight on each level, once for each stiffness and step: springs that already carry it, and rigid contacts.
TEST(ContactProblem, CarriesAStackAtAnyStiffnessAndStep) {
  constexpr double rigid = 1e14;
  for (const double ratio : {1.0, 1e6}) {
    for (const double stiffness : {1e2, 1e4, 1e6, 1e8, 1e10, 1e12, rigid}) {
      for (const double step : {1e-5, 1e-4, 1e-3, 1e-2, 1e-1}) {
        const std::vector<double> masses = growing(ratio);
        World world = stack(masses, 0.5);
        std::vector<double> weights(masses.size());
        double above = 0;
        for (std::size_t i = masses.size(); i-- > 0;) weights[i] = above += masses[i] * gravity;
        for (std::size_t k = 0; k < world.contacts.size() && stiffness < rigid; ++k) {
          world.contacts[k].compliance = 1 / (step * step * stiffness);
          world.contacts[k].offset = -weights[k / 4] / 4 / stiffness / step;
        }
        world.fall({0, 0, -gravity}, step);
        const abut_solver_options options = options_of(1e-9, 60, gravity * step);
        const Answer answer = world.solve(&options);
        const std::string where = "ratio " + std::to_string(ratio) + ", stiffness " + std::to_string(stiffness) +
                                  ", step " + std::to_string(step);
        ASSERT_EQ(answer.status, ABUT_OK) << where;
        EXPECT_EQ(answer.residuals.is_converged, 1U) << where;
        for (std::size_t i = 0; i < weights.size(); ++i) {
          double force = 0;
          for (std::size_t k = 4 * i; k < 4 * i + 4; ++k) force += answer.impulse(k).z / step;
          EXPECT_NEAR(force, weights[i], 1e-8 * weights[i]) << where << ", level " << i;
        }
      }
    }
  }
}

TEST(ContactProblem, SolvesAStackThatSlides) {
  World world = stack(in_turns(1000), 0.25);
  world.fall({3, 0, -9.3}, 1e-3);
  expect_solved(world, options_of(1e-12, 100), 1e-12);
}

// Milankovitch: a half circle with radial joints stands from a thickness of 0.1075 of the radius of its middle line.
TEST(ContactProblem, LetsThinArchesFallAndThickOnesStand) {
  constexpr double step = 1e-3;
  for (const double thickness : {1.0, 1.2}) {
    World world = arch(15, thickness, 0.9);
    world.fall({0, 0, -gravity}, step);
    expect_solved(world, options_of(1e-10, 100), 1e-11);
    const Answer answer = world.solve();
    double fastest = 0;
    for (std::size_t i = 0; i < world.bodies.size(); ++i) fastest = std::max(fastest, length(answer.linear(i)));
    if (thickness < 1.075) {
      EXPECT_GT(fastest, 0.01 * gravity * step);
    } else {
      EXPECT_LT(fastest, 1e-8 * gravity * step);
    }
  }
}

World rod(double friction, double speed) {
  constexpr double half_length = 0.5, angle = 1.1071487177940904;  // atan 2, where the rod jams most easily
  constexpr double moment = half_length * half_length / 3;
  World world;
  world.add({.mass = 1,
             .inertia = {moment, moment, moment},
             .centre = {half_length * std::cos(angle), 0, half_length * std::sin(angle)},
             .linear = {speed, 0, -gravity * 1e-3}});
  world.contacts.push_back({.friction = friction});
  return world;
}

// Mobility of the tip: 3.4 along, 1.6 across, 1.2 between them. From 1.3068 on friction stops the tip that is pushed
// ahead.
TEST(ContactProblem, JamsOrSlidesARodAsItsMobilitySays) {
  for (const double friction : {1.5, 2.5}) {
    const World world = rod(friction, -1);
    const abut_solver_options options = options_of(1e-12, 200);
    const Answer answer = world.solve(&options);
    EXPECT_EQ(answer.residuals.is_converged, 1U);
    EXPECT_NEAR(answer.impulse(0).x, 0.402943, 1e-6);
    EXPECT_NEAR(answer.impulse(0).z, 0.308339, 1e-6);
    EXPECT_NEAR(world.kinetic_energy(answer), 0.2971, 1e-4);
    EXPECT_LE(world.worst_miss(answer), 1e-11);
  }
  const Answer sliding = rod(1, -1).solve();
  EXPECT_NEAR(sliding.impulse(0).x, 0.024525, 1e-6);
  EXPECT_NEAR(sliding.impulse(0).z, 0.024525, 1e-6);
  for (const double friction : {1.0, 1.5, 2.5}) {
    const World world = rod(friction, 1);
    expect_solved(world, options_of(1e-12, 50), 1e-11);
    EXPECT_LT(world.kinetic_energy(world.solve()), 0.5 + 0.5 * gravity * gravity * 1e-6);
  }
}

TEST(ContactProblem, BeginsWhereItIsTold) {
  World world = stack(growing(1e6), 0.5);
  world.fall({0, 0, -gravity}, 1e-3);
  const Answer cold = world.solve();
  const Answer warm = world.solve(nullptr, &cold);
  EXPECT_EQ(warm.residuals.is_converged, 1U);
  EXPECT_EQ(warm.residuals.rounds, 0U);
  EXPECT_LE(world.worst_miss(warm), 1e-11);
}

TEST(ContactProblem, AnswersTheSameBitsEachTime) {
  World world = stack(in_turns(1e6), 0.5);
  world.fall({1, 2, -gravity}, 1e-3);
  const Answer once = world.solve(), twice = world.solve();
  EXPECT_EQ(once.velocities, twice.velocities);
  EXPECT_EQ(once.impulses, twice.impulses);
}

TEST(ContactProblem, TellsThatTheRoundsEnded) {
  World world = stack(in_turns(1e6), 0.5);
  world.fall({0, 0, -gravity}, 1e-3);
  const abut_solver_options options = options_of(1e-9, 2);
  const Answer answer = world.solve(&options);
  EXPECT_EQ(answer.status, ABUT_OK);
  EXPECT_EQ(answer.residuals.is_converged, 0U);
  EXPECT_EQ(answer.residuals.rounds, 2U);
  EXPECT_GT(answer.residuals.contact, 1e-9 * gravity * 1e-3);
}

}  // namespace
