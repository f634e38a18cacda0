// SPDX-License-Identifier: Apache-2.0
// What a cursor snaps to.
module;

#include <abut/picking.h>

#include "picking/embree.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

module abut.picking;
import :box_table;
import :camera;
import :entry;
import :outline;
import :region;
import :source;
import :tracer;
import :vector;

namespace abut::picking {

namespace {

constexpr abut_snap no_snap{.geometry = {0, 0},
                            .kind = 0,
                            .vertices = {0, 0},
                            .reserved = 0,
                            .parameter = 0,
                            .pixels = infinity,
                            .distance = infinity,
                            .point = {0, 0, 0}};

// Vertices go before middles of edges, and these before other points of edges, as their bits do.
[[nodiscard]] bool goes_before(const abut_snap& a, const abut_snap& b) {
  const auto order = [](const abut_snap& its) {
    return std::tuple(its.kind, its.pixels, its.geometry.slot, its.vertices[0], its.vertices[1]);
  };
  return order(a) < order(b);
}

// Edges of triangles, once each. Those between triangles of one face are none.
void add_edges(const TriangleList& list, const std::vector<std::uint32_t>& faces, Wires& out) {
  struct Side {
    std::array<std::uint32_t, 2> ends;
    std::uint32_t face;
  };
  std::vector<Side> sides;
  for (std::size_t i = 0; i + 2 < list.indices.size(); i += 3) {
    const std::array<std::uint32_t, 3> corners{list.indices[i], list.indices[i + 1], list.indices[i + 2]};
    // Of a triangle that was removed.
    if (corners[0] == corners[1] && corners[1] == corners[2]) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [low, high] = std::minmax(corners[k], corners[(k + 1) % 3]);
      out.vertices.push_back(corners[k]);
      if (low != high) sides.push_back({{low, high}, faces.empty() ? nowhere : faces[i / 3]});
    }
  }
  std::ranges::sort(out.vertices);
  out.vertices.erase(std::unique(out.vertices.begin(), out.vertices.end()), out.vertices.end());
  std::ranges::sort(sides, {}, &Side::ends);
  for (std::size_t i = 0; i < sides.size();) {
    std::size_t end = i + 1;
    while (end < sides.size() && sides[end].ends == sides[i].ends) ++end;
    const bool is_within_face = end == i + 2 && sides[i].face != nowhere && sides[i].face == sides[i + 1].face;
    if (!is_within_face) out.edges.push_back(sides[i].ends);
    i = end;
  }
}

// Vertices and edges of a geometry that are within the radius.
class Search {
 public:
  Search(const Sight& sight, abut_snap_kinds kinds, std::vector<abut_snap>& out)
      : sight_(sight), kinds_(kinds), out_(&out) {}

  void look_at(const Entry& entry, const Wires& wires, const auto& trim) {
    id_ = entry.id;
    std::vector<abut_vec3> world;
    std::vector<abut_vec3> seen;
    for (std::size_t i = 0; i + 2 < wires.xyz.size(); i += 3) {
      world.push_back(to_world(entry.frame, {wires.xyz[i], wires.xyz[i + 1], wires.xyz[i + 2]}));
      seen.push_back(sight_.seen(world.back()));
    }
    if (wants(ABUT_SNAP_VERTEX)) {
      for (const std::uint32_t vertex : wires.vertices)
        add_point(ABUT_SNAP_VERTEX, {vertex, vertex}, 0, world[vertex], seen[vertex]);
    }
    for (const std::array<std::uint32_t, 2>& edge : wires.edges) {
      const abut_vec3& a = world[edge[0]];
      const abut_vec3& b = world[edge[1]];
      if (wants(ABUT_SNAP_MIDPOINT)) {
        add_point(ABUT_SNAP_MIDPOINT, edge, 0.5, scale(add(a, b), 0.5), scale(add(seen[edge[0]], seen[edge[1]]), 0.5));
      }
      if (wants(ABUT_SNAP_EDGE)) add_edge(edge, a, b, trim);
    }
  }

 private:
  [[nodiscard]] bool wants(abut_snap_kinds kind) const { return (kinds_ & kind) != 0; }

