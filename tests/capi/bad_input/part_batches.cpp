// SPDX-License-Identifier: Apache-2.0
// Batches of parts under bad input: one bad element spoils all, whichever it is.
#include "bad_values.hpp"

namespace {

using namespace abut_test;

std::vector<abut_part_options> three_options() {
  std::vector<abut_part_options> options(3);
  for (abut_part_options& each : options) abut_part_options_init(&each, sizeof each);
  return options;
}

TEST(PartsCreate, RefusesOneBadElementAndCreatesNone) {
  const Scene scene;
  OutArray<abut_part_id> out(3);
  for (std::size_t place = 0; place < 3; ++place) {
    auto options = three_options();
    options.at(place).motion = 77;
    EXPECT_TRUE(refused(abut_parts_create(scene.universe, options.data(), 3, out.data()), ABUT_UNKNOWN_VALUE,
                        {"options", std::to_string(place), "motion", "77"}));
  }
  EXPECT_TRUE(out.is_untouched());
  EXPECT_TRUE(scene.is_unchanged());
}

// An array of structs steps by what the caller's header calls their size.
TEST(PartsCreate, StepsByTheStructSizeOfTheCaller) {
  const Universe universe;
  std::array<Grown<abut_part_options>, 3> later{};
  for (std::size_t i = 0; i < later.size(); ++i) {
    abut_part_options_init(&later.at(i).known, sizeof(abut_part_options));
    later.at(i).known.struct_size = sizeof(later[0]);
    later.at(i).known.user_data = 100 + i;
  }
  std::array<abut_part_id, 3> parts{};
  ASSERT_TRUE(succeeded(abut_parts_create(universe, &later[0].known, 3, parts.data())));
  for (std::size_t i = 0; i < parts.size(); ++i) {
    std::uint64_t user_data = 0;
    ASSERT_TRUE(succeeded(abut_part_user_data(universe, parts.at(i), &user_data)));
    EXPECT_EQ(user_data, 100 + i);
  }
}

TEST(PartsCreate, RefusesArraysOfDifferentStructSizes) {
  const Scene scene;
  OutArray<abut_part_id> out(3);
  auto options = three_options();
  options[1].struct_size = 0;
  EXPECT_TRUE(refused(abut_parts_create(scene.universe, options.data(), 3, out.data()), ABUT_WRONG_STRUCT_SIZE,
                      {"struct_size", "1", "0"}));
  EXPECT_TRUE(out.is_untouched());
  EXPECT_TRUE(scene.is_unchanged());
}

TEST(PartsCreate, AcceptsNone) {
  const Universe universe;
  EXPECT_TRUE(succeeded(abut_parts_create(universe, nullptr, 0, nullptr)));
}

}  // namespace
