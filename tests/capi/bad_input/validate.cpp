// SPDX-License-Identifier: Apache-2.0
// Findings about a scene, under bad input.
#include "bad_values.hpp"

namespace {

using namespace abut_test;

TEST(UniverseValidate, RefusesNullArguments) {
  const Scene scene;
  std::size_t count = 7;
  abut_finding finding{};
  EXPECT_TRUE(refused(abut_universe_validate(nullptr, &finding, 1, &count), ABUT_NULL_ARGUMENT, {"universe", "null"}));
  EXPECT_TRUE(
      refused(abut_universe_validate(scene.universe, &finding, 1, nullptr), ABUT_NULL_ARGUMENT, {"count", "null"}));
  EXPECT_TRUE(
      refused(abut_universe_validate(scene.universe, nullptr, 1, &count), ABUT_NULL_ARGUMENT, {"findings", "null"}));
  EXPECT_EQ(count, 7U);
}

TEST(UniverseValidate, RefusesCountsThatOverflow) {
  const Scene scene;
  std::size_t count = 7;
  abut_finding finding{};
  EXPECT_TRUE(
      refused(abut_universe_validate(scene.universe, &finding, size_max, &count), ABUT_SIZE_OVERFLOW, {"capacity"}));
  EXPECT_EQ(count, 7U);
}

TEST(UniverseValidate, CountsThenFills) {
  Universe universe;
  const Shape ball = make_sphere(1);
  for (int i = 0; i < 2; ++i) universe.add(ball, identity, ABUT_MOTION_STATIC);
  std::size_t count = 0;
  ASSERT_TRUE(succeeded(abut_universe_validate(universe, nullptr, 0, &count)));
  ASSERT_EQ(count, 1U);
  abut_finding finding{};
  ASSERT_TRUE(succeeded(abut_universe_validate(universe, &finding, 1, &count)));
  EXPECT_EQ(finding.code, abut_finding_code{ABUT_FINDING_NOTHING_MOVES});
  EXPECT_EQ(finding.geometry.slot, 0U);
  EXPECT_NE(std::string_view(finding.message).find("dynamic"), std::string_view::npos);
}

}  // namespace
