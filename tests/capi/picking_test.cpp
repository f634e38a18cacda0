// SPDX-License-Identifier: Apache-2.0
// picking.h: rays against a universe, compared with rays against each shape in double.
#include "picking_scene.hpp"

#include <abut/picking.h>
#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <thread>
#include <vector>

namespace {

using namespace picking_test;

// Equal up to single precision of `size`, the size of the scene: near ties may go to either.
::testing::AssertionResult agrees(const abut_pick& pick, const abut_pick& expected, double size) {
  const double tolerance = 2e-6 * size;
  if (std::isinf(pick.distance) && std::isinf(expected.distance)) {
    if (pick.geometry.slot == 0) return ::testing::AssertionSuccess();
    return ::testing::AssertionFailure() << "a miss that names a geometry";
  }
  if (!(std::fabs(pick.distance - expected.distance) <= tolerance)) {
    return ::testing::AssertionFailure() << "distance " << pick.distance << " of geometry " << pick.geometry.slot
                                         << ", expected " << expected.distance << " of " << expected.geometry.slot;
  }
  if (same(pick.geometry, expected.geometry) && pick.feature.index == expected.feature.index) {
    if (length(pick.normal - expected.normal) > 1e-9) {
      return ::testing::AssertionFailure() << "normal is off by " << length(pick.normal - expected.normal);
    }
    if (std::fabs(pick.distance - expected.distance) > 1e-12 * (size + expected.distance)) {
      return ::testing::AssertionFailure()
             << "the same feature is hit " << pick.distance - expected.distance << " away";
    }
  }
  if (length(pick.point - expected.point) > tolerance) return ::testing::AssertionFailure() << "the point is off";
  return ::testing::AssertionSuccess();
}

// Shapes of every kind around `centre`; all but the ground and the plane turned.
std::vector<Placed> fill(World& world, Random& random, int bodies, const abut_vec3& centre, bool with_plane) {
  std::vector<double> corners;
  for (int i = 0; i < 60; ++i) corners.push_back(random.in(-0.8, 0.8));
  const std::array shapes{sphere(0.5),   box(0.4, 0.6, 0.3), capsule(0.2, 0.7),
                          hull(corners), ball_mesh(0.6, 6),  mesh({-1, -1, 0, 1, -1, 0, 0, 1, 0.3}, {0, 1, 2})};
  std::vector<Placed> placed;
  for (int i = 0; i < bodies; ++i) {
    const Shape& shape = shapes[static_cast<std::size_t>(i) % shapes.size()];
    placed.push_back(world.add(shape, centre + random.point(6), random.turn()));
  }
  world.add(ground_mesh(8, 24, 0.4), centre + abut_vec3{0, 0, -3});
  if (with_plane) world.add(plane({0.1, 0.2, 1}, dot({0.1, 0.2, 1}, centre) / std::sqrt(1.05) - 5), {0, 0, 0});
  return placed;
}

// Every way to ask for first hits gives what brute force gives.
void compare(World& world, Random& random, int rays, const abut_vec3& centre, double size) {
  std::vector<abut_ray> asked;
  for (int i = 0; i < rays; ++i) {
    const abut_vec3 from = centre + random.point(i % 3 == 0 ? 30 : 9);
    const abut_vec3 to = centre + random.point(5);
    asked.push_back({from, random.in(0.1, 5) * (to - from), i % 4 == 0 ? random.in(0, 20) : infinity});
  }
  std::vector<abut_pick> unrelated(asked.size());
  std::vector<abut_pick> neighbours(asked.size());
  ASSERT_EQ(
      abut_picker_cast_rays(world.picker(), asked.data(), asked.size(), ABUT_COHERENCE_NONE, nullptr, unrelated.data()),
      ABUT_OK);
  ASSERT_EQ(abut_picker_cast_rays(world.picker(), asked.data(), asked.size(), ABUT_COHERENCE_NEIGHBOURS, nullptr,
                                  neighbours.data()),
            ABUT_OK);
  for (std::size_t i = 0; i < asked.size(); ++i) {
    const abut_pick expected = world.brute(asked[i]);
    EXPECT_TRUE(agrees(world.pick(asked[i]), expected, size)) << "ray " << i;
    EXPECT_TRUE(agrees(unrelated[i], expected, size)) << "ray " << i;
    EXPECT_TRUE(agrees(neighbours[i], expected, size)) << "ray " << i;
  }
}

TEST(Picker, FindsNothingInAnEmptyUniverse) {
  World world;
  const abut_pick pick = world.pick(along_x);
  EXPECT_EQ(pick.geometry.slot, 0U);
  EXPECT_TRUE(std::isinf(pick.distance));
  EXPECT_TRUE(world.pick_all(along_x).empty());
  EXPECT_EQ(abut_picker_update(world.picker()), ABUT_OK);
}

TEST(Picker, MeetsAPlaneThatIsAlone) {
  World world;
  const Placed placed = world.add(plane({-1, 0, 0}, 0), {2, 0, 0});
  const abut_pick pick = world.pick(along_x);
  EXPECT_TRUE(same(pick.geometry, placed.geometry));
  EXPECT_DOUBLE_EQ(pick.distance, 12);
  EXPECT_DOUBLE_EQ(pick.normal.x, -1);
  EXPECT_EQ(world.pick_all(along_x).size(), 1U);
}

TEST(Picker, AgreesWithEachShapeInDouble) {
  for (const std::uint64_t seed : {11U, 12U, 13U}) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    World world;
    Random random(seed);
    fill(world, random, 40, {0, 0, 0}, seed != 12);
    compare(world, random, 1500, {0, 0, 0}, 30);
  }
}

