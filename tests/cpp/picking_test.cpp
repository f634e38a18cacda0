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
  const abut::Camera parallel = camera.with_vertical_extent(4).with_pixel_aspect(2).with_shift(1, 0);
  EXPECT_NEAR(parallel.with_depth_along_axis().ray(3, 1).origin.x, 0, 1e-12);
  EXPECT_NEAR(parallel.ray(4, 1).origin.x, 4, 1e-12);
  EXPECT_THROW(camera.look_at({0, 0, 0}, {0, 0, 0}), abut::Error);
}

TEST(Camera, TakesOverAProjectionMatrix) {
  abut::Camera camera;
  camera.set_projection({2, 0, 0, 0, 0, 4, 0, 0, 0, 0, -0.5, 0, 0, 0, 0, 1});
  EXPECT_EQ(camera.projection, ABUT_PROJECTION_ORTHOGRAPHIC);
  EXPECT_EQ(camera.vertical_extent, 0.5);
  EXPECT_EQ(camera.far_distance, 2);
  EXPECT_THROW(camera.set_projection({}, ABUT_CLIP_DEPTH_UNSIGNED), abut::Error);
}

TEST(Picker, HelpsTools) {
  abut::Universe universe;
  const abut::GeometryId box = universe.create_geometry(universe.create_part(), abut::Shape::box(1, 1, 1));
  abut::Picker picker(universe);
  const abut::Ray ray{{-3, 0.5, 0}, {1, 0, 0}, INFINITY};
  EXPECT_TRUE(picker.ray_hits(ray));
  EXPECT_EQ(picker.rays_hit({ray, {{-3, 2, 0}, {1, 0, 0}, 9}}), (std::vector<std::uint32_t>{1, 0}));
  const abut::Barycentric at = picker.barycentric(picker.cast_ray(ray));
  EXPECT_NEAR(at.weights[0] + at.weights[1] + at.weights[2], 1, 1e-12);
  abut::Camera camera;
  camera.look_at({0, -5, 0}, {0, 0, 0});
  EXPECT_EQ(picker.select_rectangle(camera, 0, 0, 640, 480, ABUT_SELECTION_INSIDE), std::vector{box});
  EXPECT_TRUE(picker.select_rectangle(camera, 0, 0, 9, 9).empty());
  EXPECT_EQ(picker.snap(camera, 320, 240, 500).kind, ABUT_SNAP_VERTEX);
  EXPECT_EQ(picker.snap(camera, 320, 240, 500, ABUT_SNAP_EDGE).geometry, box);
  picker.set_clip_planes({{{1, 0, 0}, 0}});
  EXPECT_EQ(picker.cast_ray(ray).distance, 4);
  picker.set_flags(ABUT_PICKER_SKIP_BACK_FACES);
  EXPECT_FALSE(picker.ray_hits(ray));
}

}  // namespace
