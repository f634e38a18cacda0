// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include "../../hull_of.hpp"
#include "../surface_checks.hpp"

import abut.capability.cores.core_feature;
import abut.capability;
import abut.core;
import abut.math;
import abut.shapes.hull;
import abut.shapes.hull.data;

namespace {

using abut::Errc;
using abut::Hull;
using abut::Vec3;
using test::hull_of;

// Many points on a ball stay vertices, many in a cube do not.
std::vector<Vec3> points_on_ball(std::size_t count, test::Random& random) {
  std::vector<Vec3> points;
  while (points.size() < count) {
    points.push_back(test::towards(random));
  }
  return points;
}
std::vector<Vec3> points_in_cube(std::size_t count, test::Random& random) {
  std::vector<Vec3> points;
  while (points.size() < count) {
    points.push_back(random.point(1));
  }
  return points;
}

TEST(Hull, BadInputIsRefusedByName) {
  test::expect_refused<Hull>({}, {}, {}, Errc::empty, "point_count is 0;");
  test::expect_refused<Hull>({}, {1, 2, 3, 4}, {}, Errc::invalid_argument, "real_count is 4;");
  test::expect_refused<Hull>({}, {1, 2, 3, 4, std::numeric_limits<double>::infinity(), 6}, {}, Errc::not_finite,
                             "xyz[4] is inf;");
  test::expect_refused<Hull>({}, {1, 2, -1e71}, {}, Errc::out_of_range, "xyz[2] is -1e+71;");
  test::expect_refused<Hull>({1}, {1, 2, 3}, {}, Errc::invalid_argument, "parameter_count is 1;");
  test::expect_refused<Hull>({}, {1, 2, 3}, {1}, Errc::invalid_argument, "faces of a hull: face 0 has 1 corners;");
}

// As it was built: Qhull would number vertices and faces of the same points otherwise.
TEST(Hull, IsMadeAgainOfItsBuffers) {
  test::Random random(5);
  for (const std::size_t count : {std::size_t{1}, std::size_t{2}, std::size_t{4}, std::size_t{30}, std::size_t{300}}) {
    for (const bool is_flat : {false, true}) {
      std::vector<Vec3> points = points_in_cube(count, random);
      for (Vec3& p : points) p.z = is_flat ? 0 : p.z;
      const Hull built = hull_of(points);
      const abut::Buffers buffers = built.buffers();
      const auto made = Hull::make({}, buffers.reals, buffers.indices);
      ASSERT_TRUE(made.has_value()) << made.error().message;
      const abut::HullData &one = built.data(), &other = made.value().data();
      EXPECT_EQ(one.vertices, other.vertices);
      EXPECT_EQ(one.face_vertices, other.face_vertices);
      EXPECT_EQ(one.face_edges, other.face_edges);
      ASSERT_EQ(one.faces.size(), other.faces.size());
      for (std::size_t i = 0; i < one.faces.size(); ++i) {
        EXPECT_EQ(one.faces[i].normal, other.faces[i].normal);
        EXPECT_EQ(one.faces[i].offset, other.faces[i].offset);
      }
      EXPECT_EQ(one.facets.inner, other.facets.inner);
      EXPECT_EQ(one.facets.faces, other.facets.faces);
    }
  }
}

// Small hulls are scanned, large ones look candidates up; both sides of the border are here.
TEST(Hull, SupportIsTheFurthestOfAllGivenPoints) {
  test::Random random(141);
  for (const std::size_t count : {4u, 5u, 7u, 8u, 30u, 48u, 49u, 60u, 200u, 1000u}) {
    SCOPED_TRACE(std::to_string(count) + " points");
    for (const bool round : {true, false}) {
      const auto points = round ? points_on_ball(count, random) : points_in_cube(count, random);
      test::expect_support(hull_of(points), points, 1.8, 142);
    }
  }
}

// Points of a long and thin cloud share most cells of directions.
TEST(Hull, SupportOfNeedlesAndPlates) {
  test::Random random(143);
  for (const Vec3& size : {Vec3{100, 1, 1}, Vec3{1, 50, 50}, Vec3{1e-3, 1, 30}}) {
    std::vector<Vec3> points;
    for (const Vec3& p : points_on_ball(150, random)) {
      points.push_back({size.x * p.x, size.y * p.y, size.z * p.z});
    }
    test::expect_support(hull_of(points), points, 100, 144);
  }
}

TEST(Hull, BoxIsTight) {
  test::Random random(145);
  for (const std::size_t count : {4u, 30u, 150u}) {
    const auto points = points_on_ball(count, random);
    const auto reach = [&](const abut::Pose& pose, const Vec3& direction) {
      double most = -abut::infinity;
      for (const Vec3& p : points) {
        most = std::fmax(most, dot(pose * p, direction));
      }
      return most;
    };
    test::expect_tight_boxes(hull_of(points), reach, 1, 146);
  }
}

TEST(Hull, FacesArePlaneAndOutward) {
  test::Random random(147);
  for (const std::size_t count : {4u, 12u, 40u, 120u}) {
    const auto points = points_on_ball(count, random);
    test::expect_faces(hull_of(points), points, 1, 148);
  }
  const std::vector<Vec3> cube = test::corners_of({1, 1, 1}, abut::Pose::identity());
  test::expect_faces(hull_of(cube), cube, 1, 149);
  EXPECT_EQ(hull_of(cube).supporting_face({0.1, 0.2, 1}).vertices.size(), 4u);
}

// The planes through any three points with all others on one side: a hull by definition.
struct Side {
  Vec3 normal;
  double offset;
};
std::vector<Side> sides_of(const std::vector<Vec3>& points) {
  std::vector<Side> sides;
  for (const Vec3& a : points) {
    for (const Vec3& b : points) {
      for (const Vec3& c : points) {
        const Vec3 across = cross(b - a, c - a);
        const double length = std::sqrt(dot(across, across));
        if (length < 1e-12) {
          continue;
        }
        const Side side{(1 / length) * across, dot((1 / length) * across, a)};
        if (test::furthest(points, side.normal) <= side.offset + 1e-12) {
          sides.push_back(side);
        }
      }
    }
  }
  return sides;
}

TEST(Hull, RaysMeetTheFirstCrossing) {
  test::Random random(150);
  int solids = 0;
  for (const std::size_t count : {4u, 8u, 14u}) {
    const auto points = points_on_ball(count, random);
    const std::vector<Side> sides = sides_of(points);
    const auto outside = [&](const Vec3& p) {
      double most = -abut::infinity;
      for (const Side& side : sides) {
        most = std::fmax(most, dot(side.normal, p) - side.offset);
      }
      return most;
    };
    // The centre of the points lies inside; rays are drawn about the origin.
    if (outside({0, 0, 0}) < -0.05) {
      test::expect_rays(hull_of(points), outside, 1, 151);
      ++solids;
    }
  }
  EXPECT_GE(solids, 2);
}

TEST(Hull, RaysNameTheFaceThatSupportsThem) {
  const Hull cube = hull_of(test::corners_of({1, 1, 1}, abut::Pose::identity()));
  for (int axis = 0; axis < 3; ++axis) {
    for (const double sign : {-1.0, 1.0}) {
      const Vec3 outward = test::axis_vector(axis, sign), from = 3 * outward + Vec3{0.25, 0.125, 0.0625};
      const auto hit = cube.cast_ray(from, abut::UnitVec3::from_unit_unchecked(-outward), 10);
      ASSERT_TRUE(hit.has_value());
      EXPECT_EQ(hit->feature.kind, abut::FeatureKind::face);
      EXPECT_EQ(hit->feature.index, cube.supporting_face(outward).index);
      EXPECT_GT(dot(hit->normal, outward), 1 - 1e-15);
    }
  }
}

TEST(Hull, TrianglesEncloseTheVolume) {
  const Hull cube = hull_of(test::corners_of({1, 2, 3}, abut::Pose::identity()));
  const abut::Triangles surface = cube.triangles();
  EXPECT_EQ(surface.vertices.size(), 8u);
  EXPECT_EQ(surface.indices.size(), 36u);
  double volume = 0;
  for (std::size_t i = 0; i < surface.indices.size(); i += 3) {
    volume += dot(surface.vertices[surface.indices[i]],
                  cross(surface.vertices[surface.indices[i + 1]], surface.vertices[surface.indices[i + 2]])) /
              6;
  }
  EXPECT_NEAR(volume, 48, 1e-12);
}

TEST(Hull, ExtentBoundsTheCoreUpToAFactorOfTwo) {
  test::Random random(152);
  for (int i = 0; i < 50; ++i) {
    const auto points = points_in_cube(10, random);
    const Hull hull = hull_of(points);
    for (const Vec3& p : points) {
      EXPECT_LE(std::sqrt(dot(p - hull.centre(), p - hull.centre())), 2 * hull.extent());
    }
  }
}

TEST(Hull, PointsAndSegmentsShowTheirWholeCore) {
  const abut::Face point = hull_of({{1, 2, 3}, {1, 2, 3}}).supporting_face({1, 0, 0});
  ASSERT_EQ(point.vertices.size(), 1u);
  EXPECT_EQ(point.vertices[0].point, (Vec3{1, 2, 3}));
  const Hull line = hull_of({{0, 0, 0}, {1, 1, 1}, {3, 3, 3}, {2, 2, 2}});
  const abut::Face segment = line.supporting_face({1, 0, 0});
  ASSERT_EQ(segment.vertices.size(), 2u);
  EXPECT_EQ(segment.normal, (Vec3{0, 0, 0}));
  EXPECT_EQ(line.support({1, 0, 0}).point, (Vec3{3, 3, 3}));
  EXPECT_EQ(line.support({0, 0, -1}).point, (Vec3{0, 0, 0}));
}

TEST(Hull, RaysMeetFlatHullsInTheirPolygonOnly) {
  const Hull square = hull_of({{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}});
  const auto down = abut::UnitVec3::from_unit_unchecked({0, 0, -1});
  const auto hit = square.cast_ray({0.5, 0.5, 3}, down, 10);
  ASSERT_TRUE(hit.has_value());
  EXPECT_EQ(hit->distance, 3);
  EXPECT_EQ(hit->normal, (Vec3{0, 0, 1}));
  EXPECT_FALSE(square.cast_ray({1.5, 0.5, 3}, down, 10).has_value());
}

TEST(Hull, SupportingFaceOfAFeatureIsTheOneAlongItsNormal) {
  test::Random random(149);
  for (const std::size_t count : {4u, 8u, 32u, 100u}) {
    for (const auto& points : {points_on_ball(count, random), points_in_cube(count, random)}) {
      const Hull hull = hull_of(points);
      const auto& facets = hull.facets();
      const auto normal_of_plane = [&](std::size_t i) {
        const auto& planes = facets.planes[i / 4];
        return Vec3{planes.x[i % 4], planes.y[i % 4], planes.z[i % 4]};
      };
      for (std::size_t i = 0; i < 4 * facets.planes.size(); ++i) {
        const Vec3 normal = normal_of_plane(i);
        const abut::Face face = hull.supporting_face(normal, abut::core_face(i));
        EXPECT_EQ(face.index, hull.supporting_face(normal).index);
        EXPECT_EQ(face.normal, normal);
      }
      for (std::size_t i = 0; i < facets.lines.size(); ++i) {
        const Vec3 left = normal_of_plane(facets.sides[i].left), right = normal_of_plane(facets.sides[i].right);
        for (const double share : {0.01, 0.3, 0.45, 0.55, 0.9}) {
          const Vec3 between = left + share * (right - left);
          EXPECT_EQ(hull.supporting_face(between, abut::core_edge(i)).index, hull.supporting_face(between).index);
        }
      }
    }
  }
}

}  // namespace
