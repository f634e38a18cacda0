// SPDX-License-Identifier: Apache-2.0
// Manifolds of bodies that rest on each other, of which the points are known.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "catalogue.hpp"
#include "manifold.hpp"
#include "shortfall.hpp"

std::span<const property::Shortfall> property::known_shortfalls() { return {}; }

namespace {

using property::contacts_of;
using property::Flat;
using property::Manifold;
using property::Subject;

abut_pose at(double x, double y, double z) { return {{x, y, z}, {1, 0, 0, 0}}; }

abut_pose turned(double x, double y, double z, const abut_vec3& axis, double angle) {
  const double sine = std::sin(angle / 2);
  return {{x, y, z}, {std::cos(angle / 2), axis.x * sine, axis.y * sine, axis.z * sine}};
}

const double pi = std::acos(-1.0);

constexpr double sunk = 1e-3;  // how deep the upper body stands in the lower one

// Each corner has a contact point above or below it, at the depth.
void expect_corners(const Manifold& manifold, const std::vector<Flat>& corners, double depth) {
  ASSERT_EQ(manifold.status, ABUT_OK);
  for (const Flat& corner : corners) {
    const bool found = std::any_of(manifold.contacts.begin(), manifold.contacts.end(), [&](const abut_contact& c) {
      return std::hypot(c.point_a.x - corner[0], c.point_a.y - corner[1]) < 1e-12 &&
             std::abs(c.distance + depth) < 1e-12 && std::abs(c.normal.z) > 1 - 1e-12;
    });
    EXPECT_TRUE(found) << "no contact at " << corner[0] << ", " << corner[1];
  }
}

TEST(Resting, BoxOnBoxTouchesAtTheCornersOfTheOverlap) {
  const Subject lower = property::make_box("lower", 1, 1, 1);
  const Subject upper = property::make_box("upper", 0.5, 0.5, 0.5);
  const Manifold manifold = contacts_of(lower, at(0, 0, 0), upper, at(0.75, 0.25, 1.5 - sunk), 0, 4);
  EXPECT_EQ(manifold.contacts.size(), 4u);
  expect_corners(manifold, {{0.25, -0.25}, {1, -0.25}, {1, 0.75}, {0.25, 0.75}}, sunk);
}

TEST(Resting, TurnedBoxOnBoxTouchesAtTheWholeOverlap) {
  const Subject lower = property::make_box("lower", 1, 1, 1);
  const Subject upper = property::make_box("upper", 1, 1, 1);
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int round = 0; round < 200; ++round) {
    const double angle = uniform(random) * 3;
    const double x = uniform(random);
    const double y = uniform(random);
    const Manifold manifold = contacts_of(lower, at(0, 0, 0), upper, turned(x, y, 2 - sunk, {0, 0, 1}, angle), 0, 0);
    std::vector<Flat> top;
    for (const double corner : {0.25, 0.75, 1.25, 1.75}) {
      const double direction = angle + corner * pi;
      top.push_back({x + std::sqrt(2.0) * std::cos(direction), y + std::sqrt(2.0) * std::sin(direction)});
    }
    const auto polygon = property::overlap(top, {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}});
    SCOPED_TRACE(testing::Message() << "angle " << angle << " at " << x << ", " << y);
    expect_corners(manifold, polygon, sunk);
    EXPECT_NEAR(property::hull_area(property::flattened(manifold.contacts)), property::hull_area(polygon), 1e-11);
    EXPECT_LE(manifold.contacts.size(), 8u);
  }
}

TEST(Resting, CapsuleLyingOnBoxTouchesTwice) {
  const Subject box = property::make_box("box", 2, 2, 1);
  const Subject capsule = property::make_capsule("capsule", 0.25, 1);
  const Manifold manifold =
      contacts_of(box, at(0, 0, 0), capsule, turned(0.5, 0, 1.25 - sunk, {0, 1, 0}, pi / 2), 0, 4);
  EXPECT_EQ(manifold.contacts.size(), 2u);
  expect_corners(manifold, {{-0.5, 0}, {1.5, 0}}, sunk);
}