TEST(Picker, KeepsItsDigitsFarFromTheOrigin) {
  World world;
  Random random(21);
  const abut_vec3 far{1e6, -1e6, 2e6};
  fill(world, random, 40, far, false);
  compare(world, random, 1000, far, 30);
}

TEST(Picker, KeepsItsDigitsWhenPartsMoveFarAway) {
  World world;
  Random random(22);
  const std::vector<Placed> placed = fill(world, random, 40, {0, 0, 0}, false);
  compare(world, random, 200, {0, 0, 0}, 30);
  const abut_vec3 far{-1e6, 3e5, 1e6};
  for (std::size_t i = 0; i < placed.size(); i += 2) world.move(placed[i], far + random.point(6), random.turn());
  compare(world, random, 500, {0, 0, 0}, 30);
  compare(world, random, 500, far, 30);
}

TEST(Picker, FollowsWhatMovesComesAndGoes) {
  World world;
  Random random(31);
  std::vector<Placed> placed = fill(world, random, 30, {0, 0, 0}, true);
  const Shape lone = ball_mesh(1, 8);
  for (int step = 0; step < 12; ++step) {
    SCOPED_TRACE("step " + std::to_string(step));
    for (std::size_t i = static_cast<std::size_t>(step) % 3; i < placed.size(); i += 3) {
      world.move(placed[i], random.point(6), random.turn());
    }
    if (step % 3 == 1) {
      world.remove(placed.back());
      placed.pop_back();
    }
    if (step % 4 == 2) placed.push_back(world.add(lone, random.point(4)));
    compare(world, random, 120, {0, 0, 0}, 30);
  }
}

TEST(Picker, SeesAMeshThatMovesAfterItWasBaked) {
  World world;
  const Placed ball = world.add(ball_mesh(1, 10), {0, 0, 0});
  world.add(ground_mesh(5, 8, 0), {0, 0, -4});
  EXPECT_NEAR(world.pick(along_x).distance, 9, 1e-12);
  world.move(ball, {3, 0, 0});
  EXPECT_NEAR(world.pick(along_x).distance, 12, 1e-12);
  world.remove(ball);
  EXPECT_EQ(world.pick(along_x).geometry.slot, 0U);
}

