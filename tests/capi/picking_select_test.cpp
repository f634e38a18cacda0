// SPDX-License-Identifier: Apache-2.0
// picking.h: rectangles of a picture, against the triangles, balls and points of a scene one by one.
#include "picking_tools.hpp"

#include <abut/picking.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace {

using namespace picking_test;

// Points p with dot(normal, p) >= offset.
struct Side {
  abut_vec3 normal;
  double offset;
};

struct Rectangle {
  double x0, y0, x1, y1;
};

// What a rectangle shows, from the definition of a picture: x >= x0 is a plane in space.
std::vector<Side> sides_of(const abut_camera& camera, const Rectangle& its,
                           const std::vector<abut_clip_plane>& planes) {
  const Axes axes = axes_of(camera);
  std::vector<Side> out;
  const auto add = [&](const abut_vec3& normal, double offset) {
    out.push_back({normal, offset + dot(normal, axes.eye)});
  };
  const auto add_side = [&](const abut_vec3& across, double pixels, double sign) {
    // sign * (across * focal / depth - pixels) >= 0
    if (axes.is_parallel) {
      add(sign * across, sign * pixels);
    } else {
      add(sign * (across - pixels * axes.forward), 0);
    }
  };
  add_side(axes.focal_x * axes.right, std::min(its.x0, its.x1) - axes.centre_x, 1);
  add_side(axes.focal_x * axes.right, std::max(its.x0, its.x1) - axes.centre_x, -1);
  add_side(axes.focal_y * axes.up, axes.centre_y - std::max(its.y0, its.y1), 1);
  add_side(axes.focal_y * axes.up, axes.centre_y - std::min(its.y0, its.y1), -1);
  add(axes.forward, camera.near_distance);
  if (camera.far_distance < infinity) add(-1 * axes.forward, -camera.far_distance);
  for (const abut_clip_plane& plane : planes) {
    const double size = length(plane.normal);
    out.push_back({(1 / size) * plane.normal, plane.offset});
  }
  for (Side& side : out) {
    const double size = length(side.normal);
    side = {(1 / size) * side.normal, side.offset / size};
  }
  return out;
}

double height(const Side& side, const abut_vec3& p) { return dot(side.normal, p) - side.offset; }

// How far the points of a convex polygon reach into all half-spaces; what is left of it is clipped by one after the
// other (Sutherland, Hodgman 1974).
bool touches(std::vector<abut_vec3> polygon, const std::vector<Side>& sides, double grown) {
  for (const Side& side : sides) {
    std::vector<abut_vec3> left;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const abut_vec3& a = polygon[i];
      const abut_vec3& b = polygon[(i + 1) % polygon.size()];
      const double of_a = height(side, a) + grown;
      const double of_b = height(side, b) + grown;
      if (of_a >= 0) left.push_back(a);
      if ((of_a > 0 && of_b < 0) || (of_a < 0 && of_b > 0)) left.push_back(a + (of_a / (of_a - of_b)) * (b - a));
    }
    polygon = left;
  }
  return !polygon.empty();
}

// Whether a ball of this radius reaches a region: its point nearest to the centre lies on none, one, two or three
// planes.
bool touches(const abut_vec3& centre, double radius, const std::vector<Side>& sides) {
  const auto is_in = [&](const abut_vec3& p) {
    return std::all_of(sides.begin(), sides.end(), [&](const Side& side) { return height(side, p) >= -1e-9; });
  };
  const auto reaches = [&](const abut_vec3& p) { return length(p - centre) <= radius && is_in(p); };
  if (is_in(centre)) return true;
  for (const Side& a : sides) {
    if (reaches(centre - height(a, centre) * a.normal)) return true;
    for (const Side& b : sides) {
      const double c = dot(a.normal, b.normal);
      if (1 - c * c < 1e-9) continue;
      const double s = (height(a, centre) - c * height(b, centre)) / (1 - c * c);
      const double t = (height(b, centre) - c * height(a, centre)) / (1 - c * c);
      if (reaches(centre - s * a.normal - t * b.normal)) return true;
      for (const Side& d : sides) {
        const std::optional<abut_vec3> corner = corner_of(a.normal, a.offset, b.normal, b.offset, d.normal, d.offset);
        if (corner && reaches(*corner)) return true;
      }
    }
  }
  return false;
}

// What the tests know of a geometry: a ball, or points that are joined to triangles.
struct Body {
  Placed placed;
  double radius = 0;
  abut_vec3 centre{};
  std::vector<abut_vec3> points;
  std::vector<std::array<std::size_t, 3>> triangles;
};

