// SPDX-License-Identifier: Apache-2.0
// Holes where one of the two bodies is made of many: particles, and composites with holes of their own.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <set>

#include "hollow_bodies.hpp"

namespace {

using namespace abut_test;

// Whether others are in the cavity makes no difference to those outside.
TEST(HolesOfMany, LeaveParticlesOutsideToTheSolid) {
  const Shape body = hollow(sphere_hole(1));
  const Shape dust = make_of_kind("particles", {0.1}, {2.05, 0, 0, 0, 0, 0, 0, -2.03, 0.5});
  const auto found = contacts_of(body, identity, dust, identity);
  ASSERT_EQ(found.size(), 2U);
  for (const abut_contact& contact : found) {
    EXPECT_EQ(contact.child_a, 0U) << "the solid";
    EXPECT_NEAR(contact.distance, contact.child_b == 0 ? -0.05 : -0.07, 1e-12);
  }
  abut_distance distance{};
  ASSERT_TRUE(succeeded(abut_pair_distance(body, &identity, dust, &identity, nullptr, &distance)));
  EXPECT_NEAR(distance.distance, -0.07, 1e-12);
}

TEST(HolesOfMany, NumberTheContactsOfEachParticle) {
  const Shape solid = make_box(3, 3, 0.5);
  const Shape plate = make_composite({solid, cylinder_hole(0.6, 0.5, 3)}, {identity, identity});
  // Both rest on the rim, from above and from below.
  const Shape balls = make_of_kind("particles", {1}, {0, 0, 1.29, 0.01, 0, -1.28});
  const auto found = contacts_of(plate, identity, balls, identity);
  std::set<std::uint64_t> numbers;
  std::array<int, 2> count{};
  for (const abut_contact& contact : found) {
    numbers.insert(contact.id);
    ++count.at(contact.child_b);
    EXPECT_EQ(contact.normal.z > 0, contact.child_b == 0);
  }
  EXPECT_EQ(numbers.size(), found.size());
  EXPECT_GE(count[0], 4);
  EXPECT_GE(count[1], 4);
}

TEST(HolesOfMany, AloneMeetParticlesBesideThem) {
  const Shape dust = make_of_kind("particles", {0.1}, {0, 0, 0, 3, 0, 0, 0, 1.5, 0});
  for (const Shape& hole : {sphere_hole(1), cylinder_hole(1, 1, 0), box_hole(1, 1, 1, 0)}) {
    abut_distance distance{};
    ASSERT_TRUE(succeeded(abut_pair_distance(hole, &identity, dust, &identity, nullptr, &distance)));
    EXPECT_NEAR(distance.distance, -2.1, 1e-12);
    EXPECT_NEAR(deepest(contacts_of(dust, identity, hole, identity)), -2.1, 1e-12);
  }
}

// A bead in a cavity: the wall that it pokes through is there whether the bead is pierced or not.
TEST(HolesOfMany, OfBothSidesLeaveTheWalls) {
  const Shape body = hollow(sphere_hole(1));
  const Shape ball = make_sphere(0.25);
  const Shape bead = make_composite({ball, cylinder_hole(0.05, 0.3, 3)}, {identity, identity});
  const abut_pose place = at(0.8, 0, 0), centre = at(0, 0, 0.8);
  for (const bool is_swapped : {false, true}) {
    const auto found = is_swapped ? contacts_of(bead, place, body, identity) : contacts_of(body, identity, bead, place);
    EXPECT_NEAR(deepest(found), -0.05, 1e-12);
    EXPECT_EQ(is_swapped ? found.at(0).child_b : found.at(0).child_a, 1U) << "the hole of the body";
    abut_distance distance{};
    ASSERT_TRUE(succeeded(is_swapped ? abut_pair_distance(bead, &place, body, &identity, nullptr, &distance)
                                     : abut_pair_distance(body, &identity, bead, &place, nullptr, &distance)));
    EXPECT_NEAR(distance.distance, -0.05, 1e-12);
    // Where the bead is pierced it has no top that could poke through: the rim does, by the wall and not through the
    // roof.
    const double rim = 0.8 + std::sqrt(0.25 * 0.25 - 0.05 * 0.05);
    const auto pierced =
        is_swapped ? contacts_of(bead, centre, body, identity) : contacts_of(body, identity, bead, centre);
    EXPECT_NEAR(deepest(pierced), 1 - std::hypot(0.05, rim), 1e-12);
    for (const abut_contact& contact : pierced) {
      EXPECT_GT(is_swapped ? contact.normal.z : -contact.normal.z, 0.99);
    }
  }
}

// An egg that leans on a rim: no point of the rim lies deeper in it than the deepest contact.
TEST(HolesOfMany, FindWhereARimIsDeepest) {
  const Shape solid = make_box(3, 3, 0.5);
  const Shape plate = make_composite({solid, cylinder_hole(0.6, 0.5, 3)}, {identity, identity});
  const Shape egg = make_of_kind("ellipsoid", {1.2, 0.7, 0.9}), point = make_of_kind("point", {});
  for (int i = 0; i < 12; ++i) {
    abut_pose pose = at(0.02 * i, 0.1 - 0.01 * i, 1.15);
    pose.orientation = {std::cos(0.1 * i), std::sin(0.1 * i) * 0.6, 0, std::sin(0.1 * i) * 0.8};
    double least = 1;
    for (int k = 0; k < 3000; ++k) {
      const double angle = 2 * std::acos(-1.0) * k / 3000;
      const abut_pose place = at(0.6 * std::cos(angle), 0.6 * std::sin(angle), 0.5);
      abut_distance distance{};
      ASSERT_TRUE(succeeded(abut_pair_distance(egg, &pose, point, &place, nullptr, &distance)));
      least = std::min(least, distance.distance);
    }
    ASSERT_LT(least, 0) << i;
    EXPECT_LE(deepest(contacts_of(plate, identity, egg, pose)), least + 1e-12) << i;
    EXPECT_GE(deepest(contacts_of(plate, identity, egg, pose)), least - 1e-5) << i;
  }
}

// A rod through the middle of a triangle leaves the triangle sideways sooner than it leaves the surface along itself.
TEST(HolesOfMany, FarAwayChangeNoDistanceToASurface) {
  const abut_pose aside = at(0, 0, -40);
  const Shape ground = make_of_kind("height_field", {5, 4, 1.5, 18}, std::vector<double>(20, 0.0));
  const Shape rod = make_of_kind("segment", {0.9}), ball = make_sphere(0.1), hole = sphere_hole(0.2);
  const Shape whole = make_composite({rod, ball}, {identity, aside});
  const Shape pierced = make_composite({rod, ball, hole}, {identity, aside, aside});
  for (int i = 0; i < 200; ++i) {
    const abut_pose place = at(0.03 * i, 0.25 * i, 0.004 * (i - 150));
    abut_distance expected{}, found{};
    ASSERT_TRUE(succeeded(abut_pair_distance(whole, &place, ground, &identity, nullptr, &expected)));
    ASSERT_TRUE(succeeded(abut_pair_distance(pierced, &place, ground, &identity, nullptr, &found)));
    EXPECT_NEAR(found.distance, expected.distance, 1e-12) << i;
    EXPECT_NEAR(found.normal.x, expected.normal.x, 1e-12) << i;
  }
}

}  // namespace
