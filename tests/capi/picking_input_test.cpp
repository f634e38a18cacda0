// SPDX-License-Identifier: Apache-2.0
// picking.h: bad input of every kind has a status and a message of its own, and nothing is written.
#include "picking_support.hpp"

#include <abut/picking.h>
#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

namespace {

using namespace picking_test;

// Clears the message, so that the next refusal has to write one.
::testing::AssertionResult refuses(abut_status status, abut_status expected, const std::string& named) {
  const std::string message = abut_last_error_message();
  EXPECT_EQ(abut_set_last_error(ABUT_OK, nullptr), ABUT_OK);
  if (status != expected) {
    return ::testing::AssertionFailure() << abut_status_name(status) << " (" << message << "), expected "
                                         << abut_status_name(expected);
  }
  if (message.find(named) == std::string::npos)
    return ::testing::AssertionFailure() << "no '" << named << "' in: " << message;
  return ::testing::AssertionSuccess();
}

struct BadRay {
  abut_ray ray;
  abut_status status;
  std::string named;
};

std::vector<BadRay> bad_rays() {
  return {{{{not_a_number, 0, 0}, {1, 0, 0}, 1}, ABUT_NOT_FINITE, "origin"},
          {{{0, infinity, 0}, {1, 0, 0}, 1}, ABUT_NOT_FINITE, "origin"},
          {{{0, 0, -infinity}, {1, 0, 0}, 1}, ABUT_NOT_FINITE, "origin"},
          {{{0, 0, 0}, {not_a_number, 0, 0}, 1}, ABUT_NOT_FINITE, "direction"},
          {{{0, 0, 0}, {0, infinity, 0}, 1}, ABUT_NOT_FINITE, "direction"},
          {{{0, 0, 0}, {0, 0, -0.0}, 1}, ABUT_ZERO_VECTOR, "direction"},
          {{{0, 0, 0}, {1, 0, 0}, -1e-300}, ABUT_OUT_OF_RANGE, "max_distance"},
          {{{0, 0, 0}, {1, 0, 0}, -infinity}, ABUT_OUT_OF_RANGE, "max_distance"},
          {{{0, 0, 0}, {1, 0, 0}, not_a_number}, ABUT_NOT_FINITE, "max_distance"}};
}

TEST(BadInput, OfCastRayIsRefused) {
  World world;
  abut_pick pick{};
  pick.distance = -7;
  EXPECT_TRUE(refuses(abut_picker_cast_ray(nullptr, &along_x, nullptr, &pick), ABUT_NULL_ARGUMENT, "picker"));
  EXPECT_TRUE(refuses(abut_picker_cast_ray(world.picker(), nullptr, nullptr, &pick), ABUT_NULL_ARGUMENT, "ray"));
  EXPECT_TRUE(refuses(abut_picker_cast_ray(world.picker(), &along_x, nullptr, nullptr), ABUT_NULL_ARGUMENT, "out"));
  for (const BadRay& bad : bad_rays())
    EXPECT_TRUE(refuses(abut_picker_cast_ray(world.picker(), &bad.ray, nullptr, &pick), bad.status, bad.named));
  EXPECT_DOUBLE_EQ(pick.distance, -7);
}

// A picker that is up to date and shows a surface has a way of its own for the usual ray.
TEST(BadInput, OfCastRayIsRefusedNearASurface) {
  World world;
  world.add(ball_mesh(1, 10), {0, 0, 0});
  ASSERT_NE(world.pick(along_x).geometry.slot, 0U);
  std::vector<BadRay> bad = bad_rays();
  for (const double value : {not_a_number, infinity, -infinity}) {
    bad.push_back({{{value, 0, 0}, {1, 0, 0}, 1}, ABUT_NOT_FINITE, "origin"});
    bad.push_back({{{0, value, 0}, {1, 0, 0}, 1}, ABUT_NOT_FINITE, "origin"});
    bad.push_back({{{0, 0, value}, {1, 0, 0}, 1}, ABUT_NOT_FINITE, "origin"});
    bad.push_back({{{0, 0, 0}, {value, 0, 0}, 1}, ABUT_NOT_FINITE, "direction"});
    bad.push_back({{{0, 0, 0}, {1, value, 0}, 1}, ABUT_NOT_FINITE, "direction"});
    bad.push_back({{{0, 0, 0}, {1, 0, value}, 1}, ABUT_NOT_FINITE, "direction"});
  }
  abut_pick pick{};
  pick.distance = -7;
  for (const BadRay& ray : bad)
    EXPECT_TRUE(refuses(abut_picker_cast_ray(world.picker(), &ray.ray, nullptr, &pick), ray.status, ray.named));
  EXPECT_DOUBLE_EQ(pick.distance, -7);
}

// Rays are checked four at a time, and the rest one by one.
TEST(BadInput, OfCastRaysIsNamedWhereverItIs) {
  World world;
  world.add(ball_mesh(1, 10), {0, 0, 0});
  for (const BadRay& bad : bad_rays()) {
    for (std::size_t i = 0; i < 10; ++i) {
      std::array<abut_ray, 10> rays{};
      rays.fill(along_x);
      rays[i] = bad.ray;
      std::array<abut_pick, 10> picks{};
      picks[0].distance = -7;
      const auto cast = [&] {
        return abut_picker_cast_rays(world.picker(), rays.data(), rays.size(), ABUT_COHERENCE_NONE, nullptr,
                                     picks.data());
      };
      EXPECT_TRUE(refuses(cast(), bad.status, "rays[" + std::to_string(i) + "]"));
      EXPECT_DOUBLE_EQ(picks[0].distance, -7);
      // Of an unusual length, yet good.
      rays[i] = {{-10, 0, 0}, {1e-300, 0, 0}, infinity};
      EXPECT_EQ(cast(), ABUT_OK);
      EXPECT_NEAR(picks[i].distance, 9, 1e-9);
    }
  }
}

TEST(BadInput, OfCastRaysIsRefused) {
  World world;
  std::array<abut_ray, 3> rays{along_x, along_x, along_x};
  std::array<abut_pick, 3> picks{};
  picks[0].distance = -7;
  const auto cast = [&](abut_coherence coherence) {
    return abut_picker_cast_rays(world.picker(), rays.data(), rays.size(), coherence, nullptr, picks.data());
  };
  EXPECT_TRUE(
      refuses(abut_picker_cast_rays(nullptr, rays.data(), 3, 0, nullptr, picks.data()), ABUT_NULL_ARGUMENT, "picker"));
  EXPECT_TRUE(
      refuses(abut_picker_cast_rays(world.picker(), nullptr, 3, 0, nullptr, picks.data()), ABUT_NULL_ARGUMENT, "rays"));
  EXPECT_TRUE(
      refuses(abut_picker_cast_rays(world.picker(), rays.data(), 3, 0, nullptr, nullptr), ABUT_NULL_ARGUMENT, "out"));
  EXPECT_TRUE(refuses(cast(2), ABUT_UNKNOWN_VALUE, "coherence"));
  EXPECT_TRUE(refuses(abut_picker_cast_rays(world.picker(), rays.data(), std::numeric_limits<std::size_t>::max() / 8, 0,
                                            nullptr, picks.data()),
                      ABUT_SIZE_OVERFLOW, "count"));
  for (const BadRay& bad : bad_rays()) {
    rays[2] = bad.ray;
    EXPECT_TRUE(refuses(cast(ABUT_COHERENCE_NONE), bad.status, "rays[2]"));
    EXPECT_TRUE(refuses(cast(ABUT_COHERENCE_NEIGHBOURS), bad.status, bad.named));
  }
  EXPECT_DOUBLE_EQ(picks[0].distance, -7);
  EXPECT_EQ(abut_picker_cast_rays(world.picker(), nullptr, 0, 0, nullptr, nullptr), ABUT_OK);
}

TEST(BadInput, OfCastRayAllIsRefused) {
  World world;
  std::size_t count = 77;
  abut_pick pick{};
  EXPECT_TRUE(
      refuses(abut_picker_cast_ray_all(nullptr, &along_x, nullptr, &pick, 1, &count), ABUT_NULL_ARGUMENT, "picker"));
  EXPECT_TRUE(
      refuses(abut_picker_cast_ray_all(world.picker(), nullptr, nullptr, &pick, 1, &count), ABUT_NULL_ARGUMENT, "ray"));
  EXPECT_TRUE(refuses(abut_picker_cast_ray_all(world.picker(), &along_x, nullptr, nullptr, 1, &count),
                      ABUT_NULL_ARGUMENT, "picks"));
  EXPECT_TRUE(refuses(abut_picker_cast_ray_all(world.picker(), &along_x, nullptr, &pick, 1, nullptr),
                      ABUT_NULL_ARGUMENT, "count"));
  EXPECT_TRUE(refuses(abut_picker_cast_ray_all(world.picker(), &along_x, nullptr, &pick,
                                               std::numeric_limits<std::size_t>::max() / 4, &count),
                      ABUT_SIZE_OVERFLOW, "capacity"));
  for (const BadRay& bad : bad_rays()) {
    EXPECT_TRUE(
        refuses(abut_picker_cast_ray_all(world.picker(), &bad.ray, nullptr, &pick, 1, &count), bad.status, bad.named));
  }
  EXPECT_EQ(count, 77U);
}

struct BadCamera {
  abut_camera camera;
  abut_status status;
  std::string named;
};

std::vector<BadCamera> bad_cameras() {
  std::vector<BadCamera> cameras;
  const auto add = [&](abut_status status, const char* named, const auto& spoil) {
    BadCamera bad{{}, status, named};
    abut_camera_init(&bad.camera, sizeof bad.camera);
    spoil(bad.camera);
    cameras.push_back(bad);
  };
  add(ABUT_WRONG_STRUCT_SIZE, "struct_size", [](abut_camera& c) { c.struct_size = 0; });
  add(ABUT_WRONG_STRUCT_SIZE, "struct_size", [](abut_camera& c) { --c.struct_size; });
  add(ABUT_INVALID_ARGUMENT, "reserved", [](abut_camera& c) { c.reserved = 1; });
  add(ABUT_OUT_OF_RANGE, "width", [](abut_camera& c) { c.width = 0; });
  add(ABUT_OUT_OF_RANGE, "height", [](abut_camera& c) { c.height = 0; });
  add(ABUT_NOT_FINITE, "position", [](abut_camera& c) { c.pose.position.y = infinity; });
  add(ABUT_NOT_FINITE, "orientation", [](abut_camera& c) { c.pose.orientation.z = not_a_number; });
  add(ABUT_ZERO_VECTOR, "orientation", [](abut_camera& c) { c.pose.orientation.w = 0; });
  add(ABUT_NOT_UNIT, "orientation", [](abut_camera& c) { c.pose.orientation.w = 1.01; });
  add(ABUT_OUT_OF_RANGE, "vertical_fov", [](abut_camera& c) { c.vertical_fov = 0; });
  add(ABUT_OUT_OF_RANGE, "vertical_fov", [](abut_camera& c) { c.vertical_fov = std::numbers::pi; });
  add(ABUT_NOT_FINITE, "vertical_fov", [](abut_camera& c) { c.vertical_fov = not_a_number; });
  add(ABUT_OUT_OF_RANGE, "near_distance", [](abut_camera& c) { c.near_distance = -1; });
  add(ABUT_NOT_FINITE, "near_distance", [](abut_camera& c) { c.near_distance = infinity; });
  add(ABUT_NOT_FINITE, "far_distance", [](abut_camera& c) { c.far_distance = not_a_number; });
  add(ABUT_OUT_OF_RANGE, "far_distance", [](abut_camera& c) {
    c.near_distance = 2;
    c.far_distance = 1;
  });
  return cameras;
}

TEST(BadInput, OfCamerasIsRefused) {
  World world;
  abut_ray ray = along_x;
  abut_pick pick{};
  pick.distance = -7;
  std::vector<abut_pick> picture(640 * 480, pick);
  for (const BadCamera& bad : bad_cameras()) {
    EXPECT_TRUE(refuses(abut_camera_ray(&bad.camera, 1, 1, &ray), bad.status, bad.named));
    EXPECT_TRUE(
        refuses(abut_picker_pick_pixel(world.picker(), &bad.camera, 1, 1, 1, nullptr, &pick), bad.status, bad.named));
    EXPECT_TRUE(refuses(abut_picker_render(world.picker(), &bad.camera, nullptr, picture.data(), picture.size()),
                        bad.status, bad.named));
  }
  EXPECT_DOUBLE_EQ(ray.origin.x, -10);
  EXPECT_DOUBLE_EQ(pick.distance, -7);
  EXPECT_DOUBLE_EQ(picture[0].distance, -7);
}

TEST(BadInput, OfLookAtIsRefused) {
  abut_camera camera;
  abut_camera_init(&camera, sizeof camera);
  const abut_vec3 here{1, 2, 3};
  const abut_vec3 there{4, 5, 6};
  const abut_vec3 bad{0, not_a_number, 0};
  const abut_vec3 up{0, 0, 1};
  const abut_vec3 along{3, 3, 3};
  const abut_vec3 zero{0, 0, 0};
  EXPECT_TRUE(refuses(abut_camera_look_at(nullptr, &here, &there, &up), ABUT_NULL_ARGUMENT, "camera"));
  EXPECT_TRUE(refuses(abut_camera_look_at(&camera, nullptr, &there, &up), ABUT_NULL_ARGUMENT, "eye"));
  EXPECT_TRUE(refuses(abut_camera_look_at(&camera, &here, nullptr, &up), ABUT_NULL_ARGUMENT, "target"));
  EXPECT_TRUE(refuses(abut_camera_look_at(&camera, &here, &there, nullptr), ABUT_NULL_ARGUMENT, "up"));
  EXPECT_TRUE(refuses(abut_camera_look_at(&camera, &bad, &there, &up), ABUT_NOT_FINITE, "eye"));
  EXPECT_TRUE(refuses(abut_camera_look_at(&camera, &here, &bad, &up), ABUT_NOT_FINITE, "target"));
  EXPECT_TRUE(refuses(abut_camera_look_at(&camera, &here, &there, &bad), ABUT_NOT_FINITE, "up"));
  EXPECT_TRUE(refuses(abut_camera_look_at(&camera, &here, &here, &up), ABUT_ZERO_VECTOR, "target"));
  EXPECT_TRUE(refuses(abut_camera_look_at(&camera, &here, &there, &along), ABUT_ZERO_VECTOR, "up"));
  EXPECT_TRUE(refuses(abut_camera_look_at(&camera, &here, &there, &zero), ABUT_ZERO_VECTOR, "up"));
  EXPECT_DOUBLE_EQ(camera.pose.orientation.w, 1);
  camera.struct_size = 3;
  EXPECT_TRUE(refuses(abut_camera_look_at(&camera, &here, &there, &up), ABUT_WRONG_STRUCT_SIZE, "struct_size"));
}

TEST(BadInput, OfRenderIsRefused) {
  World world;
  abut_camera camera;
  abut_camera_init(&camera, sizeof camera);
  std::vector<abut_pick> picture(640 * 480);
  EXPECT_TRUE(refuses(abut_picker_render(nullptr, &camera, nullptr, picture.data(), picture.size()), ABUT_NULL_ARGUMENT,
                      "picker"));
  EXPECT_TRUE(refuses(abut_picker_render(world.picker(), nullptr, nullptr, picture.data(), picture.size()),
                      ABUT_NULL_ARGUMENT, "camera"));
  EXPECT_TRUE(refuses(abut_picker_render(world.picker(), &camera, nullptr, nullptr, picture.size()), ABUT_NULL_ARGUMENT,
                      "out"));
  EXPECT_TRUE(refuses(abut_picker_render(world.picker(), &camera, nullptr, picture.data(), picture.size() - 1),
                      ABUT_OUT_OF_RANGE, "capacity"));
  camera.width = camera.height = 0xffffffffU;
  EXPECT_TRUE(refuses(abut_picker_render(world.picker(), &camera, nullptr, picture.data(), picture.size()),
                      ABUT_SIZE_OVERFLOW, "width"));
}

}  // namespace
