// SPDX-License-Identifier: Apache-2.0
// Contact materials under bad input.
#include "bad_values.hpp"

namespace {

using namespace abut_test;

abut_contact_material default_row() {
  abut_contact_material row;
  abut_contact_material_init(&row, sizeof row);
  return row;
}

TEST(ContactMaterialInit, IgnoresNull) { abut_contact_material_init(nullptr, 0); }

TEST(ContactMaterialInit, FillsInTheDefaults) {
  Out<abut_contact_material> row;
  abut_contact_material_init(row.address(), sizeof(abut_contact_material));
  EXPECT_EQ(row.value().struct_size, sizeof(abut_contact_material));
  EXPECT_EQ(row.value().friction_primary, 0.0);
  EXPECT_EQ(row.value().static_scale, 1.0);
  EXPECT_EQ(row.value().restitution_threshold, 0.001);
}

TEST(MaterialPairSet, RefusesWrongStructSizes) {
  const Scene scene;
  for (const std::uint32_t size : {0U, 3U, 4097U, static_cast<std::uint32_t>(sizeof(abut_contact_material)) - 1}) {
    abut_contact_material row = default_row();
    row.struct_size = size;
    EXPECT_TRUE(refused(abut_material_pair_set(scene.universe, 0, 1, &row), ABUT_WRONG_STRUCT_SIZE,
                        {"row", "struct_size", std::to_string(size)}));
  }
  abut_contact_material row = default_row();
  row.reserved = 7;
  EXPECT_TRUE(
      refused(abut_material_pair_set(scene.universe, 0, 1, &row), ABUT_INVALID_ARGUMENT, {"row", "reserved", "7"}));
  EXPECT_TRUE(scene.is_unchanged());
}

TEST(MaterialPairSet, RefusesNumbersThatAreNoneOrNegative) {
  const Scene scene;
  for (const auto& [field, name] : {std::pair{&abut_contact_material::friction_primary, "friction_primary"},
                                    std::pair{&abut_contact_material::compliance, "compliance"},
                                    std::pair{&abut_contact_material::adhesive_force, "adhesive_force"}}) {
    abut_contact_material row = default_row();
    row.*field = not_a_number;
    EXPECT_TRUE(refused(abut_material_pair_set(scene.universe, 0, 1, &row), ABUT_NOT_FINITE, {"row", name}));
    row.*field = -0.5;
    EXPECT_TRUE(refused(abut_material_pair_set(scene.universe, 0, 1, &row), ABUT_OUT_OF_RANGE, {"row", name, "-0.5"}));
  }
  abut_contact_material found = default_row();
  ASSERT_TRUE(succeeded(abut_material_pair_get(scene.universe, 0, 1, &found)));
  EXPECT_EQ(found.friction_primary, 0.0) << "what was refused was not stored";
  EXPECT_TRUE(scene.is_unchanged());
}

TEST(MaterialPairGet, AnswersByTheRowOrCombines) {
  const Scene scene;
  abut_contact_material row = default_row();
  row.friction_primary = 0.25;
  ASSERT_TRUE(succeeded(abut_material_pair_set(scene.universe, 1, 1, &row)));
  row.friction_primary = 1;
  ASSERT_TRUE(succeeded(abut_material_pair_set(scene.universe, 2, 2, &row)));
  abut_contact_material found = default_row();
  ASSERT_TRUE(succeeded(abut_material_pair_get(scene.universe, 2, 1, &found)));
  EXPECT_EQ(found.friction_primary, 0.5);
  row.friction_primary = 0.75;
  ASSERT_TRUE(succeeded(abut_material_pair_set(scene.universe, 1, 2, &row)));
  ASSERT_TRUE(succeeded(abut_material_pair_get(scene.universe, 2, 1, &found)));
  EXPECT_EQ(found.friction_primary, 0.75);
  ASSERT_TRUE(succeeded(abut_material_pair_set(scene.universe, 2, 1, nullptr)));
  ASSERT_TRUE(succeeded(abut_material_pair_get(scene.universe, 1, 2, &found)));
  EXPECT_EQ(found.friction_primary, 0.5);
}

}  // namespace