TEST(Picker, DoesNotReportAGeometryThatReplacedAnother) {
  World world;
  const Placed first = world.add(sphere(1), {0, 0, 0});
  EXPECT_TRUE(same(world.pick(along_x).geometry, first.geometry));
  world.remove(first);
  const Placed second = world.add(sphere(2), {0, 0, 0});
  EXPECT_TRUE(same(world.pick(along_x).geometry, second.geometry));
  EXPECT_DOUBLE_EQ(world.pick(along_x).distance, 8);
}

TEST(Picker, LeavesNoCracksBetweenTriangles) {
  World world;
  Random random(41);
  world.add(ground_mesh(100, 64, 2), {0, 0, 0});
  int missed = 0;
  for (int i = 1; i < 64; ++i) {
    for (int j = 1; j < 64; ++j) {
      const double x = 100 * (2.0 * i / 64 - 1);
      const double y = 100 * (2.0 * j / 64 - 1);
      for (const double t : {0.0, 0.3, 0.7}) {
        const double step = 200.0 / 64 * t;
        for (const abut_vec3& target :
             {abut_vec3{x, y, 0}, {x + step, y, 0}, {x, y + step, 0}, {x + step, y + step, 0}}) {
          // From above: the ground is closed, so every ray inside of its outline must meet it.
          missed += world.pick({target + abut_vec3{0, 0, 500}, {0, 0, -1}, infinity}).geometry.slot == 0 ? 1 : 0;
        }
      }
    }
  }
  EXPECT_EQ(missed, 0);
}

TEST(Picker, EndsRaysAtTheirLimit) {
  World world;
  world.add(sphere(1), {0, 0, 0});
  world.add(ball_mesh(1, 10), {0, 5, 0});
  world.add(plane({-1, 0, 0}, 0), {4, 0, 0});
  EXPECT_EQ(world.pick({{-10, 0, 0}, {3, 0, 0}, 8.999}).geometry.slot, 0U);
  EXPECT_NE(world.pick({{-10, 0, 0}, {3, 0, 0}, 9.001}).geometry.slot, 0U);
  EXPECT_EQ(world.pick({{-10, 5, 0}, {3, 0, 0}, 8.999}).geometry.slot, 0U);
  EXPECT_NE(world.pick({{-10, 5, 0}, {3, 0, 0}, 9.001}).geometry.slot, 0U);
  EXPECT_EQ(world.pick({{-10, 9, 0}, {3, 0, 0}, 13.999}).geometry.slot, 0U);
  EXPECT_NE(world.pick({{-10, 9, 0}, {3, 0, 0}, 14.001}).geometry.slot, 0U);
}

TEST(Picker, TakesDirectionsOfAnyLength) {
  World world;
  world.add(sphere(1), {0, 0, 0});
  world.add(ball_mesh(1, 10), {0, 5, 0});
  for (const double size : {1e-300, 1e-160, 1.0, 1e160, 1e300}) {
    EXPECT_NEAR(world.pick({{-10, 0, 0}, {size, 0, 0}, infinity}).distance, 9, 1e-9);
    EXPECT_NEAR(world.pick({{-10, 5, 0}, {size, 0, 0}, infinity}).distance, 9, 1e-9);
  }
}

TEST(Picker, MeetsTheFarSideFromInside) {
  World world;
  world.add(sphere(2), {0, 0, 0});
  world.add(box(1, 1, 1), {20, 0, 0});
  world.add(ball_mesh(1, 10), {40, 0, 0});
  EXPECT_DOUBLE_EQ(world.pick({{0, 0, 0}, {1, 0, 0}, infinity}).distance, 2);
  EXPECT_NEAR(world.pick({{20, 0.2, 0}, {1, 0, 0}, infinity}).distance, 1, 1e-12);
  EXPECT_NEAR(world.pick({{40, 0, 0}, {1, 0, 0}, infinity}).distance, 1, 1e-12);
}