  void push(abut_snap_kinds kind, const std::array<std::uint32_t, 2>& vertices, double parameter, double pixels,
            const abut_vec3& point) {
    out_->push_back({.geometry = id_,
                     .kind = kind,
                     .vertices = {vertices[0], vertices[1]},
                     .reserved = 0,
                     .parameter = parameter,
                     .pixels = pixels,
                     .distance = infinity,
                     .point = point});
  }
  void add_point(abut_snap_kinds kind, const std::array<std::uint32_t, 2>& vertices, double parameter,
                 const abut_vec3& world, const abut_vec3& seen) {
    if (!sight_.aim.view.is_parallel && seen.z <= 0) return;
    const Offset off = sight_.offset_of(seen);
    const double pixels = std::hypot(off.x, off.y);
    if (pixels <= sight_.aim.radius) push(kind, vertices, parameter, pixels, world);
  }
  void add_edge(const std::array<std::uint32_t, 2>& edge, const abut_vec3& a, const abut_vec3& b, const auto& trim) {
    const abut_vec3 along = subtract(b, a);
    if (largest_component(along) == 0) return;
    const double whole = length(along);
    abut_ray part{a, normalized(along), whole};
    double skipped = 0;
    if (!trim(part, skipped)) return;
    const abut_vec3 end = part.max_distance == whole ? b : add(part.origin, scale(part.direction, part.max_distance));
    const ThinCandidate nearest = look_at_edge(sight_, sight_.seen(part.origin), sight_.seen(end));
    if (!(nearest.size <= sight_.aim.radius)) return;
    const abut_vec3 point = sight_.in_world(nearest.seen);
    const double parameter = std::clamp(dot(subtract(point, a), along) / (whole * whole), 0.0, 1.0);
    push(ABUT_SNAP_EDGE, edge, parameter, nearest.size, point);
  }

  Sight sight_;
  abut_snap_kinds kinds_;
  std::unique_ptr<std::vector<abut_snap>, Borrowed> out_;
  abut_geometry_id id_{};
};

}  // namespace

abut_status Tracer::make_wires(const ShapeRecord& shape) const {
  const std::scoped_lock lock(crossed_mutex_);
  if (shape.wires) return ABUT_OK;
  auto made = std::make_unique<Wires>();
  if (shape.is_thin()) {
    const double half = shape.rounded->half_height;
    made->xyz = half == 0 ? std::vector<double>{0, 0, 0} : std::vector<double>{0, 0, -half, 0, 0, half};
    made->vertices = half == 0 ? std::vector<std::uint32_t>{0} : std::vector<std::uint32_t>{0, 1};
    if (half != 0) made->edges.push_back({0, 1});
  } else {
    TriangleList list;
    std::vector<std::uint32_t> faces;
    if (const abut_status status = shape.access->triangles(list); status != ABUT_OK) return status;
    if (const abut_status status = shape.access->faces(list, faces); status != ABUT_OK) return status;
    add_edges(list, faces, *made);
    made->xyz = std::move(list.xyz);
  }
  shape.wires = std::move(made);
  return ABUT_OK;
}

// Tells the distance of what is seen.
bool Tracer::is_visible(const View& view, const abut_query_filter* filter, abut_snap& snap) const {
  if (!is_kept(snap.point)) return false;
  const std::optional<abut_ray> line = sight_line(view, snap.point);
  if (!line || meets(*line, filter)) return false;
  snap.distance = line->max_distance / (1 - hiding);
  return true;
}

abut_status Tracer::snap(const Aim& aim, abut_snap_kinds kinds, const abut_query_filter* filter, abut_snap& out) const {
  // Near and far along a ray are no planes: what is near the eye is looked at in any case.
  View around = aim.view;
  if (!around.is_parallel && !around.has_planes) {
    around.limit += around.start;
    around.start = 0;
  }
  const Rectangle square{aim.x - aim.radius, aim.y - aim.radius, aim.x + aim.radius, aim.y + aim.radius};
  std::vector<std::uint32_t> near;
  boxes_.look(region_of(around, square, clip_planes_),
              [&](std::uint32_t slot, PlaneBits /*crossed*/) { near.push_back(entry_of_slot_[slot]); });
  near.insert(near.end(), apart_.begin(), apart_.end());
  std::vector<abut_snap> found;
  Search search({aim}, kinds, found);
  for (const std::uint32_t index : near) {
    const Entry& entry = entries_[index];
    const ShapeRecord& shape = shapes_[entry.shape];
    if (!admits(filter, entry) || (shape.triangle_count == 0 && !shape.is_thin())) continue;
    if (const abut_status status = make_wires(shape); status != ABUT_OK) return status;
    search.look_at(entry, *shape.wires, [&](abut_ray& ray, double& skipped) { return trim(ray, skipped); });
  }
  std::ranges::sort(found, goes_before);
  const auto seen = std::ranges::find_if(found, [&](abut_snap& its) { return is_visible(aim.view, filter, its); });
  out = seen == found.end() ? no_snap : *seen;
  return ABUT_OK;
}

}  // namespace abut::picking
