// SPDX-License-Identifier: Apache-2.0
// picking.h: no finite input ends the process, and rays stay right where numbers are very large or very small.
#include "picking_scene.hpp"

#include <abut/picking.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace {

using namespace picking_test;

constexpr double largest = std::numeric_limits<double>::max();
constexpr double smallest = std::numeric_limits<double>::denorm_min();
constexpr std::array sizes{smallest, 1e-310, 1e-300, 1e-160, 1e-50, 1e-40, 1e-20, 1e-8,   1.0,
                           1e8,      1e18,   1e20,   1e39,   1e60,  1e160, 1e300, largest};

World mixed_world() {
  World world;
  world.add(sphere(1), {0, 0, 0});
  world.add(ball_mesh(1, 10), {0, 5, 0});
  world.add(ball_mesh(1, 8), {0, -5, 0});
  return world;
}

// All ways to ask for one ray.
void ask(World& world, const abut_ray& ray) {
  std::array<abut_ray, 9> rays{};
  rays.fill(ray);
  std::array<abut_pick, 9> picks{};
  abut_query_filter filter;
  abut_query_filter_init(&filter, sizeof filter);
  filter.mask = 1;
  std::size_t count = 0;
  for (const abut_query_filter* wanted : {static_cast<const abut_query_filter*>(nullptr), &std::as_const(filter)}) {
    for (const abut_coherence coherence : {ABUT_COHERENCE_NONE, ABUT_COHERENCE_NEIGHBOURS})
      (void)abut_picker_cast_rays(world.picker(), rays.data(), rays.size(), coherence, wanted, picks.data());
    (void)abut_picker_cast_ray(world.picker(), &ray, wanted, picks.data());
    (void)abut_picker_cast_ray_all(world.picker(), &ray, wanted, picks.data(), picks.size(), &count);
  }
}

TEST(PickerExtremes, DirectionsOfAnyLengthMeetTheSame) {
  World world = mixed_world();
  for (const double size : sizes) {
    for (const double y : {0.0, 5.0, -5.0}) {
      const abut_ray ray{{-10, y, 0}, {size, 0, 0}, infinity};
      EXPECT_NEAR(world.pick(ray).distance, 9, 1e-9) << size;
      EXPECT_EQ(world.pick_all(ray).size(), 2U) << size;
      for (const abut_coherence coherence : {ABUT_COHERENCE_NONE, ABUT_COHERENCE_NEIGHBOURS}) {
        abut_pick pick{};
        ASSERT_EQ(abut_picker_cast_rays(world.picker(), &ray, 1, coherence, nullptr, &pick), ABUT_OK);
        EXPECT_NEAR(pick.distance, 9, 1e-9) << size;
      }
    }
  }
}

TEST(PickerExtremes, SubnormalDirectionsKeepTheirAngle) {
  World world;
  const Placed ball = world.add(ball_mesh(1, 10), {3, 4, 0});
  const abut_pick pick = world.pick({{0, 0, 0}, {3e-310, 4e-310, 0}, infinity});
  EXPECT_TRUE(same(pick.geometry, ball.geometry));
  EXPECT_NEAR(pick.distance, 4, 0.1);
}

TEST(PickerExtremes, NoRayEndsTheProcess) {
  World world = mixed_world();
  World empty;
  for (const double place : sizes) {
    for (const double way : sizes) {
      for (const double limit : {0.0, smallest, 1e-40, 1.0, 1e39, largest, infinity}) {
        for (const double sign : {-1.0, 1.0}) {
          ask(world, {{sign * place, place, 0}, {-sign * way, smallest, way}, limit});
          ask(world, {{0, sign * place, -place}, {smallest, -sign * way, 0}, limit});
        }
      }
      ask(empty, {{place, 0, 0}, {way, way, way}, infinity});
    }
  }
}

