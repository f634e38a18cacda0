// SPDX-License-Identifier: Apache-2.0
// Contact response: a ball on the ground, and one on top of it.
#include <abut/response.hpp>
#include <gtest/gtest.h>

namespace {

TEST(ContactProblem, CarriesAStackOfTwo) {
  abut::ContactProblem problem;
  constexpr std::array<double, 9> inertia{1, 0, 0, 0, 1, 0, 0, 0, 1};
  const abut::Velocity falling{{0, 0, -0.1}, {0, 0, 0}};
  const std::uint32_t lower = problem.add_body(1, inertia, {0, 0, 1}, falling);
  const std::uint32_t upper = problem.add_body(100, inertia, {0, 0, 3}, falling);
  abut::ProblemContact contact;
  contact.b = lower;
  contact.friction = 0.5;
  problem.add_contact(contact);
  contact.a = lower;
  contact.b = upper;
  contact.point = {0, 0, 2};
  problem.add_contact(contact);
  const abut::ContactSolution solution =
      problem.solve(abut::SolverOptions().with_tolerance(1e-10).with_most_rounds(50));
  EXPECT_EQ(solution.residuals.is_converged, 1U);
  EXPECT_NEAR(solution.impulses[0].z, 10.1, 1e-8);
  EXPECT_NEAR(solution.impulses[1].z, 10, 1e-8);
  EXPECT_NEAR(solution.velocities[1].linear.z, 0, 1e-10);
  EXPECT_EQ(problem.solve(abut::SolverOptions().with_speed(1), &solution).residuals.rounds, 0U);
  contact.b = 7;
  problem.add_contact(contact);
  EXPECT_THROW(static_cast<void>(problem.solve()), abut::Error);
}

}  // namespace
