// SPDX-License-Identifier: Apache-2.0
// A scene with shapes of every kind that is edited at random, and the universe's own answers to compare with.
#pragma once

#include "picking_support.hpp"

#include <algorithm>
#include <random>
#include <span>
#include <string>

namespace picking_test {

class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  double in(double low, double high) { return low + (high - low) * static_cast<double>(engine_() >> 11U) * 0x1p-53; }
  std::size_t below(std::size_t count) { return static_cast<std::size_t>(engine_() % count); }
  bool one_in(std::size_t count) { return below(count) == 0; }
  abut_vec3 point(double reach) { return {in(-reach, reach), in(-reach, reach), in(-reach, reach)}; }
  abut_quat turn() {
    for (;;) {
      const abut_quat q{in(-1, 1), in(-1, 1), in(-1, 1), in(-1, 1)};
      const double n = std::sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
      if (n > 0.1 && n < 1) return {q.w / n, q.x / n, q.y / n, q.z / n};
    }
  }

 private:
  std::mt19937_64 engine_;
};

inline Shape shape_of_kind(const char* kind, std::span<const double> parameters) {
  abut_shape_desc desc;
  abut_shape_desc_init(&desc, sizeof desc);
  desc.kind = abut_shape_kind_by_name(kind);
  desc.parameters = parameters.data();
  desc.parameter_count = parameters.size();
  return shape_from([&](abut_shape** out) { return abut_shape_create(&desc, out); });
}

inline Shape composite(std::span<const Shape* const> children, std::span<const abut_pose> poses) {
  std::vector<const abut_shape*> pointers;
  for (const Shape* child : children) pointers.push_back(child->get());
  return shape_from(
      [&](abut_shape** out) { return abut_composite_create(pointers.data(), poses.data(), pointers.size(), out); });
}

inline Shape height_field(std::uint32_t samples, double spacing, double wave, abut_below below = ABUT_BELOW_OPEN) {
  std::vector<double> heights;
  for (std::uint32_t j = 0; j < samples; ++j) {
    for (std::uint32_t i = 0; i < samples; ++i) heights.push_back(wave * std::sin(1.7 * i) * std::cos(0.9 * j));
  }
  abut_height_field_desc desc;
  abut_height_field_desc_init(&desc, sizeof desc);
  desc.columns = desc.rows = samples;
  desc.spacing_x = desc.spacing_y = spacing;
  desc.heights = heights.data();
  desc.below = below;
  if (below == ABUT_BELOW_SOLID) heights[samples + 1] = heights[samples / 2] = std::nan("");
  return shape_from([&](abut_shape** out) { return abut_height_field_create(&desc, out); });
}

// A hull whose ends have as many corners as asked for.
inline Shape prism(int count) {
  std::vector<double> corners;
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * std::numbers::pi * i / count;
    for (const double z : {-0.6, 0.6}) corners.insert(corners.end(), {0.7 * std::cos(angle), 0.7 * std::sin(angle), z});
  }
  return hull(corners);
}

// Terrain whose triangles are found by a grid of cells.
inline Shape uv_grid(double half, std::uint32_t count, double wave) {
  std::vector<double> xyz;
  std::vector<std::uint32_t> triangles;
  for (std::uint32_t j = 0; j <= count; ++j) {
    for (std::uint32_t i = 0; i <= count; ++i) {
      const double x = half * (2.0 * i / count - 1), y = half * (2.0 * j / count - 1);
      xyz.insert(xyz.end(), {x, y, wave * std::cos(3 * x) * std::sin(2 * y)});
    }
  }
  for (std::uint32_t j = 0; j < count; ++j) {
    for (std::uint32_t i = 0; i < count; ++i) {
      const std::uint32_t a = j * (count + 1) + i;
      triangles.insert(triangles.end(), {a, a + 1, a + count + 2, a, a + count + 2, a + count + 1});
    }
  }
  return shape_from([&](abut_shape** out) {
    return abut_uv_grid_create(xyz.data(), xyz.size() / 3, triangles.data(), triangles.size() / 3, nullptr, out);
  });
}

// Two balls of clay that flow together, on a coarse grid.
inline Shape distance_field() {
  constexpr std::uint32_t count = 9;
  std::vector<double> values;
  for (std::uint32_t k = 0; k < count; ++k) {
    for (std::uint32_t j = 0; j < count; ++j) {
      for (std::uint32_t i = 0; i < count; ++i) {
        const abut_vec3 p{-1 + 0.25 * i, -1 + 0.25 * j, -1 + 0.25 * k};
        values.push_back(std::min(length(p - abut_vec3{0.3, 0, 0}), length(p + abut_vec3{0.3, 0.2, 0})) - 0.5);
      }
    }
  }
  abut_distance_field_desc desc;
  abut_distance_field_desc_init(&desc, sizeof desc);
  desc.columns = desc.rows = desc.layers = count;
  desc.spacing = {0.25, 0.25, 0.25};
  desc.origin = {-1, -1, -1};
  desc.values = values.data();
  return shape_from([&](abut_shape** out) { return abut_distance_field_create(&desc, out); });
}