TEST(Resting, CapsuleAcrossTheRimOfBoxTouchesUpToTheRim) {
  const Subject box = property::make_box("box", 2, 2, 1);
  const Subject capsule = property::make_capsule("capsule", 0.25, 1);
  const Manifold manifold =
      contacts_of(box, at(0, 0, 0), capsule, turned(1.5, 0, 1.25 - sunk, {0, 1, 0}, pi / 2), 0, 4);
  EXPECT_EQ(manifold.contacts.size(), 2u);
  expect_corners(manifold, {{0.5, 0}, {2, 0}}, sunk);
}

TEST(Resting, CapsuleLyingOnPlaneTouchesTwice) {
  const Subject plane = property::make_plane("plane", {0, 0, 1}, 0);
  const Subject capsule = property::make_capsule("capsule", 0.25, 1);
  const Manifold manifold =
      contacts_of(plane, at(0, 0, 0), capsule, turned(0, 0, 0.25 - sunk, {0, 1, 0}, pi / 2), 0, 4);
  EXPECT_EQ(manifold.contacts.size(), 2u);
  expect_corners(manifold, {{-1, 0}, {1, 0}}, sunk);
}

TEST(Resting, CapsuleStandingOnPlaneTouchesOnce) {
  const Subject plane = property::make_plane("plane", {0, 0, 1}, 0);
  const Subject capsule = property::make_capsule("capsule", 0.25, 1);
  const Manifold manifold = contacts_of(plane, at(0, 0, 0), capsule, at(3, 4, 1.25 - sunk), 0, 4);
  EXPECT_EQ(manifold.contacts.size(), 1u);
  expect_corners(manifold, {{3, 4}}, sunk);
}

TEST(Resting, ParallelCapsulesTouchAlongTheSharedLength) {
  const Subject capsule = property::make_capsule("capsule", 0.25, 1);
  const abut_pose lower = turned(0, 0, 0, {0, 1, 0}, pi / 2);
  const Manifold manifold = contacts_of(capsule, lower, capsule, turned(0.5, 0, 0.5 - sunk, {0, 1, 0}, pi / 2), 0, 4);
  EXPECT_EQ(manifold.contacts.size(), 2u);
  expect_corners(manifold, {{-0.5, 0}, {1, 0}}, sunk);
}

TEST(Resting, BoxOnPlaneTouchesWithFourCorners) {
  const Subject plane = property::make_plane("plane", {0, 0, 1}, 0);
  const Subject box = property::make_box("box", 1, 0.5, 0.25);
  const Manifold manifold = contacts_of(plane, at(0, 0, 0), box, at(0, 0, 0.25 - sunk), 0, 4);
  EXPECT_EQ(manifold.contacts.size(), 4u);
  expect_corners(manifold, {{-1, -0.5}, {1, -0.5}, {1, 0.5}, {-1, 0.5}}, sunk);
}

TEST(Resting, HexagonOnPlaneKeepsSixPointsOrFour) {
  std::vector<oracle::Point> points;
  std::vector<Flat> corners;
  for (int i = 0; i < 6; ++i) {
    corners.push_back({std::cos(i * pi / 3), std::sin(i * pi / 3)});
    for (const double z : {-0.5, 0.5}) points.push_back({corners.back()[0], corners.back()[1], z});
  }
  const Subject plane = property::make_plane("plane", {0, 0, 1}, 0);
  const Subject prism = property::make_hull("prism", points);
  const Manifold all = contacts_of(plane, at(0, 0, 0), prism, at(0, 0, 0.5 - sunk), 0, 0);
  EXPECT_EQ(all.contacts.size(), 6u);
  expect_corners(all, corners, sunk);
  EXPECT_EQ(contacts_of(plane, at(0, 0, 0), prism, at(0, 0, 0.5 - sunk), 0, 4).contacts.size(), 4u);
}

TEST(Resting, SphereTouchesOnce) {
  const Subject sphere = property::make_sphere("sphere", 0.5);
  const Subject box = property::make_box("box", 1, 1, 1);
  const Subject plane = property::make_plane("plane", {0, 0, 1}, 1);
  const Subject hull = property::make_hull("hull", {{-2, -2, 1}, {2, -2, 1}, {0, 2, 1}, {0, 0, -3}});
  const Subject capsule = property::make_capsule("capsule", 1, 0);
  for (const Subject* other : {&box, &plane, &hull, &capsule}) {
    const Manifold manifold = contacts_of(*other, at(0, 0, 0), sphere, at(0, 0, 1.5 - sunk), 0, 0);
    EXPECT_EQ(manifold.contacts.size(), 1u) << other->kind;
    expect_corners(manifold, {{0, 0}}, sunk);
  }
}

