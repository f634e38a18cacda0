// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

#include "shape_casts.hpp"

import abut.pairs.any_shape;

namespace {

using namespace test::casts;

TEST(CastShapesOfParts, OneSidedSheetsLetThroughWhatComesFromBehind) {
  const ShapeHandle ball = make("sphere", {0.5});
  for (const bool one_sided : {false, true}) {
    const ShapeHandle sheet = make_square(3, one_sided);
    EXPECT_TRUE(cast(ball, at({0.2, 0.1, 4}), {0, 0, -8}, sheet, at({0, 0, 0})));
    EXPECT_EQ(cast(ball, at({0.2, 0.1, -4}), {0, 0, 8}, sheet, at({0, 0, 0})).has_value(), !one_sided);
    EXPECT_EQ(cast(sheet, at({0, 0, 0}), {0, 0, -8}, ball, at({0.2, 0.1, -4})).has_value(), !one_sided);
  }
}

// A bumpy sheet of many triangles, and the same triangles one by one.
TEST(CastShapesOfParts, OfMeshesIsTheFirstOfTheirTriangles) {
  Random random(6);
  constexpr std::uint32_t side = 14;
  std::vector<Real> points;
  std::vector<std::uint32_t> corners;
  for (std::uint32_t j = 0; j < side; ++j) {
    for (std::uint32_t i = 0; i < side; ++i) {
      points.insert(points.end(), {0.5 * i, 0.5 * j, random.in(-0.3, 0.3)});
      if (i + 1 < side && j + 1 < side) {
        const std::uint32_t k = j * side + i;
        corners.insert(corners.end(), {k, k + 1, k + side + 1, k, k + side + 1, k + side});
      }
    }
  }
  const ShapeHandle mesh = make("mesh", {0}, points, corners);
  std::vector<ShapeHandle> triangles;
  for (std::size_t first = 0; first < corners.size(); first += 3) {
    std::vector<Real> numbers;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t at_corner = 3 * corners[first + k];
      numbers.insert(numbers.end(), {points[at_corner], points[at_corner + 1], points[at_corner + 2]});
    }
    triangles.push_back(make("triangle", numbers));
  }
  const std::vector<ShapeHandle> movers{make("sphere", {0.2}), make("box", {0.2, 0.3, 0.1}),
                                        make("cylinder", {0.2, 0.3}), make("particles", {0.1}, {0, 0, 0, 0.3, 0.1, 0})};
  int hits = 0;
  for (int i = 0; i < 24; ++i) {
    const AnyShape& mover = movers[static_cast<std::size_t>(i) % movers.size()];
    const Pose field = random.pose(random.vector(1));
    const Pose from = field * random.pose({random.in(-1, 8), random.in(-1, 8), random.in(0.8, 2)});
    const Vec3 by = field.rotation * Vec3{random.in(-6, 6), random.in(-6, 6), random.in(-4, -0.5)};
    const auto hit = cast(mover, from, by, mesh, field);
    std::optional<ShapeCastHit> first;
    std::uint32_t number = 0;
    for (std::uint32_t k = 0; k < triangles.size(); ++k) {
      const auto of_one = cast(mover, from, by, triangles[k], field);
      if (of_one && (!first || of_one->fraction < first->fraction)) {
        first = of_one;
        number = k;
      }
    }
    ASSERT_EQ(hit.has_value(), first.has_value()) << i;
    if (hit) {
      ++hits;
      EXPECT_NEAR(hit->fraction, first->fraction, 1e-9) << i;
      if (hit->fraction == first->fraction && hit->fraction > 0) {
        EXPECT_EQ(hit->feature_b, (Feature{FeatureKind::face, number}));
      }
    }
  }
  EXPECT_GT(hits, 8);
}

