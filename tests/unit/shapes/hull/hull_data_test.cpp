// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <numbers>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "../../random_boxes.hpp"

import abut.capability;
import abut.math;
import abut.shapes.hull.data;

namespace {

using abut::HullData;
using abut::HullFace;
using abut::Vec3;

std::vector<Vec3> cloud(std::size_t count, const Vec3& size, test::Random& random) {
  std::vector<Vec3> points;
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3 p = random.rotation().x;
    points.push_back({size.x * p.x, size.y * p.y, size.z * p.z});
  }
  return points;
}

// A closed surface: each edge is passed once in each direction, and the surface has no holes (Euler).
void expect_closed(const HullData& hull) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> passes;
  std::map<std::uint32_t, std::pair<std::uint32_t, std::uint32_t>> numbers;
  std::set<std::uint32_t> used;
  for (const HullFace& face : hull.faces) {
    for (std::uint32_t i = 0; i < face.count; ++i) {
      const std::uint32_t from = hull.face_vertices[face.first + i],
                          to = hull.face_vertices[face.first + (i + 1) % face.count];
      ++passes[{from, to}];
      used.insert(from);
      const auto ends = std::minmax(from, to);
      const auto known = numbers.try_emplace(hull.face_edges[face.first + i], ends).first;
      EXPECT_EQ(known->second, (std::pair<std::uint32_t, std::uint32_t>(ends)));
    }
  }
  for (const auto& [edge, count] : passes) {
    EXPECT_EQ(count, 1);
    EXPECT_TRUE(passes.contains({edge.second, edge.first}));
  }
  EXPECT_EQ(used.size(), hull.vertices.size());
  EXPECT_EQ(numbers.size() * 2, passes.size());
  EXPECT_EQ(used.size() + hull.faces.size(), numbers.size() + 2);
}

void expect_around(const HullData& hull, const std::vector<Vec3>& points, double slack) {
  for (const Vec3& vertex : hull.vertices) {
    EXPECT_NE(std::find(points.begin(), points.end(), vertex), points.end());
  }
  for (const HullFace& face : hull.faces) {
    EXPECT_NEAR(dot(face.normal, face.normal), 1, 4e-15);
    for (const Vec3& p : points) {
      EXPECT_LE(dot(face.normal, p), face.offset + slack);
    }
    for (std::uint32_t i = 0; i < face.count; ++i) {
      EXPECT_NEAR(dot(face.normal, hull.vertices[hull.face_vertices[face.first + i]]), face.offset, slack);
    }
  }
}

TEST(HullData, RandomCloudsHaveClosedHulls) {
  test::Random random(161);
  for (const std::size_t count : {4u, 5u, 10u, 49u, 200u}) {
    SCOPED_TRACE(std::to_string(count) + " points");
    for (const Vec3& size : {Vec3{1, 1, 1}, Vec3{20, 1, 0.1}}) {
      const std::vector<Vec3> points = cloud(count, size, random);
      const HullData hull = abut::build_hull(points);
      expect_closed(hull);
      expect_around(hull, points, 1e-12 * size.x);
    }
  }
}

TEST(HullData, InnerPointsAreLeftOut) {
  std::vector<Vec3> points = test::corners_of({1, 1, 1}, abut::Pose::identity());
  test::Random random(162);
  for (int i = 0; i < 100; ++i) {
    points.push_back(random.point(0.99));
  }
  const HullData hull = abut::build_hull(points);
  EXPECT_EQ(hull.vertices.size(), 8u);
  EXPECT_EQ(hull.faces.size(), 6u);
  expect_closed(hull);
  expect_around(hull, points, 1e-14);
}

// Faces of many corners stay one face.
TEST(HullData, PrismsKeepTheirPolygons) {
  for (const std::size_t sides : {3u, 6u, 16u, 24u}) {
    SCOPED_TRACE(std::to_string(sides) + " sides");
    std::vector<Vec3> points;
    for (std::size_t i = 0; i < sides; ++i) {
      const double angle = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(sides);
      points.push_back({std::cos(angle), std::sin(angle), -1});
      points.push_back({std::cos(angle), std::sin(angle), 1});
    }
    const HullData hull = abut::build_hull(points);
    EXPECT_EQ(hull.vertices.size(), 2 * sides);
    EXPECT_EQ(hull.faces.size(), sides + 2);
    expect_closed(hull);
    expect_around(hull, points, 1e-14);
  }
}

