// SPDX-License-Identifier: Apache-2.0
// picking.h: back faces, clip planes and sensors, against all triangles of a scene one by one.
#include "picking_tools.hpp"

#include <abut/picking.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace {

using namespace picking_test;

struct Triangle {
  abut_geometry_id geometry;
  std::array<abut_vec3, 3> corners;
};

std::vector<Triangle> triangles_of(World& world) {
  std::size_t count = 0;
  EXPECT_EQ(abut_universe_geometries(world.universe(), nullptr, 0, &count), ABUT_OK);
  std::vector<abut_geometry_id> ids(count);
  EXPECT_EQ(abut_universe_geometries(world.universe(), ids.data(), count, &count), ABUT_OK);
  std::vector<Triangle> out;
  for (const abut_geometry_id id : ids) {
    abut_geometry_info info;
    abut_geometry_info_init(&info, sizeof info);
    EXPECT_EQ(abut_geometry_describe(world.universe(), id, &info), ABUT_OK);
    std::size_t vertices = 0;
    std::size_t triangles = 0;
    EXPECT_EQ(abut_shape_triangles(info.shape, nullptr, 0, &vertices, nullptr, 0, &triangles), ABUT_OK);
    std::vector<double> xyz(3 * vertices);
    std::vector<std::uint32_t> indices(3 * triangles);
    EXPECT_EQ(abut_shape_triangles(info.shape, xyz.data(), vertices, &vertices, indices.data(), triangles, &triangles),
              ABUT_OK);
    const auto at = [&](std::size_t corner) {
      const std::size_t i = 3 * std::size_t{indices[corner]};
      return moved(info.pose, {xyz[i], xyz[i + 1], xyz[i + 2]});
    };
    for (std::size_t i = 0; i < triangles; ++i) out.push_back({id, {at(3 * i), at(3 * i + 1), at(3 * i + 2)}});
  }
  return out;
}

// Distances at which a ray crosses what counts, and how far from an edge that decides.
struct Nearest {
  double distance = infinity;
  double doubt = infinity;
};

Nearest nearest_of(const std::vector<Triangle>& triangles, const abut_ray& ray, bool skips_back_faces,
                   const std::vector<abut_clip_plane>& planes) {
  Nearest out;
  const abut_vec3 direction = (1 / length(ray.direction)) * ray.direction;
  for (const Triangle& its : triangles) {
    const auto& [a, b, c] = its.corners;
    const abut_vec3 normal = cross(b - a, c - a);
    const double rise = dot(normal, direction);
    const double distance = dot(normal, a - ray.origin) / rise;
    const abut_vec3 point = ray.origin + distance * direction;
    const double square = dot(normal, normal);
    const std::array<double, 3> weights{dot(cross(c - b, point - b), normal) / square,
                                        dot(cross(a - c, point - c), normal) / square,
                                        dot(cross(b - a, point - a), normal) / square};
    const double least = *std::min_element(weights.begin(), weights.end());
    if (!(distance >= 0 && distance <= ray.max_distance) || least < -1e-4) continue;
    double kept = infinity;
    for (const abut_clip_plane& plane : planes)
      kept = std::min(kept, dot(plane.normal, point) / length(plane.normal) - plane.offset);
    out.doubt = std::min({out.doubt, std::fabs(least), std::fabs(kept), std::fabs(rise) / std::sqrt(square)});
    if (least < 0 || kept < 0 || (skips_back_faces && rise > 0)) continue;
    out.distance = std::min(out.distance, distance);
  }
  return out;
}

