// SPDX-License-Identifier: Apache-2.0
// picking.h: bad input of tools is refused, and the picker answers as before.
#include "picking_tools.hpp"

#include <abut/picking.h>
#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <string>

namespace {

using namespace picking_test;

bool is_told(const std::string& words) {
  return std::string(abut_last_error_message()).find(words) != std::string::npos;
}

// A solid and a sensor before it, half of which a plane cuts away.
class Tools : public testing::Test {
 protected:
  void SetUp() override {
    world.add(sphere(1), {5, 0, 0});
    const Placed sensor = world.add(sphere(1), {0, 0, 0});
    abut_geometry_options options;
    abut_geometry_options_init(&options, sizeof options);
    options.flags = ABUT_GEOMETRY_SENSOR;
    ASSERT_EQ(abut_geometry_set_options(world.universe(), sensor.geometry, &options), ABUT_OK);
    const abut_clip_plane plane{{1, 0, 0}, 0.25};
    ASSERT_EQ(abut_picker_set_clip_planes(world.picker(), &plane, 1), ABUT_OK);
    ASSERT_EQ(abut_picker_set_flags(world.picker(), ABUT_PICKER_SENSORS), ABUT_OK);
    EXPECT_DOUBLE_EQ(world.pick(along_x).distance, 11);
  }
  void TearDown() override { EXPECT_DOUBLE_EQ(world.pick(along_x).distance, 11) << "the picker has changed"; }

  World world;
};

TEST_F(Tools, RefuseBadFlags) {
  EXPECT_EQ(abut_picker_set_flags(world.picker(), 4), ABUT_UNKNOWN_VALUE);
  EXPECT_TRUE(is_told("flags is 4"));
  EXPECT_EQ(abut_picker_set_flags(nullptr, 0), ABUT_NULL_ARGUMENT);
}

TEST_F(Tools, RefuseBadClipPlanes) {
  std::array<abut_clip_plane, 33> planes{};
  for (abut_clip_plane& plane : planes) plane = {{0, 0, 1}, -1};
  const auto refusal = [&](std::size_t count) {
    return abut_picker_set_clip_planes(world.picker(), planes.data(), count);
  };
  EXPECT_EQ(refusal(33), ABUT_OUT_OF_RANGE);
  EXPECT_TRUE(is_told("count is 33"));
  planes[2].normal = {0, 0, -0.0};
  EXPECT_EQ(refusal(3), ABUT_ZERO_VECTOR);
  EXPECT_TRUE(is_told("planes[2].normal"));
  planes[2].normal = {0, not_a_number, 1};
  EXPECT_EQ(refusal(3), ABUT_NOT_FINITE);
  EXPECT_TRUE(is_told("planes[2].normal is nan"));
  planes[2] = {{0, 0, 1}, -infinity};
  EXPECT_EQ(refusal(3), ABUT_NOT_FINITE);
  EXPECT_TRUE(is_told("planes[2].offset is -inf"));
  planes[2].offset = 1e71;
  EXPECT_EQ(refusal(3), ABUT_OUT_OF_RANGE);
  EXPECT_TRUE(is_told("planes[2].offset"));
  EXPECT_EQ(abut_picker_set_clip_planes(world.picker(), nullptr, 1), ABUT_NULL_ARGUMENT);
  EXPECT_TRUE(is_told("planes is null"));
}

TEST_F(Tools, RefuseBadRectangles) {
  abut_camera camera;
  abut_camera_init(&camera, sizeof camera);
  std::size_t count = 77;
  const auto refusal = [&](double x0, double y0, double x1, double y1, abut_selection selection) {
    return abut_picker_select_rectangle(world.picker(), &camera, x0, y0, x1, y1, selection, nullptr, nullptr, 0,
                                        &count);
  };
  EXPECT_EQ(refusal(not_a_number, 0, 0, 0, 0), ABUT_NOT_FINITE);
  EXPECT_TRUE(is_told("x0 is nan"));
  EXPECT_EQ(refusal(0, infinity, 0, 0, 0), ABUT_NOT_FINITE);
  EXPECT_TRUE(is_told("y0 is inf"));
  EXPECT_EQ(refusal(0, 0, 0, 0, 2), ABUT_UNKNOWN_VALUE);
  EXPECT_TRUE(is_told("selection is 2"));
  camera.pixel_aspect = 0;
  EXPECT_EQ(refusal(0, 0, 0, 0, 0), ABUT_OUT_OF_RANGE);
  EXPECT_TRUE(is_told("camera.pixel_aspect is 0"));
  camera.pixel_aspect = 1;
  camera.near_distance = -1;
  EXPECT_EQ(refusal(0, 0, 0, 0, 0), ABUT_OUT_OF_RANGE);
  EXPECT_TRUE(is_told("camera.near_distance is -1"));
  EXPECT_EQ(count, 77U);
}

TEST_F(Tools, RefuseBadSnaps) {
  abut_camera camera;
  abut_camera_init(&camera, sizeof camera);
  abut_snap out{};
  out.pixels = -7;
  EXPECT_EQ(abut_picker_snap(world.picker(), &camera, 0, 0, -1, 0, nullptr, &out), ABUT_OUT_OF_RANGE);
  EXPECT_TRUE(is_told("radius is -1"));
  EXPECT_EQ(abut_picker_snap(world.picker(), &camera, 0, 0, 1, 8, nullptr, &out), ABUT_UNKNOWN_VALUE);
  EXPECT_TRUE(is_told("kinds is 8"));
  EXPECT_EQ(abut_picker_snap(world.picker(), &camera, 0, infinity, 1, 0, nullptr, &out), ABUT_NOT_FINITE);
  EXPECT_TRUE(is_told("y is inf"));
  EXPECT_EQ(out.pixels, -7);
}

// Cameras of every extreme that is allowed are answered.
TEST_F(Tools, AnswerExtremeCameras) {
  for (const double far : {1e-60, 1e60}) {
    for (const abut_projection projection : {ABUT_PROJECTION_PERSPECTIVE, ABUT_PROJECTION_ORTHOGRAPHIC}) {
      abut_camera camera;
      abut_camera_init(&camera, sizeof camera);
      camera.projection = projection;
      camera.vertical_extent = camera.pixel_aspect = far;
      camera.shift_x = far;
      camera.vertical_fov = far < 1 ? 1e-300 : 3.14159265358979;
      camera.depth_axis = ABUT_DEPTH_ALONG_AXIS;
      abut_pick pick{};
      abut_snap snap{};
      for (const double x : {-1e300, 0.0, 320.0, 1e300}) {
        EXPECT_EQ(abut_picker_pick_pixel(world.picker(), &camera, x, x, 5, nullptr, &pick), ABUT_OK);
        EXPECT_EQ(abut_picker_snap(world.picker(), &camera, x, x, 5, 0, nullptr, &snap), ABUT_OK);
        for (const abut_selection selection : {ABUT_SELECTION_TOUCHING, ABUT_SELECTION_INSIDE})
          selected_by(world, camera, {x, x, 10, 10}, selection);
      }
    }
  }
}

}  // namespace
