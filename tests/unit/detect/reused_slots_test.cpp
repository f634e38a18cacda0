// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <span>
#include <vector>

#include "../queries/query_scene.hpp"

import abut.universe;

namespace {

using namespace test::queries;

// Between two steps a geometry goes and another one takes its slot, so that the places of the pair stay near.
TEST(ReusedSlots, EndAPairAndBeginAnother) {
  Universe universe({}, 1);
  add(universe, make_handle("sphere", {1}), at(0, 0, 0));
  const ShapeHandle ball = make_handle("sphere", {1});
  const GeometryId gone = add(universe, ball, at(0, 0, 1.5));
  ASSERT_TRUE(universe.step(0).has_value());
  ASSERT_TRUE(universe.step(0).has_value());
  ASSERT_EQ(universe.contacts().size(), 1U);
  EXPECT_EQ(universe.contacts()[0].age, 1U);

  const PartId part = universe.describe(gone).value().part;
  ASSERT_TRUE(universe.destroy_geometries(std::span(&gone, 1)).has_value());
  const GeometryId next = universe.create_geometries(std::span(&part, 1), std::span(&ball, 1), {}).value().front();
  ASSERT_EQ(next.slot, gone.slot);
  ASSERT_TRUE(universe.step(0).has_value());
  ASSERT_EQ(universe.contacts().size(), 1U);
  EXPECT_EQ(universe.contacts()[0].geometry_b, next);
  EXPECT_EQ(universe.contacts()[0].age, 0U);
  ASSERT_EQ(universe.events().size(), 2U);
  EXPECT_EQ(universe.events()[0].kind, EventKind::end);
  EXPECT_EQ(universe.events()[0].geometry_b, gone);
  EXPECT_EQ(universe.events()[1].kind, EventKind::begin);
  EXPECT_EQ(universe.events()[1].geometry_b, next);
}

}  // namespace