// The answer for a region that is grown by this much.
bool is_selected(const Body& body, const std::vector<Side>& sides, bool inside, double grown) {
  const auto deep = [&](const abut_vec3& p, double radius) {
    return std::all_of(sides.begin(), sides.end(), [&](const Side& side) { return height(side, p) >= radius - grown; });
  };
  if (inside && body.points.empty()) return deep(body.centre, body.radius);
  if (inside)
    return std::all_of(body.points.begin(), body.points.end(), [&](const abut_vec3& p) { return deep(p, 0); });
  if (body.points.empty()) return touches(body.centre, body.radius + grown, sides);
  return std::any_of(body.triangles.begin(), body.triangles.end(), [&](const auto& its) {
    return touches({body.points[its[0]], body.points[its[1]], body.points[its[2]]}, sides, grown);
  });
}

Body body_of(World& world, const Shape& shape, const abut_vec3& position, const abut_quat& turn, double radius) {
  Body body{
      .placed = world.add(shape, position, turn), .radius = radius, .centre = position, .points = {}, .triangles = {}};
  if (radius > 0) return body;
  const Surface surface = surface_of(shape);
  for (const abut_vec3& vertex : surface.vertices) body.points.push_back(moved({position, turn}, vertex));
  body.triangles = surface.triangles;
  return body;
}

std::vector<Body> fill(World& world, Random& random) {
  std::vector<double> corners;
  for (int i = 0; i < 60; ++i) corners.push_back(random.in(-0.8, 0.8));
  const std::array shapes{box(0.4, 0.6, 0.3),      sphere(0.5), hull(corners),
                          ball_mesh(0.6, 6),       sphere(1.5), mesh({-1, -1, 0, 1, -1, 0, 0, 1, 0.3}, {0, 1, 2}),
                          ground_mesh(1.5, 6, 0.3)};
  std::vector<Body> bodies;
  for (std::size_t i = 0; i < 140; ++i) {
    const double radius = i % 7 == 1 ? 0.5 : i % 7 == 4 ? 1.5 : 0;
    bodies.push_back(body_of(world, shapes[i % 7], random.point(8), random.turn(), radius));
  }
  return bodies;
}

TEST(Rectangle, SelectsWhatItTouchesAndWhatIsInside) {
  std::array<std::size_t, 2> selected{};
  for (const std::uint64_t seed : {71U, 72U, 73U}) {
    World world;
    Random random(seed);
    const std::vector<Body> bodies = fill(world, random);
    for (int i = 0; i < 60; ++i) {
      SCOPED_TRACE("seed " + std::to_string(seed) + ", rectangle " + std::to_string(i));
      const abut_camera camera = some_camera(random);
      // Every fifth has no width, every seventh is a point.
      Rectangle its{random.in(0, 640), random.in(0, 480), random.in(0, 640), random.in(0, 480)};
      if (i % 5 == 0) its.x1 = its.x0;
      if (i % 7 == 0) its = {its.x0, its.y0, its.x0, its.y0};
      std::vector<abut_clip_plane> planes;
      for (int k = 0; k < i % 3; ++k) planes.push_back({random.point(2), random.in(-4, 0)});
      ASSERT_EQ(abut_picker_set_clip_planes(world.picker(), planes.data(), planes.size()), ABUT_OK);
      const std::vector<Side> sides = sides_of(camera, its, planes);
      for (const bool inside : {false, true}) {
        const std::vector<abut_geometry_id> found = selected_by(
            world, camera, {its.x0, its.y0, its.x1, its.y1}, inside ? ABUT_SELECTION_INSIDE : ABUT_SELECTION_TOUCHING);
        EXPECT_TRUE(
            std::is_sorted(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.slot < b.slot; }));
        selected.at(inside ? 1 : 0) += found.size();
        for (const Body& body : bodies) {
          // What a region grown or shrunk by so little decides otherwise may be either.
          const bool larger = is_selected(body, sides, inside, 1e-7);
          if (larger != is_selected(body, sides, inside, -1e-7) && its.x0 != its.x1) continue;
          if (its.x0 == its.x1 && larger != is_selected(body, sides, inside, 1e-9)) continue;
          const bool is_found =
              std::any_of(found.begin(), found.end(), [&](const auto& id) { return same(id, body.placed.geometry); });
          EXPECT_EQ(is_found, larger) << "geometry " << body.placed.geometry.slot << (inside ? " inside" : " touching");
        }
      }
    }
  }
  EXPECT_GT(selected[0], 1000U);
  EXPECT_GT(selected[1], 300U);
}

const abut_camera& plain_camera() {
  static const abut_camera camera = [] {
    abut_camera made;
    abut_camera_init(&made, sizeof made);
    const abut_vec3 eye{0, -10, 1};
    const abut_vec3 target{0, 0, 1};
    const abut_vec3 up{0, 0, 1};
    EXPECT_EQ(abut_camera_look_at(&made, &eye, &target, &up), ABUT_OK);
    return made;
  }();
  return camera;
}

constexpr std::array<double, 4> whole_picture{0, 0, 640, 480};