TEST(CastRayAll, ReportsEachCrossingInOrder) {
  World world;
  const Placed ball = world.add(sphere(1), {0, 0, 0});
  const Placed cube = world.add(box(1, 1, 1), {5, 0.25, 0.125});
  const Placed pill = world.add(capsule(0.5, 1), {10, 0, 0});
  const Placed still = world.add(ball_mesh(1, 10), {15, 0, 0});
  const Placed wall = world.add(plane({-1, 0, 0}, 0), {20, 0, 0});
  const std::vector<abut_pick> picks = world.pick_all(along_x);
  const std::array expected{ball, ball, cube, cube, pill, pill, still, still, wall};
  const std::array distances{9.0, 11.0, 14.0, 16.0, 19.5, 20.5, 24.0, 26.0, 30.0};
  ASSERT_EQ(picks.size(), expected.size());
  for (std::size_t i = 0; i < picks.size(); ++i) {
    EXPECT_TRUE(same(picks[i].geometry, expected[i].geometry)) << i;
    EXPECT_NEAR(picks[i].distance, distances[i], 1e-9) << i;
    EXPECT_EQ(picks[i].normal.x < 0, i % 2 == 0) << i;
  }
}

TEST(CastRayAll, CountsAnEdgeBetweenTrianglesOnce) {
  World world;
  world.add(ground_mesh(4, 8, 0), {0, 0, 0});
  const Placed moving = world.add(ground_mesh(4, 8, 0), {0, 0, 1});
  world.add(box(3, 3, 0.25), {0, 0, -2});
  (void)world.pick(along_x);
  world.move(moving, {0, 0, 2});
  // Through a vertex, an edge, a diagonal of the grounds, and the diagonal of the faces of the box.
  for (const abut_vec3& from : {abut_vec3{1, 1, 9}, {1, 0.4, 9}, {0.5, 0.5, 9}, {-0.5, -0.5, 9}}) {
    EXPECT_EQ(world.pick_all({from, {0, 0, -1}, infinity}).size(), 4U) << from.x << ' ' << from.y;
  }
}

TEST(CastRayAll, BeginsWithTheFirstHit) {
  World world;
  Random random(51);
  fill(world, random, 40, {0, 0, 0}, true);
  for (int i = 0; i < 500; ++i) {
    const abut_vec3 from = random.point(12);
    const abut_ray ray{from, random.point(4) - from, infinity};
    const std::vector<abut_pick> picks = world.pick_all(ray);
    const abut_pick first = world.pick(ray);
    ASSERT_EQ(picks.empty(), first.geometry.slot == 0);
    if (!picks.empty()) EXPECT_NEAR(picks.front().distance, first.distance, 1e-9) << i;
    for (std::size_t k = 1; k < picks.size(); ++k) EXPECT_GE(picks[k].distance, picks[k - 1].distance);
  }
}

TEST(CastRayAll, WritesNoMoreThanTheCapacity) {
  World world;
  world.add(sphere(1), {0, 0, 0});
  std::array<abut_pick, 2> picks{};
  picks[1].distance = -7;
  std::size_t count = 0;
  ASSERT_EQ(abut_picker_cast_ray_all(world.picker(), &along_x, nullptr, picks.data(), 1, &count), ABUT_OK);
  EXPECT_EQ(count, 2U);
  EXPECT_DOUBLE_EQ(picks[0].distance, 9);
  EXPECT_DOUBLE_EQ(picks[1].distance, -7);
}

abut_camera camera_at(const abut_vec3& eye, const abut_vec3& target) {
  abut_camera camera;
  abut_camera_init(&camera, sizeof camera);
  const abut_vec3 up{0, 0, 1};
  EXPECT_EQ(abut_camera_look_at(&camera, &eye, &target, &up), ABUT_OK);
  return camera;
}

