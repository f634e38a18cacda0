// SPDX-License-Identifier: Apache-2.0
// A picker is told by the plan of its universe for as long as it is there.
#include <string>

#include "picking_support.hpp"

namespace {

using namespace picking_test;

std::string explain(const abut_universe* universe) {
  std::size_t needed = 0;
  EXPECT_EQ(abut_universe_explain(universe, nullptr, 0, &needed), ABUT_OK);
  std::string text(needed, '?');
  EXPECT_EQ(abut_universe_explain(universe, text.data(), text.size(), &needed), ABUT_OK);
  return text;
}

PickerHandle picker_on(abut_universe* universe) {
  abut_picker* picker = nullptr;
  EXPECT_EQ(abut_picker_create(universe, &picker), ABUT_OK) << abut_last_error_message();
  return PickerHandle(picker);
}

TEST(PickerAttached, IsToldWhileItIsThere) {
  abut_universe* created = nullptr;
  ASSERT_EQ(abut_universe_create(nullptr, &created), ABUT_OK);
  const Universe universe(created);
  EXPECT_EQ(explain(universe.get()).find("picking"), std::string::npos);
  {
    const PickerHandle picker = picker_on(universe.get());
    EXPECT_NE(explain(universe.get()).find("extensions: 1 picking\n"), std::string::npos) << explain(universe.get());
    const PickerHandle second = picker_on(universe.get());
    EXPECT_NE(explain(universe.get()).find("extensions: 2 picking\n"), std::string::npos);
    abut_picker* none = nullptr;
    EXPECT_EQ(abut_picker_create(universe.get(), nullptr), ABUT_NULL_ARGUMENT);
    EXPECT_EQ(abut_picker_create(nullptr, &none), ABUT_NULL_ARGUMENT);
    EXPECT_NE(explain(universe.get()).find("extensions: 2 picking\n"), std::string::npos) << "a failure counts nothing";
  }
  EXPECT_NE(explain(universe.get()).find("extensions: none attached\n"), std::string::npos);
}

std::uint64_t memory_in_use() {
  std::uint64_t bytes = 0;
  std::uint64_t blocks = 0;
  EXPECT_EQ(abut_memory_in_use(&bytes, &blocks), ABUT_OK);
  return blocks;
}

// Whoever collects garbage may destroy the universe first.
TEST(PickerAttached, OutlivesWhatTheCallerOwnsOfItsUniverse) {
  const std::uint64_t before = memory_in_use();
  {
    abut_universe* created = nullptr;
    ASSERT_EQ(abut_universe_create(nullptr, &created), ABUT_OK);
    abut_part_id part{};
    abut_geometry_id geometry{};
    ASSERT_EQ(abut_part_create(created, nullptr, &part), ABUT_OK);
    ASSERT_EQ(abut_geometry_create(created, part, sphere(1).get(), nullptr, &geometry), ABUT_OK);
    PickerHandle first = picker_on(created);
    const PickerHandle second = picker_on(created);
    abut_universe_destroy(created);
    first.reset();
    abut_pick pick{};
    ASSERT_EQ(abut_picker_cast_ray(second.get(), &along_x, nullptr, &pick), ABUT_OK) << abut_last_error_message();
    EXPECT_TRUE(same(pick.geometry, geometry)) << "the world as it was";
    EXPECT_DOUBLE_EQ(pick.distance, 9);
  }
  EXPECT_EQ(memory_in_use(), before) << "the universe has gone with its last picker";
}

}  // namespace
