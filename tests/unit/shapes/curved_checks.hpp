// SPDX-License-Identifier: Apache-2.0
// What curved surfaces promise about support points, faces and nearest points, judged by searching them.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <numbers>
#include <utility>
#include <vector>

#include "surface_checks.hpp"

namespace test {

// A piece of a surface over the unit square; the first parameter goes round an axis, or is held within.
using Patch = std::function<abut::Vec3(double, double)>;
struct Surface {
  std::vector<Patch> patches;
  bool is_round = true;
};

// How far a shape reaches from its own origin in a direction of length one.
using OwnReach = std::function<double(const abut::Vec3&)>;

// A ring around Z from one radius and height to another: a disc, a cylinder or a cone.
inline Patch ring(double radius, double height, double other_radius, double other_height) {
  return [=](double around, double share) {
    const double r = (1 - share) * radius + share * other_radius;
    const double angle = 2 * std::numbers::pi * around;
    return abut::Vec3{r * std::cos(angle), r * std::sin(angle), (1 - share) * height + share * other_height};
  };
}

// Everything that shape and surface are known to be.
struct Known {
  Surface surface;
  Outside outside;
  OwnReach reach;
  double size;
};

inline double distance_between(const abut::Vec3& a, const abut::Vec3& b) {
  return std::hypot(a.x - b.x, a.y - b.y, a.z - b.z);
}

// Downhill in smaller and smaller steps.
inline double refined_distance(const Patch& patch, bool is_round, const abut::Vec3& p, double u, double v,
                               double step) {
  double best = distance_between(patch(u, v), p);
  while (step > 1e-9) {
    bool better = false;
    for (int k = 0; k < 8; ++k) {
      const double angle = k * std::numbers::pi / 4, ahead = u + step * std::cos(angle);
      const double to_u = is_round ? ahead : std::clamp(ahead, 0.0, 1.0);
      const double to_v = std::clamp(v + step * std::sin(angle), 0.0, 1.0);
      const double distance = distance_between(patch(to_u, to_v), p);
      if (distance < best) {
        best = distance;
        u = to_u;
        v = to_v;
        better = true;
      }
    }
    step = better ? step : step / 2;
  }
  return best;
}

// From the best points of a grid on every piece.
inline double searched_distance(const Surface& surface, const abut::Vec3& p) {
  constexpr int cells = 24;
  double best = abut::infinity;
  for (const Patch& patch : surface.patches) {
    std::vector<std::pair<double, std::array<double, 2>>> starts;
    for (int i = 0; i <= cells; ++i) {
      for (int k = 0; k <= cells; ++k) {
        const double u = static_cast<double>(i) / cells, v = static_cast<double>(k) / cells;
        starts.push_back({distance_between(patch(u, v), p), {u, v}});
      }
    }
    std::partial_sort(starts.begin(), starts.begin() + 4, starts.end());
    for (std::size_t i = 0; i < 4; ++i) {
      best = std::fmin(
          best, refined_distance(patch, surface.is_round, p, starts[i].second[0], starts[i].second[1], 1.0 / cells));
    }
  }
  return best;
}

// Of length one: any, along the axes, and a little beside the axes.
inline std::vector<abut::Vec3> tried_directions(std::uint64_t seed) {
  Random random(seed);
  std::vector<abut::Vec3> directions;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double sign : {-1.0, 1.0}) {
      directions.push_back(axis_vector(axis, sign));
      for (const double beside : {1e-12, 1e-6, 1e-2}) {
        directions.push_back(abut::UnitVec3::make(axis_vector(axis, sign) + random.point(beside)).value());
      }
    }
  }
  for (int i = 0; i < 500; ++i) {
    directions.push_back(towards(random));
  }
  return directions;
}

// Support points lie on the surface, as far out as it reaches, whatever the length of the direction.
template <class S>
void expect_curved_support(const S& shape, const Known& known, std::uint64_t seed) {
  Random random(seed);
  for (const abut::Vec3& direction : tried_directions(seed)) {
    for (const double length : {1.0, 1e-3, 40.0, 1e-200, 1e70}) {
      const abut::Vec3 point = shape.support(length * direction).point;
      ASSERT_NEAR(dot(point, direction), known.reach(direction), 4e-15 * known.size)
          << "seed " << seed << ", length " << length;
      ASSERT_LE(known.outside(point), 4e-15 * known.size) << "seed " << seed << ", length " << length;
    }
    const abut::Pose pose{random.rotation(), random.point(10)};
    const abut::Vec3 there = placed_support(shape, place(shape, pose), direction).point - pose.position;
    EXPECT_NEAR(dot(there, direction), known.reach(pose.rotation.undo(direction)), 1e-14 * (10 + known.size))
        << "seed " << seed;
  }
  for (int axis = 0; axis < 3; ++axis) {  // zeros of either sign beside the number that counts
    EXPECT_EQ(dot(shape.support(axis_vector(axis, 1)).point, axis_vector(axis, 1)), known.reach(axis_vector(axis, 1)));
    EXPECT_EQ(dot(shape.support(-axis_vector(axis, 1)).point, -axis_vector(axis, 1)),
              known.reach(-axis_vector(axis, 1)));
  }
}

