// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <set>

#include "../random_boxes.hpp"

import abut.capability;
import abut.math;

namespace {

using abut::ContactPoint;
using abut::Distance;
using abut::Feature;
using abut::FeatureKind;
using abut::Pose;
using abut::Vec3;

// A quarter turn about Z and a step.
constexpr Pose quarter{{{0, 1, 0}, {-1, 0, 0}, {0, 0, 1}}, {10, 20, 30}};

Distance some_distance() {
  Distance found{};
  found.distance = 2;
  found.lower = 1.5;
  found.upper = 2.5;
  found.point_a = {1, 0, 0};
  found.point_b = {3, 0, 0};
  found.normal = {1, 0, 0};
  found.iterations = 4;
  return found;
}

ContactPoint some_contact() {
  return {{1, 0, 0}, {0.5, 0, 0}, {1, 0, 0}, -0.5, {FeatureKind::vertex, 3}, {FeatureKind::face, 5}, 99};
}

TEST(Frames, MoveTakesPointsWholeAndTheNormalTurned) {
  Distance found = some_distance();
  move_by(found, quarter);
  EXPECT_EQ(found.point_a, (Vec3{10, 21, 30}));
  EXPECT_EQ(found.point_b, (Vec3{10, 23, 30}));
  EXPECT_EQ(found.normal, (Vec3{0, 1, 0}));
  EXPECT_EQ(found.distance, 2);
  EXPECT_EQ(found.lower, 1.5);
  EXPECT_EQ(found.upper, 2.5);
  EXPECT_EQ(found.iterations, 4u);
}

TEST(Frames, MoveKeepsTheFeaturesOfAContact) {
  ContactPoint contact = some_contact();
  move_by(contact, quarter);
  EXPECT_EQ(contact.point_b, (Vec3{10, 20.5, 30}));
  EXPECT_EQ(contact.feature_a, (Feature{FeatureKind::vertex, 3}));
  EXPECT_EQ(contact.feature_b, (Feature{FeatureKind::face, 5}));
  EXPECT_EQ(contact.id, 99u);
}

// Swapping a and b swaps points and features and negates the normal; nothing else changes.
TEST(Frames, MoveExchangesTheSides) {
  Distance found = some_distance();
  move_by(found, quarter, true);
  EXPECT_EQ(found.point_a, (Vec3{10, 23, 30}));
  EXPECT_EQ(found.point_b, (Vec3{10, 21, 30}));
  EXPECT_EQ(found.normal, (Vec3{0, -1, 0}));
  EXPECT_EQ(found.distance, dot(found.point_b - found.point_a, found.normal));
  ContactPoint contact = some_contact();
  move_by(contact, quarter, true);
  EXPECT_EQ(contact.feature_a, (Feature{FeatureKind::face, 5}));
  EXPECT_EQ(contact.feature_b, (Feature{FeatureKind::vertex, 3}));
  EXPECT_EQ(contact.distance, -0.5);
  EXPECT_EQ(contact.id, 99u);
}

TEST(Frames, MoveKeepsDistanceAndPointsTogether) {
  test::Random random(251);
  for (int i = 0; i < 300; ++i) {
    Distance found{};
    found.normal = random.rotation().x;
    found.distance = random.uniform(-1, 1);
    found.point_a = random.point(3);
    found.point_b = found.point_a + found.distance * found.normal;
    move_by(found, {random.rotation(), random.point(10)});
    EXPECT_NEAR(dot(found.point_b - found.point_a, found.normal), found.distance, 1e-14);
  }
}

TEST(ContactIds, TellFeaturesAndSidesApart) {
  const Feature vertex{FeatureKind::vertex, 3}, edge{FeatureKind::edge, 3}, other{FeatureKind::vertex, 4};
  const std::uint64_t id = abut::contact_id(vertex, edge);
  EXPECT_EQ(id, abut::contact_id(vertex, edge));
  EXPECT_NE(id, abut::contact_id(edge, vertex));
  EXPECT_NE(id, abut::contact_id(vertex, other));
  EXPECT_NE(id, abut::contact_id(vertex, vertex));
}

// Numbers of features differ in few bits, and so do those of parts.
TEST(ContactIds, OfPartsAreApart) {
  std::set<std::uint64_t> seen;
  std::size_t made = 0;
  for (std::uint32_t a = 0; a < 16; ++a) {
    for (std::uint32_t b = 0; b < 16; ++b) {
      const std::uint64_t id = abut::contact_id({FeatureKind::vertex, a}, {FeatureKind::face, b});
      for (std::uint32_t part = 0; part < 16; ++part, ++made) {
        seen.insert(abut::contact_id_of_part(id, part));
      }
    }
  }
  EXPECT_EQ(seen.size(), made);
}

}  // namespace