TEST(PickerExtremes, OriginsBeyondTheLimitAreRefused) {
  World world = mixed_world();
  const abut_ray ray{{0, 2e70, 0}, {1, 0, 0}, infinity};
  abut_pick pick{};
  EXPECT_EQ(abut_picker_cast_ray(world.picker(), &ray, nullptr, &pick), ABUT_OUT_OF_RANGE);
  EXPECT_NE(std::string(abut_last_error_message()).find("origin"), std::string::npos);
  const std::array rays{along_x, along_x, ray, along_x, along_x};
  std::array<abut_pick, 5> picks{};
  EXPECT_EQ(abut_picker_cast_rays(world.picker(), rays.data(), 5, ABUT_COHERENCE_NONE, nullptr, picks.data()),
            ABUT_OUT_OF_RANGE);
  EXPECT_NE(std::string(abut_last_error_message()).find("rays[2]"), std::string::npos);
}

TEST(PickerExtremes, RaysFromFarAwayMeet) {
  World world = mixed_world();
  for (const double far : {1e6, 1e9, 1e12}) {
    for (const double y : {0.0, 5.0})
      EXPECT_NEAR(world.pick({{-far, y, 0}, {1, 0, 0}, infinity}).distance, far - 1, 1e-15 * far + 1e-3);
  }
}

// Everything a thousandth of a billion times as large, and a billion billion times: shapes, places and rays.
TEST(PickerExtremes, ScenesOfAnySizeAgreeWithTheUniverse) {
  for (const double size : {1e-60, 1e-30, 1e-18, 1e-12, 1e-7, 1e7, 1e11, 1e15, 1e20, 1e40, 1e60}) {
    SCOPED_TRACE(size);
    World world;
    Random random(17);
    const std::array shapes{sphere(size), box(size, 2 * size, size), ball_mesh(size, 6), ground_mesh(size, 6, 0)};
    std::vector<abut_vec3> places;
    for (int i = 0; i < 12; ++i) {
      places.push_back(size * random.point(6));
      world.add(shapes[static_cast<std::size_t>(i) % shapes.size()], places.back(), random.turn());
    }
    ASSERT_EQ(abut_universe_refresh(world.universe()), ABUT_OK);
    int hits = 0;
    for (int i = 0; i < 200; ++i) {
      const abut_vec3 from = size * random.point(12);
      const abut_vec3 to = places[random.below(places.size())] + 0.5 * size * random.point(1);
      const abut_ray ray{from, to - from, infinity};
      const abut_pick expected = hit_of_universe(world, ray, nullptr);
      EXPECT_TRUE(is_same_pick(world.pick(ray), expected, 30 * size)) << i;
      std::array<abut_pick, 2> picks{};
      for (const abut_coherence coherence : {ABUT_COHERENCE_NONE, ABUT_COHERENCE_NEIGHBOURS}) {
        ASSERT_EQ(abut_picker_cast_rays(world.picker(), &ray, 1, coherence, nullptr, &picks[coherence]), ABUT_OK);
        EXPECT_TRUE(is_same_pick(picks[coherence], expected, 30 * size)) << i;
      }
      hits += expected.geometry.slot != 0 ? 1 : 0;
    }
    EXPECT_GT(hits, 50);
  }
}

TEST(PickerExtremes, GeometriesThatLeaveTheTraceableSpaceAreStillMet) {
  World world;
  for (const Placed& placed : {world.add(sphere(1), {0, 0, 0}), world.add(ball_mesh(1, 10), {0, 0, 0})}) {
    for (const double far : {1e3, 1e14, 1e40, 1e3, 0.0}) {
      world.move(placed, {far, 100, 0});
      ASSERT_EQ(abut_universe_refresh(world.universe()), ABUT_OK);
      const abut_ray ray{{far, 100, -10}, {0, 0, 1}, infinity};
      EXPECT_TRUE(same(world.pick(ray).geometry, placed.geometry)) << far;
      EXPECT_NEAR(world.pick(ray).distance, 9, 1e-9) << far;
    }
    world.remove(placed);
  }
}

