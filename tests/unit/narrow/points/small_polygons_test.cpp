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
using abut::FewCorners;
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

const Sketch square{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}, 0, 0, 0};
const Sketch triangle_within{{{0, 0}, {0.5, 0}, {0, 0.7}}, 0, 0, 1};

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
  const Sketch b{{{0, 0}, {1, 0.5}, {0, 0.7}}, 0, 0, 1};
  const Face face_a = square.face(true), face_b = b.face(false);
  abut::ClipPoints points;
  EXPECT_FALSE(clip_small_polygons(few_corners_of(face_a), few_corners_of(face_b), projection_of(face_a), points));
  EXPECT_EQ(points.size(), 0u);
}

TEST(SmallPolygons, LeaveAFaceThatIsNotFlatOpen) {
  Face face_a = square.face(true);
  const Face face_b = triangle_within.face(false);
  face_a.vertices[2].point.z += 1e-6;
  abut::ClipPoints points;
  EXPECT_FALSE(clip_small_polygons(few_corners_of(face_a), few_corners_of(face_b), projection_of(face_a), points));
}

double highest_of(const Sketch& sketch) {
  double top = -abut::infinity;
  for (const Place& corner : sketch.corners) {
    top = std::max(top, sketch.at(corner).z);
  }
  return top;
}
double lowest_of(const Sketch& sketch) {
  double bottom = abut::infinity;
  for (const Place& corner : sketch.corners) {
    bottom = std::min(bottom, sketch.at(corner).z);
  }
  return bottom;
}
abut::ContactsWanted wanted_of(const Sketch& a, const Sketch& b, double margin) {
  return {up, lowest_of(b) - highest_of(a), 0, 0, margin, 1e-12, true};
}

// Contacts are at the corners that both share, up to a distance. Where the closest points are wanted, and no corner is
// as close, there are none.
TEST(SmallPolygons, HaveContactsAtTheCornersOfTheirRegion) {
  test::Random random(4);
  std::size_t found = 0, without_closest = 0, in_doubt = 0;
  for (int round = 0; round < 4000; ++round) {
    const Sketch a = random_sketch(round % 2 == 0 ? 3 : 4, random), b = random_sketch(round % 3 == 0 ? 3 : 4, random);
    const Face face_a = a.face(true), face_b = b.face(false);
    abut::ContactsWanted wanted = wanted_of(a, b, random.uniform(-1, 1));
    wanted.closest_count = round % 5 == 0;
    wanted.radius_a = random.uniform(0, 0.1);
    wanted.radius_b = random.uniform(0, 0.1);
    wanted.deepest -= wanted.radius_a + wanted.radius_b;
    const double radii = wanted.radius_a + wanted.radius_b;
    std::vector<Place> expected;
    double least = abut::infinity;
    for (const Place& place : shared_corners(a.corners, b.corners)) {
      if (const double distance = b.at(place).z - a.at(place).z - radii; distance <= wanted.margin) {
        expected.push_back(place);
        least = std::min(least, distance);
      }
    }
    abut::Manifold contacts(1);
    const auto answer = append_contacts_of(few_corners_of(face_a), few_corners_of(face_b), wanted, contacts);
    if (!answer) {
      EXPECT_EQ(contacts.size(), 1u);
      ++(wanted.closest_count && least > wanted.deepest + rounding ? without_closest : in_doubt);
      continue;
    }
    ++found;
    EXPECT_TRUE(*answer == least || std::fabs(*answer - least) < rounding);
    EXPECT_TRUE(!wanted.closest_count || least <= wanted.deepest + rounding);
    ASSERT_EQ(contacts.size(), 1 + expected.size());
    for (const abut::ContactPoint& contact : std::span(contacts).subspan(1)) {
      const Vec3 on_a = contact.point_a - wanted.radius_a * up, on_b = contact.point_b + wanted.radius_b * up;
      const auto nearest = std::ranges::min_element(
          expected, {}, [&](const Place& p) { return std::hypot(p.x - on_a.x, p.y - on_a.y); });
      EXPECT_LT(norm(on_a - a.at(*nearest)), rounding);
      EXPECT_LT(norm(on_b - b.at(*nearest)), rounding);
      EXPECT_NEAR(contact.distance, b.at(*nearest).z - a.at(*nearest).z - radii, rounding);
      EXPECT_EQ(contact.normal, up);
      EXPECT_LT(off_feature(face_a, contact.feature_a, on_a), rounding);
      EXPECT_LT(off_feature(face_b, contact.feature_b, on_b), rounding);
      EXPECT_EQ(contact.id, contact_id(contact.feature_a, contact.feature_b));
      expected.erase(nearest);
    }
  }
  EXPECT_GT(found, 3000u);
  EXPECT_GT(without_closest, 100u);
  EXPECT_LT(in_doubt, 100u);
}

// Cosines between the faces and the normal are 0.1 and 0.03.
TEST(SmallPolygons, LeaveAFaceThatStandsSteepOpen) {
  const auto take = [](const Sketch& a, const Sketch& b, abut::Manifold& contacts) {
    const FewCorners face_a = few_corners_of(a.face(true)), face_b = few_corners_of(b.face(false));
    return append_contacts_of(face_a, face_b, wanted_of(a, b, 100), contacts).has_value();
  };
  const Sketch slope{triangle_within.corners, 10, 0, 1}, steep{triangle_within.corners, 30, 0, 1};
  abut::Manifold contacts;
  EXPECT_TRUE(take(square, slope, contacts));
  EXPECT_TRUE(take(slope, square, contacts));
  EXPECT_EQ(contacts.size(), 6u);
  EXPECT_FALSE(take(square, steep, contacts));
  EXPECT_FALSE(take(steep, square, contacts));
  EXPECT_EQ(contacts.size(), 6u);
}

}  // namespace
