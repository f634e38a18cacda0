// SPDX-License-Identifier: Apache-2.0
// A contact problem where calls answer a Result.
#include <abut/response.hpp>
#include <gtest/gtest.h>

namespace {

TEST(Result, IsTheAnswerOfAContactProblem) {
  abut::ContactProblem problem;
  problem.add_body(2, {1, 0, 0, 0, 1, 0, 0, 0, 1}, {0, 0, 0}, {{0, 0, -1}, {0, 0, 0}});
  abut::ProblemContact contact;
  contact.b = 0;
  problem.add_contact(contact);
  const auto solution = problem.solve();
  ASSERT_TRUE(solution);
  EXPECT_NEAR(solution->impulses[0].z, 2, 1e-8);
  const abut::ContactSolution other;
  EXPECT_FALSE(problem.solve(abut::SolverOptions(), &other));
}

TEST(Result, IsTheAnswerOfAResponse) {
  auto universe = abut::Universe::create();
  ASSERT_TRUE(universe);
  auto response = abut::Response::create(*universe);
  ASSERT_TRUE(response);
  ASSERT_TRUE(response->step(0.1));
  const auto contacts = response->contacts();
  ASSERT_TRUE(contacts);
  EXPECT_TRUE(contacts->empty());
  EXPECT_FALSE(response->step(-1));
}

}  // namespace
