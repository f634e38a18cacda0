// SPDX-License-Identifier: Apache-2.0
// picking.h: what a cursor snaps to, against all vertices and edges of a scene one by one; what hides them is found by
// rays against each shape in double.
#include "picking_tools.hpp"

#include <abut/picking.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace picking_test;

struct Wires {
  abut_geometry_id geometry;
  std::vector<abut_vec3> vertices;
  std::vector<std::pair<std::size_t, std::size_t>> edges;
};

std::pair<std::size_t, std::size_t> edge_of(std::size_t a, std::size_t b) { return {std::min(a, b), std::max(a, b)}; }

// Edges of a surface. Of a box and a hull only those whose triangles lie in different planes.
Wires wires_of(World& world, const Shape& shape, const abut_pose& pose, bool has_flat_faces) {
  Wires out{world.add(shape, pose.position, pose.orientation).geometry, {}, {}};
  const Surface surface = surface_of(shape);
  for (const abut_vec3& vertex : surface.vertices) out.vertices.push_back(moved(pose, vertex));
  std::set<std::pair<std::size_t, std::size_t>> sides;
  for (const auto& its : surface.triangles) {
    for (std::size_t k = 0; k < 3; ++k) sides.insert(edge_of(its.at(k), its.at((k + 1) % 3)));
  }
  for (const auto& side : sides) {
    double volume = 0;
    for (const auto& its : surface.triangles) {
      for (std::size_t k = 0; k < 3; ++k) {
        if (edge_of(its.at(k), its.at((k + 1) % 3)) != side) continue;
        for (const auto& other : surface.triangles) {
          const bool has_both = std::count(other.begin(), other.end(), side.first) +
                                    std::count(other.begin(), other.end(), side.second) ==
                                2;
          if (!has_both) continue;
          for (const std::size_t far : other) {
            const abut_vec3& a = surface.vertices[its[0]];
            volume = std::max(volume, std::fabs(dot(surface.vertices[far] - a, cross(surface.vertices[its[1]] - a,
                                                                                     surface.vertices[its[2]] - a))));
          }
        }
      }
    }
    if (!has_flat_faces || volume > 1e-9) out.edges.push_back(side);
  }
  return out;
}

struct Found {
  abut_snap_kinds kind = 0;
  double pixels = infinity;
  bool is_clear = true;  // no other candidate is as near
};

class Oracle {
 public:
  Oracle(World& world, const abut_camera& camera, double x, double y, double radius)
      : world_(world), camera_(camera), axes_(axes_of(camera)), x_(x), y_(y), radius_(radius) {}

  Found find(const std::vector<Wires>& all, abut_snap_kinds kinds) {
    for (const abut_snap_kinds kind : {ABUT_SNAP_VERTEX, ABUT_SNAP_MIDPOINT, ABUT_SNAP_EDGE}) {
      if ((kinds & kind) == 0) continue;
      Found best{kind, infinity, true};
      for (const Wires& wires : all) look_at(wires, kind, best);
      if (best.pixels < infinity) return best;
    }
    return {};
  }
  double pixels_to(const abut_vec3& point) const {
    const abut_vec3 seen = pictured(axes_, point);
    return std::hypot(seen.x - x_, seen.y - y_);
  }
  // Nothing lies before it but what is as near as the point itself.
  bool is_seen(const abut_vec3& point) const {
    const abut_vec3 seen = pictured(axes_, point);
    abut_ray ray{};
    EXPECT_EQ(abut_camera_ray(&camera_, seen.x, seen.y, &ray), ABUT_OK);
    const double distance = length(point - ray.origin);
    if (seen.z < camera_.near_distance || seen.z > camera_.far_distance) return false;
    return world_.brute(ray).distance > distance * (1 - 1e-6);
  }

 private:
  void look_at(const Wires& wires, abut_snap_kinds kind, Found& best) {
    if (kind == ABUT_SNAP_VERTEX) {
      for (const abut_vec3& vertex : wires.vertices) try_point(vertex, best);
      return;
    }
    for (const auto& [a, b] : wires.edges) {
      const abut_vec3& from = wires.vertices[a];
      const abut_vec3& to = wires.vertices[b];
      if (kind == ABUT_SNAP_MIDPOINT) {
        try_point(0.5 * (from + to), best);
      } else if (is_before(from) && is_before(to)) {
        try_point(nearest_on(from, to), best);
      }
    }
  }
  bool is_before(const abut_vec3& point) const { return axes_.is_parallel || pictured(axes_, point).z > 0; }
  void try_point(const abut_vec3& point, Found& best) {
    if (!is_before(point)) return;
    const double pixels = pixels_to(point);
    if (pixels > radius_ || pixels > best.pixels + 1e-6 || !is_seen(point)) return;
    best.pixels = std::min(best.pixels, pixels);
  }
  // By golden sections: the distance in the picture has one valley along an edge.
  abut_vec3 nearest_on(const abut_vec3& from, const abut_vec3& to) const {
    double low = 0;
    double high = 1;
    for (int i = 0; i < 100; ++i) {
      const double a = low + (high - low) * 0.381966011250105;
      const double b = low + (high - low) * 0.618033988749895;
      (pixels_to(from + a * (to - from)) < pixels_to(from + b * (to - from)) ? high : low) =
          pixels_to(from + a * (to - from)) < pixels_to(from + b * (to - from)) ? b : a;
    }
    return from + 0.5 * (low + high) * (to - from);
  }

