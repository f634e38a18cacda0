// SPDX-License-Identifier: Apache-2.0
// Distance fields of meshes, judged by closed forms and by all triangles one by one.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "../../random_boxes.hpp"

import abut.capability;
import abut.core;
import abut.math;
import abut.pairs.any_shape;
import abut.pairs.any_shape.field_of_mesh;
import abut.pairs.registry;
import abut.shapes.distance_field;

namespace {

using abut::AnyShape;
using abut::ShapeHandle;
using abut::Vec3;

double from_ball(const Vec3& p) { return norm(p) - 0.8; }

// Stretched, sheared and turned by 140 degrees: all of a lattice.
Vec3 bent(const Vec3& p) {
  const double c = std::cos(2.4), s = std::sin(2.4);
  return {1.3 * (c * p.x - s * p.y) + 0.2 * p.z, 1.3 * (s * p.x + c * p.y), 0.8 * p.z};
}

// A ball of triangles: rings between the poles.
struct Triangles {
  std::vector<double> xyz;
  std::vector<std::uint32_t> indices;
};
Triangles ball_of_triangles(std::uint32_t rings) {
  Triangles out;
  const std::uint32_t around = 2 * rings;
  const double pi = 3.14159265358979323846;
  for (std::uint32_t j = 0; j <= rings; ++j) {
    for (std::uint32_t i = 0; i < around; ++i) {
      const double up = pi * j / rings, turn = 2 * pi * i / around;
      const double across = j == 0 || j == rings ? 0 : 0.8 * std::sin(up);
      out.xyz.insert(out.xyz.end(), {across * std::cos(turn), across * std::sin(turn), -0.8 * std::cos(up)});
      if (j < rings) {
        const std::uint32_t a = j * around + i, b = j * around + (i + 1) % around;
        out.indices.insert(out.indices.end(), {a, b, b + around, a, b + around, a + around});
      }
    }
  }
  return out;
}

double value_of(const AnyShape& field, const Vec3& p) { return field.distance_to(p)->distance; }

TEST(FieldOfMesh, IsTheBallWithinItsTriangles) {
  const Triangles ball = ball_of_triangles(48);
  for (const bool is_smooth : {false, true}) {
    const ShapeHandle field = abut::make_field_of_mesh(ball.xyz, ball.indices, {0.04, 3, false, is_smooth}).value();
    test::Random random(7);
    for (int i = 0; i < 4000; ++i) {
      const Vec3 p = random.point(1.2);
      const double truth = from_ball(p), near = std::fabs(truth) < 0.12 ? 0.2 * 0.04 : 8 * 0.04;
      EXPECT_NEAR(value_of(field, p), truth, near) << p.x << " " << p.y << " " << p.z;
    }
  }
}

// One triangle in eight is gone, one in eight is flipped: signs hold away from the surface.
TEST(FieldOfMesh, DamageLeavesTheSignsWhereTheWindingIsClear) {
  Triangles ball = ball_of_triangles(32);
  std::vector<std::uint32_t> damaged;
  test::Random random(11);
  for (std::size_t i = 0; i < ball.indices.size(); i += 3) {
    const double fate = random.uniform(0, 24);
    if (fate < 1) {
      continue;
    }
    damaged.insert(damaged.end(),
                   {ball.indices[i], ball.indices[fate < 2 ? i + 2 : i + 1], ball.indices[fate < 2 ? i + 1 : i + 2]});
  }
  const ShapeHandle field = abut::make_field_of_mesh(ball.xyz, damaged, {0.05, 3, false, false}).value();
  int judged = 0;
  for (int i = 0; i < 3000; ++i) {
    const Vec3 p = random.point(1);
    if (std::fabs(from_ball(p)) > 0.2) {
      ++judged;
      EXPECT_EQ(value_of(field, p) < 0, from_ball(p) < 0) << p.x << " " << p.y << " " << p.z;
    }
  }
  EXPECT_GT(judged, 1000);
}

// Of a point from a triangle: the nearest of its plane, where that is in the triangle, and of its edges.
double from_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  double least = abut::infinity;
  const std::array<std::pair<const Vec3*, const Vec3*>, 3> edges{{{&a, &b}, {&b, &c}, {&c, &a}}};
  const Vec3 normal = cross(b - a, c - a);
  bool is_over = true;
  for (const auto& [from, to] : edges) {
    const Vec3 edge = *to - *from;
    const double at = std::clamp(dot(p - *from, edge) / dot(edge, edge), 0.0, 1.0);
    least = std::fmin(least, norm(p - (*from + at * edge)));
    is_over = is_over && dot(cross(normal, edge), p - *from) >= 0;
  }
  return is_over ? std::fabs(dot(normal, p - a)) / norm(normal) : least;
}
// Negative inside a ball of triangles that is convex.
double from_triangles(const Vec3& p, const Triangles& ball) {
  double least = abut::infinity;
  bool is_inside = true;
  const auto corner = [&](std::size_t i) {
    const std::size_t at = 3 * std::size_t{ball.indices[i]};
    return Vec3{ball.xyz[at], ball.xyz[at + 1], ball.xyz[at + 2]};
  };
  for (std::size_t i = 0; i < ball.indices.size(); i += 3) {
    const Vec3 a = corner(i), b = corner(i + 1), c = corner(i + 2), normal = cross(b - a, c - a);
    if (norm(normal) > 1e-12) {
      least = std::fmin(least, from_triangle(p, a, b, c));
      is_inside = is_inside && dot(normal, p - a) < 0;
    }
  }
  return is_inside ? -least : least;
}