// Its horizon is the middle of the picture, far beyond all other shapes.
TEST(Rectangle, TouchesTheGroundBelowTheHorizon) {
  World world;
  const Placed ground = world.add(plane({0, 0, 1}, 0), {0, 0, 0});
  world.add(sphere(1), {0, 0, 1});
  const auto touches_ground = [&](double top, double bottom) {
    for (const abut_geometry_id id :
         selected_by(world, plain_camera(), {600, top, 640, bottom}, ABUT_SELECTION_TOUCHING)) {
      if (same(id, ground.geometry)) return true;
    }
    return false;
  };
  EXPECT_TRUE(touches_ground(300, 400));
  EXPECT_TRUE(touches_ground(100, 240.001));
  EXPECT_FALSE(touches_ground(100, 239.999));
  const std::vector<abut_geometry_id> inside = selected_by(world, plain_camera(), whole_picture, ABUT_SELECTION_INSIDE);
  ASSERT_EQ(inside.size(), 1U);
  EXPECT_FALSE(same(inside[0], ground.geometry));
}

TEST(Rectangle, SelectsShapesOfEveryKind) {
  constexpr std::uint64_t seed = 74;
  SCOPED_TRACE("seed " + std::to_string(seed));
  Random random(seed);
  const std::vector<Shape> shapes = shapes_of_every_kind(random);
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    SCOPED_TRACE("shape " + std::to_string(i));
    World world;
    const Placed placed = world.add(shapes[i], {0, 0, 1});
    for (const abut_selection selection : {ABUT_SELECTION_TOUCHING, ABUT_SELECTION_INSIDE}) {
      const std::vector<abut_geometry_id> found = selected_by(world, plain_camera(), whole_picture, selection);
      ASSERT_EQ(found.size(), 1U);
      EXPECT_TRUE(same(found[0], placed.geometry));
      EXPECT_TRUE(selected_by(world, plain_camera(), {0, 0, 20, 20}, selection).empty());
    }
    // A cross of four rectangles: the shape is in none of them, and touches one at least.
    std::size_t touching = 0;
    for (const auto& part :
         {std::array<double, 4>{0, 0, 320, 240}, {320, 0, 640, 240}, {0, 240, 320, 480}, {320, 240, 640, 480}})
      touching += selected_by(world, plain_camera(), part, ABUT_SELECTION_TOUCHING).size();
    EXPECT_GE(touching, 1U);
  }
}

TEST(Rectangle, FollowsTheUniverseAndTheFilter) {
  World world;
  const Placed a = world.add(sphere(1), {-3, 0, 1});
  const Placed b = world.add(ball_mesh(1, 8), {3, 0, 1});
  const Placed hidden = world.add(sphere(0.2), {3, 5, 1});
  const auto count = [&](const abut_query_filter* filter = nullptr) {
    return selected_by(world, plain_camera(), whole_picture, ABUT_SELECTION_TOUCHING, filter).size();
  };
  EXPECT_EQ(count(), 3U) << "hidden geometries count";
  world.move(a, {-30, 0, 1});
  EXPECT_EQ(count(), 2U);
  world.move(a, {-3, 0, 1});
  EXPECT_EQ(count(), 3U);
  abut_query_filter filter;
  abut_query_filter_init(&filter, sizeof filter);
  filter.ignore_geometry = b.geometry;
  EXPECT_EQ(count(&filter), 2U);
  world.remove(hidden);
  EXPECT_EQ(count(), 2U);
  ASSERT_EQ(abut_geometry_park(world.universe(), b.geometry, ABUT_PARKING_SHORT_TERM), ABUT_OK);
  EXPECT_EQ(count(), 1U);
  abut_geometry_options options;
  abut_geometry_options_init(&options, sizeof options);
  options.flags = ABUT_GEOMETRY_SENSOR;
  ASSERT_EQ(abut_geometry_set_options(world.universe(), a.geometry, &options), ABUT_OK);
  EXPECT_EQ(count(), 0U);
  ASSERT_EQ(abut_picker_set_flags(world.picker(), ABUT_PICKER_SENSORS), ABUT_OK);
  EXPECT_EQ(count(), 1U);
}

TEST(Rectangle, FillsAsMuchAsThereIsRoomFor) {
  World world;
  for (int i = 0; i < 5; ++i) world.add(sphere(0.1), {0.5 * i - 1, 0, 1});
  std::array<abut_geometry_id, 3> room{};
  std::size_t count = 0;
  ASSERT_EQ(abut_picker_select_rectangle(world.picker(), &plain_camera(), 640, 480, 0, 0, ABUT_SELECTION_INSIDE,
                                         nullptr, room.data(), 2, &count),
            ABUT_OK);
  EXPECT_EQ(count, 5U);
  EXPECT_NE(room[1].slot, 0U);
  EXPECT_EQ(room[2].slot, 0U);
}

}  // namespace
