// SPDX-License-Identifier: Apache-2.0
// Sweeps over the contacts of a problem: the same law, with another cost.
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <vector>

#include "heap.hpp"
#include "scene.hpp"

namespace {

using namespace response_test;

abut_solver_options sweeps_of(double tolerance, std::uint32_t most_rounds) {
  abut_solver_options options = options_of(tolerance, most_rounds);
  options.solver = ABUT_SOLVER_SWEEPS;
  return options;
}

TEST(Sweeps, SatisfyTheLawWhereTheyConverge) {
  World world = stack({1, 2}, 0.5);
  world.fall({3, 1, -gravity}, 1e-2);
  for (Contact& contact : world.contacts) contact.compliance = contact.point.z > 1 ? 1e-4 : 0;
  const abut_solver_options options = sweeps_of(1e-9, 20000);
  const Answer found = world.solve(&options);
  ASSERT_EQ(found.status, ABUT_OK);
  EXPECT_EQ(found.residuals.is_converged, 1U);
  EXPECT_EQ(found.residuals.newton_steps, 0U);
  EXPECT_LE(world.worst_miss(found), 1e-9);
  const Answer exact = world.solve();
  for (std::size_t i = 0; i < found.velocities.size(); ++i) EXPECT_NEAR(found.velocities[i], exact.velocities[i], 1e-7);
}

// They end at the rounds that are given, with a residual that others can check.
TEST(Sweeps, TellHowFarTheyCame) {
  World world = heap(60, 0.5, 200, 7);
  double last = 1;
  for (const std::uint32_t rounds : {10U, 100U, 1000U}) {
    const abut_solver_options options = sweeps_of(1e-12, rounds);
    const Answer found = world.solve(&options);
    ASSERT_EQ(found.status, ABUT_OK);
    EXPECT_EQ(found.residuals.is_converged, 0U);
    EXPECT_EQ(found.residuals.rounds, rounds);
    const double miss = world.worst_miss(found), told = std::max(found.residuals.contact, found.residuals.motion);
    EXPECT_LT(miss, 10 * told);
    EXPECT_LT(told, 10 * miss);
    EXPECT_LT(told, last);
    last = told;
  }
}

TEST(Sweeps, MoveBodies) {
  Scene scene([](abut_response_options& its) {
    its.solver = ABUT_SOLVER_SWEEPS;
    its.most_rounds = 2000;
  });
  scene.material([](abut_contact_material& row) { row.friction_primary = row.friction_secondary = 0.5; });
  scene.floor();
  const abut_part_id low = scene.body(block(0.5, 0.5, 0.5), {{0, 0, 0.5}, no_turn}, 1),
                     high = scene.body(block(0.5, 0.5, 0.5), {{0, 0, 1.5}, no_turn}, 1);
  abut_link_options options;
  abut_link_options_init(&options, sizeof options);
  options.a = low;
  options.b = high;
  options.point_a = options.point_b = {0.5, 0, 1};
  std::uint64_t link = 0;
  require(abut_response_add_link(scene.response(), &options, &link));
  scene.step(1e-2, 100);
  EXPECT_EQ(scene.islands()[0].residuals.is_converged, 1U);
  EXPECT_EQ(scene.islands()[0].residuals.newton_steps, 0U);
  EXPECT_NEAR(scene.pose(high).position.z, 1.5, 1e-4);
  EXPECT_NEAR(scene.pose(high).position.x, 0, 1e-6);
}

// Sweeps alone leave velocities of the size of the fall, so that the stack runs into itself.
TEST(Sweeps, GiveWayToNewtonBetweenVeryDifferentMasses) {
  std::vector<double> growing;
  for (int i = 0; i < 10; ++i) growing.push_back(std::pow(1e6, i / 9.0));
  World world = stack(growing, 0.5);
  world.fall({0, 0, -gravity}, 1e-2);
  const abut_solver_options options = sweeps_of(1e-9, 100);
  const Answer found = world.solve(&options);
  ASSERT_EQ(found.status, ABUT_OK);
  EXPECT_EQ(found.residuals.is_converged, 1U);
  EXPECT_GT(found.residuals.newton_steps, 0U);
  EXPECT_LE(world.worst_miss(found), 1e-8);
  // Of masses that are alike, sweeps are all there is.
  World alike = stack({1, 1, 1, 1, 1, 1, 1, 1, 1, 1}, 0.5);
  alike.fall({0, 0, -gravity}, 1e-2);
  const abut_solver_options few = sweeps_of(1e-9, 10);
  EXPECT_EQ(alike.solve(&few).residuals.newton_steps, 0U);
}

TEST(Sweeps, HoldAStackOfVeryDifferentMasses) {
  Scene scene([](abut_response_options& its) { its.solver = ABUT_SOLVER_SWEEPS; });
  scene.material([](abut_contact_material& row) { row.friction_primary = row.friction_secondary = 0.5; });
  scene.floor();
  std::vector<abut_part_id> parts;
  for (int i = 0; i < 8; ++i)
    parts.push_back(scene.body(block(0.5, 0.5, 0.5), {{0, 0, 0.5 + i}, no_turn}, std::pow(10, i)));
  scene.step(1e-2, 100);
  for (std::size_t i = 0; i < parts.size(); ++i)
    EXPECT_NEAR(scene.pose(parts[i]).position.z, 0.5 + static_cast<double>(i), 1e-3) << i;
}

TEST(Sweeps, AreRefusedUnderAnotherNumber) {
  World world = stack({1}, 0.5);
  abut_solver_options options = sweeps_of(1e-9, 10);
  options.solver = 2;
  EXPECT_EQ(world.solve(&options).status, ABUT_UNKNOWN_VALUE);
  options.solver = 0;
  options.reserved = 1;
  EXPECT_EQ(world.solve(&options).status, ABUT_INVALID_ARGUMENT);
}

}  // namespace
