// SPDX-License-Identifier: Apache-2.0
// Everything that a ray meets.
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
#include <utility>
#include <vector>

module abut.picking;
import :box_scene;
import :crossing;
import :entry;
import :hit;
import :source;
import :surface;
import :tracer;
import :vector;

namespace abut::picking {

namespace {

// So many triangles are looked at sooner one by one.
constexpr std::size_t few_triangles = 32;

// Surfaces of other sizes have no boxes in single precision.
constexpr double smallest_boxed = 1e-9;
constexpr double largest_boxed = 1e9;

[[nodiscard]] abut_aabb box_around(const std::array<abut_vec3, 3>& corners) {
  abut_aabb box = empty_box;
  for (const abut_vec3& corner : corners) extend(box, corner);
  return box;
}

// By winding; `size` is about that of the triangle.
[[nodiscard]] abut_vec3 normal_of(const std::array<abut_vec3, 3>& corners, double size) {
  const auto side = [&](std::size_t corner) { return scale(subtract(corners[corner], corners[0]), 1 / size); };
  const abut_vec3 normal = cross(side(1), side(2));
  return largest_component(normal) > 0 ? normalized(normal) : normal;
}

// The normal of a triangle that a ray meets, on the side that its outline shows: rounding may turn the normal of one
// that is seen edge-on by 1e-15, and the least step is more than that.
[[nodiscard]] abut_vec3 facing(const abut_vec3& normal, const abut_vec3& direction, bool enters) {
  constexpr double least = 0x1p-48;
  const double toward = enters ? -1 : 1;
  const double rise = dot(normal, direction);
  if (toward * rise >= least) return normal;
  return normalized(add(normal, scale(direction, toward * least - rise)));
}

}  // namespace

abut_status Tracer::trace_all(const abut_ray& ray, const abut_query_filter* filter, std::vector<abut_pick>& out) const {
  abut_ray unit{ray.origin, normalized(ray.direction), ray.max_distance};
  double skipped = 0;
  out.clear();
  if (!trim(unit, skipped)) return ABUT_OK;
  AllHits query(unit, filter);
  for (const Baked& baked : baked_) query.met.push_back(baked.entry);
  query.met.insert(query.met.end(), apart_.begin(), apart_.end());
  for (const MovingScene& moving : moving_) {
    Entrance entrance{};
    if (moving.is_empty() || !enter(moving.space, unit.origin, unit.direction, unit.max_distance, entrance)) continue;
    RTCRayHit hit;
    write_ray(hit, entrance.point, unit.direction, unit.max_distance - entrance.advance);
    embree::intersect(moving.scene.get(), query, hit);
  }
  if (query.out_of_memory) return ABUT_OUT_OF_MEMORY;
  for (const std::uint32_t index : query.met) {
    if (const abut_status status = cross(query, index); status != ABUT_OK) return status;
  }
  merge_crossings(query.crossings, unit.direction, out);
  if (skips_back_faces_)
    std::erase_if(out, [&](const abut_pick& pick) { return dot(pick.normal, unit.direction) > 0; });
  for (abut_pick& pick : out) pick.distance += skipped;
  return ABUT_OK;
}

abut_status Tracer::cross(AllHits& query, std::uint32_t index) const {
  const Entry& entry = entries_[index];
  if (!admits(query.wanted.get(), entry)) return ABUT_OK;
  const ShapeRecord& shape = shapes_[entry.shape];
  if (shape.triangle_count != 0) return cross_surface(query, entry, shape);
  cross_exact(query, entry, shape);
  return ABUT_OK;
}

// Many threads may ask at once, and Embree builds on threads of its own, which no traversal may wait for: so this is
// outside of all of them.
abut_status Tracer::make_crossed(const ShapeRecord& shape) const {
  const std::scoped_lock lock(crossed_mutex_);
  if (shape.crossed) return ABUT_OK;
  auto made = std::make_unique<CrossedSurface>();
  if (const abut_status status = shape.access->triangles(made->list); status != ABUT_OK) return status;
  if (const abut_status status = shape.access->faces(made->list, made->faces); status != ABUT_OK) return status;
  made->box = box_of(made->list);
  const double size = diagonal_of(made->box);
  if (made->size() > few_triangles && size >= smallest_boxed && size <= largest_boxed) {
    std::vector<abut_aabb> boxes;
    boxes.reserve(made->size());
    for (std::uint32_t i = 0; i < made->size(); ++i) boxes.push_back(box_around(made->corners_of(i)));
    made->boxes = make_box_scene(device_.get(), space_around(made->box), boxes);
    if (!made->boxes) return ABUT_OUT_OF_MEMORY;
  }
  shape.crossed = std::move(made);
  return ABUT_OK;
}

abut_status Tracer::cross_surface(AllHits& query, const Entry& entry, const ShapeRecord& shape) const {
  Entrance entrance{};
  if (is_bounded(entry.box) &&
      !enter(space_around(entry.box), query.ray.origin, query.ray.direction, query.ray.max_distance, entrance)) {
    return ABUT_OK;
  }
  if (const abut_status status = make_crossed(shape); status != ABUT_OK) return status;
  const CrossedSurface& surface = *shape.crossed;
  const Space space = surface.boxes ? surface.boxes->space : space_around(surface.box);
  const abut_vec3 direction = normalized(rotate_back(entry.frame, query.ray.direction));
  if (!enter(space, to_local(entry.frame, query.ray.origin), direction, query.ray.max_distance, entrance))
    return ABUT_OK;
  const LineOfSight line(add(space.origin, entrance.point), direction, space.extent);
  const auto look_at = [&](std::uint32_t triangle) {
    const std::array<abut_vec3, 3> corners = surface.corners_of(triangle);
    const std::optional<LineOfSight::Met> met = line.crosses(corners);
    if (!met) return;
    const double distance = entrance.advance + met->along;
    if (!(distance >= 0 && distance <= query.ray.max_distance)) return;
    query.crossings.push_back(
        {.pick = {.geometry = entry.id,
                  .feature = {ABUT_FEATURE_FACE, surface.faces.empty() ? triangle : surface.faces[triangle]},
                  .child = 0,
                  .reserved = 0,
                  .distance = distance,
                  .point = add(query.ray.origin, scale(query.ray.direction, distance)),
                  .normal =
                      facing(rotate(entry.frame, normal_of(corners, space.extent)), query.ray.direction, met->enters)},
         .blur = -1});
  };
  if (!surface.boxes) {
    for (std::uint32_t i = 0; i < surface.size(); ++i) look_at(i);
    return ABUT_OK;
  }
  std::vector<std::uint32_t> near;
  if (!boxes_on_ray(*surface.boxes, entrance, direction, query.ray.max_distance, near)) return ABUT_OUT_OF_MEMORY;
  for (const std::uint32_t triangle : near) look_at(triangle);
  return ABUT_OK;
}

void Tracer::cross_exact(AllHits& query, const Entry& entry, const ShapeRecord& shape) {
  visit_crossings(*shape.access, entry.pose, query.ray, [&](const abut_ray_hit& hit) {
    query.crossings.push_back({.pick = pick_of(entry.id, hit), .blur = 0});
    return true;
  });
}

}  // namespace abut::picking
