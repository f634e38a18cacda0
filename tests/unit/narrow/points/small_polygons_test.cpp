// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>
#include <span>
#include <vector>

#include "../../random_boxes.hpp"

import abut.capability;
import abut.math;
import abut.narrow.points.clip;
import abut.narrow.points.lift;
import abut.narrow.points.small_polygons;

namespace {

using abut::Face;
using abut::Feature;
using abut::FeatureKind;
using abut::Vec3;

constexpr Vec3 up{0, 0, 1};
constexpr double rounding = 1e-12;

struct Place {
  double x, y;
};
double turn_of(const Place& a, const Place& b, const Place& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

// A polygon seen from above, counter-clockwise, on a plane of given slopes.
struct Sketch {
  std::vector<Place> corners;
  double slope_x, slope_y, height;

  [[nodiscard]] Vec3 at(const Place& p) const { return {p.x, p.y, height + slope_x * p.x + slope_y * p.y}; }
  [[nodiscard]] Face face(bool looks_up) const {
    Face face;
    const double length = std::sqrt(1 + slope_x * slope_x + slope_y * slope_y), sign = looks_up ? 1 : -1;
    face.normal = (sign / length) * Vec3{-slope_x, -slope_y, 1};
    face.index = looks_up ? 50 : 60;
    for (std::uint32_t i = 0; i < corners.size(); ++i) {
      const std::size_t place = looks_up ? i : corners.size() - 1 - i;
      face.vertices.push_back({at(corners[place]), i, 10 + i});
    }
    return face;
  }
};

Sketch random_sketch(std::size_t count, test::Random& random) {
  Sketch sketch{{}, random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5), random.uniform(-1, 1)};
  const Place middle{random.uniform(-1, 1), random.uniform(-1, 1)};
  std::vector<double> angles;
  for (std::size_t i = 0; i < count; ++i) {
    angles.push_back(random.uniform(0, 2 * std::numbers::pi));
  }
  std::ranges::sort(angles);
  for (const double angle : angles) {
    sketch.corners.push_back({middle.x + std::cos(angle), middle.y + std::sin(angle)});
  }
  return sketch;
}

// The corners of what two polygons share, each corner of one inside the other and each crossing of two edges.
std::vector<Place> shared_corners(const std::vector<Place>& a, const std::vector<Place>& b) {
  std::vector<Place> corners;
  const auto add_inside = [&](const std::vector<Place>& from, const std::vector<Place>& in) {
    for (const Place& p : from) {
      bool is_inside = true;
      for (std::size_t i = 0; i < in.size(); ++i) {
        is_inside = is_inside && turn_of(in[i], in[(i + 1) % in.size()], p) > 0;
      }
      if (is_inside) {
        corners.push_back(p);
      }
    }
  };
  add_inside(a, b);
  add_inside(b, a);
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) {
      const Place &p = a[i], &q = a[(i + 1) % a.size()], &r = b[j], &s = b[(j + 1) % b.size()];
      if (turn_of(p, q, r) * turn_of(p, q, s) < 0 && turn_of(r, s, p) * turn_of(r, s, q) < 0) {
        const double t = turn_of(r, s, p) / (turn_of(r, s, p) - turn_of(r, s, q));
        corners.push_back({p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)});
      }
    }
  }
  return corners;
}

abut::Projection projection_of(const Face& face) { return {face.vertices[0].point, abut::tangents_of(up), up, 1e-14}; }

double distance_to_line(const Face& face, std::uint32_t edge, const Vec3& point) {
  const std::size_t i = edge - 10, count = face.vertices.size();
  const Vec3 from = face.vertices[i].point, along = face.vertices[(i + 1) % count].point - from;
  return norm(cross(point - from, along)) / norm(along);
}

// How far a point of a contact is from the feature that it is said to be.
double off_feature(const Face& face, const Feature& feature, const Vec3& point) {
  switch (feature.kind) {
    case FeatureKind::vertex: return norm(point - face.vertices[feature.index].point);
    case FeatureKind::edge: return distance_to_line(face, feature.index, point);
    case FeatureKind::face:
      return feature.index == face.index ? std::fabs(dot(face.normal, point - face.vertices[0].point)) : 1;
    case FeatureKind::whole:
    case FeatureKind::cell:
    case FeatureKind::particle: break;
  }
  return 1;
}

TEST(SmallPolygons, ShareTheCornersThatAreInBoth) {
  test::Random random(3);
  std::size_t found = 0, corners = 0;
  for (int round = 0; round < 4000; ++round) {
    const Sketch a = random_sketch(round % 2 == 0 ? 3 : 4, random), b = random_sketch(round % 3 == 0 ? 3 : 4, random);
    const Face face_a = a.face(true), face_b = b.face(false);
    abut::ClipPoints points;
    if (!clip_small_polygons(few_corners_of(face_a), few_corners_of(face_b), projection_of(face_a), points)) {
      EXPECT_EQ(points.size(), 0u);
      continue;
    }
    ++found;
    std::vector<Place> expected = shared_corners(a.corners, b.corners);
    corners += expected.size();
    ASSERT_EQ(points.size(), expected.size());
    for (const abut::ClipPoint& point : points.span()) {
      const auto nearest = std::ranges::min_element(
          expected, {}, [&](const Place& p) { return std::hypot(p.x - point.point_a.x, p.y - point.point_a.y); });
      EXPECT_LT(norm(point.point_a - a.at(*nearest)), rounding);
      EXPECT_LT(norm(point.point_b - b.at(*nearest)), rounding);
      EXPECT_LT(off_feature(face_a, point.feature_a, point.point_a), rounding);
      EXPECT_LT(off_feature(face_b, point.feature_b, point.point_b), rounding);
      expected.erase(nearest);
    }
  }
  EXPECT_GT(found, 3900u);
  EXPECT_GT(corners, 7000u);
}

