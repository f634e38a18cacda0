// SPDX-License-Identifier: Apache-2.0
// Picking: rays, the mouse and pictures against one ball.
#include <abut/picking.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <vector>

namespace {

struct Stage {
  Stage() { ball = universe.create_geometry(universe.create_part(), abut::Shape::sphere(1)); }

  abut::Universe universe;
  abut::GeometryId ball{};
};

TEST(Picker, FollowsItsUniverse) {
  Stage stage;
  const abut::Picker picker(stage.universe);
  picker.update();
  const abut::Ray ray{{-3, 0, 0}, {1, 0, 0}, INFINITY};
  EXPECT_EQ(picker.cast_ray(ray).distance, 2);
  EXPECT_EQ(picker.cast_ray_all(ray).size(), 2U);
  EXPECT_TRUE(abut::is_null(picker.cast_ray(ray, abut::QueryFilter().with_mask(2)).geometry));
  EXPECT_EQ(picker.cast_rays({ray, ray}, ABUT_COHERENCE_NEIGHBOURS)[1].geometry, stage.ball);
  std::vector<abut::Pick> out(2);
  picker.cast_rays({ray, ray}, out);
  EXPECT_EQ(out[1].distance, 2);
  EXPECT_THROW(picker.cast_rays({ray}, out), abut::Error);
  stage.universe.destroy(stage.ball);
  EXPECT_TRUE(abut::is_null(picker.cast_ray(ray).geometry));
}

TEST(Picker, KeepsItsUniverse) {
  auto stage = std::make_unique<Stage>();
  const abut::Picker picker(stage->universe);
  const abut::GeometryId ball = stage->ball;
  stage.reset();
  EXPECT_EQ(picker.cast_ray({{-3, 0, 0}, {1, 0, 0}, INFINITY}).geometry, ball);
}

TEST(Camera, SeesThroughItsPixels) {
  Stage stage;
  const abut::Picker picker(stage.universe);
  abut::Camera camera = abut::Camera().with_size(4, 2).with_vertical_fov(0.5).with_range(0, 100);
  camera.look_at({0, -5, 0}, {0, 0, 0});
  EXPECT_NEAR(camera.ray(2, 1).direction.y, 1, 1e-12);
  EXPECT_EQ(picker.pick_pixel(camera, 2, 1, 0).geometry, stage.ball);
  EXPECT_EQ(picker.render(camera).size(), 8U);
  EXPECT_THROW(camera.look_at({0, 0, 0}, {0, 0, 0}), abut::Error);
}

}  // namespace