TEST(Resting, CrossedEdgesTouchOnce) {
  const Subject box = property::make_box("box", 1, 1, 1);
  const double high = 2 * std::sqrt(2.0) - sunk;
  const Manifold manifold =
      contacts_of(box, turned(0, 0, 0, {0, 1, 0}, pi / 4), box, turned(0.25, 0.5, high, {1, 0, 0}, pi / 4), 0, 0);
  EXPECT_EQ(manifold.contacts.size(), 1u);
  expect_corners(manifold, {{0, 0.5}}, sunk);
}

TEST(Resting, NothingIsWrittenPastTheCapacity) {
  const Subject box = property::make_box("box", 1, 1, 1);
  const abut_pose lower = at(0, 0, 0);
  const abut_pose upper = at(0, 0, 2 - sunk);
  std::vector<abut_contact> contacts(4);
  for (abut_contact& contact : contacts) contact.distance = 77;
  std::size_t count = 0;
  ASSERT_EQ(abut_pair_contacts(box.shape.get(), &lower, box.shape.get(), &upper, nullptr, contacts.data(), 2, &count),
            ABUT_OK);
  EXPECT_EQ(count, 4u);
  EXPECT_NE(contacts[1].distance, 77);
  EXPECT_EQ(contacts[2].distance, 77);
  EXPECT_EQ(contacts[3].distance, 77);
}

oracle::Soup flat_sheet(int cells, double size) {
  oracle::Soup soup;
  for (int j = 0; j <= cells; ++j) {
    for (int i = 0; i <= cells; ++i)
      soup.points.push_back({i * size - cells * size / 2, j * size - cells * size / 2, 0});
  }
  const auto side = static_cast<std::uint32_t>(cells) + 1;
  for (std::uint32_t j = 0; j + 1 < side; ++j) {
    for (std::uint32_t i = 0; i + 1 < side; ++i) {
      const std::uint32_t corner = j * side + i;
      soup.triangles.push_back({corner, corner + 1, corner + side + 1});
      soup.triangles.push_back({corner, corner + side + 1, corner + side});
    }
  }
  return soup;
}

// Inner edges of a flat surface must not tilt the normal, wherever a body stands.
TEST(Resting, FlatSurfacesPushStraightUp) {
  const Subject mesh = property::make_mesh("sheet", flat_sheet(8, 0.5));
  const Subject field = property::make_height_field("field", {9, 9, 0.5, 0.5, std::vector<double>(81, 0.0)});
  const Subject sphere = property::make_sphere("sphere", 0.3);
  const Subject box = property::make_box("box", 0.4, 0.3, 0.3);
  const Subject capsule = property::make_capsule("capsule", 0.3, 0);
  std::mt19937_64 random(17);
  std::uniform_real_distribution<double> uniform(-0.9, 0.9);
  for (int round = 0; round < 100; ++round) {
    const double x = round == 0 ? 0 : uniform(random);
    const double y = round == 0 ? 0 : uniform(random);
    for (const Subject* body : {&sphere, &box, &capsule}) {
      for (const Subject* ground : {&mesh, &field}) {
        const double middle = ground == &field ? 2 : 0;
        const abut_pose pose =
            turned(x + middle, y + middle, 0.3 - sunk, {0, 0, 1}, body == &box ? uniform(random) : 0);
        const Manifold manifold = contacts_of(*ground, at(0, 0, 0), *body, pose, 0, 0);
        ASSERT_EQ(manifold.status, ABUT_OK);
        EXPECT_FALSE(manifold.contacts.empty()) << body->kind << " on " << ground->kind;
        for (const abut_contact& contact : manifold.contacts) {
          EXPECT_NEAR(contact.normal.z, 1, 1e-9) << body->kind << " on " << ground->kind << " at " << x << ", " << y;
          EXPECT_NEAR(contact.distance, -sunk, 1e-9)
              << body->kind << " on " << ground->kind << " at " << x << ", " << y;
        }
        if (body != &box) continue;
        EXPECT_NEAR(property::hull_area(property::flattened(manifold.contacts)), 0.48, 1e-9)
            << ground->kind << " at " << x << ", " << y;
      }
    }
  }
}

}  // namespace
