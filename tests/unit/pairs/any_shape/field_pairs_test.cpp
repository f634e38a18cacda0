// SPDX-License-Identifier: Apache-2.0
// Distance fields against all kinds. What answers are judged by: closed forms, and points all over the other shape.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "../../random_boxes.hpp"

import abut.capability;
import abut.math;
import abut.pairs.any_shape;
import abut.pairs.any_shape.casts.shape_cast;
import abut.pairs.registry;

namespace {

using abut::AnyShape;
using abut::ShapeHandle;
using abut::Outcome;
using abut::Pose;
using abut::Vec3;

ShapeHandle made(std::string_view kind, const std::vector<double>& parameters, const std::vector<double>& reals = {},
                 const std::vector<std::uint32_t>& indices = {}) {
  return abut::make_shape(*abut::find_kind(kind), parameters, reals, indices).value();
}

constexpr double cell = 0.0625;
constexpr std::uint32_t samples = 41;

// Of a function of the distance, on a grid around the origin.
template <class ValueOf>
std::vector<double> values_of(ValueOf&& value_of) {
  const double low = -0.5 * (samples - 1) * cell;
  std::vector<double> values;
  for (std::uint32_t k = 0; k < samples; ++k) {
    for (std::uint32_t j = 0; j < samples; ++j) {
      for (std::uint32_t i = 0; i < samples; ++i) {
        values.push_back(value_of(Vec3{low + i * cell, low + j * cell, low + k * cell}));
      }
    }
  }
  return values;
}
template <class ValueOf>
ShapeHandle field_of(ValueOf&& value_of, bool is_inside_out = false, bool is_smooth = false) {
  const double low = -0.5 * (samples - 1) * cell;
  return made(
      "distance_field",
      {samples, samples, samples, cell, cell, cell, low, low, low, is_inside_out ? 1.0 : 0.0, is_smooth ? 1.0 : 0.0},
      values_of(value_of));
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
  ShapeHandle shape;
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
void expect_deepest_point(ValueOf&& value_of, std::uint64_t seed, bool is_smooth = false) {
  const ShapeHandle field = field_of(value_of, false, is_smooth);
  // Half the diagonal of a cell where edges become round.
  const double off = (is_smooth ? 0.87 : 0.5) * cell;
  test::Random random(seed);
  int apart = 0, deep = 0;
  for (const Solid& solid : solids()) {
    for (int i = 0; i < 25; ++i) {
      const Pose pose = placed(random, 1.1);
      const abut::Distance found = distance(field, solid.shape, pose);
      const double least = least_of_points(solid, pose, value_of), spread = 0.5 * solid.reach * 2 / 24 * 1.8;
      const std::string what = "seed " + std::to_string(seed) + " pose " + std::to_string(i);
      (found.distance > 0 ? apart : deep) += 1;
      // Half a cell for the field, or its diagonal; what lies between the points is found, too.
      EXPECT_LE(found.distance, least + off) << what;
      // A radius has to come out after its core, also where the solid is thinner.
      EXPECT_GE(found.distance, least - off - spread - (least < 0 ? solid.radius : 0)) << what;
      EXPECT_LE(found.lower, found.distance) << what;
      EXPECT_GE(found.upper, found.distance) << what;
      EXPECT_NEAR(dot(found.point_b - found.point_a, found.normal), found.distance, 1e-9) << what;
      if (least > 0) {
        EXPECT_LE(found.lower, least + off) << what;
      }
      const abut::Manifold manifold = contacts(field, solid.shape, pose, 0.01);
      double deepest = abut::infinity;
      for (const abut::ContactPoint& contact : manifold) {
        deepest = std::min(deepest, contact.distance);
        EXPECT_NEAR(norm(contact.point_b - contact.point_a - contact.distance * contact.normal), 0, 1e-9) << what;
        EXPECT_NEAR(value_of(contact.point_a), 0, off) << what;
      }
      EXPECT_EQ(manifold.empty(), found.distance > 0.01) << what << " at " << found.distance;
      if (!manifold.empty()) {
        EXPECT_NEAR(deepest, found.distance, off) << what;
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

TEST(FieldPairs, SmoothFieldsFindTheDeepestPointOfConvexShapes) {
  expect_deepest_point(from_ball, 1, true);
  expect_deepest_point(from_slab, 2, true);
  expect_deepest_point(from_torus, 3, true);
}

// Four corners of a box that lies flat, each as deep as the box.
TEST(FieldPairs, ABoxRestsOnFourCorners) {
  for (const bool is_smooth : {false, true}) {
    const ShapeHandle field = field_of(from_slab, false, is_smooth), box = made("box", {0.4, 0.3, 0.2});
    const abut::Manifold manifold = contacts(field, box, {abut::Rotation::identity(), {0.1, 0.05, 0.44}});
    ASSERT_EQ(manifold.size(), 4U);
    for (const abut::ContactPoint& contact : manifold) {
      EXPECT_NEAR(contact.distance, -0.01, 1e-6);
      EXPECT_NEAR(contact.normal.z, 1, 1e-9);
      EXPECT_NEAR(std::fabs(contact.point_b.x - 0.1), 0.4, 1e-12);
      EXPECT_NEAR(std::fabs(contact.point_b.y - 0.05), 0.3, 1e-12);
    }
  }
}

// A beam over a ring touches it on both sides.
TEST(FieldPairs, EveryDeepestPointIsAContact) {
  for (const bool is_smooth : {false, true}) {
    const ShapeHandle ring = field_of(from_torus, false, is_smooth), beam = made("capsule", {0.1, 1});
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
}

TEST(FieldPairs, TwoBallsAsFieldsAgreeWithTheClosedForm) {
  for (const bool is_smooth : {false, true}) {
    const ShapeHandle ball = field_of(from_ball, false, is_smooth);
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
}

TEST(FieldPairs, PlanesMeetTheLowestPoints) {
  for (const bool is_smooth : {false, true}) {
    const ShapeHandle slab = field_of(from_slab, false, is_smooth), plane = made("plane", {0, 0, 1, 0});
    const Pose above{abut::Rotation::identity(), {0, 0, 0.24}};
    EXPECT_NEAR(distance(plane, slab, above).distance, -0.01, 1e-6);
    const abut::Manifold manifold = contacts(plane, slab, above);
    Vec3 low{abut::infinity, abut::infinity, 0}, high = -low;
    for (const abut::ContactPoint& contact : manifold) {
      low = minimum(low, contact.point_b);
      high = maximum(high, contact.point_b);
      EXPECT_NEAR(contact.distance, -0.01, 1e-2);
    }
    // They span the lower face but for a cell, and another one where edges are round.
    const double border = (is_smooth ? 2 : 1) * cell;
    EXPECT_LT(low.x, -1 + border);
    EXPECT_GT(high.y, 0.9 - border);
    EXPECT_NEAR(distance(plane, slab, {abut::Rotation::identity(), {0, 0, 1}}).distance, 0.75, 1e-6);
  }
}

TEST(FieldPairs, SurfacesMeetFieldsTriangleByTriangle) {
  for (const bool is_smooth : {false, true}) {
    const ShapeHandle ball = field_of(from_ball, false, is_smooth);
    const ShapeHandle sheet = made("mesh", {0}, {-2, -2, 0, 2, -2, 0, 2, 2, 0, -2, 2, 0}, {0, 1, 2, 0, 2, 3});
    const ShapeHandle ground = made("height_field", {2, 2, 4, 4}, {0, 0, 0, 0});
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
}

TEST(FieldPairs, ParticlesAndChildrenMeetFieldsOneByOne) {
  const ShapeHandle slab = field_of(from_slab);
  const ShapeHandle balls = made("particles", {0.1}, {0, 0, 0, 0.5, 0, 0, 0.5, 0.5, 1});
  const abut::Manifold manifold = contacts(slab, balls, {abut::Rotation::identity(), {0, 0, 0.34}});
  ASSERT_EQ(manifold.size(), 2U);
  for (const abut::ContactPoint& contact : manifold) {
    EXPECT_NEAR(contact.distance, -0.01, 1e-6);
    EXPECT_EQ(contact.feature_b.kind, abut::FeatureKind::particle);
  }
}

// What lies in a container touches its wall where it comes near.
TEST(FieldPairs, AContainerHoldsWhatIsInIt) {
  for (const bool is_smooth : {false, true}) {
    const ShapeHandle container = field_of(from_ball, true, is_smooth), ball = made("sphere", {0.3});
    const auto at = [](double x) { return Pose{abut::Rotation::identity(), {x, 0, 0}}; };
    EXPECT_NEAR(distance(container, ball, at(0.4)).distance, 0.1, 0.3 * cell);
    EXPECT_NEAR(distance(container, ball, at(0.55)).distance, -0.05, 0.3 * cell);
    EXPECT_TRUE(contacts(container, ball, at(0.4)).empty());
    const abut::Manifold manifold = contacts(container, ball, at(0.55));
    ASSERT_EQ(manifold.size(), 1U);
    EXPECT_LT(manifold[0].normal.x, -0.99);
    EXPECT_LT(distance(container, ball, at(3)).distance, -2);
    // Also far beyond the samples. No move is known to part anything from a container, so no depth is too much.
    for (const double x : {0.55, 1.5, 3.0, 40.0}) {
      const abut::Distance found = distance(container, ball, at(x));
      EXPECT_EQ(found.lower, -std::numeric_limits<double>::infinity()) << x;
      EXPECT_GE(found.upper, 0.5 - x - 0.3 * cell) << x;
    }
    abut::Distance out{};
    EXPECT_EQ(abut::pair_distance(container, container, at(0.1), {}, out), Outcome::unsupported);
    EXPECT_EQ(abut::pair_distance(made("plane", {0, 0, 1, 0}), container, at(0), {}, out), Outcome::unsupported);
  }
}

TEST(FieldPairs, ACastStopsAtTheSurface) {
  for (const bool is_smooth : {false, true}) {
    const ShapeHandle slab = field_of(from_slab, false, is_smooth), ball = made("sphere", {0.2});
    std::optional<abut::ShapeCastHit> hit;
    ASSERT_EQ(abut::cast_shapes(slab, Pose::identity(), {0, 0, 0}, ball, {abut::Rotation::identity(), {0.1, 0.2, 2}},
                                {0, 0, -4}, {}, 1, hit),
              Outcome::ok);
    ASSERT_TRUE(hit.has_value());
    EXPECT_NEAR(hit->fraction, (2 - 0.45) / 4, 1e-6);
    EXPECT_NEAR(hit->contact.normal.z, 1, 1e-6);
  }
}

// Stretched, sheared and turned by 140 degrees: all of a lattice.
Vec3 bent(const Vec3& p) {
  const double c = std::cos(2.4), s = std::sin(2.4);
  return {1.3 * (c * p.x - s * p.y) + 0.2 * p.z, 1.3 * (s * p.x + c * p.y), 0.8 * p.z};
}
Vec3 unbent(const Vec3& p) {
  const double c = std::cos(2.4), s = std::sin(2.4), z = p.z / 0.8, x = (p.x - 0.2 * z) / 1.3, y = p.y / 1.3;
  return {c * x + s * y, -s * x + c * y, z};
}
ShapeHandle bent_field(const std::vector<double>& values, bool is_inside_out, bool is_smooth) {
  constexpr int along = 3;
  const double low = -0.5 * (samples - 1) * cell;
  std::vector<double> reals = values;
  for (int i = 0; i < along * along * along; ++i) {
    const Vec3 p = bent(low * Vec3{1.0 - i % 3, 1.0 - i / 3 % 3, 1.0 - i / 9 % 3});
    reals.insert(reals.end(), {p.x, p.y, p.z});
  }
  return made("distance_field",
              {samples, samples, samples, cell, cell, cell, low, low, low, is_inside_out ? 1.0 : 0.0,
               is_smooth ? 1.0 : 0.0, along, along, along},
              reals);
}
// Points all over the bent torus.
std::vector<Vec3> bent_torus() {
  constexpr int around = 240, across = 120;
  std::vector<Vec3> out;
  for (int i = 0; i < around; ++i) {
    for (int j = 0; j < across; ++j) {
      const double a = 2 * 3.14159265358979323846 * i / around, b = 2 * 3.14159265358979323846 * j / across;
      const double away = 0.7 + 0.3 * std::cos(b);
      out.push_back(bent({away * std::cos(a), away * std::sin(a), 0.3 * std::sin(b)}));
    }
  }
  return out;
}

// What is apart from a bent torus is as far as its nearest point. That is asked of kinds with an own test of points.
TEST(FieldPairs, BentFieldsAreAsFarAsTheirPoints) {
  const std::vector<Vec3> surface = bent_torus();
  // Half a cell and the way between two points, both stretched.
  const double off = 1.6 * (0.5 * cell + 0.02);
  for (const bool is_smooth : {false, true}) {
    const ShapeHandle field = bent_field(values_of(from_torus), false, is_smooth);
    const ShapeHandle ball = made("sphere", {0.3}), box = made("box", {0.4, 0.3, 0.2});
    const ShapeHandle sheet =
        made("mesh", {0}, {-0.5, -0.5, 0, 0.5, -0.5, 0, 0.5, 0.5, 0, -0.5, 0.5, 0}, {0, 1, 2, 0, 2, 3});
    const ShapeHandle plane = made("plane", {0, 0, 1, 0}), other = field_of(from_ball, false, is_smooth);
    test::Random random(31);
    // Points that are found are seldom not the nearest ones; then the bounds are apart.
    int apart = 0, nearest = 0;
    for (int i = 0; i < 60; ++i) {
      const Pose pose = placed(random, 1.8);
      const auto from_ball_at = [&](const Vec3& p) { return norm(p - pose.position) - 0.3; };
      const auto from_box_at = [&](const Vec3& p, const Vec3& half) {
        const Vec3 out = absolute(pose.undo(p)) - half;
        return norm(maximum(out, Vec3{0, 0, 0}));
      };
      const auto expect = [&](const abut::Distance& found, auto&& from, const char* what) {
        double truth = abut::infinity;
        for (const Vec3& p : surface) {
          truth = std::fmin(truth, from(p));
        }
        EXPECT_LE(found.lower, found.distance) << what << " " << i;
        EXPECT_GE(found.upper, found.distance) << what << " " << i;
        EXPECT_NEAR(norm(found.point_b - found.point_a - found.distance * found.normal), 0, 1e-9) << what << " " << i;
        if (truth > off) {
          ++apart;
          EXPECT_LE(found.lower, truth + off) << what << " " << i;
          EXPECT_GE(found.upper, truth - off) << what << " " << i;
          EXPECT_GT(found.distance, truth - off) << what << " " << i;
          nearest += found.distance < truth + off ? 1 : 0;
        }
      };
      expect(distance(field, ball, pose), from_ball_at, "ball");
      expect(distance(field, box, pose), [&](const Vec3& p) { return from_box_at(p, {0.4, 0.3, 0.2}); }, "box");
      expect(distance(field, sheet, pose), [&](const Vec3& p) { return from_box_at(p, {0.5, 0.5, 0}); }, "sheet");
      expect(distance(field, other, pose), [&](const Vec3& p) { return norm(p - pose.position) - 0.8; }, "field");
      // Of the plane the field is the second one.
      const Pose lifted{pose.rotation, {0, 0, 2.5}};
      expect(distance(plane, field, lifted), [&](const Vec3& p) { return (lifted * p).z; }, "plane");
      for (const abut::ContactPoint& contact : contacts(field, ball, pose)) {
        EXPECT_NEAR(from_torus(unbent(contact.point_a)), 0, 0.6 * cell) << i;
      }
    }
    EXPECT_GT(apart, 100);
    EXPECT_GE(nearest, 0.99 * apart);
  }
}

TEST(FieldPairs, ABentContainerHoldsWhatIsInIt) {
  const ShapeHandle container = bent_field(values_of(from_ball), true, true), ball = made("sphere", {0.2});
  // The wall is 0.64 above the middle, and slopes by the shear.
  const auto at = [](double z) { return Pose{abut::Rotation::identity(), {0.25 * z, 0, z}}; };
  EXPECT_TRUE(contacts(container, ball, at(0.2)).empty());
  EXPECT_FALSE(contacts(container, ball, at(0.55)).empty());
  EXPECT_GT(distance(container, ball, at(0.2)).distance, 0.1);
}

// Only the sample in the middle of the grid is inside, by `depth`. Its neighbours know nothing of it.
ShapeHandle field_of_one_sample(double depth, bool is_smooth) {
  return field_of([&](const Vec3& p) { return norm(p) < 0.5 * cell ? -depth : 0.6 + 0.1 * p.x; }, false, is_smooth);
}

TEST(FieldPairs, ASingleSampleInsideIsFound) {
  const ShapeHandle point = made("point", {}), ball = made("sphere", {0.05}), box = made("box", {0.1, 0.2, 0.05});
  for (const bool is_smooth : {false, true}) {
    const ShapeHandle field = field_of_one_sample(is_smooth ? 4 : 0.1, is_smooth);
    test::Random random(29);
    for (int i = 0; i < 60; ++i) {
      const Vec3 way = random.point(1), place = (random.uniform(0.4, 1.1) / norm(way)) * way;
      for (const ShapeHandle* other : {&point, &ball, &box}) {
        const abut::Distance found = distance(field, *other, {abut::Rotation::identity(), place});
        EXPECT_LT(found.upper, abut::infinity);
        EXPECT_NEAR(field->distance_to(found.point_a)->distance, 0, 1e-5 * cell);
        EXPECT_LE(norm(found.point_a), 1.5 * cell);
        EXPECT_TRUE(contacts(field, *other, {abut::Rotation::identity(), place}, 0.5 * found.distance).empty());
        EXPECT_FALSE(contacts(field, *other, {abut::Rotation::identity(), place}, 1.01 * found.distance).empty());
      }
    }
  }
}

// A box with a cavity around its middle.
ShapeHandle hollow_box() {
  const std::array children{abut::PlacedShape{abut::ShapeHandle(made("box", {0.3, 0.3, 0.3})), Pose::identity()},
                            abut::PlacedShape{abut::ShapeHandle(made("sphere_hole", {0.1})), Pose::identity()}};
  return abut::make_composite(children).value();
}

// Means of a sample and its neighbours are all positive: there is no solid.
TEST(FieldPairs, NothingTouchesASolidWithoutAPoint) {
  const ShapeHandle none = field_of_one_sample(0.01, true), ball = made("sphere", {0.05}),
                    large = made("sphere", {0.7}), other = field_of([](const Vec3& p) { return norm(p) - 0.3; }),
                    hollow = hollow_box();
  const Pose near{abut::Rotation::identity(), {0.2, 0.1, 0}};
  for (const ShapeHandle* shape : std::array{&ball, &large, &other, &none, &hollow}) {
    for (const bool is_first : {true, false}) {
      const AnyShape &a = is_first ? none : *shape, &b = is_first ? *shape : none;
      const abut::Distance found = distance(a, b, near);
      EXPECT_EQ(found.upper, abut::infinity);
      EXPECT_LE(found.lower, found.distance);
      EXPECT_TRUE(std::isfinite(found.distance));
      EXPECT_NEAR(dot(found.point_b - found.point_a, found.normal), found.distance, 1e-12);
      EXPECT_TRUE(contacts(a, b, near, 5).empty());
    }
  }
}

}  // namespace
