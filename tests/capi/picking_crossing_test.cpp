// SPDX-License-Identifier: Apache-2.0
// picking.h: rays through edges and corners. Closed surfaces are left as often as they are entered, and no ray passes
// between the triangles of steep terrain.
#include "picking_scene.hpp"

#include <abut/picking.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace {

using namespace picking_test;

std::uint64_t fresh_seed() { return std::random_device()(); }

const std::vector<std::uint32_t> octahedron_triangles{0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4,
                                                      2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5};

// How often a ray enters, less how often it leaves.
int balance_of(const std::vector<abut_pick>& picks, const abut_vec3& direction) {
  int balance = 0;
  for (const abut_pick& pick : picks) balance += dot(pick.normal, direction) < 0 ? 1 : -1;
  return balance;
}

TEST(CastRayAll, CrossesACornerOnce) {
  const std::vector<double> xyz{8, 0, 0, -4, 0, 0, 0, 2, 0, 0, -3, 0, 0, 0, 7, 0, 0, -4};
  for (const bool is_hull : {false, true}) {
    World world;
    world.add(is_hull ? hull(xyz) : mesh(xyz, octahedron_triangles), {0, 0, 0});
    const abut_vec3 way{-10, 2, -1};
    const std::vector<abut_pick> picks = world.pick_all({{38, -6, 3}, way, infinity});
    ASSERT_EQ(picks.size(), 2U);
    EXPECT_NEAR(picks[0].point.x, 8, 1e-12);
    EXPECT_EQ(balance_of(picks, way), 0);
  }
}