// Surfaces that lie still, that move, and that are asked in double.
void fill(World& world, Random& random) {
  world.add(ground_mesh(8, 12, 0.4), {0, 0, -3});
  std::vector<double> corners;
  for (int i = 0; i < 60; ++i) corners.push_back(random.in(-0.8, 0.8));
  const std::array shapes{box(0.5, 0.7, 0.4), ball_mesh(0.9, 5), hull(corners),
                          hull({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1})};
  for (std::size_t i = 0; i < 24; ++i) {
    const Placed placed = world.add(shapes[i % shapes.size()], random.point(4), random.turn());
    if (i % 8 < 4) continue;
    EXPECT_EQ(abut_picker_update(world.picker()), ABUT_OK);
    world.move(placed, random.point(4), random.turn());
  }
  for (int i = 0; i < 4; ++i) world.add(ball_mesh(0.7, 4 + static_cast<std::uint32_t>(i)), random.point(5));
}

void compare(World& world, Random& random, bool skips_back_faces, std::size_t plane_count) {
  std::vector<abut_clip_plane> planes;
  for (std::size_t i = 0; i < plane_count; ++i) planes.push_back({random.point(2), random.in(-3, 0.5)});
  ASSERT_EQ(abut_picker_set_flags(world.picker(), skips_back_faces ? ABUT_PICKER_SKIP_BACK_FACES : 0), ABUT_OK);
  ASSERT_EQ(abut_picker_set_clip_planes(world.picker(), planes.data(), planes.size()), ABUT_OK);
  const std::vector<Triangle> triangles = triangles_of(world);
  std::vector<abut_ray> rays;
  for (int i = 0; i < 400; ++i) {
    const abut_vec3 from = random.point(i % 3 == 0 ? 3 : 9);
    rays.push_back({from, random.in(0.1, 5) * (random.point(4) - from), i % 4 == 0 ? random.in(2, 20) : infinity});
  }
  std::array<std::vector<abut_pick>, 2> batches;
  std::array<std::vector<std::uint32_t>, 2> met;
  for (const abut_coherence coherence : {ABUT_COHERENCE_NONE, ABUT_COHERENCE_NEIGHBOURS}) {
    batches[coherence].resize(rays.size());
    met[coherence].resize(rays.size());
    ASSERT_EQ(
        abut_picker_cast_rays(world.picker(), rays.data(), rays.size(), coherence, nullptr, batches[coherence].data()),
        ABUT_OK);
    ASSERT_EQ(abut_picker_rays_hit(world.picker(), rays.data(), rays.size(), coherence, nullptr, met[coherence].data()),
              ABUT_OK);
  }
  std::size_t hits = 0;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const Nearest expected = nearest_of(triangles, rays[i], skips_back_faces, planes);
    if (expected.doubt < 1e-4) continue;
    SCOPED_TRACE("ray " + std::to_string(i));
    const std::vector<abut_pick> all = world.pick_all(rays[i]);
    EXPECT_EQ(all.empty(), expected.distance == infinity);
    hits += all.empty() ? 0 : 1;
    for (const abut_pick& pick :
         {world.pick(rays[i]), batches[0][i], batches[1][i], all.empty() ? batches[0][i] : all.front()}) {
      if (expected.distance == infinity) {
        EXPECT_EQ(pick.geometry.slot, 0U) << "at " << pick.distance;
        EXPECT_EQ(pick.distance, infinity);
      } else {
        EXPECT_NEAR(pick.distance, expected.distance, 1e-9);
        EXPECT_NEAR(length(pick.point - rays[i].origin), expected.distance, 1e-9);
      }
    }
    std::uint32_t is_met = 7;
    ASSERT_EQ(abut_picker_ray_hits(world.picker(), &rays[i], nullptr, &is_met), ABUT_OK);
    for (const std::uint32_t answer : {is_met, met[0][i], met[1][i]})
      EXPECT_EQ(answer, expected.distance == infinity ? 0U : 1U);
  }
  EXPECT_GT(hits, 20U);
}

TEST(PickerFlags, AndClipPlanesLeaveOutWhatTheyCut) {
  for (const std::uint64_t seed : {51U, 52U, 53U}) {
    World world;
    Random random(seed);
    fill(world, random);
    for (const bool skips_back_faces : {false, true}) {
      for (const std::size_t planes : {0U, 1U, 2U}) {
        SCOPED_TRACE("seed " + std::to_string(seed) + (skips_back_faces ? ", fronts only, " : ", both sides, ") +
                     std::to_string(planes) + " clip planes");
        compare(world, random, skips_back_faces, planes);
      }
    }
  }
}

