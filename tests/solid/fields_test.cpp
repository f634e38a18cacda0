// SPDX-License-Identifier: Apache-2.0
// Height fields that are solid below.
#include "solids.hpp"

namespace {

using namespace solid;

ShapePtr field(const std::vector<double>& heights, std::uint32_t columns, abut_below below) {
  abut_height_field_desc desc;
  abut_height_field_desc_init(&desc, sizeof desc);
  desc.columns = columns;
  desc.rows = static_cast<std::uint32_t>(heights.size()) / columns;
  desc.heights = heights.data();
  desc.below = below;
  return made([&](abut_shape** out) { return abut_height_field_create(&desc, out); });
}

TEST(Fields, BallThatFellThroughIsPushedUp) {
  const ShapePtr ground = field(std::vector<double>(81, 0.0), 9, ABUT_BELOW_SOLID), ball = sphere(0.25);
  for (const double z : {0.2, 0.0, -0.1, -0.25, -1.0, -3.0}) {
    const abut_distance found = distance(ground, ball, at(4.1, 4.2, z));
    EXPECT_NEAR(found.distance, z - 0.25, 1e-11);
    EXPECT_NEAR(found.normal.z, 1, 1e-9);
    const auto met = contacts(ground, ball, at(4.1, 4.2, z));
    ASSERT_FALSE(met.empty()) << z;
    for (const abut_contact& contact : met) EXPECT_NEAR(contact.normal.z, 1, 1e-9);
  }
  EXPECT_NEAR(distance(ground, ball, at(4.1, 4.2, 1)).distance, 0.75, 1e-12);
  EXPECT_GT(distance(ground, ball, at(4.1, 4.2, -9)).distance, 0);  // below the floor
}

TEST(Fields, BelowIsOpenByDefault) {
  const ShapePtr ground = field(std::vector<double>(81, 0.0), 9, ABUT_BELOW_OPEN), ball = sphere(0.25);
  EXPECT_NEAR(distance(ground, ball, at(4.1, 4.2, -1)).distance, 0.75, 1e-12);
  EXPECT_TRUE(contacts(ground, ball, at(4.1, 4.2, -1)).empty());
}

// The depth of a body below hills is at most the way straight up, and no more than rounding is left after it.
TEST(Fields, DepthBelowHillsIsParted) {
  std::vector<double> hills;
  for (int j = 0; j < 20; ++j) {
    for (int i = 0; i < 20; ++i) hills.push_back(0.8 * std::sin(0.7 * i) * std::cos(0.5 * j));
  }
  const ShapePtr ground = field(hills, 20, ABUT_BELOW_SOLID), ball = sphere(0.3), body = box(0.4, 0.3, 0.2);
  for (int i = 0; i < 30; ++i) {
    const abut_pose pose = at(3 + 0.4 * i, 15 - 0.35 * i, -2.0 + 0.08 * i);
    for (const ShapePtr* shape : {&ball, &body}) {
      const abut_distance found = distance(ground, *shape, pose);
      if (found.distance < 0) {
        EXPECT_GT(found.normal.z, 0);
        expect_parted(ground, *shape, pose, found);
      }
    }
  }
}

TEST(Fields, UnknownBelowIsRefused) {
  const std::array<double, 4> heights{0, 0, 0, 0};
  abut_height_field_desc desc;
  abut_height_field_desc_init(&desc, sizeof desc);
  desc.columns = desc.rows = 2;
  desc.heights = heights.data();
  desc.below = 2;
  abut_shape* out = nullptr;
  EXPECT_EQ(abut_height_field_create(&desc, &out), ABUT_UNKNOWN_VALUE);
  EXPECT_NE(std::string(abut_last_error_message()).find("desc.below is 2"), std::string::npos)
      << abut_last_error_message();
  EXPECT_EQ(out, nullptr);
}

}  // namespace