  World& world_;
  const abut_camera& camera_;
  Axes axes_;
  double x_, y_, radius_;
};

abut_snap snap_at(World& world, const abut_camera& camera, double x, double y, double radius,
                  abut_snap_kinds kinds = 0) {
  abut_snap out{};
  EXPECT_EQ(abut_picker_snap(world.picker(), &camera, x, y, radius, kinds, nullptr, &out), ABUT_OK)
      << abut_last_error_message();
  return out;
}

// The point lies where its geometry, vertices and parameter say.
void expect_consistent(const abut_snap& snap, const std::vector<Wires>& all) {
  const auto its =
      std::find_if(all.begin(), all.end(), [&](const Wires& w) { return same(w.geometry, snap.geometry); });
  ASSERT_NE(its, all.end());
  const abut_vec3& a = its->vertices.at(snap.vertices[0]);
  const abut_vec3& b = its->vertices.at(snap.vertices[1]);
  EXPECT_NEAR(length(a + snap.parameter * (b - a) - snap.point), 0, 1e-9);
  EXPECT_EQ(snap.kind == ABUT_SNAP_VERTEX, snap.vertices[0] == snap.vertices[1]);
  if (snap.kind == ABUT_SNAP_MIDPOINT) EXPECT_EQ(snap.parameter, 0.5);
  if (snap.kind != ABUT_SNAP_VERTEX) {
    const std::pair<std::size_t, std::size_t> edge{snap.vertices[0], snap.vertices[1]};
    EXPECT_NE(std::find(its->edges.begin(), its->edges.end(), edge), its->edges.end()) << "no edge of its shape";
  }
}

TEST(Snap, FindsTheNearestThatIsSeen) {
  std::array<std::size_t, 5> found{};
  for (const std::uint64_t seed : {81U, 82U, 83U, 84U}) {
    World world;
    Random random(seed);
    std::vector<double> corners;
    for (int i = 0; i < 36; ++i) corners.push_back(random.in(-1.2, 1.2));
    const std::array shapes{box(1, 0.6, 0.8), hull(corners), ball_mesh(1, 4),
                            mesh({-1, -1, 0, 1, -1, 0, 0, 1, 0.3}, {0, 1, 2})};
    std::vector<Wires> all;
    for (std::size_t i = 0; i < 24; ++i)
      all.push_back(wires_of(world, shapes[i % 4], {random.point(5), random.turn()}, i % 4 < 2));
    for (int i = 0; i < 40; ++i) {
      SCOPED_TRACE("seed " + std::to_string(seed) + ", camera " + std::to_string(i));
      const abut_camera camera = some_camera(random);
      const double x = random.in(100, 540);
      const double y = random.in(100, 380);
      const double radius = random.in(1, 40);
      const abut_snap_kinds kinds = static_cast<abut_snap_kinds>(random.below(8));
      Oracle oracle(world, camera, x, y, radius);
      const Found expected = oracle.find(all, kinds == 0 ? 7 : kinds);
      const abut_snap snap = snap_at(world, camera, x, y, radius, kinds);
      ASSERT_EQ(snap.kind, expected.kind) << snap.pixels << " beside " << expected.pixels;
      ++found.at(snap.kind);
      if (snap.kind == 0) {
        EXPECT_EQ(snap.geometry.slot, 0U);
        EXPECT_EQ(snap.pixels, infinity);
        continue;
      }
      EXPECT_NEAR(snap.pixels, expected.pixels, 1e-6);
      EXPECT_NEAR(oracle.pixels_to(snap.point), snap.pixels, 1e-6);
      EXPECT_TRUE(oracle.is_seen(snap.point));
      expect_consistent(snap, all);
    }
  }
  for (const std::size_t kind : {0U, 1U, 2U, 4U}) EXPECT_GT(found.at(kind), 10U) << "of kind " << kind;
}

abut_camera from_above() {
  abut_camera camera;
  abut_camera_init(&camera, sizeof camera);
  camera.projection = ABUT_PROJECTION_ORTHOGRAPHIC;
  camera.vertical_extent = 48;  // a tenth of a metre for a pixel
  camera.pose.position = {0, 0, 10};
  return camera;
}

