// Triangles of surfaces, one by one: what trees and grids must agree with.
#pragma once
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <set>
#include <utility>
#include <vector>

#include "surface_checks.hpp"

namespace test {

struct Corners {
  abut::Vec3 a, b, c;
};
inline Corners corners_at(const abut::Triangles& surface, std::size_t triangle) {
  return {surface.vertices[surface.indices[3 * triangle]], surface.vertices[surface.indices[3 * triangle + 1]],
          surface.vertices[surface.indices[3 * triangle + 2]]};
}

// How far inside all edges of a triangle, in barycentric terms, a line meets its plane, and where.
struct Meeting {
  double distance, depth;
};
inline Meeting meeting(const Corners& t, const abut::Vec3& origin, const abut::Vec3& direction) {
  const abut::Vec3 normal = cross(t.b - t.a, t.c - t.a);
  const double distance = dot(normal, t.a - origin) / dot(normal, direction), area = dot(normal, normal);
  const abut::Vec3 p = origin + distance * direction;
  const double first = dot(normal, cross(t.c - t.b, p - t.b)) / area,
               second = dot(normal, cross(t.a - t.c, p - t.c)) / area;
  return {distance, std::fmin(std::fmin(first, second), 1 - first - second)};
}

// First crossing of all triangles; rays that pass an edge too closely are left to other tests.
template <class S>
void expect_first_triangle(const S& shape, const abut::Vec3& centre, const abut::Vec3& size, std::uint64_t seed,
                           int least_hits) {
  Random random(seed);
  const abut::Triangles surface = shape.triangles();
  int hits = 0;
  for (int i = 0; i < 2000; ++i) {
    const auto near = [&](double by) {
      const abut::Vec3 p = random.point(by);
      return centre + abut::Vec3{p.x * size.x, p.y * size.y, p.z * size.z};
    };
    const abut::Vec3 origin = near(2), target = near(0.7);
    const auto direction = abut::UnitVec3::make(target - origin).value();
    double nearest = abut::infinity;
    std::size_t first = 0;
    bool close = false;
    for (std::size_t k = 0; k < surface.indices.size() / 3; ++k) {
      const Meeting met = meeting(corners_at(surface, k), origin, direction);
      close = close || std::fabs(met.depth) < 1e-9;
      if (met.depth > 0 && met.distance >= 0 && met.distance < nearest) {
        nearest = met.distance;
        first = k;
      }
    }
    if (close) {
      continue;
    }
    const auto hit = shape.cast_ray(origin, direction, abut::infinity);
    ASSERT_EQ(hit.has_value(), nearest < abut::infinity) << "ray " << i;
    if (hit) {
      ++hits;
      EXPECT_NEAR(hit->distance, nearest, 1e-11 * nearest);
      EXPECT_EQ(hit->feature, (abut::Feature{abut::FeatureKind::face, static_cast<std::uint32_t>(first)}));
      const Corners t = corners_at(surface, first);
      EXPECT_GT(dot(hit->normal, cross(t.b - t.a, t.c - t.a)), 0);  // by winding, from either side
      EXPECT_NEAR(dot(hit->normal, hit->normal), 1, 4e-15);
      EXPECT_FALSE(shape.cast_ray(origin, direction, 0.999 * nearest).has_value());
    }
  }
  EXPECT_GT(hits, least_hits);
}

// Every part whose box overlaps the given one, each once, with its number.
template <class S>
void expect_parts(const S& shape, const abut::Vec3& centre, const abut::Vec3& size, std::uint64_t seed) {
  Random random(seed);
  const abut::Triangles surface = shape.triangles();
  std::size_t most = 0;
  for (int i = 0; i < 500; ++i) {
    const abut::Vec3 p = random.point(1.2);
    const abut::Vec3 middle = centre + abut::Vec3{p.x * size.x, p.y * size.y, p.z * size.z};
    const double share = random.uniform(0, i % 10 == 0 ? 2 : 0.3);
    const abut::Vec3 half = share * size;
    std::set<std::uint32_t> expected, got;
    for (std::uint32_t k = 0; k < surface.indices.size() / 3; ++k) {
      const Corners t = corners_at(surface, k);
      bool apart = false;
      for (int axis = 0; axis < 3; ++axis) {
        const double low = std::fmin(std::fmin(t.a[axis], t.b[axis]), t.c[axis]);
        const double high = std::fmax(std::fmax(t.a[axis], t.b[axis]), t.c[axis]);
        apart = apart || low > middle[axis] + half[axis] || high < middle[axis] - half[axis];
      }
      if (!apart) {
        expected.insert(k);
      }
    }
    abut::Aabb box{middle - half, middle + half};
    shape.visit_parts(box, [&](const abut::Triangle& part, std::uint32_t index) {
      EXPECT_TRUE(got.insert(index).second) << "part " << index << " comes twice";
      const Corners t = corners_at(surface, index);
      EXPECT_EQ(part.corners()[0], t.a);
      EXPECT_EQ(part.corners()[1], t.b);
      EXPECT_EQ(part.corners()[2], t.c);
      EXPECT_EQ(part.index(), index);
    });
    EXPECT_EQ(got, expected);
    most = expected.size() > most ? expected.size() : most;
  }
  EXPECT_EQ(most, surface.indices.size() / 3);
}

// Whether nothing around some corners of a triangle (by bit) rises over the plane through them: all triangles that have
// these corners are looked at.
inline bool lies_behind(const abut::Triangles& surface, std::size_t triangle, unsigned corners,
                        const abut::Vec3& direction) {
  std::set<std::uint32_t> wanted;
  for (unsigned i = 0; i < 3; ++i) {
    if ((corners >> i & 1) != 0) {
      wanted.insert(surface.indices[3 * triangle + i]);
    }
  }
  const double height = dot(direction, surface.vertices[*wanted.begin()]);
  for (std::size_t first = 0; first < surface.indices.size(); first += 3) {
    const std::set<std::uint32_t> own{surface.indices[first], surface.indices[first + 1], surface.indices[first + 2]};
    bool has_all = true;
    for (const std::uint32_t vertex : wanted) {
      has_all = has_all && own.contains(vertex);
    }
    for (const std::uint32_t vertex : own) {
      if (has_all && dot(direction, surface.vertices[vertex]) > height + 1e-12) {
        return false;
      }
    }
  }
  return true;
}

// For each vertex and edge of each triangle, and directions in which it is the outermost of the triangle, flat ones
// too.
template <class S>
void expect_crests(const S& shape, std::uint64_t seed, int least) {
  Random random(seed);
  const abut::Triangles surface = shape.triangles();
  int crests = 0, others = 0;
  for (std::uint32_t k = 0; k < surface.indices.size() / 3; ++k) {
    const Corners t = corners_at(surface, k);
    const std::array<abut::Vec3, 3> at{t.a, t.b, t.c};
    for (int round = 0; round < 30; ++round) {
      const auto from = static_cast<unsigned>(round % 3);
      const bool is_edge = round % 2 == 0;
      abut::Vec3 direction = round < 6 ? cross(t.b - t.a, t.c - t.a) : random.point(1);
      const abut::Vec3 edge = at[(from + 1) % 3] - at[from];
      if (is_edge) {
        direction = direction - (dot(direction, edge) / dot(edge, edge)) * edge;
      }
      direction = *abut::UnitVec3::make(direction);
      const unsigned corners = is_edge ? 1u << from | 1u << (from + 1) % 3 : 1u << from;
      const bool expected = lies_behind(surface, k, corners, direction);
      EXPECT_EQ(shape.is_crest(k, corners, direction, 1e-12), expected) << "triangle " << k << ", corners " << corners;
      ++(expected ? crests : others);
    }
  }
  EXPECT_GT(crests, least);
  EXPECT_GT(others, least);
}

// The box of a turned surface holds all of it and is no larger than the turned box of its vertices.
template <class S>
void expect_boxes_hold(const S& shape, std::uint64_t seed) {
  Random random(seed);
  const abut::Triangles surface = shape.triangles();
  const abut::Aabb own = shape.aabb(abut::Pose::identity());
  const abut::Vec3 half = 0.5 * (own.high - own.low);
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(own.high[axis], furthest(surface.vertices, axis_vector(axis, 1)), 1e-15);
    EXPECT_NEAR(own.low[axis], -furthest(surface.vertices, axis_vector(axis, -1)), 1e-15);
  }
  for (int i = 0; i < 200; ++i) {
    const abut::Pose pose{random.rotation(), random.point(10)};
    const abut::Aabb box = shape.aabb(pose);
    std::vector<abut::Vec3> placed;
    for (const abut::Vec3& p : surface.vertices) {
      placed.push_back(pose * p);
    }
    const auto corners = corners_of(half, {pose.rotation, pose * own.centre()});
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_GE(box.high[axis], furthest(placed, axis_vector(axis, 1)) - 1e-14);
      EXPECT_LE(box.low[axis], -furthest(placed, axis_vector(axis, -1)) + 1e-14);
      EXPECT_NEAR(box.high[axis], furthest(corners, axis_vector(axis, 1)), 1e-13);
      EXPECT_NEAR(box.low[axis], -furthest(corners, axis_vector(axis, -1)), 1e-13);
    }
  }
}

}  // namespace test
