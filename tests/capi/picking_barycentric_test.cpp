// SPDX-License-Identifier: Apache-2.0
// picking.h: weights of the corners of a triangle, which give back the point.
#include "picking_scene.hpp"

#include <abut/picking.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace {

using namespace picking_test;

struct Triangles {
  std::vector<double> xyz;
  std::vector<std::uint32_t> indices;
};

Triangles triangles_of(const Shape& shape) {
  std::size_t vertices = 0;
  std::size_t triangles = 0;
  EXPECT_EQ(abut_shape_triangles(shape.get(), nullptr, 0, &vertices, nullptr, 0, &triangles), ABUT_OK);
  Triangles out{std::vector<double>(3 * vertices), std::vector<std::uint32_t>(3 * triangles)};
  EXPECT_EQ(
      abut_shape_triangles(shape.get(), out.xyz.data(), vertices, &vertices, out.indices.data(), triangles, &triangles),
      ABUT_OK);
  return out;
}

// The shapes stand unturned, so that world and local coordinates differ by the position alone.
TEST(Barycentric, WeightsGiveBackThePointOfAHit) {
  constexpr std::uint64_t seed = 61;
  SCOPED_TRACE("seed " + std::to_string(seed));
  Random random(seed);
  std::vector<double> corners;
  for (int i = 0; i < 60; ++i) corners.push_back(random.in(-0.8, 0.8));
  const std::array shapes{
      box(0.4, 0.6, 0.3), hull(corners),         prism(12), ball_mesh(0.6, 6), height_field(8, 0.3, 0.2),
      uv_grid(1, 7, 0.3), ground_mesh(1, 6, 0.3)};
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    SCOPED_TRACE("shape " + std::to_string(i));
    World world;
    const abut_vec3 place = random.point(5);
    world.add(shapes[i], place);
    const Triangles its = triangles_of(shapes[i]);
    std::size_t hits = 0;
    for (int k = 0; k < 100; ++k) {
      const abut_vec3 from = place + random.point(4);
      const abut_pick pick = world.pick({from, place + random.point(0.5) - from, infinity});
      if (pick.geometry.slot == 0) continue;
      ++hits;
      abut_barycentric at{};
      ASSERT_EQ(abut_picker_barycentric(world.picker(), pick.geometry, pick.feature.index, &pick.point, &at), ABUT_OK)
          << abut_last_error_message();
      ASSERT_LT(3 * std::size_t{at.triangle} + 2, its.indices.size());
      abut_vec3 sum{0, 0, 0};
      double whole = 0;
      for (std::size_t corner = 0; corner < 3; ++corner) {
        EXPECT_EQ(at.vertices[corner], its.indices[3 * std::size_t{at.triangle} + corner]);
        const std::size_t vertex = 3 * std::size_t{at.vertices[corner]};
        EXPECT_GE(at.weights[corner], -1e-9);
        sum = sum + at.weights[corner] * abut_vec3{its.xyz[vertex], its.xyz[vertex + 1], its.xyz[vertex + 2]};
        whole += at.weights[corner];
      }
      EXPECT_NEAR(whole, 1, 1e-12);
      EXPECT_NEAR(length(place + sum - pick.point), 0, 1e-9);
    }
    EXPECT_GT(hits, 20U);
  }
}

TEST(Barycentric, FollowsThePoseAndProjectsThePoint) {
  World world;
  const Placed placed = world.add(mesh({0, 0, 0, 2, 0, 0, 0, 2, 0}, {0, 1, 2}), {0, 0, 0});
  world.move(placed, {10, 0, 0}, {std::sqrt(0.5), 0, 0, std::sqrt(0.5)});
  // Local (1, 0.5, 3), turned by a right angle around Z.
  const abut_vec3 point{9.5, 1, 3};
  abut_barycentric at{};
  ASSERT_EQ(abut_picker_barycentric(world.picker(), placed.geometry, 0, &point, &at), ABUT_OK);
  EXPECT_NEAR(at.weights[0], 0.25, 1e-12);
  EXPECT_NEAR(at.weights[1], 0.5, 1e-12);
  EXPECT_NEAR(at.weights[2], 0.25, 1e-12);
}

TEST(Barycentric, IsRefusedWhereThereAreNoTriangles) {
  World world;
  const Placed ball = world.add(sphere(1), {0, 0, 0});
  const Placed sheet = world.add(mesh({0, 0, 0, 2, 0, 0, 0, 2, 0, 1, 0, 0}, {0, 1, 2, 0, 3, 1}), {0, 0, 0});
  const Placed parked = world.add(box(1, 1, 1), {0, 0, 0});
  ASSERT_EQ(abut_geometry_park(world.universe(), parked.geometry, ABUT_PARKING_LONG_TERM), ABUT_OK);
  const abut_vec3 point{0, 0, 0};
  abut_barycentric at{};
  at.weights[0] = -7;
  const auto refusal = [&](abut_geometry_id geometry, std::uint32_t face, abut_status expected) {
    EXPECT_EQ(abut_picker_barycentric(world.picker(), geometry, face, &point, &at), expected);
    EXPECT_EQ(at.weights[0], -7);
    return std::string(abut_last_error_message());
  };
  EXPECT_NE(refusal(ball.geometry, 0, ABUT_UNSUPPORTED).find("geometry.slot is 1"), std::string::npos);
  EXPECT_NE(refusal(parked.geometry, 0, ABUT_UNSUPPORTED).find("parked"), std::string::npos);
  EXPECT_NE(refusal(sheet.geometry, 2, ABUT_INDEX_OUT_OF_RANGE).find("face is 2"), std::string::npos);
  EXPECT_NE(refusal(sheet.geometry, 1, ABUT_ZERO_VECTOR).find("face is 1"), std::string::npos);
}

}  // namespace
