// SPDX-License-Identifier: Apache-2.0
// Dense heaps: the hard case for friction. The bounds are what this solver reaches, not what one would wish for.
#include <gtest/gtest.h>

#include "heap.hpp"

namespace {

using namespace response_test;

TEST(ContactProblem, SolvesHeapsWithoutFriction) {
  const World world = heap(216, 0, 500, 1);
  ASSERT_GT(world.contacts.size(), 600U);
  const abut_solver_options options = options_of(1e-9, 40);
  const Answer answer = world.solve(&options);
  EXPECT_EQ(answer.residuals.is_converged, 1U);
  EXPECT_LE(world.worst_miss(answer), 1e-9);
}

TEST(ContactProblem, TellsHowFarHeapsWithFrictionAreFromTheLaw) {
  constexpr struct {
    double friction, bound;
  } cases[] = {{0.1, 1e-10}, {0.3, 5e-6}, {0.5, 2e-5}};
  for (const auto& [friction, bound] : cases) {
    for (const unsigned seed : {1U, 2U}) {
      const World world = heap(60, friction, 900, seed);
      ASSERT_GT(world.contacts.size(), 120U);
      const abut_solver_options options = options_of(1e-9, 250);
      const Answer answer = world.solve(&options);
      ASSERT_EQ(answer.status, ABUT_OK);
      const double missed = world.worst_miss(answer);
      EXPECT_LE(missed, bound) << "friction " << friction << ", seed " << seed;
      // What is told is what is so: two measures of one error, by another norm.
      EXPECT_LE(missed, 4 * (answer.residuals.contact + answer.residuals.motion));
      EXPECT_GE(missed, 0.25 * answer.residuals.contact);
    }
  }
}

// The next step of a heap begins with the impulses of this one.
TEST(ContactProblem, TakesFewerStepsWhereItBeginsWarm) {
  World world = heap(60, 0.1, 900, 3);
  const abut_solver_options options = options_of(1e-6, 250);
  const Answer cold = world.solve(&options);
  for (Body& ball : world.bodies) ball.linear.x += 1e-6;
  const Answer warm = world.solve(&options, &cold);
  ASSERT_EQ(warm.residuals.is_converged, 1U);
  EXPECT_LE(warm.residuals.newton_steps, cold.residuals.newton_steps * 7 / 10);
}

}  // namespace