TEST(Snap, PrefersVerticesToMidpointsToEdges) {
  World world;
  const Placed placed = world.add(box(2, 1, 1), {0, 0, 0});
  const abut_camera camera = from_above();
  // 4 pixels above the upper edge, 8 pixels to the right of its middle and 12 to the left of its end.
  const auto at = [&](double radius, abut_snap_kinds kinds = 0) {
    return snap_at(world, camera, 328, 226, radius, kinds);
  };
  EXPECT_EQ(at(3.9).kind, 0U);
  abut_snap snap = at(4.1);
  EXPECT_EQ(snap.kind, static_cast<abut_snap_kinds>(ABUT_SNAP_EDGE));
  EXPECT_NEAR(length(snap.point - abut_vec3{0.8, 1, 1}), 0, 1e-12);
  EXPECT_NEAR(snap.distance, 9, 1e-12);
  snap = at(9);
  EXPECT_EQ(snap.kind, static_cast<abut_snap_kinds>(ABUT_SNAP_MIDPOINT));
  EXPECT_NEAR(length(snap.point - abut_vec3{0, 1, 1}), 0, 1e-12);
  snap = at(13);
  EXPECT_EQ(snap.kind, static_cast<abut_snap_kinds>(ABUT_SNAP_VERTEX));
  EXPECT_NEAR(length(snap.point - abut_vec3{2, 1, 1}), 0, 1e-12);
  EXPECT_TRUE(same(snap.geometry, placed.geometry));
  EXPECT_EQ(at(13, ABUT_SNAP_EDGE).kind, static_cast<abut_snap_kinds>(ABUT_SNAP_EDGE));
  EXPECT_EQ(at(13, ABUT_SNAP_EDGE | ABUT_SNAP_MIDPOINT).kind, static_cast<abut_snap_kinds>(ABUT_SNAP_MIDPOINT));
}

TEST(Snap, FindsPointsAndSegments) {
  World world;
  const Placed point = world.add(shape_of_kind("point", {}), {0.5, 0, 0});
  abut_snap snap = snap_at(world, from_above(), 320, 240, 6);
  EXPECT_TRUE(same(snap.geometry, point.geometry));
  EXPECT_EQ(snap.kind, static_cast<abut_snap_kinds>(ABUT_SNAP_VERTEX));
  EXPECT_NEAR(snap.pixels, 5, 1e-12);
  world.remove(point);
  const double half = std::sqrt(0.5);
  const Placed segment = world.add(shape_of_kind("segment", std::array{4.0}), {1, 0.2, 0}, {half, 0, half, 0});
  snap = snap_at(world, from_above(), 320, 240, 6);
  EXPECT_TRUE(same(snap.geometry, segment.geometry));
  EXPECT_EQ(snap.kind, static_cast<abut_snap_kinds>(ABUT_SNAP_EDGE));
  EXPECT_EQ(snap.vertices[1], 1U);
  EXPECT_NEAR(length(snap.point - abut_vec3{0, 0.2, 0}), 0, 1e-12);
  EXPECT_NEAR(snap.parameter, 0.375, 1e-12);
}

TEST(Snap, HeedsClipPlanesFiltersAndWhatHides) {
  World world;
  const Placed low = world.add(box(1, 1, 1), {0, 0, 0});
  const abut_camera camera = from_above();
  const auto snap = [&](const abut_query_filter* filter = nullptr) {
    abut_snap out{};
    EXPECT_EQ(abut_picker_snap(world.picker(), &camera, 330, 230, 3, 0, filter, &out), ABUT_OK);
    return out;
  };
  EXPECT_NEAR(length(snap().point - abut_vec3{1, 1, 1}), 0, 1e-12);
  // Two edges along X end at the cut, half a metre before the cursor.
  const abut_clip_plane left{{-1, 0, 0}, -0.5};
  ASSERT_EQ(abut_picker_set_clip_planes(world.picker(), &left, 1), ABUT_OK);
  EXPECT_EQ(snap().kind, 0U);
  const abut_snap cut = snap_at(world, camera, 330, 230, 6);
  EXPECT_EQ(cut.kind, static_cast<abut_snap_kinds>(ABUT_SNAP_EDGE));
  EXPECT_NEAR(cut.pixels, 5, 1e-9);
  EXPECT_NEAR(cut.point.x, 0.5, 1e-9);
  ASSERT_EQ(abut_picker_set_clip_planes(world.picker(), nullptr, 0), ABUT_OK);
  const Placed lid = world.add(box(3, 3, 0.1), {0, 0, 5});
  EXPECT_EQ(snap().kind, 0U);
  abut_query_filter filter;
  abut_query_filter_init(&filter, sizeof filter);
  filter.ignore_geometry = lid.geometry;
  EXPECT_TRUE(same(snap(&filter).geometry, low.geometry));
}

}  // namespace
