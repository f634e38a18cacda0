// SPDX-License-Identifier: Apache-2.0
// One ray.
module;

#include <abut/picking.h>

#include "picking/embree.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>

module abut.picking;
import :entry;
import :hit;
import :source;
import :surface;
import :tracer;
import :vector;

namespace abut::picking {

// All that lies between two traversals delays the next one, so the usual ray passes here at once: its
// direction is nearly of unit length, which is the same in single precision, so that Embree need not wait
// for its scale, it starts near the surfaces, and nothing but surfaces is there. No ray that a caller has
// to refuse is one of these: each comparison fails for what is not a number.
bool Tracer::trace_usual(const abut_ray& ray, abut_pick& out) const noexcept {
  // First: until then another thread may be at work on what the rest reads.
  if (!is_current()) [[unlikely]]
    return false;
  const double square = dot_of_three(last_half(ray), last_half(ray));
  const Four start = first_half(ray) - still_space_.numbers();
  const bool is_usual =
      std::fabs(square - 1.0) < nearly_unit && are_within(start, usual_reach_) && ray.max_distance >= 0;
  if (!is_usual) [[unlikely]]
    return false;
  [[clang::uninitialized]] RTCRayHit hit;
  write_ray(hit, start, last_half(ray));
  embree::Query query(false);
  embree::intersect(single_still_.get(), query, hit);
  const double unit = 1.5 - 0.5 * square;
  if (hit.hit.geomID == RTC_INVALID_GEOMETRY_ID ||
      !resolve_still(first_half(ray), last_half(ray) * unit, ray.max_distance, hit.hit,
                     static_cast<double>(hit.ray.tfar), out)) {
    out = nothing();
  }
  return true;
}

void Tracer::trace(const abut_ray& any_ray, const abut_query_filter* filter, abut_pick& out) const {
  abut_ray ray{any_ray.origin, normalized(any_ray.direction), any_ray.max_distance};
  double skipped = 0;
  if (!trim(ray, skipped)) [[unlikely]] {
    out = nothing();
    return;
  }
  bool is_hit = false;
  Entrance entrance{};
  if (!baked_.empty() && enter(still_space_, ray.origin, ray.direction, ray.max_distance, entrance)) {
    [[clang::uninitialized]] RTCRayHit hit;
    write_ray(hit, entrance.point, ray.direction, ray.max_distance - entrance.advance);
    StillHit query(false, skips_back_faces_, filter);
    embree::intersect(single_still_.get(), query, hit);
    const double found = entrance.advance + static_cast<double>(hit.ray.tfar);
    is_hit = hit.hit.geomID != RTC_INVALID_GEOMETRY_ID &&
             resolve_still(first_half(ray), last_half(ray), ray.max_distance, hit.hit, found, out);
  }
  if (!is_hit) out = nothing();
  if (has_moving()) trace_moving(ray, filter, out);
  out.distance += skipped;
}

// Looks for something nearer than `out` holds.
void Tracer::trace_moving(const abut_ray& ray, const abut_query_filter* filter, abut_pick& out) const {
  FirstHit query(*this, ray, filter);
  if (out.geometry.slot != 0) query.ray.max_distance = out.distance;
  meet_apart(filter, query.ray, out);
  bool is_exact = false;
  for (const MovingScene& moving : moving_) meet_moving(query, moving, out, is_exact);
}

// Shortens the ray to what it meets. `is_exact`: what `out` holds was met in double, in another moving scene.
void Tracer::meet_moving(FirstHit& query, const MovingScene& moving, abut_pick& out, bool& is_exact) const {
  Entrance entrance{};
  if (moving.is_empty() ||
      !enter(moving.space, query.ray.origin, query.ray.direction, query.ray.max_distance, entrance))
    return;
  query.advance = entrance.advance;
  [[clang::uninitialized]] RTCRayHit hit;
  write_ray(hit, entrance.point, query.ray.direction, query.ray.max_distance - entrance.advance);
  embree::intersect(moving.scene.get(), query, hit);
  if (hit.hit.geomID == RTC_INVALID_GEOMETRY_ID) return;
  const Entry& entry = entries_[hit.hit.geomID & ~entry_flag];
  if (entry.role == Role::instance) {
    resolve_instance(query.ray, entry, hit.hit.primID, query.advance + static_cast<double>(hit.ray.tfar), out);
    is_exact = is_exact && out.geometry.slot != entry.id.slot;
  } else {
    // Of what is equally near in double, the lower slot counts.
    const bool is_first =
        query.exact.distance < query.ray.max_distance ||
        (query.exact.distance == query.ray.max_distance && !(is_exact && out.geometry.slot < entry.id.slot));
    if (!is_first) return;
    out = pick_of(entry.id, query.exact);
    is_exact = true;
  }
  if (out.geometry.slot != 0) query.ray.max_distance = std::min(query.ray.max_distance, out.distance);
}

// Shortens the ray to what it meets.
void Tracer::meet_apart(const abut_query_filter* filter, abut_ray& ray, abut_pick& out) const {
  for (const std::uint32_t index : apart_) {
    const Entry& entry = entries_[index];
    if (!admits(filter, entry)) continue;
    const auto hit = cast_seen(entry, ray);
    if (!hit || !(hit->distance < out.distance)) continue;
    out = pick_of(entry.id, *hit);
    ray.max_distance = hit->distance;
  }
}

void Tracer::resolve_instance(const abut_ray& ray, const Entry& entry, std::uint32_t triangle, double found,
                              abut_pick& out) const {
  const ShapeRecord& shape = shapes_[entry.shape];
  const Instanced& instanced = *shape.instanced;
  const Facet& plane = instanced.surface[triangle];
  const abut_ray local{to_local(entry.frame, ray.origin), rotate_back(entry.frame, ray.direction), 0};
  const double distance =
      distance_to(numbers_of(plane), first_half(local), last_half(local), found, instanced.space.extent);
  if (distance > ray.max_distance) return;
  out = {.geometry = entry.id,
         .feature = {ABUT_FEATURE_FACE, shape.faces.empty() ? triangle : shape.faces[triangle]},
         .child = 0,
         .reserved = 0,
         .distance = distance,
         .point = add(ray.origin, scale(ray.direction, distance)),
         .normal = rotate(entry.frame, plane.normal)};
}

}  // namespace abut::picking
