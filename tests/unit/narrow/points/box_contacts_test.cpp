// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <tuple>
#include <vector>

#include "../../made.hpp"
#include "../../random_boxes.hpp"

import abut.capability;
import abut.math;
import abut.narrow.fan.box_sat;
import abut.narrow.fan.sat;
import abut.narrow.points.box_contacts;
import abut.narrow.points.clip;
import abut.shapes.box;

namespace {

using abut::ContactPoint;
using abut::Feature;
using abut::FeatureKind;
using abut::Pose;
using abut::Vec3;

constexpr double size = 8;  // of the coordinates of all boxes below

// The corners of the region of two boxes under the axis along which they overlap least; none where there is doubt.
std::vector<ContactPoint> region_of(const Vec3& half_a, const Vec3& half_b, const Pose& ab, double margin) {
  const abut::SatResult axis = abut::sat_of_boxes(half_a, half_b, ab, 1e-14, abut::infinity);
  std::vector<ContactPoint> contacts;
  abut::BoxRegion region;
  if (abut::clip_boxes(half_a, half_b, ab, axis.normal, axis.separation, margin, size, region)) {
    abut::contacts_of_region(region, axis.normal, 0, 0,
                             [&](const ContactPoint& contact) { contacts.push_back(contact); });
  }
  return contacts;
}

// Whether a point of a box lies on a feature, from the numbering that box.cppm documents.
bool is_on(const Vec3& half, const Feature& feature, const Vec3& p) {
  const auto is_at = [&](int axis, bool upper) {
    return std::fabs(p[axis] - (upper ? half[axis] : -half[axis])) < 1e-13;
  };
  const std::uint32_t index = feature.index;
  if (feature.kind == FeatureKind::vertex) {
    return is_at(0, index & 1) && is_at(1, index & 2) && is_at(2, index & 4);
  }
  if (feature.kind == FeatureKind::edge) {
    const int along = static_cast<int>(index / 4);
    return is_at(along == 0 ? 1 : 0, index & 1) && is_at(along == 2 ? 1 : 2, index & 2);
  }
  return feature.kind == FeatureKind::face && is_at(static_cast<int>(index / 2), index & 1);
}

void expect_on_features(const Vec3& half_a, const Vec3& half_b, const Pose& ab, const ContactPoint& contact) {
  const Vec3 local = ab.undo(contact.point_b);
  EXPECT_TRUE(is_on(half_a, contact.feature_a, contact.point_a));
  EXPECT_TRUE(is_on(half_b, contact.feature_b, local));
  EXPECT_TRUE(test::is_inside(half_a, contact.point_a, 1e-13));
  EXPECT_TRUE(test::is_inside(half_b, local, 1e-13));
  EXPECT_LE(abut::norm(contact.point_b - contact.point_a - contact.distance * contact.normal), 1e-14);
  EXPECT_EQ(contact.id, abut::contact_id(contact.feature_a, contact.feature_b));
}

std::tuple<FeatureKind, std::uint32_t, FeatureKind, std::uint32_t> name_of(const Feature& a, const Feature& b) {
  return {a.kind, a.index, b.kind, b.index};
}

// Cutting edge by edge finds the same corners.
TEST(BoxContacts, RandomBoxesHaveTheCornersOfTheirClippedFaces) {
  test::Random random(61);
  std::size_t overlapping = 0, found = 0, compared = 0;
  for (int i = 0; i < 6000; ++i) {
    const Vec3 half_a = abut::absolute(random.point(1)), half_b = abut::absolute(random.point(1));
    const Pose ab{random.rotation(), random.point(1.2)};
    const abut::SatResult axis = abut::sat_of_boxes(half_a, half_b, ab, 1e-14, abut::infinity);
    if (axis.separation > -1e-3) {
      continue;
    }
    ++overlapping;
    const std::vector<ContactPoint> contacts = region_of(half_a, half_b, ab, abut::infinity);
    found += contacts.empty() ? 0 : 1;
    const auto box_a = test::made<abut::Box>({half_a.x, half_a.y, half_a.z});
    const auto box_b = test::made<abut::Box>({half_b.x, half_b.y, half_b.z});
    abut::ClipPoints clipped;
    abut::clip_faces(box_a.supporting_face(axis.normal), abut::placed_face(box_b, ab, -axis.normal), axis.normal,
                     clipped);
    // What cutting loses to rounding comes back as the closest points of both faces, without a corner's name.
    const bool is_whole = std::ranges::none_of(clipped.span(), [](const abut::ClipPoint& point) {
      return point.feature_a.kind == FeatureKind::face && point.feature_b.kind == FeatureKind::face;
    });
    for (const ContactPoint& contact : contacts) {
      expect_on_features(half_a, half_b, ab, contact);
      if (is_whole) {
        const auto same = std::ranges::find_if(clipped.span(), [&](const abut::ClipPoint& point) {
          return name_of(point.feature_a, point.feature_b) == name_of(contact.feature_a, contact.feature_b);
        });
        ASSERT_NE(same, clipped.span().end()) << i;
        EXPECT_LE(abut::norm(same->point_a - contact.point_a), 1e-10);
        EXPECT_LE(abut::norm(same->point_b - contact.point_b), 1e-10);
      }
    }
    if (is_whole && !contacts.empty()) {
      ++compared;
      EXPECT_EQ(contacts.size(), clipped.size()) << i;
    }
  }
  EXPECT_GT(overlapping, 2000u);
  EXPECT_GT(static_cast<double>(found), 0.85 * static_cast<double>(overlapping));
  EXPECT_GT(static_cast<double>(compared), 0.95 * static_cast<double>(found));
}

// The deepest corner is as deep as the boxes overlap.
TEST(BoxContacts, TheDeepestCornerIsTheSeparation) {
  test::Random random(62);
  for (int i = 0; i < 2000; ++i) {
    const Vec3 half_a = abut::absolute(random.point(1)), half_b = abut::absolute(random.point(1));
    const Pose ab{random.rotation(), random.point(1)};
    double deepest = abut::infinity;
    for (const ContactPoint& contact : region_of(half_a, half_b, ab, abut::infinity)) {
      deepest = std::fmin(deepest, contact.distance);
    }
    if (deepest < abut::infinity) {
      EXPECT_NEAR(deepest, abut::sat_of_boxes(half_a, half_b, ab, 1e-14, abut::infinity).separation, 1e-14);
    }
  }
}

std::size_t count_of(const std::vector<ContactPoint>& contacts, FeatureKind a, FeatureKind b) {
  return static_cast<std::size_t>(std::ranges::count_if(contacts, [&](const ContactPoint& contact) {
    return contact.feature_a.kind == a && contact.feature_b.kind == b;
  }));
}

// Every face of a meets every face of b, turned about it by right angles.
TEST(BoxContacts, StacksInAllDirections) {
  const Vec3 half{1, 1, 1};
  const double root = std::numbers::sqrt2 / 2;
  const std::array<abut::Quat, 7> turns{abut::Quat{1, 0, 0, 0}, {root, root, 0, 0}, {root, 0, root, 0},
                                        {root, 0, 0, root},     {0, 1, 0, 0},       {0, 0, 1, 0},
                                        {0.5, 0.5, 0.5, 0.5}};
  for (const abut::Quat& turn : turns) {
    const abut::Rotation rotation = abut::Rotation::from(turn);
    for (const Vec3& way : {Vec3{1.9, 0, 0}, {-1.9, 0, 0}, {0, 1.9, 0}, {0, -1.9, 0}, {0, 0, 1.9}, {0, 0, -1.9}}) {
      // Equal faces: the corners of b count, which lie on those of a. A smaller and a larger box.
      for (const auto& [half_b, vertices_of_a] : {std::tuple<double, std::size_t>{1, 0}, {0.5, 0}, {2, 4}}) {
        const Vec3 size_b{half_b, half_b, half_b};
        const Pose ab{rotation, ((0.9 + half_b) / 1.9) * way};
        const std::vector<ContactPoint> contacts = region_of(half, size_b, ab, 0);
        ASSERT_EQ(contacts.size(), 4u);
        EXPECT_EQ(count_of(contacts, FeatureKind::vertex, FeatureKind::face), vertices_of_a);
        EXPECT_EQ(count_of(contacts, FeatureKind::face, FeatureKind::vertex), 4 - vertices_of_a);
        for (const ContactPoint& contact : contacts) {
          expect_on_features(half, size_b, ab, contact);
          EXPECT_NEAR(contact.distance, -0.1, 1e-15);
        }
      }
    }
  }
}

TEST(BoxContacts, StaggeredBricksShareARectangleOfEveryKindOfCorner) {
  const Pose ab{abut::Rotation::identity(), {1.5, 0.5, 1.9}};
  const std::vector<ContactPoint> contacts = region_of({2, 1, 1}, {2, 1, 1}, ab, 0);
  ASSERT_EQ(contacts.size(), 4u);
  EXPECT_EQ(count_of(contacts, FeatureKind::vertex, FeatureKind::face), 1u);
  EXPECT_EQ(count_of(contacts, FeatureKind::face, FeatureKind::vertex), 1u);
  EXPECT_EQ(count_of(contacts, FeatureKind::edge, FeatureKind::edge), 2u);
  for (const ContactPoint& contact : contacts) {
    expect_on_features({2, 1, 1}, {2, 1, 1}, ab, contact);
    EXPECT_TRUE(contact.point_a.x == -0.5 || contact.point_a.x == 2);
    EXPECT_TRUE(contact.point_a.y == -0.5 || contact.point_a.y == 1);
  }
}

// A box that is tilted about one axis: its lower edge is deeper than its upper one.
TEST(BoxContacts, OnlyCornersWithinTheMargin) {
  const double tilt = 0.1, c = std::cos(tilt), s = std::sin(tilt);
  const Pose ab{abut::Rotation::from({std::cos(tilt / 2), std::sin(tilt / 2), 0, 0}), {0, 0, 1 + c + s - 0.05}};
  const Vec3 small{0.5, 1, 1};
  EXPECT_EQ(region_of({3, 3, 1}, small, ab, 0).size(), 2u);
  EXPECT_EQ(region_of({3, 3, 1}, small, ab, 1).size(), 4u);
  for (const ContactPoint& contact : region_of({3, 3, 1}, small, ab, 0)) {
    EXPECT_NEAR(contact.distance, -0.05, 1e-14);
  }
}

TEST(BoxContacts, TheMarginLeavesOutCornersOfRandomBoxes) {
  test::Random random(63);
  std::size_t left_out = 0;
  for (int i = 0; i < 2000; ++i) {
    const Vec3 half_a = abut::absolute(random.point(1)), half_b = abut::absolute(random.point(1));
    const Pose ab{random.rotation(), random.point(1)};
    const std::vector<ContactPoint> all = region_of(half_a, half_b, ab, abut::infinity);
    const std::vector<ContactPoint> within = region_of(half_a, half_b, ab, 0);
    EXPECT_EQ(static_cast<std::ptrdiff_t>(within.size()),
              std::ranges::count_if(all, [](const ContactPoint& contact) { return contact.distance <= 0; }));
    left_out += all.size() - within.size();
  }
  EXPECT_GT(left_out, 500u);
}

// Corners of b on edges of a, and faces that only meet along a line, are left to others.
TEST(BoxContacts, NothingWhereThereIsDoubt) {
  const abut::Rotation eighth =
      abut::Rotation::from({std::cos(std::numbers::pi / 8), 0, 0, std::sin(std::numbers::pi / 8)});
  const double side = std::numbers::sqrt2 / 2;
  EXPECT_TRUE(region_of({1, 1, 1}, {side, side, 1}, {eighth, {0, 0, 1.9}}, 0).empty());
  EXPECT_EQ(region_of({1, 1, 1}, {side + 1e-9, side + 1e-9, 1}, {eighth, {0, 0, 1.9}}, 0).size(), 8u);
  EXPECT_EQ(region_of({1, 1, 1}, {side - 1e-9, side - 1e-9, 1}, {eighth, {0, 0, 1.9}}, 0).size(), 4u);
  EXPECT_TRUE(region_of({1, 1, 1}, {1, 1, 1}, {abut::Rotation::identity(), {2, 0, 2}}, 0).empty());
  EXPECT_TRUE(region_of({1, 1, 0}, {0, 1, 1}, {eighth, {0, 0, 0.9}}, 0).empty());
}

// Radii move the points off the cores and the distance with them.
TEST(BoxContacts, RoundedBoxes) {
  const Pose ab{abut::Rotation::identity(), {0.25, 0.5, 1.9}};
  const abut::SatResult axis = abut::sat_of_boxes({1, 1, 1}, {1, 1, 1}, ab, 0, abut::infinity);
  abut::BoxRegion region;
  ASSERT_TRUE(abut::clip_boxes({1, 1, 1}, {1, 1, 1}, ab, axis.normal, axis.separation, 1, size, region));
  EXPECT_EQ(std::popcount(region.corners), 4);
  abut::contacts_of_region(region, axis.normal, 0.25, 0.5, [](const ContactPoint& contact) {
    EXPECT_NEAR(contact.distance, -0.85, 1e-15);
    EXPECT_NEAR(contact.point_a.z, 1.25, 1e-15);
    EXPECT_NEAR(contact.point_b.z, 0.4, 1e-15);
  });
}

}  // namespace
