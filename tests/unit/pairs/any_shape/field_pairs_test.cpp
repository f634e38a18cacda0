// SPDX-License-Identifier: Apache-2.0
// Distance fields against all kinds. What answers are judged by: closed forms, and points all over the other shape.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "../../random_boxes.hpp"

import abut.capability;
import abut.core;
import abut.math;
import abut.pairs.any_shape;
import abut.pairs.any_shape.field_of_mesh;
import abut.pairs.any_shape.shape_cast;
import abut.pairs.registry;

namespace {

using abut::AnyShape;
using abut::Outcome;
using abut::Pose;
using abut::Vec3;

AnyShape made(std::string_view kind, const std::vector<double>& parameters, const std::vector<double>& reals = {},
              const std::vector<std::uint32_t>& indices = {}) {
  return abut::make_shape(*abut::find_kind(kind), parameters, reals, indices).value();
}

constexpr double cell = 0.0625;
constexpr std::uint32_t samples = 41;

// Of a function of the distance, on a grid around the origin.
template <class ValueOf>
AnyShape field_of(ValueOf&& value_of, bool is_inside_out = false) {
  const double low = -0.5 * (samples - 1) * cell;
  std::vector<double> values;
  for (std::uint32_t k = 0; k < samples; ++k) {
    for (std::uint32_t j = 0; j < samples; ++j) {
      for (std::uint32_t i = 0; i < samples; ++i) {
        values.push_back(value_of(Vec3{low + i * cell, low + j * cell, low + k * cell}));
      }
    }
  }
  return made("distance_field", {samples, samples, samples, cell, cell, cell, low, low, low, is_inside_out ? 1.0 : 0.0},
              values);
}
double from_ball(const Vec3& p) { return norm(p) - 0.8; }
double from_slab(const Vec3& p) {
  const Vec3 out = absolute(p) - Vec3{1, 0.9, 0.25};
  return norm(maximum(out, Vec3{0, 0, 0})) + std::fmin(std::fmax(out.x, std::fmax(out.y, out.z)), 0.0);
}
double from_torus(const Vec3& p) { return std::hypot(std::hypot(p.x, p.y) - 0.7, p.z) - 0.3; }

abut::Distance distance(const AnyShape& a, const AnyShape& b, const Pose& ab) {
  abut::Distance out{};
  EXPECT_EQ(abut::pair_distance(a, b, ab, {}, out), Outcome::ok);
  return out;
}
abut::Manifold contacts(const AnyShape& a, const AnyShape& b, const Pose& ab, double margin = 0) {
  abut::Manifold out;
  EXPECT_EQ(abut::pair_contacts(a, b, ab, {.margin = margin}, out), Outcome::ok);
  return out;
}
Pose placed(test::Random& random, double by) {
  const abut::Quat turn{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
  return {abut::Rotation::from(turn), random.point(by)};
}

// A shape with a test of its own of which points are in it.
struct Solid {
  AnyShape shape;
  double reach;   // half of the box that holds it
  double radius;  // around its core
  bool (*holds)(const Vec3& p);
};
std::vector<Solid> solids() {
  std::vector<double> corners;
  for (const Vec3& p :
       {Vec3{0.5, 0, 0}, Vec3{-0.5, 0, 0}, Vec3{0, 0.5, 0}, Vec3{0, -0.5, 0}, Vec3{0, 0, 0.5}, Vec3{0, 0, -0.5}}) {
    corners.insert(corners.end(), {p.x, p.y, p.z});
  }
  return {{made("sphere", {0.3}), 0.3, 0.3, [](const Vec3& p) { return norm(p) <= 0.3; }},
          {made("box", {0.4, 0.3, 0.2}), 0.4, 0,
           [](const Vec3& p) { return std::fabs(p.x) <= 0.4 && std::fabs(p.y) <= 0.3 && std::fabs(p.z) <= 0.2; }},
          {made("capsule", {0.15, 0.3}), 0.45, 0.15,
           [](const Vec3& p) { return norm(p - Vec3{0, 0, std::clamp(p.z, -0.3, 0.3)}) <= 0.15; }},
          {made("cylinder", {0.3, 0.2}), 0.3, 0,
           [](const Vec3& p) { return std::hypot(p.x, p.y) <= 0.3 && std::fabs(p.z) <= 0.2; }},
          {made("cone", {0.3, 0.3}), 0.3, 0,
           [](const Vec3& p) { return std::fabs(p.z) <= 0.3 && std::hypot(p.x, p.y) <= 0.5 * (0.3 - p.z); }},
          {made("ellipsoid", {0.4, 0.3, 0.2}), 0.4, 0,
           [](const Vec3& p) { return norm(Vec3{p.x / 0.4, p.y / 0.3, p.z / 0.2}) <= 1; }},
          {made("hull", {}, corners), 0.5, 0,
           [](const Vec3& p) { return std::fabs(p.x) + std::fabs(p.y) + std::fabs(p.z) <= 0.5; }}};
}

// The least true distance of points all over a solid.
template <class ValueOf>
double least_of_points(const Solid& solid, const Pose& pose, ValueOf&& value_of) {
  constexpr int steps = 24;
  double least = abut::infinity;
  for (int i = 0; i <= steps; ++i) {
    for (int j = 0; j <= steps; ++j) {
      for (int k = 0; k <= steps; ++k) {
        const Vec3 p = solid.reach * Vec3{2.0 * i / steps - 1, 2.0 * j / steps - 1, 2.0 * k / steps - 1};
        least = solid.holds(p) ? std::min(least, value_of(pose * p)) : least;
      }
    }
  }
  return least;
}

template <class ValueOf>
void expect_deepest_point(ValueOf&& value_of, std::uint64_t seed) {
  const AnyShape field = field_of(value_of);
  test::Random random(seed);
  int apart = 0, deep = 0;
  for (const Solid& solid : solids()) {
    for (int i = 0; i < 25; ++i) {
      const Pose pose = placed(random, 1.1);
      const abut::Distance found = distance(field, solid.shape, pose);
      const double least = least_of_points(solid, pose, value_of), spread = 0.5 * solid.reach * 2 / 24 * 1.8;
      const std::string what = "seed " + std::to_string(seed) + " pose " + std::to_string(i);
      (found.distance > 0 ? apart : deep) += 1;
      // Half a cell for the field; what lies between the points is found, too.
      EXPECT_LE(found.distance, least + 0.5 * cell) << what;
      // A radius has to come out after its core, also where the solid is thinner.
      EXPECT_GE(found.distance, least - 0.5 * cell - spread - (least < 0 ? solid.radius : 0)) << what;
      EXPECT_LE(found.lower, found.distance) << what;
      EXPECT_GE(found.upper, found.distance) << what;
      EXPECT_NEAR(dot(found.point_b - found.point_a, found.normal), found.distance, 1e-9) << what;
      if (least > 0) {
        EXPECT_LE(found.lower, least + 0.5 * cell) << what;
      }
      const abut::Manifold manifold = contacts(field, solid.shape, pose, 0.01);
      double deepest = abut::infinity;
      for (const abut::ContactPoint& contact : manifold) {
        deepest = std::min(deepest, contact.distance);
        EXPECT_NEAR(norm(contact.point_b - contact.point_a - contact.distance * contact.normal), 0, 1e-9) << what;
        EXPECT_NEAR(value_of(contact.point_a), 0, 0.5 * cell) << what;
      }
      EXPECT_EQ(manifold.empty(), found.distance > 0.01) << what << " at " << found.distance;
      if (!manifold.empty()) {
        EXPECT_NEAR(deepest, found.distance, 0.5 * cell) << what;
      }
    }
  }
  EXPECT_GT(apart, 20);
  EXPECT_GT(deep, 20);
}

TEST(FieldPairs, FindTheDeepestPointOfConvexShapes) {
  expect_deepest_point(from_ball, 1);
  expect_deepest_point(from_slab, 2);
  expect_deepest_point(from_torus, 3);
}

// Four corners of a box that lies flat, each as deep as the box.
TEST(FieldPairs, ABoxRestsOnFourCorners) {
  const AnyShape field = field_of(from_slab), box = made("box", {0.4, 0.3, 0.2});
  const abut::Manifold manifold = contacts(field, box, {abut::Rotation::identity(), {0.1, 0.05, 0.44}});
  ASSERT_EQ(manifold.size(), 4U);
  for (const abut::ContactPoint& contact : manifold) {
    EXPECT_NEAR(contact.distance, -0.01, 1e-6);
    EXPECT_NEAR(contact.normal.z, 1, 1e-9);
    EXPECT_NEAR(std::fabs(contact.point_b.x - 0.1), 0.4, 1e-12);
    EXPECT_NEAR(std::fabs(contact.point_b.y - 0.05), 0.3, 1e-12);
  }
}

// A beam over a ring touches it on both sides.
TEST(FieldPairs, EveryDeepestPointIsAContact) {
  const AnyShape ring = field_of(from_torus), beam = made("capsule", {0.1, 1});
  const Pose along_x{abut::Rotation::from({std::sqrt(0.5), 0, std::sqrt(0.5), 0}), {0, 0, 0.38}};
  const abut::Manifold manifold = contacts(ring, beam, along_x);
  int left = 0, right = 0;
  for (const abut::ContactPoint& contact : manifold) {
    left += contact.point_b.x < -0.5 ? 1 : 0;
    right += contact.point_b.x > 0.5 ? 1 : 0;
    EXPECT_NEAR(contact.distance, -0.02, 0.02);
  }
  EXPECT_GE(left, 1);
  EXPECT_GE(right, 1);
}

TEST(FieldPairs, TwoBallsAsFieldsAgreeWithTheClosedForm) {
  const AnyShape ball = field_of(from_ball);
  test::Random random(5);
  for (int i = 0; i < 40; ++i) {
    const Pose pose = placed(random, 1.5);
    const double truth = norm(pose.position) - 1.6;
    const abut::Distance found = distance(ball, ball, pose);
    if (norm(pose.position) < 0.5) {
      continue;  // deepest points all around
    }
    EXPECT_LE(found.lower, truth + cell) << i;
    if (truth > 0) {
      EXPECT_NEAR(found.distance, truth, cell) << i;
      EXPECT_GE(found.upper, truth - 0.1 * cell) << i;
    } else {
      // The depth of the deepest point of the other ball.
      EXPECT_NEAR(found.distance, std::max(truth, -0.8), cell) << i;
    }
    EXPECT_EQ(contacts(ball, ball, pose).empty(), found.distance > 0) << i;
  }
}

TEST(FieldPairs, PlanesMeetTheLowestPoints) {
  const AnyShape slab = field_of(from_slab), plane = made("plane", {0, 0, 1, 0});
  const Pose above{abut::Rotation::identity(), {0, 0, 0.24}};
  EXPECT_NEAR(distance(plane, slab, above).distance, -0.01, 1e-6);
  const abut::Manifold manifold = contacts(plane, slab, above);
  Vec3 low{abut::infinity, abut::infinity, 0}, high = -low;
  for (const abut::ContactPoint& contact : manifold) {
    low = minimum(low, contact.point_b);
    high = maximum(high, contact.point_b);
    EXPECT_NEAR(contact.distance, -0.01, 1e-2);
  }
  // They span the lower face but for a cell.
  EXPECT_LT(low.x, -1 + cell);
  EXPECT_GT(high.y, 0.9 - cell);
  EXPECT_NEAR(distance(plane, slab, {abut::Rotation::identity(), {0, 0, 1}}).distance, 0.75, 1e-6);
}

TEST(FieldPairs, SurfacesMeetFieldsTriangleByTriangle) {
  const AnyShape ball = field_of(from_ball);
  const AnyShape sheet = made("mesh", {0}, {-2, -2, 0, 2, -2, 0, 2, 2, 0, -2, 2, 0}, {0, 1, 2, 0, 2, 3});
  const AnyShape ground = made("height_field", {2, 2, 4, 4}, {0, 0, 0, 0});
  const Pose above{abut::Rotation::identity(), {0.1, 0.2, -0.75}}, corner{above.rotation, {-1.9, -1.8, -0.75}};
  EXPECT_NEAR(distance(ball, sheet, above).distance, -0.05, 0.3 * cell);
  EXPECT_NEAR(distance(ball, ground, corner).distance, -0.05, 0.3 * cell);
  for (const auto& [surface, pose] : {std::pair(&sheet, &above), std::pair(&ground, &corner)}) {
    const abut::Manifold manifold = contacts(ball, *surface, *pose);
    ASSERT_FALSE(manifold.empty());
    for (const abut::ContactPoint& contact : manifold) {
      EXPECT_LT(contact.normal.z, -0.98);
      EXPECT_NEAR(contact.distance, -0.05, 0.5 * cell);
    }
  }
  // From behind terrain stops nothing.
  EXPECT_TRUE(contacts(ball, ground, {above.rotation, {-1.9, -1.8, 0.75}}).empty());
  EXPECT_NEAR(distance(ball, sheet, {above.rotation, {0, 0, -1.5}}).distance, 0.7, 0.3 * cell);
}

TEST(FieldPairs, ParticlesAndChildrenMeetFieldsOneByOne) {
  const AnyShape slab = field_of(from_slab);
  const AnyShape balls = made("particles", {0.1}, {0, 0, 0, 0.5, 0, 0, 0.5, 0.5, 1});
  const abut::Manifold manifold = contacts(slab, balls, {abut::Rotation::identity(), {0, 0, 0.34}});
  ASSERT_EQ(manifold.size(), 2U);
  for (const abut::ContactPoint& contact : manifold) {
    EXPECT_NEAR(contact.distance, -0.01, 1e-6);
    EXPECT_EQ(contact.feature_b.kind, abut::FeatureKind::particle);
  }
}

// What lies in a container touches its wall where it comes near.
TEST(FieldPairs, AContainerHoldsWhatIsInIt) {
  const AnyShape container = field_of(from_ball, true), ball = made("sphere", {0.3});
  const auto at = [](double x) { return Pose{abut::Rotation::identity(), {x, 0, 0}}; };
  EXPECT_NEAR(distance(container, ball, at(0.4)).distance, 0.1, 0.3 * cell);
  EXPECT_NEAR(distance(container, ball, at(0.55)).distance, -0.05, 0.3 * cell);
  EXPECT_TRUE(contacts(container, ball, at(0.4)).empty());
  const abut::Manifold manifold = contacts(container, ball, at(0.55));
  ASSERT_EQ(manifold.size(), 1U);
  EXPECT_LT(manifold[0].normal.x, -0.99);
  EXPECT_LT(distance(container, ball, at(3)).distance, -2);
  abut::Distance out{};
  EXPECT_EQ(abut::pair_distance(container, container, at(0.1), {}, out), Outcome::unsupported);
  EXPECT_EQ(abut::pair_distance(made("plane", {0, 0, 1, 0}), container, at(0), {}, out), Outcome::unsupported);
}

TEST(FieldPairs, ACastStopsAtTheSurface) {
  const AnyShape slab = field_of(from_slab), ball = made("sphere", {0.2});
  std::optional<abut::ShapeCastHit> hit;
  ASSERT_EQ(abut::cast_shapes(slab, Pose::identity(), {0, 0, 0}, ball, {abut::Rotation::identity(), {0.1, 0.2, 2}},
                              {0, 0, -4}, {}, 1, hit),
            Outcome::ok);
  ASSERT_TRUE(hit.has_value());
  EXPECT_NEAR(hit->fraction, (2 - 0.45) / 4, 1e-6);
  EXPECT_NEAR(hit->contact.normal.z, 1, 1e-6);
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
  const AnyShape field = abut::make_field_of_mesh(ball.xyz, ball.indices, {0.04, 3, false}).value();
  test::Random random(7);
  for (int i = 0; i < 4000; ++i) {
    const Vec3 p = random.point(1.2);
    const double truth = from_ball(p), near = std::fabs(truth) < 0.12 ? 0.2 * 0.04 : 8 * 0.04;
    EXPECT_NEAR(value_of(field, p), truth, near) << p.x << " " << p.y << " " << p.z;
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
  const AnyShape field = abut::make_field_of_mesh(ball.xyz, damaged, {0.05, 3, false}).value();
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

TEST(FieldOfMesh, BadInputIsRefusedByName) {
  const std::vector<double> xyz{0, 0, 0, 1, 0, 0, 0, 1, 0};
  const auto message = [](const std::vector<double>& points, const std::vector<std::uint32_t>& indices,
                          const abut::FieldOptions& options) {
    const abut::Result<AnyShape> made = abut::make_field_of_mesh(points, indices, options);
    return made ? std::string("none") : made.error().message;
  };
  EXPECT_EQ(message({}, {0, 1, 2}, {}), "vertex_count is 0; a distance field of a mesh needs vertices");
  EXPECT_EQ(message(xyz, {}, {}), "triangle_count is 0; a distance field of a mesh needs at least one triangle");
  EXPECT_EQ(message(xyz, {0, 1, 3}, {}), "triangles[2] is 3; it must be below vertex_count, which is 3");
  EXPECT_EQ(message(xyz, {0, 1, 2}, {-1, 3, false}), "options.spacing is -1; it must be zero or positive");
  EXPECT_EQ(message(xyz, {0, 1, 2}, {0, -2, false}), "options.band is -2; it must be zero or positive");
  EXPECT_EQ(message(xyz, {0, 1, 2}, {1e-6, 3, false}).substr(0, 15), "options.spacing");
  EXPECT_EQ(message(xyz, {0, 0, 0}, {}).substr(0, 40), "triangles names one vertex three times i");
  EXPECT_EQ(message({1, 2, 3, 1, 2, 3, 1, 2, 3}, {0, 1, 2}, {}).substr(0, 31), "the triangles have no extent; a");
  EXPECT_EQ(message(xyz, {0, 1, 2}, {0.05, 3, false}).substr(0, 28), "triangles enclose no sample;");
}

}  // namespace