// Near the surface it is the field that all distances make, found by looking at all triangles. So are the fringes of
// blocks, whose neighbours hold samples or do not.
TEST(FieldOfMesh, NearTheSurfaceItIsMadeOfAllDistances) {
  const Triangles ball = ball_of_triangles(9);
  for (const bool is_smooth : {false, true}) {
    const ShapeHandle found = abut::make_field_of_mesh(ball.xyz, ball.indices, {0.07, 1, false, is_smooth}).value();
    const auto& field = std::get<abut::DistanceField>(*found);
    ASSERT_LT(field.held_blocks(), field.all_blocks());
    const std::vector<double> parameters = field.parameters();
    std::vector<double> values;
    for (double k = 0; k < parameters[2]; ++k) {
      for (double j = 0; j < parameters[1]; ++j) {
        for (double i = 0; i < parameters[0]; ++i) {
          values.push_back(from_triangles(Vec3{parameters[6] + i * parameters[3], parameters[7] + j * parameters[4],
                                               parameters[8] + k * parameters[5]},
                                          ball));
        }
      }
    }
    const abut::DistanceField whole = abut::DistanceField::make(parameters, values, {}).value();
    test::Random random(13);
    int near = 0;
    for (int i = 0; i < 20000; ++i) {
      const Vec3 p = random.point(0.95);
      if (std::fabs(whole.value_at(p).value) < 0.5 * 0.07) {
        ++near;
        EXPECT_NEAR(field.value_at(p).value, whole.value_at(p).value, 1e-6);
        EXPECT_NEAR(norm(field.value_at(p).gradient - whole.value_at(p).gradient), 0, 1e-4);
      }
    }
    EXPECT_GT(near, 500);
    // What is saved makes the same field.
    const abut::Buffers buffers = field.buffers();
    const abut::DistanceField again = abut::DistanceField::make(parameters, buffers.reals, buffers.indices).value();
    for (int i = 0; i < 2000; ++i) {
      const Vec3 p = random.point(1.5);
      EXPECT_EQ(again.value_at(p).value, field.value_at(p).value);
      EXPECT_EQ(again.value_at(p).gradient, field.value_at(p).gradient);
    }
    EXPECT_EQ(again.least_within(0, 1), field.least_within(0, 1));
    EXPECT_EQ(again.surface().points, field.surface().points);
  }
}

// Against all triangles, near the surface and far from it, inside and outside.
TEST(FieldOfMesh, ValuesAreOffByNoMoreThanReported) {
  const Triangles ball = ball_of_triangles(9);
  for (const bool is_smooth : {false, true}) {
    const ShapeHandle found = abut::make_field_of_mesh(ball.xyz, ball.indices, {0.03, 1, false, is_smooth}).value();
    const abut::FieldReport report = abut::field_report_of(found).value();
    const auto& field = std::get<abut::DistanceField>(*found);
    EXPECT_EQ(report.is_smooth, is_smooth);
    EXPECT_LT(report.held_blocks, report.blocks);
    EXPECT_NEAR(report.near_error, 0.5 * std::sqrt(3.0) * 0.03, 1e-6);
    EXPECT_NEAR(report.far_error, 8 * report.near_error, 1e-6);
    EXPECT_EQ(report.least_stretch, 1);
    test::Random random(17);
    double worst_near = 0, worst_far = 0;
    for (int i = 0; i < 4000; ++i) {
      const Vec3 p = random.point(0.88);
      const double truth = from_triangles(p, ball), off = std::fabs(field.value_at(p).value - truth);
      // Blocks within a cell of the surface hold samples.
      double& worst = std::fabs(truth) < 0.03 ? worst_near : worst_far;
      worst = std::fmax(worst, off);
    }
    EXPECT_LE(worst_near, report.near_error);
    EXPECT_LE(worst_far, report.far_error);
    EXPECT_GT(worst_far, report.near_error);
  }
  EXPECT_FALSE(abut::field_report_of(abut::make_shape(*abut::find_kind("sphere"), std::vector{1.0}, {}, {}).value())
                   .has_value());
}

