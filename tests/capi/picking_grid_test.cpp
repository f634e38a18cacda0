// SPDX-License-Identifier: Apache-2.0
// picking.h: grids, whose triangles are traced in pairs.
#include "picking_support.hpp"

#include <abut/picking.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

namespace {

using namespace picking_test;

constexpr double half = 8;
constexpr std::uint32_t cells = 24;
constexpr double wave = 0.4;
constexpr abut_vec3 place{0.3, -0.7, 100};

// A vertex of ground_mesh(half, cells, wave) at `place`.
abut_vec3 vertex(std::uint32_t i, std::uint32_t j) {
  const double x = half * (2.0 * i / cells - 1);
  const double y = half * (2.0 * j / cells - 1);
  return place + abut_vec3{x, y, wave * std::sin(x) * std::cos(1.3 * y)};
}

std::array<abut_vec3, 3> corners_of(std::uint32_t triangle) {
  const std::uint32_t i = triangle / 2 % cells;
  const std::uint32_t j = triangle / 2 / cells;
  if (triangle % 2 == 0) return {vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1)};
  return {vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1)};
}

struct Aimed {
  std::vector<abut_ray> rays;
  std::vector<double> distances;
};

class Aim {
 public:
  explicit Aim(std::uint64_t seed) : engine_(seed) {}

  double in(double low, double high) { return low + (high - low) * static_cast<double>(engine_() >> 11U) * 0x1p-53; }

  // From above, steeper than any slope of the ground.
  void at(const abut_vec3& target, Aimed& out) {
    const abut_vec3 upwards{in(-0.4, 0.4), in(-0.4, 0.4), 1};
    const double distance = in(3, 20);
    out.rays.push_back({target + (distance / length(upwards)) * upwards, -1.0 * upwards, infinity});
    out.distances.push_back(distance);
  }

 private:
  std::mt19937_64 engine_;
};

// One by one, and as both kinds of batches.
std::array<std::vector<abut_pick>, 3> picks_of(World& world, const std::vector<abut_ray>& rays) {
  std::array<std::vector<abut_pick>, 3> out;
  for (const abut_ray& ray : rays) out[0].push_back(world.pick(ray));
  out[1].resize(rays.size());
  out[2].resize(rays.size());
  EXPECT_EQ(
      abut_picker_cast_rays(world.picker(), rays.data(), rays.size(), ABUT_COHERENCE_NONE, nullptr, out[1].data()),
      ABUT_OK);
  EXPECT_EQ(abut_picker_cast_rays(world.picker(), rays.data(), rays.size(), ABUT_COHERENCE_NEIGHBOURS, nullptr,
                                  out[2].data()),
            ABUT_OK);
  return out;
}

TEST(Grid, HasNoCracksAlongEdgesAndDiagonals) {
  World world;
  world.add(ground_mesh(half, cells, wave), place);
  Aim aim(61);
  Aimed aimed;
  for (std::uint32_t j = 1; j + 1 < cells; ++j) {
    for (std::uint32_t i = 1; i + 1 < cells; ++i) {
      for (const abut_vec3& end : {vertex(i, j), vertex(i + 1, j), vertex(i, j + 1), vertex(i + 1, j + 1)}) {
        for (int k = 0; k < 10; ++k) aim.at(vertex(i, j) + aim.in(0, 1) * (end - vertex(i, j)), aimed);
      }
    }
  }
  for (const std::vector<abut_pick>& picks : picks_of(world, aimed.rays)) {
    for (std::size_t i = 0; i < picks.size(); ++i) {
      ASSERT_NE(picks[i].geometry.slot, 0U) << "ray " << i;
      ASSERT_NEAR(picks[i].distance, aimed.distances[i], 1e-5) << "ray " << i;
    }
  }
}

TEST(Grid, NamesTheTriangleThatIsHit) {
  World world;
  world.add(ground_mesh(half, cells, wave), place);
  Aim aim(62);
  Aimed aimed;
  for (std::uint32_t triangle = 0; triangle < 2 * cells * cells; ++triangle) {
    const auto [a, b, c] = corners_of(triangle);
    const double v = aim.in(0.01, 0.98);
    const double w = aim.in(0.01, 0.99 - v);
    aim.at(a + v * (b - a) + w * (c - a), aimed);
  }
  for (const std::vector<abut_pick>& picks : picks_of(world, aimed.rays)) {
    for (std::size_t i = 0; i < picks.size(); ++i) {
      ASSERT_EQ(picks[i].feature.index, i);
      ASSERT_NEAR(picks[i].distance, aimed.distances[i], 1e-12 * (100 + aimed.distances[i])) << "ray " << i;
      const auto [a, b, c] = corners_of(static_cast<std::uint32_t>(i));
      ASSERT_NEAR(dot(picks[i].normal, b - a), 0, 1e-13);
      ASSERT_NEAR(dot(picks[i].normal, c - a), 0, 1e-13);
    }
  }
  for (std::size_t i = 0; i < aimed.rays.size(); ++i) {
    const std::vector<abut_pick> all = world.pick_all(aimed.rays[i]);
    ASSERT_FALSE(all.empty());
    ASSERT_EQ(all.front().feature.index, i);
  }
}

TEST(Grid, LiesBesideMeshesThatAreNone) {
  World world;
  const Placed ground = world.add(ground_mesh(half, cells, wave), place);
  const Placed ball = world.add(ball_mesh(1, 8), place + abut_vec3{0, 0, 3});
  const abut_vec3 above = place + abut_vec3{0.1, 0.2, 9};
  EXPECT_TRUE(same(world.pick({above, {0, 0, -1}, infinity}).geometry, ball.geometry));
  EXPECT_TRUE(same(world.pick({above + abut_vec3{3, 0, 0}, {0, 0, -1}, infinity}).geometry, ground.geometry));
  world.remove(ground);
  EXPECT_TRUE(same(world.pick({above, {0, 0, -1}, infinity}).geometry, ball.geometry));
  EXPECT_EQ(world.pick({above + abut_vec3{3, 0, 0}, {0, 0, -1}, infinity}).geometry.slot, 0U);
}

}  // namespace