TEST(Camera, LooksAlongMinusZByDefault) {
  abut_camera camera;
  abut_camera_init(&camera, sizeof camera);
  abut_ray ray;
  ASSERT_EQ(abut_camera_ray(&camera, 320, 240, &ray), ABUT_OK);
  EXPECT_NEAR(ray.direction.z, -1, 1e-15);
  EXPECT_TRUE(std::isinf(ray.max_distance));
  // The upper border of the picture is half of the angle above the middle.
  ASSERT_EQ(abut_camera_ray(&camera, 320, 0, &ray), ABUT_OK);
  EXPECT_NEAR(ray.direction.y, std::sin(0.5), 1e-12);
  ASSERT_EQ(abut_camera_ray(&camera, 400, 240, &ray), ABUT_OK);
  EXPECT_GT(ray.direction.x, 0);
}

TEST(Camera, LooksAtItsTarget) {
  Random random(61);
  for (int i = 0; i < 200; ++i) {
    const abut_vec3 eye = random.point(10);
    const abut_vec3 target = random.point(10);
    const abut_vec3 up = random.point(1);
    abut_camera camera;
    abut_camera_init(&camera, sizeof camera);
    ASSERT_EQ(abut_camera_look_at(&camera, &eye, &target, &up), ABUT_OK);
    abut_ray middle;
    ASSERT_EQ(abut_camera_ray(&camera, 320, 240, &middle), ABUT_OK);
    const abut_vec3 sight = (1 / length(target - eye)) * (target - eye);
    EXPECT_NEAR(length(middle.direction - sight), 0, 1e-12);
    abut_ray above;
    ASSERT_EQ(abut_camera_ray(&camera, 320, 200, &above), ABUT_OK);
    EXPECT_GT(dot(above.direction - middle.direction, up), 0);
  }
}

TEST(Camera, StartsAtNearAndEndsAtFar) {
  abut_camera camera;
  abut_camera_init(&camera, sizeof camera);
  camera.near_distance = 2;
  camera.far_distance = 5;
  abut_ray ray;
  ASSERT_EQ(abut_camera_ray(&camera, 320, 240, &ray), ABUT_OK);
  EXPECT_NEAR(ray.origin.z, -2, 1e-15);
  EXPECT_DOUBLE_EQ(ray.max_distance, 3);
}

TEST(Render, GivesWhatTheRaysOfThePixelsGive) {
  for (const std::uint32_t width : {1U, 3U, 16U, 61U}) {
    World world;
    Random random(71);
    fill(world, random, 40, {0, 0, 0}, true);
    abut_camera camera = camera_at({9, -8, 5}, {0, 0, -1});
    camera.width = width;
    camera.height = 37;
    std::vector<abut_pick> picture(std::size_t{width} * 37);
    ASSERT_EQ(abut_picker_render(world.picker(), &camera, nullptr, picture.data(), picture.size()), ABUT_OK);
    for (std::uint32_t y = 0; y < 37; ++y) {
      for (std::uint32_t x = 0; x < width; ++x) {
        abut_ray ray;
        ASSERT_EQ(abut_camera_ray(&camera, x + 0.5, y + 0.5, &ray), ABUT_OK);
        EXPECT_TRUE(agrees(picture[std::size_t{y} * width + x], world.brute(ray), 30)) << x << ' ' << y;
      }
    }
  }
}

TEST(PickPixel, PrefersWhatLiesUnderThePoint) {
  World world;
  const Placed ball = world.add(sphere(1), {0, 0, 0});
  const abut_camera camera = camera_at({-10, 0, 0}, {0, 0, 0});
  abut_pick pick{};
  ASSERT_EQ(abut_picker_pick_pixel(world.picker(), &camera, 320, 240, 20, nullptr, &pick), ABUT_OK);
  EXPECT_TRUE(same(pick.geometry, ball.geometry));
  EXPECT_NEAR(pick.distance, 9, 1e-12);
}

