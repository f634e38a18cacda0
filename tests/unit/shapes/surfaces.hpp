// SPDX-License-Identifier: Apache-2.0
// Triangles of surfaces, one by one: what trees and grids must agree with.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <map>
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
  const double speed = dot(normal, direction), area = dot(normal, normal);
  if (speed == 0) {
    return {0, -1};  // along the plane, or a triangle that is missing
  }
  const double distance = dot(normal, t.a - origin) / speed;
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

// The triangles around a vertex: how many edges from it have one triangle only, and the directions in which the normals
// look.
struct Fan {
  std::map<std::uint32_t, int> triangles_at;  // by the other end of the edge
  std::vector<abut::Vec3> normals;
  [[nodiscard]] bool is_closed() const {
    return std::ranges::all_of(triangles_at, [](const auto& edge) { return edge.second == 2; });
  }
  [[nodiscard]] bool is_seen_from_one_side(const abut::Vec3& direction) const {
    return std::ranges::all_of(normals, [&](const abut::Vec3& n) { return dot(n, direction) < -0.05 * norm(n); });
  }
};
inline std::vector<Fan> fans_of(const abut::Triangles& surface) {
  std::vector<Fan> fans(surface.vertices.size());
  for (std::size_t k = 0; k < surface.indices.size() / 3; ++k) {
    const Corners t = corners_at(surface, k);
    for (std::size_t i = 0; i < 3; ++i) {
      Fan& fan = fans[surface.indices[3 * k + i]];
      ++fan.triangles_at[surface.indices[3 * k + (i + 1) % 3]];
      ++fan.triangles_at[surface.indices[3 * k + (i + 2) % 3]];
      fan.normals.push_back(cross(t.b - t.a, t.c - t.a));
    }
  }
  return fans;
}

// Rays at inner vertices, and at points of the edges from there, that all triangles around look at: none slips through.
template <class S>
void expect_no_gaps(const S& shape, double distance, std::uint64_t seed) {
  Random random(seed);
  const abut::Triangles surface = shape.triangles();
  const std::vector<Fan> fans = fans_of(surface);
  int rays = 0;
  for (int i = 0; i < 20000; ++i) {
    const auto vertex = static_cast<std::size_t>(random.uniform(0, static_cast<double>(fans.size())));
    const Fan& fan = fans[vertex];
    const abut::Vec3 slant = random.point(0.5), at = surface.vertices[vertex];
    const abut::Vec3 direction = random.uniform(0, 1) < 0.2 ? abut::Vec3{0, 0, -1} : slant - abut::Vec3{0, 0, 1};
    if (!fan.is_closed() || !fan.is_seen_from_one_side(direction)) {
      continue;
    }
    auto edge = fan.triangles_at.begin();
    std::advance(edge, static_cast<int>(random.uniform(0, static_cast<double>(fan.triangles_at.size()))));
    const double share = random.uniform(0, 1) < 0.3 ? 0 : random.uniform(0, 0.5);
    const abut::Vec3 target = at + share * (surface.vertices[edge->first] - at);
    const abut::Vec3 origin = target - distance * random.uniform(1, 2) * direction;
    const auto towards = abut::UnitVec3::make(target - origin).value();
    ++rays;
    EXPECT_TRUE(shape.cast_ray(origin, towards, abut::infinity)) << "ray " << i << " at vertex " << vertex;
  }
  EXPECT_GT(rays, 5000);
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
      bool apart = t.a == t.b && t.b == t.c;  // a missing one
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
  std::size_t present = 0;
  for (std::size_t k = 0; k < surface.indices.size() / 3; ++k) {
    const Corners t = corners_at(surface, k);
    present += t.a == t.b && t.b == t.c ? 0 : 1;
  }
  EXPECT_EQ(most, present);
}

// Every part that reaches down to a height along a direction, each once; and the lowest of all where the height is
// lowered to that of the lowest so far.
template <class S>
void expect_below(const S& shape, double size, std::uint64_t seed) {
  Random random(seed);
  const abut::Triangles surface = shape.triangles();
  std::size_t visited = 0;
  for (int i = 0; i < 300; ++i) {
    const abut::Vec3 direction = i % 5 == 0 ? axis_vector(i % 3, i % 2 == 0 ? 1 : -1) : random.point(1);
    double limit = random.uniform(-size, size), lowest = abut::infinity;
    std::set<std::uint32_t> expected, got;
    for (std::uint32_t k = 0; k < surface.indices.size() / 3; ++k) {
      const Corners t = corners_at(surface, k);
      const double height = std::fmin(std::fmin(dot(direction, t.a), dot(direction, t.b)), dot(direction, t.c));
      const bool is_missing = t.a == t.b && t.b == t.c;
      lowest = is_missing ? lowest : std::fmin(lowest, height);
      if (height <= limit && !is_missing) {
        expected.insert(k);
      }
    }
    shape.visit_below(direction, limit, [&](const abut::Triangle& part, std::uint32_t index) {
      EXPECT_TRUE(got.insert(index).second) << "part " << index << " comes twice";
      EXPECT_EQ(part.corners()[0], corners_at(surface, index).a);
    });
    EXPECT_EQ(got, expected);
    double reached = abut::infinity;
    shape.visit_below(direction, reached, [&](const abut::Triangle& part, std::uint32_t) {
      ++visited;
      for (const abut::Vec3& corner : part.corners()) {
        reached = std::fmin(reached, dot(direction, corner));
      }
    });
    EXPECT_EQ(reached, lowest);
  }
  // Best first: few of them.
  EXPECT_LT(visited, 300 * (surface.indices.size() / 3) / 2);
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
    if (t.a == t.b && t.b == t.c) {
      continue;
    }
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
