// SPDX-License-Identifier: Apache-2.0
// Single parts under bad input.
#include "bad_values.hpp"

namespace {

using namespace abut_test;

abut_part_options default_options() {
  abut_part_options options;
  abut_part_options_init(&options, sizeof options);
  return options;
}

TEST(PartOptionsInit, IgnoresNull) { abut_part_options_init(nullptr, 0); }

TEST(PartOptionsInit, FillsInTheDefaults) {
  Out<abut_part_options> options;
  abut_part_options_init(options.address(), sizeof(abut_part_options));
  EXPECT_EQ(options.value().struct_size, sizeof(abut_part_options));
  EXPECT_EQ(options.value().motion, abut_motion{ABUT_MOTION_DYNAMIC});
  EXPECT_EQ(options.value().pose.position.x, 0.0);
  EXPECT_EQ(options.value().pose.orientation.w, 1.0);
  EXPECT_EQ(options.value().pose.orientation.x, 0.0);
  EXPECT_EQ(options.value().user_data, 0U);
}

TEST(PartCreate, RefusesUnknownMotion) {
  const Scene scene;
  Out<abut_part_id> out;
  for (const abut_motion motion : {3U, 77U, 0xFFFFFFFFU}) {
    abut_part_options options = default_options();
    options.motion = motion;
    EXPECT_TRUE(refused(abut_part_create(scene.universe, &options, out.address()), ABUT_UNKNOWN_VALUE,
                        {"motion", std::to_string(motion)}));
  }
  EXPECT_TRUE(out.is_untouched());
  EXPECT_TRUE(scene.is_unchanged());
}

TEST(PartCreate, AcceptsLaterOptionsWithZeroTail) {
  const Scene scene;
  abut_part_id part{};
  expect_zero_tail_accepted(default_options(), [&](const abut_part_options* later) {
    return abut_part_create(scene.universe, later, &part);
  });
  EXPECT_NE(part.slot, 0U);
}

}  // namespace