TEST(HullData, CoplanarPointsAreAPolygonWithTwoSides) {
  test::Random random(163);
  for (int i = 0; i < 50; ++i) {
    const abut::Pose pose{random.rotation(), random.point(5)};
    std::vector<Vec3> points;
    for (const Vec3& flat :
         {Vec3{-1, -1, 0}, Vec3{1, -1, 0}, Vec3{1, 1, 0}, Vec3{-1, 1, 0}, Vec3{0, 0, 0}, Vec3{0.5, 0.25, 0}}) {
      points.push_back(pose * flat);
    }
    const HullData hull = abut::build_hull(points);
    ASSERT_EQ(hull.vertices.size(), 4u);
    ASSERT_EQ(hull.faces.size(), 2u);
    EXPECT_EQ(hull.faces[0].count, 4u);
    EXPECT_LT(dot(hull.faces[0].normal, hull.faces[1].normal), -1 + 1e-14);
    expect_around(hull, points, 1e-13);
  }
}

TEST(HullData, CollinearPointsAreASegment) {
  test::Random random(164);
  for (int i = 0; i < 50; ++i) {
    const Vec3 start = random.point(5), along = random.rotation().x;
    std::vector<Vec3> points;
    for (const double at : {0.5, 2.0, -1.0, 0.0, 1.5}) {
      points.push_back(start + at * along);
    }
    const HullData hull = abut::build_hull(points);
    ASSERT_EQ(hull.vertices.size(), 2u);
    EXPECT_TRUE(hull.faces.empty());
    EXPECT_NEAR(norm(hull.vertices[1] - hull.vertices[0]), 3, 1e-14);
  }
}

TEST(HullData, CoincidentPointsAreOne) {
  const HullData hull = abut::build_hull(std::vector<Vec3>(7, Vec3{1, -2, 3}));
  EXPECT_EQ(hull.vertices, (std::vector<Vec3>{{1, -2, 3}}));
  EXPECT_TRUE(hull.faces.empty());
  EXPECT_EQ(hull.centre, (Vec3{1, -2, 3}));
  EXPECT_EQ(hull.extent, 0);
}

TEST(HullData, FacesAroundAVertexAreThoseThatHaveIt) {
  test::Random random(165);
  const HullData hull = abut::build_hull(cloud(60, {1, 1, 1}, random));
  ASSERT_EQ(hull.first_face.size(), hull.vertices.size() + 1);
  for (std::uint32_t vertex = 0; vertex < hull.vertices.size(); ++vertex) {
    std::set<std::uint32_t> expected;
    for (std::uint32_t i = 0; i < hull.faces.size(); ++i) {
      const auto corners = std::span(hull.face_vertices).subspan(hull.faces[i].first, hull.faces[i].count);
      if (std::find(corners.begin(), corners.end(), vertex) != corners.end()) {
        expected.insert(i);
      }
    }
    const auto listed = std::span(hull.faces_at)
                            .subspan(hull.first_face[vertex], hull.first_face[vertex + 1] - hull.first_face[vertex]);
    EXPECT_EQ((std::set<std::uint32_t>(listed.begin(), listed.end())), expected);
    EXPECT_EQ(listed.size(), expected.size());
  }
}

TEST(HullData, BoundsAreThoseOfTheVertices) {
  const HullData hull = abut::build_hull(test::corners_of({1, 2, 3}, {abut::Rotation::identity(), {10, 20, 30}}));
  EXPECT_EQ(hull.low, (Vec3{9, 18, 27}));
  EXPECT_EQ(hull.high, (Vec3{11, 22, 33}));
  EXPECT_EQ(hull.centre, (Vec3{10, 20, 30}));
}