TEST(PickerFlags, OpenASolidAtTheCut) {
  World world;
  const Placed ball = world.add(sphere(1), {0, 0, 0});
  const abut_clip_plane half{{3, 0, 0}, 0.5};
  ASSERT_EQ(abut_picker_set_clip_planes(world.picker(), &half, 1), ABUT_OK);
  const abut_pick pick = world.pick(along_x);
  EXPECT_TRUE(same(pick.geometry, ball.geometry));
  EXPECT_DOUBLE_EQ(pick.distance, 11);
  EXPECT_DOUBLE_EQ(pick.normal.x, 1);
  EXPECT_EQ(world.pick_all(along_x).size(), 1U);
  ASSERT_EQ(abut_picker_set_flags(world.picker(), ABUT_PICKER_SKIP_BACK_FACES), ABUT_OK);
  EXPECT_EQ(world.pick(along_x).geometry.slot, 0U);
  ASSERT_EQ(abut_picker_set_clip_planes(world.picker(), nullptr, 0), ABUT_OK);
  EXPECT_DOUBLE_EQ(world.pick(along_x).distance, 9);
}

TEST(PickerFlags, ShowACutPicture) {
  World world;
  world.add(ball_mesh(1, 20), {0, 0, 0});
  abut_camera camera;
  abut_camera_init(&camera, sizeof camera);
  camera.width = camera.height = 9;
  camera.vertical_fov = 0.2;
  const abut_vec3 eye{-10, 0, 0};
  const abut_vec3 target{0, 0, 0};
  const abut_vec3 up{0, 0, 1};
  ASSERT_EQ(abut_camera_look_at(&camera, &eye, &target, &up), ABUT_OK);
  const abut_clip_plane right{{0, -1, 0}, 0.01};
  ASSERT_EQ(abut_picker_set_clip_planes(world.picker(), &right, 1), ABUT_OK);
  std::array<abut_pick, 81> picture{};
  ASSERT_EQ(abut_picker_render(world.picker(), &camera, nullptr, picture.data(), picture.size()), ABUT_OK);
  std::size_t hits = 0;
  for (const abut_pick& pick : picture) {
    if (pick.geometry.slot == 0) continue;
    ++hits;
    EXPECT_LE(pick.point.y, -0.01 + 1e-12);
  }
  EXPECT_GT(hits, 0U);
}

TEST(PickerFlags, SeeSensorsOnlyWhereAskedTo) {
  World world;
  const Placed sensor = world.add(ball_mesh(1, 6), {0, 0, 0});
  const Placed solid = world.add(sphere(1), {5, 0, 0});
  abut_geometry_options options;
  abut_geometry_options_init(&options, sizeof options);
  options.flags = ABUT_GEOMETRY_SENSOR;
  ASSERT_EQ(abut_geometry_set_options(world.universe(), sensor.geometry, &options), ABUT_OK);
  EXPECT_TRUE(same(world.pick(along_x).geometry, solid.geometry));
  ASSERT_EQ(abut_picker_set_flags(world.picker(), ABUT_PICKER_SENSORS), ABUT_OK);
  EXPECT_TRUE(same(world.pick(along_x).geometry, sensor.geometry));
  abut_query_filter filter;
  abut_query_filter_init(&filter, sizeof filter);
  filter.flags = ABUT_QUERY_FILTER_SKIP_SENSORS;
  EXPECT_TRUE(same(world.pick(along_x, &filter).geometry, solid.geometry));
  ASSERT_EQ(abut_picker_set_flags(world.picker(), 0), ABUT_OK);
  EXPECT_TRUE(same(world.pick(along_x).geometry, solid.geometry));
}

}  // namespace