// One shape of every kind at least; about as large as 1.
inline std::vector<Shape> shapes_of_every_kind(Random& random) {
  std::vector<double> many;
  for (int i = 0; i < 120; ++i) many.push_back(random.in(-0.8, 0.8));
  const std::vector<double> few(many.begin(), many.begin() + 15);
  std::vector<double> centres;
  for (int i = 0; i < 30; ++i) centres.push_back(random.in(-0.9, 0.9));
  std::vector<Shape> shapes;
  shapes.push_back(sphere(0.5));
  shapes.push_back(box(0.4, 0.6, 0.3));
  shapes.push_back(box(0.7, 0.5, 0));
  shapes.push_back(capsule(0.2, 0.7));
  shapes.push_back(hull(many));
  shapes.push_back(hull(few));
  shapes.push_back(prism(12));
  shapes.push_back(ball_mesh(0.6, 6));
  shapes.push_back(ground_mesh(1, 6, 0.3));
  shapes.push_back(mesh({-1, -1, 0, 1, -1, 0, 0, 1, 0.3}, {0, 1, 2}));
  shapes.push_back(height_field(8, 0.3, 0.2));
  shapes.push_back(height_field(6, 0.2, 0.2, ABUT_BELOW_SOLID));
  shapes.push_back(shape_of_kind("point", {}));
  shapes.push_back(shape_of_kind("segment", std::array{0.8}));
  shapes.push_back(shape_of_kind("triangle", std::array{-1.0, -1.0, 0.0, 1.0, -1.0, 0.2, 0.0, 1.0, 0.0}));
  shapes.push_back(shape_of_kind("cylinder", std::array{0.5, 0.4}));
  shapes.push_back(shape_of_kind("cone", std::array{0.6, 0.5}));
  shapes.push_back(shape_of_kind("ellipsoid", std::array{0.7, 0.4, 0.2}));
  shapes.push_back(shape_from([&](abut_shape** out) { return abut_particles_create(centres.data(), 10, 0.15, out); }));
  shapes.push_back(uv_grid(1, 7, 0.3));
  shapes.push_back(distance_field());
  const Shape drill = shape_of_kind("cylinder_hole", std::array{0.2, 2.0, 3.0});
  const abut_pose here{{0, 0, 0}, no_turn};
  const abut_pose aside{{0.8, 0.2, 0.1}, random.turn()};
  const abut_pose above{{-0.3, 0.1, 0.9}, random.turn()};
  shapes.push_back(composite(std::array{&shapes[0], &shapes[1], &shapes[7]}, std::array{here, aside, above}));
  shapes.push_back(
      composite(std::array<const Shape*, 3>{&shapes[1], &drill, &shapes[15]}, std::array{here, here, above}));
  return shapes;
}

// The nearest hit that the universe itself finds, as a pick.
inline abut_pick hit_of_universe(World& world, const abut_ray& ray, const abut_query_filter* filter) {
  abut_query_hit hit{};
  std::size_t count = 0;
  EXPECT_EQ(abut_universe_cast_ray(world.universe(), &ray, filter, ABUT_HIT_NEAREST, &hit, 1, &count), ABUT_OK)
      << abut_last_error_message();
  if (count == 0) return {{0, 0}, {0, 0}, 0, 0, infinity, {0, 0, 0}, {0, 0, 0}};
  return {hit.geometry, hit.feature, hit.child, 0, hit.distance, hit.point, hit.normal};
}

// Each geometry once, with its first crossing.
inline std::vector<abut_query_hit> hits_of_universe(World& world, const abut_ray& ray,
                                                    const abut_query_filter* filter) {
  std::size_t count = 0;
  EXPECT_EQ(abut_universe_cast_ray(world.universe(), &ray, filter, ABUT_HIT_ALL, nullptr, 0, &count), ABUT_OK);
  std::vector<abut_query_hit> hits(count);
  EXPECT_EQ(abut_universe_cast_ray(world.universe(), &ray, filter, ABUT_HIT_ALL, hits.data(), count, &count), ABUT_OK);
  return hits;
}

// Whether a pick is what is expected. Another geometry or feature may be named where both are equally near in single
// precision of `size`, the size of the scene.
inline ::testing::AssertionResult is_same_pick(const abut_pick& pick, const abut_pick& expected, double size) {
  const auto failure = [&] {
    return ::testing::AssertionFailure() << "geometry " << pick.geometry.slot << " feature " << pick.feature.kind << '/'
                                         << pick.feature.index << " child " << pick.child << " at " << pick.distance
                                         << ", expected " << expected.geometry.slot << " feature "
                                         << expected.feature.kind << '/' << expected.feature.index << " child "
                                         << expected.child << " at " << expected.distance;
  };
  if (expected.geometry.slot == 0)
    return pick.geometry.slot == 0 && std::isinf(pick.distance) ? ::testing::AssertionSuccess() : failure();
  const double off = std::fabs(pick.distance - expected.distance);
  const bool is_same_thing = same(pick.geometry, expected.geometry) && pick.feature.kind == expected.feature.kind &&
                             pick.feature.index == expected.feature.index && pick.child == expected.child;
  if (!(off <= (is_same_thing ? 1e-12 : 2e-6) * (size + expected.distance))) return failure() << ", too far off";
  if (!is_same_thing && off > 1e-12 * (size + expected.distance)) return ::testing::AssertionSuccess();
  if (!same(pick.geometry, expected.geometry)) return failure() << ", another geometry";
  if (!is_same_thing && length(pick.normal - expected.normal) < 1e-9) return failure() << ", another name for it";
  if (is_same_thing && length(pick.normal - expected.normal) > 1e-9) return failure() << ", another normal";
  if (length(pick.point - expected.point) > 1e-11 * (size + expected.distance)) return failure() << ", another point";
  return ::testing::AssertionSuccess();
}

}  // namespace picking_test
