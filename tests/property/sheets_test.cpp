// SPDX-License-Identifier: Apache-2.0
// What sheets (meshes and height fields) owe to those that meet them, in scenes that once went wrong.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "manifold.hpp"
#include "shortfall.hpp"

std::span<const property::Shortfall> property::known_shortfalls() { return {}; }

namespace {

using property::Manifold;
using property::ShapePtr;

abut_pose at(double x, double y, double z) { return {{x, y, z}, {1, 0, 0, 0}}; }

ShapePtr mesh(const std::vector<double>& xyz, const std::vector<std::uint32_t>& triangles, abut_sides sides) {
  abut_mesh_options options;
  abut_mesh_options_init(&options, sizeof options);
  options.sides = sides;
  abut_shape* shape = nullptr;
  EXPECT_EQ(abut_mesh_create(xyz.data(), xyz.size() / 3, triangles.data(), triangles.size() / 3, &options, &shape),
            ABUT_OK);
  return ShapePtr(shape);
}

ShapePtr square(abut_sides sides) { return mesh({-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0}, {0, 1, 2, 0, 2, 3}, sides); }

ShapePtr box(double half) {
  abut_shape* shape = nullptr;
  EXPECT_EQ(abut_box_create(half, half, half, &shape), ABUT_OK);
  return ShapePtr(shape);
}

ShapePtr sphere(double radius) {
  abut_shape* shape = nullptr;
  EXPECT_EQ(abut_sphere_create(radius, &shape), ABUT_OK);
  return ShapePtr(shape);
}

std::vector<abut_contact> contacts(const ShapePtr& a, const abut_pose& pose_a, const ShapePtr& b,
                                   const abut_pose& pose_b) {
  abut_query_options options;
  abut_query_options_init(&options, sizeof options);
  options.max_contacts = 0;
  std::vector<abut_contact> found(1000);
  std::size_t count = 0;
  EXPECT_EQ(abut_pair_contacts(a.get(), &pose_a, b.get(), &pose_b, &options, found.data(), found.size(), &count),
            ABUT_OK);
  found.resize(count);
  return found;
}

double distance(const ShapePtr& a, const abut_pose& pose_a, const ShapePtr& b, const abut_pose& pose_b) {
  abut_distance result{};
  EXPECT_EQ(abut_pair_distance(a.get(), &pose_a, b.get(), &pose_b, nullptr, &result), ABUT_OK);
  return result.distance;
}

double apart(const abut_vec3& u, const abut_vec3& v) { return std::hypot(u.x - v.x, u.y - v.y, u.z - v.z); }

bool is_among(const abut_contact& contact, const std::vector<abut_contact>& others) {
  return std::any_of(others.begin(), others.end(), [&](const abut_contact& other) {
    return apart(contact.point_a, other.point_b) < 1e-12 && apart(contact.point_b, other.point_a) < 1e-12 &&
           std::abs(contact.distance - other.distance) < 1e-12;
  });
}

TEST(Sheets, DistanceDependsOnTheSidesWhereAFrontPushesTheOtherWay) {
  const ShapePtr both = square(ABUT_SIDES_BOTH), front = square(ABUT_SIDES_FRONT), body = box(0.5);
  for (const double z : {-0.75, -0.5, -0.25, -0.01, 0.0, 0.25, 0.5, 0.75}) {
    const double of_both = distance(both, at(0, 0, 0), body, at(0.1, 0.2, z));
    const double of_front = distance(front, at(0, 0, 0), body, at(0.1, 0.2, z));
    const bool is_pushed_from_behind = z > -0.5 && z < 0;
    EXPECT_NEAR(of_both, std::abs(z) - 0.5, 1e-12);
    EXPECT_NEAR(of_front, is_pushed_from_behind ? z - 0.5 : std::abs(z) - 0.5, 1e-12);
  }
}

TEST(Sheets, CrossingSheetsMirrorTheirContactsWhenSwapped) {
  const abut_pose upright{{0.3, 0.1, 0.9}, {std::sqrt(0.5), std::sqrt(0.5), 0, 0}};
  const abut_pose tilted{{0.3, 0.1, 0.4}, {0.9, 0.3, 0.1, 0.3}};
  for (const abut_sides sides : {ABUT_SIDES_BOTH, ABUT_SIDES_FRONT}) {
    const ShapePtr first = square(ABUT_SIDES_BOTH), second = square(sides);
    for (const abut_pose& pose : {upright, tilted}) {
      const auto there = contacts(first, at(0, 0, 0), second, pose);
      const auto back = contacts(second, pose, first, at(0, 0, 0));
      EXPECT_FALSE(there.empty());
      EXPECT_EQ(there.size(), back.size());
      for (const abut_contact& contact : there) EXPECT_TRUE(is_among(contact, back));
    }
  }
}

TEST(Sheets, FrontOnlyPushesForward) {
  const ShapePtr field = square(ABUT_SIDES_FRONT), body = box(0.5);
  const auto found = contacts(field, at(0, 0, 0), body, at(0.1, 0.2, -0.1));
  EXPECT_FALSE(found.empty());
  for (const abut_contact& contact : found) EXPECT_GT(contact.normal.z, 0.99);
}

// The repeated triangle lies back on the first one across each of its edges, which stay rims.
TEST(Sheets, RepeatedTriangleIsTouchedAtItsRim) {
  const ShapePtr twice = mesh({0, 0, 0, 1, 0, 0, 0, 1, 0}, {0, 1, 2, 0, 1, 2}, ABUT_SIDES_BOTH);
  const auto found = contacts(twice, at(0, 0, 0), sphere(0.5), at(-0.3, 0.3, 0.3));
  ASSERT_FALSE(found.empty());
  EXPECT_NEAR(found.front().distance, std::hypot(0.3, 0.3) - 0.5, 1e-12);
  EXPECT_NEAR(found.front().normal.x, -std::sqrt(0.5), 1e-12);
}

// A box edge held along the edge of a sheet: the deepest points are on both.
TEST(Sheets, PointsLieOnTheSheetWhenABoxPushesItSideways) {
  const ShapePtr sheet = square(ABUT_SIDES_BOTH), body = box(0.5);
  const auto found = contacts(sheet, at(0, 0, 0), body, at(1.4, 0.2, 0.1));
  ASSERT_FALSE(found.empty());
  for (const abut_contact& contact : found) {
    EXPECT_LE(std::abs(contact.point_a.x), 1 + 1e-12);
    EXPECT_LE(std::abs(contact.point_a.y), 1 + 1e-12);
    EXPECT_NEAR(contact.point_a.z, 0, 1e-12);
    EXPECT_NEAR(apart(contact.point_a, contact.point_b), std::abs(contact.distance), 1e-12);
  }
  EXPECT_NEAR(found.front().distance, -0.1, 1e-12);
}

// Found by the box, whose corner is 0.1 over the rim, in a mesh of two triangles: the one that it meets at its tip only
// has no way of its own out, and must not push it through the sheet.
TEST(Sheets, BoxOverTheRimIsPushedOffTheRim) {
  const ShapePtr body = box(1);
  for (const abut_sides sides : {ABUT_SIDES_BOTH, ABUT_SIDES_FRONT}) {
    const ShapePtr sheet = square(sides);
    for (const double y : {-1.9, -1.0, -0.3, 0.0, 0.4, 1.05, 1.5, 1.85}) {
      for (const double z : {-0.3, 0.07, 0.5}) {
        const auto found = contacts(sheet, at(0, 0, 0), body, at(1.9, y, z));
        ASSERT_FALSE(found.empty()) << y << " " << z;
        EXPECT_NEAR(found.front().distance, -std::min({0.1, 2 - std::abs(y), 1 - z}), 1e-12) << y << " " << z;
      }
    }
  }
}

ShapePtr cube(abut_sides sides) {
  return mesh(
      {-1, -1, -1, 1, -1, -1, 1, 1, -1, -1, 1, -1, -1, -1, 1, 1, -1, 1, 1, 1, 1, -1, 1, 1},
      {0, 2, 1, 0, 3, 2, 4, 5, 6, 4, 6, 7, 0, 1, 5, 0, 5, 4, 2, 3, 7, 2, 7, 6, 1, 2, 6, 1, 6, 5, 3, 0, 4, 3, 4, 7},
      sides);
}

TEST(Sheets, CubesThatOverlapAreParted) {
  for (const abut_sides sides : {ABUT_SIDES_BOTH, ABUT_SIDES_FRONT}) {
    const ShapePtr first = cube(sides), second = cube(sides);
    for (const double y : {0.13, 0.4, -0.7, 1.2}) {
      for (const double z : {0.13, -0.31, 0.9}) {
        const auto found = contacts(first, at(0, 0, 0), second, at(1.9, y, z));
        ASSERT_FALSE(found.empty());
        EXPECT_NEAR(found.front().distance, -0.1, 1e-12) << y << " " << z;
      }
    }
  }
}

// A ridge of a millionth along the middle.
TEST(Sheets, RidgeOfAMillionthTurnsNoNormal) {
  const std::vector<double> xyz{-1, -1, 0, 0, -1, 1e-6, 1, -1, 0, -1, 1, 0, 0, 1, 1e-6, 1, 1, 0};
  for (const abut_sides sides : {ABUT_SIDES_BOTH, ABUT_SIDES_FRONT}) {
    const ShapePtr ridge = mesh(xyz, {0, 1, 4, 0, 4, 3, 1, 2, 5, 1, 5, 4}, sides);
    const auto of_box = contacts(ridge, at(0, 0, 0), box(0.5), at(0.4995, 0, 0.499));
    const auto of_sphere = contacts(ridge, at(0, 0, 0), sphere(0.4), at(0.02, 0.1, 0.399));
    EXPECT_GE(of_box.size(), 4u);
    EXPECT_EQ(of_sphere.size(), 1u);
    for (const auto* found : {&of_box, &of_sphere}) {
      for (const abut_contact& contact : *found) EXPECT_GT(contact.normal.z, 1 - 1e-11);
    }
  }
}

TEST(Sheets, RidgeOfABillionthInAHeightFieldTurnsNoNormal) {
  const std::vector<double> heights{0, 1e-9, 0, 0, 1e-9, 0};
  abut_height_field_desc desc;
  abut_height_field_desc_init(&desc, sizeof desc);
  desc.columns = 3;
  desc.rows = 2;
  desc.spacing_x = 1;
  desc.spacing_y = 2;
  desc.heights = heights.data();
  abut_shape* shape = nullptr;
  ASSERT_EQ(abut_height_field_create(&desc, &shape), ABUT_OK);
  const ShapePtr field(shape);
  const auto found = contacts(field, at(0, 0, 0), sphere(0.4), at(1.02, 1.1, 0.399));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_GT(found.front().normal.z, 1 - 1e-11);
}

// Over the top of a box, near its side: the side wall is further away than the top, and has no contact.
TEST(Sheets, BallSunkInABoxIsPushedByTheTopAlone) {
  for (const abut_sides sides : {ABUT_SIDES_BOTH, ABUT_SIDES_FRONT}) {
    const ShapePtr body = cube(sides);
    for (const double sunk : {0.01, 0.042, 0.05, 0.1, 0.2}) {
      for (const double aside : {0.1, 0.2, 0.25}) {
        const auto found = contacts(body, at(0, 0, 0), sphere(0.3), at(1 - aside, 0.2, 1.3 - sunk));
        ASSERT_FALSE(found.empty());
        for (const abut_contact& contact : found) {
          EXPECT_GT(contact.normal.z, 1 - 1e-12) << sunk << " " << aside;
          EXPECT_NEAR(contact.distance, -sunk, 1e-12);
        }
      }
    }
  }
}

// A way goes on through as many sheets as there are.
TEST(Sheets, ManyInARowAreAllLeft) {
  constexpr int sheets = 151;
  constexpr double gap = 0.8, wide = 1000;
  std::vector<double> xyz;
  std::vector<std::uint32_t> triangles;
  for (int i = 0; i < sheets; ++i) {
    const double z = gap * (i - sheets / 2);
    const auto first = static_cast<std::uint32_t>(4 * i);
    for (const double y : {-wide, wide}) {
      xyz.insert(xyz.end(), {-wide, y, z, wide, y, z});
    }
    for (const std::uint32_t step : {0u, 1u, 3u, 0u, 3u, 2u}) {
      triangles.push_back(first + step);
    }
  }
  const ShapePtr stack = mesh(xyz, triangles, ABUT_SIDES_BOTH);
  EXPECT_NEAR(distance(stack, at(0, 0, 0), sphere(0.5), at(0, 0, 0.1)), -(gap * (sheets / 2) + 0.4), 1e-9);
  EXPECT_NEAR(distance(stack, at(0, 0, 0), box(0.5), at(0, 0, 0.1)), -(gap * (sheets / 2) + 0.4), 1e-9);
}

}  // namespace
