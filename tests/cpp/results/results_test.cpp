// SPDX-License-Identifier: Apache-2.0
// The same headers where calls answer a Result, compiled without exceptions.
#include <abut/abut.hpp>
#include <gtest/gtest.h>

#include <type_traits>

namespace {

TEST(Result, HoldsAValueOrAnError) {
  const auto ball = abut::Shape::sphere(1);
  static_assert(std::is_same_v<decltype(ball), const abut::Result<abut::Shape>>);
  ASSERT_TRUE(ball.has_value());
  EXPECT_EQ(ball->parameters().value(), std::vector<double>{1});
  const auto wrong = abut::Shape::sphere(-1);
  ASSERT_FALSE(wrong);
  EXPECT_EQ(wrong.error().status(), ABUT_OUT_OF_RANGE);
  EXPECT_STREQ(wrong.error().what(), "radius is -1; it must be positive");
  EXPECT_EQ(wrong.value_or(*ball), *ball);
}

TEST(ResultDeathTest, EndsTheProgramWhereItHasNoValue) {
  EXPECT_DEATH(static_cast<void>(abut::Shape::sphere(-1).value()), "");
  EXPECT_DEATH(static_cast<void>(abut::Shape::sphere(1).error()), "");
}

TEST(Result, IsTheAnswerOfEveryCall) {
  auto universe = abut::Universe::create(abut::UniverseOptions().with_threads(1));
  ASSERT_TRUE(universe);
  const auto shape = abut::Shape::box(1, 1, 1);
  ASSERT_TRUE(shape);
  for (const double height : {0.0, 1.75}) {
    const auto part = universe->create_part(abut::PartOptions().with_pose(abut::pose({0, 0, height})));
    ASSERT_TRUE(part);
    ASSERT_TRUE(universe->create_geometry(*part, *shape));
  }
  ASSERT_TRUE(universe->step(0.01));
  const auto contacts = universe->contacts();
  ASSERT_TRUE(contacts);
  EXPECT_EQ(contacts->size(), 4U);
  const auto negative = universe->step(-1);
  ASSERT_FALSE(negative);
  EXPECT_EQ(negative.error().status(), ABUT_OUT_OF_RANGE);
  const auto hit = universe->cast_ray({{-9, 0, 0}, {1, 0, 0}, 1});
  ASSERT_TRUE(hit);
  EXPECT_FALSE(hit->has_value());
  const auto lists = universe->at_points({{0, 0, 0}});
  ASSERT_TRUE(lists);
  EXPECT_EQ(lists->of(0).size(), 1U);
  ASSERT_TRUE(universe->explain());
  ASSERT_TRUE(universe->shape(lists->of(0)[0]));
  EXPECT_FALSE(abut::pair_distance(*shape, abut::pose(), *shape, abut::Pose{}));
  const auto of_each = abut::pairs_contacts(*shape, {abut::pose()}, *shape, {abut::pose({0, 0, 1.75})});
  ASSERT_TRUE(of_each);
  EXPECT_EQ(of_each->of(0).size(), 4U);
  EXPECT_FALSE(abut::pairs_contacts(*shape, {abut::pose()}, *shape, {}));
  const auto hits = abut::pairs_cast(*shape, {abut::pose()}, {{0, 0, 2}}, *shape, {abut::pose({0, 0, 3})}, {{0, 0, 0}});
  ASSERT_TRUE(hits);
  EXPECT_NEAR((*hits)[0].fraction, 0.5, 1e-9);
  EXPECT_FALSE(abut::pairs_cast(*shape, {abut::pose()}, {}, *shape, {abut::pose()}, {{0, 0, 0}}));
}

}  // namespace