// A torus of `around` times `across` quads, of two triangles each.
struct Torus {
  std::vector<double> xyz;
  std::vector<std::uint32_t> triangles;
};
Torus torus(std::uint32_t around, std::uint32_t across) {
  Torus out;
  const double step = 2 * std::numbers::pi;
  for (std::uint32_t i = 0; i < around; ++i) {
    for (std::uint32_t j = 0; j < across; ++j) {
      const double u = step * i / around, v = step * j / across, r = 3 + std::cos(v);
      // Whole 64ths, so that rays reach vertices exactly.
      for (const double x : {r * std::cos(u), r * std::sin(u), std::sin(v)}) out.xyz.push_back(std::round(64 * x) / 64);
    }
  }
  const auto at = [&](std::uint32_t i, std::uint32_t j) { return i % around * across + j % across; };
  for (std::uint32_t i = 0; i < around; ++i) {
    for (std::uint32_t j = 0; j < across; ++j) {
      out.triangles.insert(out.triangles.end(), {at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      out.triangles.insert(out.triangles.end(), {at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return out;
}

abut_vec3 vertex_of(const std::vector<double>& xyz, std::size_t i) {
  return {xyz[3 * i], xyz[3 * i + 1], xyz[3 * i + 2]};
}

// From outside of all that is within 10 of the origin, by whole steps: what is between is exact.
abut_ray through(Random& random, const abut_vec3& point) {
  const auto whole = [&] { return std::floor(random.in(-20, 21)); };
  abut_vec3 back{whole(), whole(), whole()};
  if (length(back) == 0) back.x = 1;
  const double steps = 24 + std::floor(random.in(0, 8));
  return {point + steps * back, -1.0 * back, infinity};
}

void expect_balance(World& world, Random& random, const std::vector<double>& xyz,
                    const std::vector<std::uint32_t>& triangles, int rays) {
  for (int i = 0; i < rays; ++i) {
    const std::size_t triangle = random.below(triangles.size() / 3);
    const abut_vec3 a = vertex_of(xyz, triangles[3 * triangle]), b = vertex_of(xyz, triangles[3 * triangle + 1]);
    const abut_ray ray = through(random, random.one_in(2) ? a : 0.5 * (a + b));
    const std::vector<abut_pick> picks = world.pick_all(ray);
    ASSERT_EQ(balance_of(picks, ray.direction), 0) << "ray " << i << ", " << picks.size() << " crossings";
    ASSERT_TRUE(std::ranges::is_sorted(picks, {}, &abut_pick::distance));
  }
}

TEST(CastRayAll, LeavesClosedSurfacesAsOftenAsItEntersThem) {
  const std::uint64_t seed = fresh_seed();
  SCOPED_TRACE("seed " + std::to_string(seed));
  Random random(seed);
  for (int round = 0; round < 40 && !testing::Test::HasFailure(); ++round) {
    std::vector<double> xyz(18, 0.0);
    for (std::size_t i = 0; i < 6; ++i) xyz[3 * i + i / 2] = (i % 2 == 0 ? 1 : -1) * std::floor(random.in(1, 10));
    World world;
    world.add(mesh(xyz, octahedron_triangles), {0, 0, 0});
    expect_balance(world, random, xyz, octahedron_triangles, 100);
    World of_hull;
    of_hull.add(hull(xyz), {0, 0, 0});
    expect_balance(of_hull, random, xyz, octahedron_triangles, 100);
  }
  for (const std::uint32_t cells : {5U, 12U, 40U}) {
    const Torus ring = torus(cells, cells);
    World still;
    still.add(mesh(ring.xyz, ring.triangles), {0, 0, 0});
    expect_balance(still, random, ring.xyz, ring.triangles, 1000);
    World moving;
    const Placed placed = moving.add(mesh(ring.xyz, ring.triangles), {50, 0, 0});
    EXPECT_EQ(moving.pick(along_x).geometry.slot, placed.geometry.slot);
    moving.move(placed, {0, 0, 0});
    expect_balance(moving, random, ring.xyz, ring.triangles, 1000);
  }
}

// From the middle of a torus a ray crosses it twice or not at all, and from within it once more than it enters.
TEST(CastRayAll, LeavesWhatItStartsIn) {
  const std::uint64_t seed = fresh_seed();
  SCOPED_TRACE("seed " + std::to_string(seed));
  Random random(seed);
  const Torus ring = torus(24, 16);
  World world;
  world.add(mesh(ring.xyz, ring.triangles), {0, 0, 0});
  for (int i = 0; i < 2000; ++i) {
    const abut_vec3 target = vertex_of(ring.xyz, random.below(ring.xyz.size() / 3));
    const abut_vec3 within{3, 0.0625, 0.03125};
    const abut_vec3 way = target - within;
    ASSERT_EQ(balance_of(world.pick_all({within, way, infinity}), way), -1) << "ray " << i;
    ASSERT_EQ(balance_of(world.pick_all({{0, 0, 0}, target, infinity}), target), 0) << "ray " << i;
  }
}

// A surface over all of a square, so that each ray from above meets it.
struct Terrain {
  std::uint32_t samples;
  std::vector<double> heights;

  [[nodiscard]] abut_vec3 at(std::uint32_t i, std::uint32_t j) const {
    return {static_cast<double>(i), static_cast<double>(j), heights[j * samples + i]};
  }
};

Shape field_of(const Terrain& terrain) {
  abut_height_field_desc desc;
  abut_height_field_desc_init(&desc, sizeof desc);
  desc.columns = desc.rows = terrain.samples;
  desc.heights = terrain.heights.data();
  return shape_from([&](abut_shape** out) { return abut_height_field_create(&desc, out); });
}

void expect_no_cracks(World& world, Random& random, const Terrain& terrain, double height, const abut_vec3& place) {
  constexpr std::array<std::array<std::uint32_t, 2>, 3> edges{{{1, 0}, {0, 1}, {1, 1}}};
  std::vector<abut_ray> rays;
  for (int i = 0; i < 20000; ++i) {
    const auto column = static_cast<std::uint32_t>(2 + random.below(terrain.samples - 5));
    const auto row = static_cast<std::uint32_t>(2 + random.below(terrain.samples - 5));
    const auto [right, up] = edges[random.below(3)];
    const abut_vec3 a = terrain.at(column, row), b = terrain.at(column + right, row + up);
    const abut_vec3 target = random.one_in(4) ? a : a + random.in(0, 1) * (b - a);
    const double tilt = std::min(0.5, 1.5 / height);
    const abut_vec3 back{random.in(-tilt, tilt), random.in(-tilt, tilt), 1};
    rays.push_back({place + target + (1 + 1.2 * height) * back, -1.0 * back, infinity});
  }
  std::vector<abut_pick> picks(rays.size());
  for (const abut_coherence coherence : {ABUT_COHERENCE_NONE, ABUT_COHERENCE_NEIGHBOURS}) {
    ASSERT_EQ(abut_picker_cast_rays(world.picker(), rays.data(), rays.size(), coherence, nullptr, picks.data()),
              ABUT_OK);
    EXPECT_TRUE(std::ranges::all_of(picks, [](const abut_pick& pick) { return pick.geometry.slot != 0; }));
  }
  for (std::size_t i = 0; i < 2000; ++i) {
    ASSERT_NE(world.pick(rays[i]).geometry.slot, 0U) << "ray " << i;
    // One that goes down through all of it crosses it an odd number of times.
    ASSERT_EQ(world.pick_all(rays[i]).size() % 2, 1U) << "ray " << i;
  }
}

TEST(HeightField, HasNoCracksHoweverSteepItIs) {
  const std::uint64_t seed = fresh_seed();
  SCOPED_TRACE("seed " + std::to_string(seed));
  Random random(seed);
  for (const double height : {0.5, 2.0, 4.0, 16.0, 64.0}) {
    SCOPED_TRACE("height " + std::to_string(height));
    Terrain terrain{40, {}};
    for (int i = 0; i < 1600; ++i) terrain.heights.push_back(random.in(0, height));
    World still;
    still.add(field_of(terrain), {0, 0, 0});
    expect_no_cracks(still, random, terrain, height, {0, 0, 0});
    // One shape twice is traced in its own frame.
    World twice;
    const Shape shape = field_of(terrain);
    twice.add(shape, {0, 0, 0});
    twice.add(shape, {500, 0, 0});
    expect_no_cracks(twice, random, terrain, height, {500, 0, 0});
  }
}

// Samples of a ball of radius 1 about the origin, on a grid of cells of a quarter.
Shape field_of_ball() {
  constexpr std::uint32_t count = 13;
  std::vector<double> values;
  for (std::uint32_t k = 0; k < count; ++k) {
    for (std::uint32_t j = 0; j < count; ++j) {
      for (std::uint32_t i = 0; i < count; ++i)
        values.push_back(length({-1.5 + 0.25 * i, -1.5 + 0.25 * j, -1.5 + 0.25 * k}) - 1);
    }
  }
  abut_distance_field_desc desc;
  abut_distance_field_desc_init(&desc, sizeof desc);
  desc.columns = desc.rows = desc.layers = count;
  desc.spacing = {0.25, 0.25, 0.25};
  desc.origin = {-1.5, -1.5, -1.5};
  desc.values = values.data();
  return shape_from([&](abut_shape** out) { return abut_distance_field_create(&desc, out); });
}

// A field is met itself, not triangles through its cells.
TEST(DistanceField, IsMetWhereItsValueIsZero) {
  const std::uint64_t seed = fresh_seed();
  SCOPED_TRACE("seed " + std::to_string(seed));
  Random random(seed);
  World world;
  const abut_quat turn = random.turn();
  world.add(field_of_ball(), {1, 2, 3}, turn);
  ASSERT_EQ(abut_universe_refresh(world.universe()), ABUT_OK);
  for (int i = 0; i < 2000; ++i) {
    const abut_vec3 from = abut_vec3{1, 2, 3} + 5.0 * random.point(1);
    const abut_vec3 way = abut_vec3{1, 2, 3} + random.point(1.3) - from;
    const abut_ray ray{from, way, infinity};
    const abut_pick pick = world.pick(ray), expected = hit_of_universe(world, ray, nullptr);
    ASSERT_EQ(pick.geometry.slot, expected.geometry.slot);
    if (pick.geometry.slot == 0) continue;
    ASSERT_NEAR(pick.distance, expected.distance, 1e-12);
    ASSERT_EQ(pick.feature.kind, expected.feature.kind);
    if (length(from - abut_vec3{1, 2, 3}) > 1.5)
      ASSERT_NEAR(length(pick.point - abut_vec3{1, 2, 3}), 1, 0.02) << "a sixteenth of a cell";
  }
}

}  // namespace
