// SPDX-License-Identifier: Apache-2.0
// picking.h: points, segments and filters under the mouse.
#include "picking_scene.hpp"

#include <abut/picking.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>

namespace {

using namespace picking_test;

// From -10 on the X axis; a pixel at the distance of the origin has this size.
abut_camera camera_to_origin() {
  abut_camera camera;
  abut_camera_init(&camera, sizeof camera);
  const abut_vec3 eye{-10, 0, 0};
  const abut_vec3 target{0, 0, 0};
  const abut_vec3 up{0, 0, 1};
  EXPECT_EQ(abut_camera_look_at(&camera, &eye, &target, &up), ABUT_OK);
  return camera;
}
const double pixel = 10 * std::tan(0.5) / 240;

abut_pick pick_at(World& world, double radius, const abut_query_filter* filter = nullptr) {
  const abut_camera camera = camera_to_origin();
  abut_pick pick{};
  EXPECT_EQ(abut_picker_pick_pixel(world.picker(), &camera, 320, 240, radius, filter, &pick), ABUT_OK)
      << abut_last_error_message();
  return pick;
}

Shape point() { return shape_of_kind("point", {}); }
Shape segment(double half_length) { return shape_of_kind("segment", std::array{half_length}); }

TEST(PickPixel, FindsAPointWithinTheRadius) {
  World world;
  const Placed placed = world.add(point(), {0, 6 * pixel, 0});
  EXPECT_EQ(pick_at(world, 0).geometry.slot, 0U);
  EXPECT_EQ(pick_at(world, 5.9).geometry.slot, 0U);
  const abut_pick pick = pick_at(world, 6.1);
  EXPECT_TRUE(same(pick.geometry, placed.geometry));
  EXPECT_EQ(pick.feature.kind, static_cast<abut_feature_kind>(ABUT_FEATURE_VERTEX));
  EXPECT_NEAR(pick.distance, std::hypot(10, 6 * pixel), 1e-12);
  EXPECT_NEAR(length(pick.point - abut_vec3{0, 6 * pixel, 0}), 0, 1e-12);
  EXPECT_EQ(length(pick.normal), 0);
}

TEST(PickPixel, FindsTheNearestPlaceOfASegment) {
  World world;
  const Placed placed = world.add(segment(2), {0, 6 * pixel, 1});
  const abut_pick pick = pick_at(world, 8);
  EXPECT_TRUE(same(pick.geometry, placed.geometry));
  EXPECT_EQ(pick.feature.kind, static_cast<abut_feature_kind>(ABUT_FEATURE_EDGE));
  EXPECT_NEAR(length(pick.point - abut_vec3{0, 6 * pixel, 0}), 0, 1e-9);
}

// Along the sight and past the eye: its picture runs out of the picture.
TEST(PickPixel, FindsASegmentThatPassesTheEye) {
  World world;
  const double half = std::sqrt(0.5);
  const Placed placed = world.add(segment(30), {0, 0.1, 0}, {half, 0, half, 0});
  const abut_pick pick = pick_at(world, 2);
  EXPECT_TRUE(same(pick.geometry, placed.geometry));
  EXPECT_NEAR(pick.point.x, 30, 1e-9);
}

TEST(PickPixel, ChoosesTheNearestPointInThePicture) {
  World world;
  world.add(point(), {0, 6 * pixel, 0});
  const Placed nearest = world.add(point(), {5, 0, -3 * 1.5 * pixel});
  world.add(segment(1), {0, -5 * pixel, 0});
  world.add(point(), {-20, 0, 0});
  EXPECT_TRUE(same(pick_at(world, 10).geometry, nearest.geometry));
}

TEST(PickPixel, PrefersAPointToTheSurfaceBehindIt) {
  World world;
  const Placed wall = world.add(box(1, 5, 5), {5, 0, 0});
  EXPECT_TRUE(same(pick_at(world, 10).geometry, wall.geometry));
  const Placed placed = world.add(point(), {4, 2 * pixel, 0});  // on the wall
  EXPECT_TRUE(same(pick_at(world, 10).geometry, placed.geometry));
  EXPECT_TRUE(same(pick_at(world, 0).geometry, wall.geometry));
}

TEST(PickPixel, DoesNotFindAHiddenPoint) {
  World world;
  const Placed wall = world.add(box(1, 5, 5), {5, 0, 0});
  world.add(point(), {7, 2 * pixel, 0});
  EXPECT_TRUE(same(pick_at(world, 10).geometry, wall.geometry));
  abut_query_filter filter;
  abut_query_filter_init(&filter, sizeof filter);
  filter.ignore_geometry = wall.geometry;
  EXPECT_NE(pick_at(world, 10, &filter).geometry.slot, 0U);
}

TEST(PickPixel, EndsPointsAtNearAndFar) {
  World world;
  world.add(point(), {0, 0, 0});
  abut_camera camera = camera_to_origin();
  abut_pick pick{};
  camera.near_distance = 9;
  camera.far_distance = 11;
  ASSERT_EQ(abut_picker_pick_pixel(world.picker(), &camera, 320, 240, 1, nullptr, &pick), ABUT_OK);
  EXPECT_NEAR(pick.distance, 1, 1e-12);
  camera.near_distance = 10.5;
  ASSERT_EQ(abut_picker_pick_pixel(world.picker(), &camera, 320, 240, 1, nullptr, &pick), ABUT_OK);
  EXPECT_EQ(pick.geometry.slot, 0U);
  camera.near_distance = 0;
  camera.far_distance = 9;
  ASSERT_EQ(abut_picker_pick_pixel(world.picker(), &camera, 320, 240, 1, nullptr, &pick), ABUT_OK);
  EXPECT_EQ(pick.geometry.slot, 0U);
}

TEST(PickPixel, FindsOnlyWhatTheFilterAdmits) {
  World world;
  const Placed near = world.add(sphere(pixel), {0, 4 * pixel, 0});
  const Placed far = world.add(sphere(pixel), {0, -7 * pixel, 0});
  EXPECT_TRUE(same(pick_at(world, 10).geometry, near.geometry));
  abut_query_filter filter;
  abut_query_filter_init(&filter, sizeof filter);
  filter.ignore_part = near.part;
  EXPECT_TRUE(same(pick_at(world, 10, &filter).geometry, far.geometry));
}

TEST(Render, ShowsOnlyWhatTheFilterAdmits) {
  World world;
  const Placed front = world.add(ball_mesh(1, 10), {0, 0, 0});
  const Placed back = world.add(ball_mesh(2, 10), {5, 0, 0});
  abut_camera camera = camera_to_origin();
  camera.width = camera.height = 9;
  std::array<abut_pick, 81> picture{};
  ASSERT_EQ(abut_picker_render(world.picker(), &camera, nullptr, picture.data(), picture.size()), ABUT_OK);
  EXPECT_TRUE(same(picture[40].geometry, front.geometry));
  abut_query_filter filter;
  abut_query_filter_init(&filter, sizeof filter);
  filter.ignore_geometry = front.geometry;
  ASSERT_EQ(abut_picker_render(world.picker(), &camera, &filter, picture.data(), picture.size()), ABUT_OK);
  EXPECT_TRUE(same(picture[40].geometry, back.geometry));
}

TEST(BadInput, OfFiltersIsRefused) {
  World world;
  World other;
  const Placed stranger = other.add(sphere(1), {0, 0, 0});
  abut_query_filter good;
  abut_query_filter_init(&good, sizeof good);
  const auto status_of = [&](const auto& spoil) {
    abut_query_filter filter = good;
    spoil(filter);
    abut_pick pick{};
    pick.distance = -7;
    const abut_status status = abut_picker_cast_ray(world.picker(), &along_x, &filter, &pick);
    EXPECT_TRUE(status == ABUT_OK || pick.distance == -7);
    EXPECT_EQ(abut_picker_cast_rays(world.picker(), &along_x, 1, ABUT_COHERENCE_NONE, &filter, &pick), status);
    return status;
  };
  EXPECT_EQ(status_of([](abut_query_filter&) {}), ABUT_OK);
  EXPECT_EQ(status_of([](abut_query_filter& f) { f.struct_size = 3; }), ABUT_WRONG_STRUCT_SIZE);
  EXPECT_EQ(status_of([](abut_query_filter& f) { f.flags = 2; }), ABUT_UNKNOWN_VALUE);
  EXPECT_EQ(status_of([](abut_query_filter& f) { f.ray_start = 3; }), ABUT_UNKNOWN_VALUE);
  EXPECT_EQ(status_of([](abut_query_filter& f) { f.ray_start = ABUT_RAY_START_SKIP; }), ABUT_UNSUPPORTED);
  EXPECT_EQ(status_of([](abut_query_filter& f) { f.reserved = 1; }), ABUT_INVALID_ARGUMENT);
  EXPECT_EQ(status_of([&](abut_query_filter& f) { f.ignore_part = stranger.part; }), ABUT_STALE_ID);
  EXPECT_EQ(status_of([&](abut_query_filter& f) { f.ignore_geometry = stranger.geometry; }), ABUT_STALE_ID);
}

}  // namespace