// What separating axes need: planes that hold all vertices, arcs between the faces of an edge, a ball inside.
TEST(HullData, FacetsAreThoseOfTheFaces) {
  test::Random random(167);
  for (const std::size_t count : {4u, 7u, 32u, 60u}) {
    SCOPED_TRACE(std::to_string(count) + " points");
    const HullData hull = abut::build_hull(cloud(count, {2, 1, 0.5}, random));
    const abut::HullFacets& facets = hull.facets;
    ASSERT_TRUE(facets.is_closed);
    ASSERT_EQ(facets.planes.size(), (hull.faces.size() + 3) / 4);
    ASSERT_EQ(facets.points.size(), hull.vertices.size());
    EXPECT_EQ(hull.vertices.size() + hull.faces.size(), facets.lines.size() + 2);
    EXPECT_LE(facets.flatness, 1e-14);
    EXPECT_GT(facets.inner, 0);
    std::set<std::array<double, 3>> listed, points;
    for (const HullFace& face : hull.faces) {
      listed.insert({face.normal.x, face.normal.y, face.normal.z});
      EXPECT_LE(dot(face.normal, facets.middle) + facets.inner, face.offset + 1e-14);
    }
    const auto normal_at = [&](std::size_t face) {
      const abut::HullFacets::Planes& planes = facets.planes[face / 4];
      return Vec3{planes.x[face % 4], planes.y[face % 4], planes.z[face % 4]};
    };
    std::set<std::array<double, 3>> found;
    for (std::size_t face = 0; face < 4 * facets.planes.size(); ++face) {
      const Vec3 normal = normal_at(face);
      found.insert({normal.x, normal.y, normal.z});
      double most = -1e9;
      for (const Vec3& p : hull.vertices) {
        most = std::fmax(most, dot(normal, p));
      }
      EXPECT_NEAR(facets.planes[face / 4].reach[face % 4], most, 1e-15);
    }
    EXPECT_EQ(found, listed);
    for (std::size_t edge = 0; edge < facets.lines.size(); ++edge) {
      const Vec3 from = abut::vec3_of(facets.lines[edge].from), along = abut::vec3_of(facets.lines[edge].along);
      const Vec3 left = normal_at(facets.sides[edge].left), right = normal_at(facets.sides[edge].right);
      const abut::HullFacets::Arcs& arcs = facets.arcs[edge / 4];
      EXPECT_EQ(left, (Vec3{arcs.left_x[edge % 4], arcs.left_y[edge % 4], arcs.left_z[edge % 4]}));
      EXPECT_EQ(right, (Vec3{arcs.right_x[edge % 4], arcs.right_y[edge % 4], arcs.right_z[edge % 4]}));
      EXPECT_EQ(from, (Vec3{arcs.from_x[edge % 4], arcs.from_y[edge % 4], arcs.from_z[edge % 4]}));
      EXPECT_NEAR(dot(left, along), 0, 1e-15);
      EXPECT_NEAR(dot(right, along), 0, 1e-15);
      // Seen from outside along the edge, the left face lies to the left.
      EXPECT_GT(dot(along, cross(left, right)), 0);
    }
    for (const abut::Lanes& p : facets.points) {
      points.insert({p[0], p[1], p[2]});
    }
    EXPECT_EQ(points.size(), hull.vertices.size());
  }
}

TEST(HullData, OnlySolidsAndPolygonsHaveFacets) {
  EXPECT_TRUE(abut::build_hull(std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}).facets.is_closed);
  EXPECT_FALSE(abut::build_hull(std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}}).facets.is_closed);
  EXPECT_FALSE(abut::build_hull(std::vector<Vec3>{{0, 0, 0}}).facets.is_closed);
}

// Whatever rounding does to its planes: where there is a ball inside, the faces are taken to tell what lies in the
// hull.
TEST(HullData, NoBallLiesInAPolygon) {
  test::Random random(169);
  for (int i = 0; i < 100; ++i) {
    const HullData hull = abut::build_hull(std::vector<Vec3>{random.point(1), random.point(1), random.point(1)});
    ASSERT_EQ(hull.faces.size(), 2u);
    EXPECT_EQ(hull.facets.inner, 0) << "triangle " << i;
  }
}

// The last block of four vertices is filled up with copies, which win ties against what they are copies of.
TEST(HullData, SupportNamesAVertexOfEveryCount) {
  test::Random random(167);
  for (std::size_t count = 4; count <= HullData::scan_limit + 2; ++count) {
    const HullData hull = abut::build_hull(cloud(count, {1, 1, 1}, random));
    ASSERT_EQ(hull.vertices.size(), count);
    for (std::uint32_t i = 0; i < count; ++i) {
      // On a sphere each vertex is the only one that is furthest along itself.
      const abut::SupportPoint top = hull.support(hull.vertices[i]);
      ASSERT_EQ(top.index, i) << "of " << count;
      EXPECT_EQ(top.point, hull.vertices[i]);
    }
    const abut::SupportPoint nowhere = hull.support({0, 0, 0});
    ASSERT_LT(nowhere.index, count);
    EXPECT_EQ(nowhere.point, hull.vertices[nowhere.index]);
  }
}

// Ties, zero directions and directions along the borders of cells.
TEST(HullData, SupportIsRightOnTheBordersOfCells) {
  test::Random random(166);
  const std::vector<Vec3> points = cloud(300, {1, 2, 0.5}, random);
  const HullData hull = abut::build_hull(points);
  for (int x = -8; x <= 8; ++x) {
    for (int y = -8; y <= 8; ++y) {
      for (int z = -8; z <= 8; ++z) {
        const Vec3 direction{x / 8.0, y / 8.0, z / 8.0};
        double most = -1e9;
        for (const Vec3& p : points) {
          most = std::fmax(most, dot(p, direction));
        }
        const abut::SupportPoint top = hull.support(direction);
        ASSERT_LT(top.index, hull.vertices.size());
        EXPECT_EQ(top.point, hull.vertices[top.index]);
        EXPECT_NEAR(dot(top.point, direction), most, 4e-15) << x << " " << y << " " << z;
      }
    }
  }
}

}  // namespace