// Cameras whose numbers are at the ends of what they may be.
TEST(PickerExtremes, NoCameraEndsTheProcess) {
  World world = mixed_world();
  world.add(plane({0, 0, 1}, -3), {0, 0, 0});
  world.add(shape_of_kind("segment", std::array{1.0}), {0, 2, 0});
  abut_pick pick{};
  abut_ray ray{};
  for (const double number : sizes) {
    for (int field = 0; field < 6; ++field) {
      abut_camera camera;
      abut_camera_init(&camera, sizeof camera);
      camera.width = camera.height = 4;
      camera.pose.position = {0, 0, 10};
      double x = 2;
      double radius = 3;
      if (field == 0) camera.pose.position.x = number;
      if (field == 1) camera.vertical_fov = std::min(number, 3.1415926535897927);
      if (field == 2) camera.near_distance = number;
      if (field == 3) camera.far_distance = number;
      if (field == 4) x = number;
      if (field == 5) radius = number;
      std::array<abut_pick, 16> picture{};
      (void)abut_camera_ray(&camera, x, -x, &ray);
      (void)abut_picker_pick_pixel(world.picker(), &camera, x, -x, radius, nullptr, &pick);
      (void)abut_picker_pick_pixel(world.picker(), &camera, -x, 3 * radius, radius, nullptr, &pick);
      (void)abut_picker_render(world.picker(), &camera, nullptr, picture.data(), picture.size());
    }
  }
  const std::array<abut_vec3, 4> ends{{{largest, 0, 0}, {0, -largest, largest}, {smallest, 0, smallest}, {0, 0, 0}}};
  for (const abut_vec3& eye : ends) {
    for (const abut_vec3& target : ends) {
      for (const abut_vec3& up : ends) {
        abut_camera camera;
        abut_camera_init(&camera, sizeof camera);
        (void)abut_camera_look_at(&camera, &eye, &target, &up);
        (void)abut_picker_pick_pixel(world.picker(), &camera, 320, 240, 10, nullptr, &pick);
      }
    }
  }
}

TEST(PickerExtremes, ANarrowViewSeesFarThings) {
  World world;
  const Placed ball = world.add(sphere(1), {0, 0, -1e6});
  abut_camera camera;
  abut_camera_init(&camera, sizeof camera);
  camera.vertical_fov = 1e-6;
  abut_pick pick{};
  ASSERT_EQ(abut_picker_pick_pixel(world.picker(), &camera, 320, 240, 0, nullptr, &pick), ABUT_OK);
  EXPECT_TRUE(same(pick.geometry, ball.geometry));
  camera.vertical_fov = smallest;
  ASSERT_EQ(abut_picker_pick_pixel(world.picker(), &camera, 320, 240, 0, nullptr, &pick), ABUT_OK);
  EXPECT_TRUE(same(pick.geometry, ball.geometry));
}

// The scenes of rays lie around what is in them, so that no origin has to be set.
void expect_precise_at(World& world, double far, double tolerance) {
  Random random(3);
  for (int i = 0; i < 400; ++i) {
    const abut_ray ray{{far + random.in(-3, 3), far + random.in(-3, 3), 5},
                       {random.in(-0.3, 0.3), random.in(-0.3, 0.3), -1},
                       infinity};
    const abut_pick found = world.pick(ray), wanted = world.brute(ray);
    ASSERT_TRUE(same(found.geometry, wanted.geometry)) << far;
    if (wanted.geometry.slot != 0) EXPECT_NEAR(found.distance, wanted.distance, tolerance) << far;
  }
}

TEST(PickerExtremes, AWorldFarFromZeroCostsNoDigits) {
  for (const double far : {1e4, 1e7, 1e9}) {
    World world;
    const Placed ground = world.add(ground_mesh(2, 20, 0.3), {far, far, 0});
    world.add(sphere(0.5), {far, far, 1});
    world.add(prism(12), {far + 1, far, 1});
    expect_precise_at(world, far, 1e-13);
    world.move(ground, {far + 0.25, far, 0});
    expect_precise_at(world, far, 1e-13);
  }
}

// Where a ray meets an edge, single precision may name the neighbour.
TEST(PickerExtremes, AWideWorldIsPreciseAtBothEnds) {
  for (const double far : {1e4, 1e7, 1e9}) {
    World world;
    const Shape ground = ground_mesh(2, 20, 0.3);
    world.add(ground, {far, far, 0});
    world.add(ground, {0, 0, 0});
    world.add(sphere(0.5), {far, far, 1});
    world.add(sphere(0.5), {-far, 0, 1});
    expect_precise_at(world, far, 1e-6);
    expect_precise_at(world, 0, 1e-6);
  }
}

}  // namespace
