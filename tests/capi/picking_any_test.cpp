// SPDX-License-Identifier: Apache-2.0
// picking.h: whether a ray meets anything, compared with rays against each shape in double.
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

std::uint32_t hits(World& world, const abut_ray& ray, const abut_query_filter* filter = nullptr) {
  std::uint32_t out = 7;
  EXPECT_EQ(abut_picker_ray_hits(world.picker(), &ray, filter, &out), ABUT_OK) << abut_last_error_message();
  return out;
}

std::vector<std::uint32_t> each_hits(World& world, const std::vector<abut_ray>& rays, abut_coherence coherence) {
  std::vector<std::uint32_t> out(rays.size(), 7);
  EXPECT_EQ(abut_picker_rays_hit(world.picker(), rays.data(), rays.size(), coherence, nullptr, out.data()), ABUT_OK);
  return out;
}

// Still surfaces, or these with all that moves.
void fill(World& world, Random& random, bool is_still) {
  world.add(ground_mesh(8, 24, 0.4), {0, 0, -3});
  for (int i = 0; i < 12; ++i) world.add(ball_mesh(0.6, 6), random.point(4), random.turn());
  if (is_still) return;
  const std::vector<Shape> shapes = shapes_of_every_kind(random);
  for (const Shape& shape : shapes) world.add(shape, random.point(5), random.turn());
  const Placed moved = world.add(ball_mesh(1, 8), {0, 0, 0});
  EXPECT_EQ(abut_picker_update(world.picker()), ABUT_OK);
  world.move(moved, {1, 2, 0});
}

TEST(AnyHit, IsThereWhereTheNearestIs) {
  for (const std::uint64_t seed : {41U, 42U, 43U, 44U}) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    World world;
    fill(world, random, seed % 2 == 0);
    std::vector<abut_ray> rays;
    std::vector<std::uint32_t> expected;
    for (int i = 0; i < 1500; ++i) {
      const abut_vec3 from = random.point(i % 3 == 0 ? 30 : 9);
      abut_ray ray{from, random.in(0.1, 5) * (random.point(5) - from), infinity};
      const double nearest = world.brute(ray).distance;
      // Every other ray ends, and most of these close before or behind what it would meet.
      if (i % 4 == 1) ray.max_distance = random.in(0, 30);
      if (i % 4 == 3 && nearest < infinity)
        ray.max_distance = nearest + (i % 8 == 3 ? 1 : -1) * (i % 3 == 0 ? 1e-9 : 1e-4);
      rays.push_back(ray);
      expected.push_back(nearest < infinity && nearest <= ray.max_distance ? 1 : 0);
      // So close to its end single precision decides, as for the nearest hit.
      if (std::fabs(nearest - ray.max_distance) < 1e-5) expected.back() = world.pick(ray).geometry.slot == 0 ? 0 : 1;
    }
    const std::vector<std::uint32_t> unrelated = each_hits(world, rays, ABUT_COHERENCE_NONE);
    const std::vector<std::uint32_t> neighbours = each_hits(world, rays, ABUT_COHERENCE_NEIGHBOURS);
    std::size_t met = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
      EXPECT_EQ(hits(world, rays[i]), expected[i]) << "ray " << i;
      EXPECT_EQ(unrelated[i], expected[i]) << "ray " << i;
      EXPECT_EQ(neighbours[i], expected[i]) << "ray " << i;
      met += expected[i];
    }
    EXPECT_GT(met, 300U);
    EXPECT_LT(met, 1300U);
  }
}

TEST(AnyHit, IsOfWhatTheFilterAdmits) {
  World world;
  const Placed ball = world.add(sphere(1), {0, 0, 0});
  const Placed still = world.add(ball_mesh(1, 10), {5, 0, 0});
  EXPECT_EQ(hits(world, along_x), 1U);
  abut_query_filter filter;
  abut_query_filter_init(&filter, sizeof filter);
  filter.ignore_geometry = still.geometry;
  EXPECT_EQ(hits(world, along_x, &filter), 1U);
  filter.ignore_part = ball.part;
  EXPECT_EQ(hits(world, along_x, &filter), 0U);
  filter.ignore_geometry = {0, 0};
  EXPECT_EQ(hits(world, along_x, &filter), 1U);
  abut_ray shorter = along_x;
  shorter.max_distance = 13;
  EXPECT_EQ(hits(world, shorter, &filter), 0U);
}

TEST(AnyHit, IsNotInAnEmptyUniverse) {
  World world;
  EXPECT_EQ(hits(world, along_x), 0U);
  EXPECT_EQ(each_hits(world, {along_x, along_x, along_x}, ABUT_COHERENCE_NEIGHBOURS),
            (std::vector<std::uint32_t>{0, 0, 0}));
  EXPECT_EQ(abut_picker_rays_hit(world.picker(), nullptr, 0, 0, nullptr, nullptr), ABUT_OK);
}

}  // namespace