// Faces lie on the surface and are outward, edges and vertices hold a support point; a polygon may cut off
// the part of a rim between two corners.
template <class S>
void expect_curved_faces(const S& shape, const Known& known, double rim_radius, std::uint64_t seed) {
  const double cut = rim_radius * (1 - std::cos(std::numbers::pi / 16));
  for (const abut::Vec3& direction : tried_directions(seed)) {
    for (const double length : {1.0, 1e-200}) {
      const abut::Face face = shape.supporting_face(length * direction);
      const std::size_t count = face.vertices.size();
      ASSERT_GE(count, 1u);
      double top = -abut::infinity;
      for (std::size_t k = 0; k < count; ++k) {
        const abut::FaceVertex &a = face.vertices[k], &b = face.vertices[(k + 1) % count],
                               &c = face.vertices[(k + 2) % count];
        EXPECT_NEAR(known.outside(a.point), 0, 4e-15 * known.size) << "seed " << seed;
        top = std::fmax(top, dot(a.point, direction));
        if (count > 2) {
          EXPECT_GT(dot(face.normal, cross(b.point - a.point, c.point - b.point)), 0);
          EXPECT_NEAR(dot(face.normal, a.point), known.reach(face.normal), 4e-15 * known.size);
        }
      }
      EXPECT_NEAR(dot(face.normal, face.normal), count > 2 ? 1 : 0, 4e-15);
      EXPECT_GE(dot(face.normal, direction), 0);
      EXPECT_LE(top, known.reach(direction) + 4e-15 * known.size);
      EXPECT_GE(top, known.reach(direction) - (count > 2 ? cut : 0) - 4e-15 * known.size) << "seed " << seed;
    }
  }
}

template <class S>
void expect_nearest_at(const S& shape, const Known& known, const abut::Vec3& p) {
  const abut::SurfacePoint found = shape.nearest(p);
  const double slack = 1e-13 * (known.size + norm(p)), magnitude = std::fabs(found.distance);
  SCOPED_TRACE(::testing::Message() << "at (" << p.x << ", " << p.y << ", " << p.z << ")");
  ASSERT_NEAR(dot(found.normal, found.normal), 1, 1e-14);
  ASSERT_NEAR(known.outside(found.point), 0, slack);
  ASSERT_LE(largest_magnitude((p - found.point) - found.distance * found.normal), slack);
  const double out = known.outside(p);
  EXPECT_TRUE(out > slack    ? found.distance > 0
              : out < -slack ? found.distance < 0
                             : magnitude <= 10 * slack)
      << found.distance;
  const double searched = searched_distance(known.surface, p);
  EXPECT_LE(magnitude, searched + slack);
  EXPECT_NEAR(magnitude, searched, 1e-7 * known.size);
  if (found.distance > 1e-3 * known.size) {  // nothing of a convex solid lies further out than its nearest point
    EXPECT_NEAR(dot(found.normal, found.point), known.reach(found.normal), 1e3 * slack);
  }
}

template <class S>
void expect_nearest(const S& shape, const Known& known, std::uint64_t seed) {
  Random random(seed);
  for (int i = 0; i < 150; ++i) {
    SCOPED_TRACE(::testing::Message() << "seed " << seed << ", point " << i);
    expect_nearest_at(shape, known, random.point((i % 3 == 0 ? 0.5 : i % 3 == 1 ? 1 : 3) * known.size));
  }
  // On the surface the normal is outward as well.
  for (const Patch& patch : known.surface.patches) {
    for (int i = 0; i < 100; ++i) {
      const abut::Vec3 p = patch(random.uniform(0, 1), random.uniform(0, 1));
      const abut::SurfacePoint found = shape.nearest(p);
      EXPECT_NEAR(found.distance, 0, 2e-15 * known.size) << "seed " << seed;
      EXPECT_LE(distance_between(found.point, p), 2e-15 * known.size) << "seed " << seed;
      EXPECT_NEAR(dot(found.normal, found.normal), 1, 1e-14);
      EXPECT_NEAR(dot(found.normal, p), known.reach(found.normal), 1e-12 * known.size) << "seed " << seed;
    }
  }
}

inline void expect_same(const abut::SurfacePoint& found, const abut::Vec3& point, const abut::Vec3& normal,
                        double distance) {
  EXPECT_NEAR(found.distance, distance, 1e-15 * (1 + std::fabs(distance)));
  EXPECT_LE(largest_magnitude(found.point - point), 1e-15 * (1 + norm(point)));
  EXPECT_LE(largest_magnitude(found.normal - normal), 1e-15);
}

// Points of a surface with the normals that a ray must face there: two at a rim.
struct Aim {
  abut::Vec3 point, outward, other_outward;
};
using Aiming = std::function<Aim(Random&)>;

// Rays aimed at points of the surface from a distance meet them, and nothing before.
template <class S>
void expect_rays_at(const S& shape, const Aiming& aimed, double distance, double tolerance, std::uint64_t seed) {
  Random random(seed);
  int met = 0;
  for (int i = 0; i < 20000; ++i) {
    const Aim aim = aimed(random);
    const abut::Vec3 direction = towards(random);
    if (dot(direction, aim.outward) > -0.1 || dot(direction, aim.other_outward) > -0.1) {
      continue;
    }
    const auto way = abut::UnitVec3::from_unit_unchecked(direction);
    const auto hit = shape.cast_ray(aim.point - distance * direction, way, abut::infinity);
    ASSERT_TRUE(hit.has_value()) << "seed " << seed << ", ray " << i;
    ASSERT_NEAR(hit->distance, distance, tolerance) << "seed " << seed << ", ray " << i;
    ASSERT_NEAR(dot(hit->normal, hit->normal), 1, 1e-14) << "seed " << seed << ", ray " << i;
    const double agreement = std::fmax(dot(hit->normal, aim.outward), dot(hit->normal, aim.other_outward));
    ASSERT_GE(agreement, 1 - 1e-9) << "seed " << seed << ", ray " << i;
    ++met;
  }
  EXPECT_GT(met, 2000);
}

}  // namespace test
