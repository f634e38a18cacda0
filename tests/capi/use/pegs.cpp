// SPDX-License-Identifier: Apache-2.0
// Round pegs along a through hole. What they reach beyond the block changes nothing: the distance is the clearance of
// two circles.
#include <cmath>
#include <random>

#include "hollow_bodies.hpp"

namespace {

using namespace abut_test;

constexpr double width = 1, half_thickness = 0.6, radius_of_hole = 0.5;

Shape make_block(double half_height) {
  constexpr double open_at_both_ends = ABUT_OPEN_TOP | ABUT_OPEN_BOTTOM;
  return make_composite({make_box(width, width, half_thickness),
                         make_of_kind("cylinder_hole", {radius_of_hole, half_height, open_at_both_ends})},
                        {identity, identity});
}

abut_distance distance_between(const Shape& a, const abut_pose& pose_a, const Shape& b, const abut_pose& pose_b) {
  abut_distance found{};
  require(abut_pair_distance(a, &pose_a, b, &pose_b, nullptr, &found));
  return found;
}

std::vector<abut_contact> contacts_within(double margin, const Shape& a, const abut_pose& pose_a, const Shape& b,
                                          const abut_pose& pose_b) {
  abut_query_options options;
  abut_query_options_init(&options, sizeof options);
  options.margin = margin;
  std::vector<abut_contact> found(64);
  std::size_t count = 0;
  require(abut_pair_contacts(a, &pose_a, b, &pose_b, &options, found.data(), found.size(), &count));
  found.resize(count);
  return found;
}

TEST(Pegs, ThatStickOutOfAHoleHaveTheClearance) {
  const Shape block = make_block(0.7);
  const abut_distance jammed =
      distance_between(block, identity, make_of_kind("cylinder", {0.45, 0.75}), at(0.055, 0, 0));
  EXPECT_NEAR(jammed.distance, -0.005, 1e-9);
  EXPECT_NEAR(jammed.normal.x, -1, 1e-9);
  const abut_distance free = distance_between(block, identity, make_of_kind("cylinder", {0.4, 1}), identity);
  EXPECT_NEAR(free.distance, 0.1, 1e-9);
  EXPECT_NEAR(free.upper, 0.1, 1e-9);
}

TEST(Pegs, AtRandomHaveTheClearance) {
  constexpr unsigned seed = 7;
  SCOPED_TRACE(seed);
  std::mt19937_64 random(seed);
  const auto between = [&](double low, double high) {
    return low + (high - low) * (static_cast<double>(random() >> 11) * 0x1p-53);
  };
  int jammed = 0, free = 0;
  for (int i = 0; i < 400; ++i) {
    const double radius = between(0.2, 0.49), angle = between(0, 6.283), half_height = between(0.65, 2);
    const double clearance = i % 2 == 0 ? between(-0.05, -1e-4) : between(1e-4, radius_of_hole - radius);
    const double aside = radius_of_hole - radius - clearance, along = between(-0.04, 0.04);
    const bool is_capsule = i % 4 > 1;
    const Shape block = make_block(between(half_thickness, 1.5)),
                peg = is_capsule ? make_capsule(radius, half_height) : make_of_kind("cylinder", {radius, half_height});
    const abut_pose pose = at(aside * std::cos(angle), aside * std::sin(angle), along);
    SCOPED_TRACE(testing::Message() << i << " radius " << radius << " half height " << half_height << " aside " << aside
                                    << " at " << angle << " along " << along);
    const abut_distance found = distance_between(block, identity, peg, pose);
    EXPECT_NEAR(found.distance, clearance, 1e-6);
    EXPECT_LE(found.lower, clearance + 1e-6);
    EXPECT_GE(found.upper, clearance - 1e-6);
    EXPECT_LT(found.normal.x * std::cos(angle) + found.normal.y * std::sin(angle), -1 + 1e-3);
    const auto contacts = contacts_within(0.3, block, identity, peg, pose);
    ASSERT_FALSE(contacts.empty());
    EXPECT_NEAR(contacts[0].distance, clearance, 1e-6);
    ++(clearance < 0 ? jammed : free);
  }
  EXPECT_EQ(jammed, 200);
  EXPECT_EQ(free, 200);
}

}  // namespace
