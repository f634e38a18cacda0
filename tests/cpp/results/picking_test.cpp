// SPDX-License-Identifier: Apache-2.0
// A picker where calls answer a Result.
#include <abut/picking.hpp>
#include <gtest/gtest.h>

namespace {

TEST(Result, IsTheAnswerOfAPicker) {
  auto universe = abut::Universe::create();
  ASSERT_TRUE(universe);
  const auto picker = abut::Picker::create(*universe);
  ASSERT_TRUE(picker);
  const auto pick = picker->cast_ray({{0, 0, 0}, {1, 0, 0}, 1});
  ASSERT_TRUE(pick);
  EXPECT_TRUE(abut::is_null(pick->geometry));
}

}  // namespace
