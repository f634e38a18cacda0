// SPDX-License-Identifier: Apache-2.0
// Two surfaces that move and turn, against all their triangles two by two: corners from faces, edges from edges, and
// edges through faces. Nothing touches before the interval, and at its end something does.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

#include "../../damaged_meshes.hpp"

import abut.capability;
import abut.math;
import abut.math.turn;
import abut.motion.paths.path;
import abut.motion.time_of_impact;
import abut.pairs.any_shape;

namespace {

using namespace abut;
using Corners = std::array<Vec3, 3>;

Real from_segment(const Vec3& point, const Vec3& p, const Vec3& u) {
  return norm(p + std::clamp(dot(point - p, u) / dot(u, u), 0.0, 1.0) * u - point);
}

Real between_edges(const Vec3& p, const Vec3& u, const Vec3& q, const Vec3& v) {
  Real least =
      std::min({from_segment(p, q, v), from_segment(p + u, q, v), from_segment(q, p, u), from_segment(q + v, p, u)});
  const Vec3 w = p - q;
  const Real a = dot(u, u), b = dot(u, v), c = dot(v, v), determinant = a * c - b * b;
  if (determinant > 0) {
    const Real s = (b * dot(v, w) - c * dot(u, w)) / determinant, t = (a * dot(v, w) - b * dot(u, w)) / determinant;
    if (s >= 0 && s <= 1 && t >= 0 && t <= 1) {
      least = std::min(least, norm(w + s * u - t * v));
    }
  }
  return least;
}

bool is_over(const Corners& face, const Vec3& point) {
  const Vec3 n = cross(face[1] - face[0], face[2] - face[0]);
  bool is_inside = true;
  for (std::size_t i = 0; i < 3; ++i) {
    is_inside = is_inside && dot(n, cross(face[(i + 1) % 3] - face[i], point - face[i])) >= 0;
  }
  return is_inside;
}

// Of corners over the face, and zero where an edge goes through it.
Real from_face(const Corners& face, const Corners& other) {
  const Vec3 n = UnitVec3::make(cross(face[1] - face[0], face[2] - face[0])).value();
  Real least = infinity;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 &p = other[i], &q = other[(i + 1) % 3];
    const Real height = dot(n, p - face[0]), next = dot(n, q - face[0]);
    if (is_over(face, p)) {
      least = std::min(least, std::fabs(height));
    }
    if ((height < 0) != (next < 0) && is_over(face, p + (height / (height - next)) * (q - p))) {
      return 0;
    }
  }
  return least;
}

Real between_triangles(const Corners& a, const Corners& b) {
  Real least = std::min(from_face(a, b), from_face(b, a));
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      least = std::min(least, between_edges(a[i], a[(i + 1) % 3] - a[i], b[k], b[(k + 1) % 3] - b[k]));
    }
  }
  return least;
}

std::vector<Corners> placed(const test::Surface& surface, const Pose& pose) {
  std::vector<Corners> out;
  for (std::size_t triangle = 0; triangle < surface.triangle_count(); ++triangle) {
    Corners& corners = out.emplace_back();
    for (std::size_t i = 0; i < 3; ++i) {
      const auto at = surface.corner(triangle, i);
      corners[i] = pose * Vec3{at[0], at[1], at[2]};
    }
  }
  return out;
}

Real gap_of(const test::Surface& a, const Pose& pose_a, const test::Surface& b, const Pose& pose_b) {
  const std::vector<Corners> all_a = placed(a, pose_a), all_b = placed(b, pose_b);
  Real least = infinity;
  for (const Corners& of_a : all_a) {
    const Aabb box = Aabb{minimum(minimum(of_a[0], of_a[1]), of_a[2]), maximum(maximum(of_a[0], of_a[1]), of_a[2])};
    for (const Corners& of_b : all_b) {
      const Aabb other{minimum(minimum(of_b[0], of_b[1]), of_b[2]), maximum(maximum(of_b[0], of_b[1]), of_b[2])};
      if (box.inflated(std::min(least, 10.0)).overlaps(other)) {
        least = std::min(least, between_triangles(of_a, of_b));
      }
    }
  }
  return least;
}

ShapeHandle mesh_of(const test::Surface& surface) {
  return make_shape(find_kind("mesh").value(), std::vector{0.0}, surface.xyz, surface.triangles).value();
}

struct Random {
  std::mt19937 engine;

  Real number(Real low, Real high) { return std::uniform_real_distribution<Real>(low, high)(engine); }
  Vec3 vector(Real size) { return {number(-size, size), number(-size, size), number(-size, size)}; }
};