TEST(SmallPolygons, LeaveACornerOnAnEdgeOpen) {
  const Sketch a{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}, 0, 0, 0}, b{{{0, 0}, {1, 0.5}, {0, 0.7}}, 0, 0, 1};
  const Face face_a = a.face(true), face_b = b.face(false);
  abut::ClipPoints points;
  EXPECT_FALSE(clip_small_polygons(few_corners_of(face_a), few_corners_of(face_b), projection_of(face_a), points));
  EXPECT_EQ(points.size(), 0u);
}

TEST(SmallPolygons, LeaveAFaceThatIsNotFlatOpen) {
  const Sketch a{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}, 0, 0, 0}, b{{{0, 0}, {0.5, 0}, {0, 0.7}}, 0, 0, 1};
  Face face_a = a.face(true);
  const Face face_b = b.face(false);
  face_a.vertices[2].point.z += 1e-6;
  abut::ClipPoints points;
  EXPECT_FALSE(clip_small_polygons(few_corners_of(face_a), few_corners_of(face_b), projection_of(face_a), points));
}

abut::ContactsWanted wanted_of(const Face& a, const Face& b, double margin) {
  double top = -abut::infinity, bottom = abut::infinity;
  for (const abut::FaceVertex& vertex : a.vertices.span()) {
    top = std::max(top, vertex.point.z);
  }
  for (const abut::FaceVertex& vertex : b.vertices.span()) {
    bottom = std::min(bottom, vertex.point.z);
  }
  return {up, bottom - top, 0, 0, margin, 1e-12, true};
}

// Contacts are the corners of the region: at the same places, with the same features, up to a distance.
TEST(SmallPolygons, HaveContactsAtTheCornersOfTheirRegion) {
  test::Random random(4);
  std::size_t found = 0, without_closest = 0;
  for (int round = 0; round < 4000; ++round) {
    const Face face_a = random_sketch(round % 2 == 0 ? 3 : 4, random).face(true),
               face_b = random_sketch(round % 3 == 0 ? 3 : 4, random).face(false);
    abut::ContactsWanted wanted = wanted_of(face_a, face_b, random.uniform(-1, 1));
    wanted.closest_count = round % 5 == 0;
    wanted.radius_a = random.uniform(0, 0.1);
    wanted.radius_b = random.uniform(0, 0.1);
    abut::ClipPoints points;
    clip_faces(face_a, face_b, up, points, wanted.closest_count);
    abut::Manifold contacts(1);
    const auto least = append_contacts_of(few_corners_of(face_a), few_corners_of(face_b), wanted, contacts);
    if (!least) {
      EXPECT_EQ(contacts.size(), 1u);
      without_closest += wanted.closest_count ? 1 : 0;
      continue;
    }
    ++found;
    std::size_t next = 1;
    double expected_least = abut::infinity;
    for (const abut::ClipPoint& point : points.span()) {
      const double distance = point.point_b.z - point.point_a.z - wanted.radius_a - wanted.radius_b;
      if (distance > wanted.margin) {
        continue;
      }
      expected_least = std::min(expected_least, distance);
      ASSERT_LT(next, contacts.size());
      const abut::ContactPoint& contact = contacts[next++];
      EXPECT_LT(norm(contact.point_a - (point.point_a + wanted.radius_a * up)), rounding);
      EXPECT_LT(norm(contact.point_b - (point.point_b - wanted.radius_b * up)), rounding);
      EXPECT_NEAR(contact.distance, distance, rounding);
      EXPECT_EQ(contact.normal, up);
      EXPECT_EQ(contact.feature_a, point.feature_a);
      EXPECT_EQ(contact.feature_b, point.feature_b);
      EXPECT_EQ(contact.id, contact_id(point.feature_a, point.feature_b));
    }
    EXPECT_EQ(next, contacts.size());
    EXPECT_TRUE(*least == expected_least || std::fabs(*least - expected_least) < rounding);
  }
  EXPECT_GT(found, 3000u);
  EXPECT_GT(without_closest, 100u);
}

TEST(SmallPolygons, LeaveAFaceThatStandsSteepOpen) {
  const Sketch a{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}, 0, 0, 0}, b{{{0, 0}, {0.5, 0}, {0, 0.7}}, 0, 0, 1};
  const Face face_a = a.face(true), face_b = b.face(false);
  abut::Manifold contacts;
  EXPECT_TRUE(append_contacts_of(few_corners_of(face_a), few_corners_of(face_b), wanted_of(face_a, face_b, 2), contacts)
                  .has_value());
  EXPECT_EQ(contacts.size(), 3u);
  abut::FewCorners steep = few_corners_of(face_b);
  steep.normal = {1, 0, 0};
  EXPECT_FALSE(append_contacts_of(few_corners_of(face_a), steep, wanted_of(face_a, face_b, 2), contacts).has_value());
  EXPECT_EQ(contacts.size(), 3u);
}

}  // namespace