TEST(CastShapesOfParts, OfCompositesIsTheFirstOfTheirChildren) {
  Random random(7);
  const ShapeHandle ball{make("sphere", {0.3})}, block{make("box", {0.3, 0.2, 0.4})}, sheet{make_square(0.6, false)};
  std::vector<PlacedShape> children;
  for (int i = 0; i < 12; ++i) {
    children.push_back({i % 3 == 0 ? ball : i % 3 == 1 ? block : sheet, random.pose(random.vector(3))});
  }
  const ShapeHandle composite = make_composite(children).value();
  int hits = 0;
  for (int i = 0; i < 60; ++i) {
    const ShapeHandle mover = make("capsule", {0.2, 0.3});
    const Pose placed = random.pose(random.vector(1)),
               from = placed * random.pose({random.in(-3, 3), random.in(-3, 3), 6});
    const Vec3 by = placed.rotation * Vec3{random.in(-2, 2), random.in(-2, 2), -11};
    std::optional<Real> first;
    for (const PlacedShape& child : children) {
      const auto of_one = cast(mover, from, by, *child.shape, placed * child.pose);
      first = of_one ? std::min(first.value_or(1), of_one->fraction) : first;
    }
    const auto hit = cast(mover, from, by, composite, placed), back = cast(composite, placed, -by, mover, from);
    ASSERT_EQ(hit.has_value(), first.has_value()) << i;
    ASSERT_EQ(back.has_value(), first.has_value()) << i;
    if (hit) {
      ++hits;
      EXPECT_NEAR(hit->fraction, *first, 1e-10);
      EXPECT_NEAR(back->fraction, *first, 1e-10);
      const PlacedShape& child = children[hit->child_b];
      const auto of_child = cast(mover, from, by, *child.shape, placed * child.pose);
      ASSERT_TRUE(of_child);
      EXPECT_NEAR(of_child->fraction, *first, 1e-10);
      EXPECT_EQ(back->child_a, hit->child_b);
    }
  }
  EXPECT_GT(hits, 10);
}

// Both fronts look at each other, and meet before the ball meets the ground.
TEST(CastShapesOfParts, HeightFieldsInCompositesMeet) {
  const ShapeHandle field{make("height_field", {3, 3, 2, 2}, std::vector<Real>(9, 0.0))}, ball{make("sphere", {0.5})};
  const Vec3 middle = aabb_of(*field, at({0, 0, 0})).centre();
  const Pose over{Rotation::identity(), -middle}, under{Rotation::from({0, 1, 0, 0}), {-middle.x, middle.y, 0}};
  const ShapeHandle ground = make_composite(std::vector<PlacedShape>{{field, over}}).value();
  const ShapeHandle lid = make_composite(std::vector<PlacedShape>{{ball, at({0.3, 0.2, 1})}, {field, under}}).value();
  const auto hit = cast(lid, at({0, 0, 4}), {0, 0, -8}, ground, at({0, 0, 0}));
  ASSERT_TRUE(hit);
  EXPECT_NEAR(hit->fraction, 4.0 / 8, 1e-12);
  EXPECT_EQ(hit->child_a, 1u);
}

// A plate with a shaft through it lets through what fits, and stops what does not.
TEST(CastShapesOfParts, HolesLetThrough) {
  const ShapeHandle plate{make("box", {2, 2, 0.5})}, shaft{make("cylinder_hole", {0.6, 1, 3})};
  const ShapeHandle pierced =
      make_composite(std::vector<PlacedShape>{{plate, at({0, 0, 0})}, {shaft, at({0, 0, 0})}}).value();
  EXPECT_FALSE(cast(make("sphere", {0.4}), at({0.1, 0, 3}), {0, 0, -6}, pierced, at({0, 0, 0})));
  const auto beside = cast(make("sphere", {0.4}), at({1.2, 0, 3}), {0, 0, -6}, pierced, at({0, 0, 0}));
  ASSERT_TRUE(beside);
  EXPECT_NEAR(beside->fraction, 2.1 / 6, 1e-9);
  const auto wall = cast(make("sphere", {0.4}), at({0, 0, 0}), {6, 0, 0}, pierced, at({0, 0, 0}));
  ASSERT_TRUE(wall);
  EXPECT_NEAR(wall->fraction, 0.2 / 6, 1e-9);
}

}  // namespace