TEST(MovingSurfaces, TouchWhenTheFirstOfAllTrianglesDo) {
  constexpr unsigned seed = 23;
  RecordProperty("seed", static_cast<int>(seed));
  Random random{std::mt19937(seed)};
  const test::Surface a = test::torus(1, 0.4, 11, 7), b = test::torus(0.7, 0.2, 9, 5);
  const ShapeHandle shape_a = mesh_of(a), shape_b = mesh_of(b);
  int touches = 0;
  for (int flight = 0; flight < 60; ++flight) {
    const auto path = [&](const Vec3& place, const Vec3& velocity) {
      const Motion motion{velocity, random.vector(flight % 3 == 0 ? 8 : 2), random.vector(0.5), random.vector(1)};
      return Path::along({rotation_by(random.vector(3)), place}, random.vector(0.2), motion, 1).value();
    };
    const Vec3 away = 2.6 * UnitVec3::make(random.vector(1)).value();
    const Path path_a = path({0, 0, 0}, random.vector(0.3));
    const Path path_b = path(away, -1.4 * away + random.vector(3));
    Impact found, swapped;
    ASSERT_EQ(time_of_impact({shape_a, path_a}, {shape_b, path_b}, {}, found), Outcome::ok);
    ASSERT_EQ(time_of_impact({shape_b, path_b}, {shape_a, path_a}, {}, swapped), Outcome::ok);
    EXPECT_EQ(found.state, swapped.state) << flight;
    EXPECT_EQ(found.lower, swapped.lower) << flight;
    EXPECT_EQ(found.upper, swapped.upper) << flight;
    ASSERT_NE(found.state, ImpactState::undecided) << flight;
    const Real free = found.state == ImpactState::apart ? 1 : found.lower;
    const auto gap = [&](Real time) { return gap_of(a, path_a.at(time), b, path_b.at(time)); };
    constexpr int samples = 12;
    for (int k = 0; k < samples; ++k) {
      EXPECT_GT(gap(free * k / samples), 0) << flight;
    }
    // Nearly at the touch, where a later one would show.
    EXPECT_GT(gap(free - 1e-9), 0) << flight;
    if (found.state == ImpactState::touches) {
      EXPECT_LE(gap(found.upper), 1e-11) << flight;
      ++touches;
    }
  }
  EXPECT_GT(touches, 25);
  EXPECT_LT(touches, 60);
}

// In a span the ways of corners are bent, and most of all where bodies turn far.
TEST(MovingSurfaces, AreMetWhereOnlyATurnBringsThemTogether) {
  const test::Surface blade{{0, -0.1, 0, 3, -0.1, 0, 3, 0.1, 0, 0, 0.1, 0}, {0, 1, 2, 0, 2, 3}};
  const test::Surface post{{-0.05, 0, -1, 0.05, 0, -1, 0, 0, 1}, {0, 1, 2}};
  const Path turning = Path::along(Pose::identity(), {0, 0, 0}, {.angular_velocity = {0, 0, 6}}, 1).value();
  const Path still = Path::at_rest({Rotation::identity(), {-2, 0.5, 0}}, 1);
  Impact found;
  ASSERT_EQ(time_of_impact({mesh_of(blade), turning}, {mesh_of(post), still}, {}, found), Outcome::ok);
  ASSERT_EQ(found.state, ImpactState::touches);
  EXPECT_GT(gap_of(blade, turning.at(found.lower - 1e-9), post, still.at(0)), 0);
  EXPECT_LE(gap_of(blade, turning.at(found.upper), post, still.at(0)), 1e-11);
  EXPECT_GT(found.upper, 0.45);
  EXPECT_LT(found.upper, 0.55);
}

// The tip of a blade swings through a wall and is out of it again at the end. At both ends of the way there is a gap
// between all boxes, along the normal of the wall: only the bend of the way leads into it.
TEST(MovingSurfaces, AreMetWhereAWayOnlyBendsIntoAnother) {
  constexpr Real length = 3, depth = 0.03, turned = 0.4;
  const test::Surface blade{{0, -0.01, 0, 0, 0.01, 0, length, 0, 0}, {0, 1, 2}};
  const Real x = length - depth;
  const test::Surface wall{{x, -2, -2, x, 2, -2, x, 2, 2, x, -2, 2}, {0, 1, 2, 0, 2, 3}};
  const Path still = Path::at_rest(Pose::identity(), 1);
  const Real touch = std::acos(x / length);
  for (int i = 0; i <= 18; ++i) {
    const Real before = 0.16 + 0.02 * i;
    const Pose start{rotation_by({0, 0, -before}), {0, 0, 0}};
    const Path swing = Path::along(start, {0, 0, 0}, {.angular_velocity = {0, 0, turned}}, 1).value();
    Impact found, swapped;
    ASSERT_EQ(time_of_impact({mesh_of(blade), swing}, {mesh_of(wall), still}, {}, found), Outcome::ok);
    ASSERT_EQ(time_of_impact({mesh_of(wall), still}, {mesh_of(blade), swing}, {}, swapped), Outcome::ok);
    ASSERT_EQ(found.state, ImpactState::touches) << before;
    ASSERT_EQ(swapped.state, ImpactState::touches) << before;
    EXPECT_NEAR(found.upper, (before - touch) / turned, 1e-9) << before;
    EXPECT_NEAR(swapped.upper, (before - touch) / turned, 1e-9) << before;
  }
}

}  // namespace