// Blocks without samples say nothing about the surface, and rays pass through them in long steps.
TEST(FieldOfMesh, RaysMeetItWhereItIsBent) {
  const Triangles ball = ball_of_triangles(32);
  const ShapeHandle made_of_mesh = abut::make_field_of_mesh(ball.xyz, ball.indices, {0.03, 1, false, false}).value();
  const auto& rest = std::get<abut::DistanceField>(*made_of_mesh);
  std::vector<double> parameters = rest.parameters(), reals = rest.buffers().reals;
  for (int i = 0; i < 8; ++i) {
    const auto along = [&](std::size_t axis, bool is_upper) {
      return parameters[6 + axis] + (is_upper ? (parameters[axis] - 1) * parameters[3 + axis] : 0);
    };
    const Vec3 p = bent({along(0, (i & 1) != 0), along(1, (i & 2) != 0), along(2, (i & 4) != 0)});
    reals.insert(reals.end(), {p.x, p.y, p.z});
  }
  parameters[11] = parameters[12] = parameters[13] = 2;
  const auto field = abut::DistanceField::make(parameters, reals, rest.buffers().indices).value();
  ASSERT_LT(field.held_blocks(), field.all_blocks());
  test::Random random(19);
  int hits = 0;
  for (int i = 0; i < 400; ++i) {
    const Vec3 from = random.point(2), to = random.point(1), way = (1 / norm(to - from)) * (to - from);
    const double along = dot(from, way), square = along * along - dot(from, from) + 0.64;
    if (std::fabs(square) < 0.1 || std::fabs(from_ball(from)) < 0.03) {
      continue;
    }
    const double root = square > 0 ? std::sqrt(square) : -1;
    const double truth = -along - root >= 0 ? -along - root : -along + root;
    const Vec3 origin = bent(from), target = bent(from + way);
    const auto hit = field.cast_ray(origin, abut::UnitVec3::make(target - origin).value(), abut::infinity);
    ASSERT_EQ(hit.has_value(), square > 0 && truth >= 0) << i;
    if (hit) {
      ++hits;
      EXPECT_NEAR(hit->distance / norm(target - origin), truth, 0.02) << i;
    }
  }
  EXPECT_GT(hits, 50);
}

TEST(FieldOfMesh, BadInputIsRefusedByName) {
  const std::vector<double> xyz{0, 0, 0, 1, 0, 0, 0, 1, 0};
  const auto message = [](const std::vector<double>& points, const std::vector<std::uint32_t>& indices,
                          const abut::FieldOptions& options) {
    const abut::Result<ShapeHandle> made = abut::make_field_of_mesh(points, indices, options);
    return made ? std::string("none") : made.error().message;
  };
  EXPECT_EQ(message({}, {0, 1, 2}, {}), "vertex_count is 0; a distance field of a mesh needs vertices");
  EXPECT_EQ(message(xyz, {}, {}), "triangle_count is 0; a distance field of a mesh needs at least one triangle");
  EXPECT_EQ(message(xyz, {0, 1, 3}, {}), "triangles[2] is 3; it must be below vertex_count, which is 3");
  EXPECT_EQ(message(xyz, {0, 1, 2}, {-1, 3, false, false}), "options.spacing is -1; it must be zero or positive");
  EXPECT_EQ(message(xyz, {0, 1, 2}, {0, -2, false, false}), "options.band is -2; it must be zero or positive");
  EXPECT_EQ(message(xyz, {0, 1, 2}, {1e-6, 3, false, false}).substr(0, 15), "options.spacing");
  EXPECT_EQ(message(xyz, {0, 1, 2}, {1e40, 3, false, false}).substr(0, 24), "the diagonal of the grid");
  EXPECT_EQ(message(xyz, {0, 0, 0}, {}).substr(0, 40), "triangles names one vertex three times i");
  EXPECT_EQ(message({1, 2, 3, 1, 2, 3, 1, 2, 3}, {0, 1, 2}, {}).substr(0, 31), "the triangles have no extent; a");
  EXPECT_EQ(message(xyz, {0, 1, 2}, {0.05, 3, false, false}).substr(0, 28), "triangles enclose no sample;");
}

}  // namespace
