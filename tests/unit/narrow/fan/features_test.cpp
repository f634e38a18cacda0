// SPDX-License-Identifier: Apache-2.0
// Each search tells the features of its normal: those that all corners of both cores confirm.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "../../hull_of.hpp"
#include "../../made.hpp"
#include "../../random_boxes.hpp"

import abut.capability;
import abut.math;
import abut.narrow.convex.separation;
import abut.narrow.fan.features;
import abut.shapes.box;
import abut.shapes.capsule;
import abut.shapes.cone;
import abut.shapes.cylinder;
import abut.shapes.hull;
import abut.shapes.triangle;

namespace {

using abut::CoreFeature;
using abut::Pose;
using abut::Vec3;
using Points = std::vector<Vec3>;

constexpr double tie = 1e-12;

// A core, and points that no other ones of it exceed: of a round core those of both rims in the direction asked for.
struct Pebble {
  Points points;
  explicit Pebble(test::Random& random) {
    for (int i = 0; i < 14; ++i) {
      points.push_back(random.point(1));
    }
  }
  [[nodiscard]] abut::Hull core() const { return test::hull_of(points); }
  [[nodiscard]] Points outline(const Vec3&) const { return points; }
};
struct Brick {
  Vec3 half;
  explicit Brick(test::Random& random) : half(abut::absolute(random.point(0.8)) + Vec3{0.1, 0.1, 0.1}) {}
  [[nodiscard]] abut::Box core() const { return test::made<abut::Box>({half.x, half.y, half.z}); }
  [[nodiscard]] Points outline(const Vec3&) const { return test::corners_of(half, Pose::identity()); }
};
struct Rod {
  double half;
  explicit Rod(test::Random& random) : half(random.uniform(0.3, 1)) {}
  [[nodiscard]] abut::Capsule core() const { return test::made<abut::Capsule>({0.1, half}); }
  [[nodiscard]] Points outline(const Vec3&) const { return {{0, 0, -half}, {0, 0, half}}; }
};
struct Sheet {
  Points points;
  explicit Sheet(test::Random& random) : points{random.point(1), random.point(1), random.point(1)} {}
  [[nodiscard]] abut::FreeTriangle core() const {
    std::vector<double> xyz;
    for (const Vec3& p : points) {
      xyz.insert(xyz.end(), {p.x, p.y, p.z});
    }
    return test::made<abut::FreeTriangle>(xyz);
  }
  [[nodiscard]] Points outline(const Vec3&) const { return points; }
};
template <class Shape, bool is_pointed>
struct Round {
  double radius, half;
  explicit Round(test::Random& random) : radius(random.uniform(0.3, 0.8)), half(random.uniform(0.3, 0.8)) {}
  [[nodiscard]] Shape core() const { return test::made<Shape>({radius, half}); }
  // Along the axis three points of each rim: a disc is a face.
  [[nodiscard]] Points outline(const Vec3& d) const {
    const double angle = std::atan2(d.y, d.x), top = is_pointed ? 0 : radius;
    Points found;
    for (const double turn : {0.0, 2.0, 4.0}) {
      const double c = std::cos(angle + turn), s = std::sin(angle + turn);
      found.push_back({radius * c, radius * s, -half});
      found.push_back({top * c, top * s, half});
    }
    return found;
  }
};
using Drum = Round<abut::Cylinder, false>;
using Spike = Round<abut::Cone, true>;

struct Outermost {
  double height;
  long count;
};
template <class Maker>
Outermost outermost_of(const Maker& maker, const Vec3& direction) {
  double height = -abut::infinity;
  const Points points = maker.outline(direction);
  for (const Vec3& p : points) {
    height = std::fmax(height, dot(p, direction));
  }
  return {height, std::count_if(points.begin(), points.end(),
                                [&](const Vec3& p) { return dot(p, direction) >= height - tie; })};
}

// `outward`: along the normal, in the frame of the core.
template <class Maker>
void expect_feature(const Maker& maker, const CoreFeature& feature, const Vec3& outward) {
  const auto core = maker.core();
  const Outermost found = outermost_of(maker, outward);
  if (feature.kind == CoreFeature::Kind::face) {
    EXPECT_GE(found.count, 3);
    EXPECT_LE(norm(face_normal(core, feature.index) - outward), tie);
  } else if (feature.kind == CoreFeature::Kind::edge) {
    const abut::CoreEdge edge = edge_of(core, feature.index, outward);
    EXPECT_GT(norm(edge.along), 0.01);
    EXPECT_NEAR(dot(edge.from, outward), found.height, tie);
    EXPECT_NEAR(dot(edge.from + edge.along, outward), found.height, tie);
  }
}

// At least this share of the overlaps must have features; those of rims have none.
template <class MakerA, class MakerB>
void expect_features(std::uint64_t seed, double least_share) {
  test::Random random(seed);
  int deep = 0, known = 0, faces_of_a = 0, faces_of_b = 0, edges = 0;
  for (int i = 0; i < 2000 && deep < 300; ++i) {
    SCOPED_TRACE(i);
    const MakerA a(random);
    const MakerB b(random);
    const Pose ab{random.rotation(), random.point(1)};
    const abut::CoreSeparation found = separate_cores(a.core(), b.core(), ab, {}, abut::infinity);
    if (!(found.distance < -1e-3)) {
      continue;
    }
    ++deep;
    if (!found.features.are_known()) {
      continue;
    }
    ++known;
    edges += found.features.are_edges() ? 1 : 0;
    faces_of_a += found.features.a.kind == CoreFeature::Kind::face ? 1 : 0;
    faces_of_b += found.features.b.kind == CoreFeature::Kind::face ? 1 : 0;
    expect_feature(a, found.features.a, found.normal);
    expect_feature(b, found.features.b, ab.rotation.undo(-found.normal));
    if (!found.features.are_edges() || (has_straight_edges(a.core()) && has_straight_edges(b.core()))) {
      EXPECT_LE(norm(normal_of(a.core(), b.core(), ab, found.features) - found.normal), 1e-9);
    }
  }
  EXPECT_GT(deep, 100);
  EXPECT_GE(known, least_share * deep);
  EXPECT_GT(edges, 10);
  EXPECT_GT(faces_of_a + faces_of_b, 10);
}

TEST(Features, OfTwoHulls) { expect_features<Pebble, Pebble>(401, 1); }
TEST(Features, OfAHullAndABox) { expect_features<Pebble, Brick>(402, 1); }
TEST(Features, OfABoxAndAHull) { expect_features<Brick, Pebble>(403, 1); }
TEST(Features, OfARodAndAHull) { expect_features<Rod, Pebble>(404, 1); }
TEST(Features, OfAHullAndATriangle) { expect_features<Pebble, Sheet>(405, 1); }
TEST(Features, OfTwoBoxes) { expect_features<Brick, Brick>(406, 1); }
TEST(Features, OfABoxAndATriangle) { expect_features<Brick, Sheet>(407, 1); }
TEST(Features, OfARodAndABox) { expect_features<Rod, Brick>(408, 1); }
TEST(Features, OfABoxAndACylinder) { expect_features<Brick, Drum>(409, 0.5); }
TEST(Features, OfACylinderAndAHull) { expect_features<Drum, Pebble>(410, 0.5); }
TEST(Features, OfATriangleAndACylinder) { expect_features<Sheet, Drum>(411, 0.5); }
TEST(Features, OfARodAndACone) { expect_features<Rod, Spike>(412, 0.3); }
TEST(Features, OfTwoCylinders) { expect_features<Drum, Drum>(413, 0.3); }
TEST(Features, OfAConeAndABox) { expect_features<Spike, Brick>(414, 0.3); }

}  // namespace
