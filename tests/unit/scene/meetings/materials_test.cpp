// SPDX-License-Identifier: Apache-2.0
// The table of contact materials.
#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <optional>
#include <string>

import abut.scene.meetings.materials;

namespace {

using namespace abut;

constexpr std::uint32_t steel = 1, rubber = 2, ice = 3;

TEST(MaterialTable, HasTheDefaultForMaterialsThatNobodyKnows) {
  const MaterialTable table;
  EXPECT_EQ(table.of(steel, steel), ContactMaterial{});
  EXPECT_EQ(table.of(steel, rubber), ContactMaterial{});
}

TEST(MaterialTable, IsSymmetric) {
  MaterialTable table;
  table.set(rubber, steel, ContactMaterial{.friction_primary = 0.7});
  EXPECT_EQ(table.of(steel, rubber).friction_primary, 0.7);
  EXPECT_EQ(table.of(rubber, steel).friction_primary, 0.7);
  table.set(steel, rubber, ContactMaterial{.friction_primary = 0.6});
  EXPECT_EQ(table.of(rubber, steel).friction_primary, 0.6);
  EXPECT_EQ(table.size(), 1U);
}

TEST(MaterialTable, CombinesTheRowsOfEachWithItself) {
  MaterialTable table;
  table.set(
      steel, steel,
      ContactMaterial{.friction_primary = 0.25, .slip = 1, .damping = 3, .restitution = 0.5, .adhesive_force = 2});
  table.set(rubber, rubber,
            ContactMaterial{.friction_primary = 1, .slip = 2, .damping = 1, .restitution = 0.8, .adhesive_force = 5});
  const ContactMaterial both = table.of(rubber, steel);
  EXPECT_EQ(both.friction_primary, 0.5);
  EXPECT_EQ(both.slip, 3);
  EXPECT_EQ(both.damping, 3);
  EXPECT_EQ(both.restitution, 0.8);
  EXPECT_EQ(both.adhesive_force, 7);
  EXPECT_EQ(both.restitution_threshold, 0.001);
  EXPECT_EQ(both.static_scale, 1);
  EXPECT_EQ(table.of(steel, ice).friction_primary, 0) << "a mean with the default, which has none";
}

TEST(MaterialTable, ARowOfThePairComesFirstUntilItIsTakenAway) {
  MaterialTable table;
  table.set(steel, steel, ContactMaterial{.friction_primary = 0.25});
  table.set(rubber, rubber, ContactMaterial{.friction_primary = 1});
  table.set(steel, rubber, ContactMaterial{.friction_primary = 0.9});
  EXPECT_EQ(table.of(steel, rubber).friction_primary, 0.9);
  table.set(steel, rubber, std::nullopt);
  EXPECT_EQ(table.of(steel, rubber).friction_primary, 0.5);
}

TEST(MaterialTable, RefusesWhatIsNoNumberOrNegative) {
  EXPECT_FALSE(check_material({}).has_value());
  const auto fault = check_material({.damping = -1});
  ASSERT_TRUE(fault.has_value());
  EXPECT_NE(fault->message.find("damping is -1"), std::string::npos) << fault->message;
  EXPECT_TRUE(check_material({.adhesive_force = std::numeric_limits<double>::quiet_NaN()}).has_value());
  EXPECT_TRUE(check_material({.slip = std::numeric_limits<double>::infinity()}).has_value());
}

}  // namespace