// Shapes that are thinner than a pixel, 6 pixels to the side of what is asked for.
TEST(PickPixel, FindsThinThings) {
  const abut_camera camera = camera_at({-10, 0, 0}, {0, 0, 0});
  const double pixel = 10 * std::tan(0.5) / 240;  // size of a pixel at the distance of the shapes
  const std::array shapes{box(0.1 * pixel, 0.01 * pixel, 1), capsule(0.01 * pixel, 1), sphere(0.05 * pixel),
                          mesh({0, -0.01 * pixel, -1, 0, 0.01 * pixel, -1, 0, 0, 1}, {0, 1, 2}),
                          hull({0, -0.01 * pixel, -1, 0, 0.01 * pixel, -1, 0, 0, 1, 0.01, 0, 0})};
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    SCOPED_TRACE("shape " + std::to_string(i));
    World world;
    const Placed thin = world.add(shapes[i], {0, 6.3 * pixel, 0});
    world.add(sphere(0.5), {0, -0.5 - 9 * pixel, 0});
    abut_pick pick{};
    ASSERT_EQ(abut_picker_pick_pixel(world.picker(), &camera, 320, 240, 0, nullptr, &pick), ABUT_OK);
    EXPECT_EQ(pick.geometry.slot, 0U);
    ASSERT_EQ(abut_picker_pick_pixel(world.picker(), &camera, 320, 240, 5, nullptr, &pick), ABUT_OK);
    EXPECT_EQ(pick.geometry.slot, 0U);
    ASSERT_EQ(abut_picker_pick_pixel(world.picker(), &camera, 320, 240, 20, nullptr, &pick), ABUT_OK);
    EXPECT_TRUE(same(pick.geometry, thin.geometry));
    EXPECT_NEAR(pick.distance, 10, 0.1);
  }
}

TEST(PickPixel, FindsTheNearestOfManyAndTheHorizon) {
  World world;
  const abut_camera camera = camera_at({-10, 0, 1}, {0, 0, 1});
  const Placed ground = world.add(plane({0, 0, 1}, 0), {0, 0, 0});
  abut_pick pick{};
  ASSERT_EQ(abut_picker_pick_pixel(world.picker(), &camera, 320, 235, 3, nullptr, &pick), ABUT_OK);
  EXPECT_EQ(pick.geometry.slot, 0U);
  ASSERT_EQ(abut_picker_pick_pixel(world.picker(), &camera, 320, 235, 8, nullptr, &pick), ABUT_OK);
  EXPECT_TRUE(same(pick.geometry, ground.geometry));
  const double pixel = 10 * std::tan(0.5) / 240;
  const Placed ball = world.add(sphere(0.1 * pixel), {0, 0, 1 + 7 * pixel});
  ASSERT_EQ(abut_picker_pick_pixel(world.picker(), &camera, 320, 235, 8, nullptr, &pick), ABUT_OK);
  EXPECT_TRUE(same(pick.geometry, ball.geometry));
}

TEST(Picker, AnswersManyThreadsAtOnce) {
  World world;
  Random random(81);
  const std::vector<Placed> placed = fill(world, random, 40, {0, 0, 0}, true);
  for (int round = 0; round < 4; ++round) {
    for (const Placed& body : placed) world.move(body, random.point(6), random.turn());
    std::vector<abut_ray> rays;
    std::vector<abut_pick> expected;
    for (int i = 0; i < 200; ++i) {
      const abut_vec3 from = random.point(9);
      rays.push_back({from, random.point(4) - from, infinity});
      expected.push_back(world.brute(rays.back()));
    }
    // All threads find the picker out of date and race to be the one that brings it up to date.
    std::atomic<int> wrong = 0;
    std::vector<std::thread> threads;
    for (int t = 0; t < 4; ++t) {
      threads.emplace_back([&, t] {
        for (std::size_t i = 0; i < rays.size(); ++i) {
          const std::size_t k = (i + static_cast<std::size_t>(t) * 50) % rays.size();
          abut_pick pick{};
          if (abut_picker_cast_ray(world.picker(), &rays[k], nullptr, &pick) != ABUT_OK ||
              !agrees(pick, expected[k], 30))
            ++wrong;
        }
      });
    }
    for (std::thread& thread : threads) thread.join();
    EXPECT_EQ(wrong, 0);
  }
}

}  // namespace
