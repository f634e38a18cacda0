// One ray.
module;

#include <abut/picking.h>

#include "embree.hpp"

#include <cstddef>
#include <cstdint>
#include <span>

module abut.picking;
import :hit;
import :source;
import :surface;
import :tracer;
import :vector;

namespace abut::picking {

void Tracer::trace(const abut_ray& ray, abut_pick& out) const {
  const abut_ray unit{ray.origin, normalized(ray.direction), ray.max_distance};
  [[clang::uninitialized]] RTCRayHit hit;
  Entrance entrance{};
  if (!baked_.empty() && enter(still_space_, unit.origin, unit.direction, unit.max_distance, entrance)) {
    write_ray(hit, entrance.point, unit.direction, unit.max_distance - entrance.advance);
    embree::Query query(false);
    embree::intersect(still_.get(), query, hit);
  } else {
    hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  }
  out = nothing();
  if (hit.hit.geomID != RTC_INVALID_GEOMETRY_ID) {
    const double found = entrance.advance + static_cast<double>(hit.ray.tfar);
    resolve_still(unit, hit.hit.geomID, hit.hit.primID, found, out);
  }
  if (has_moving()) trace_moving(unit, out);
}

// Looks for something nearer than `out` holds.
void Tracer::trace_moving(const abut_ray& ray, abut_pick& out) const {
  FirstHit<1> query(false);
  Lane& lane = query.lanes[0];
  lane.ray = ray;
  if (out.geometry.slot != 0) lane.ray.max_distance = out.distance;
  meet_endless(lane.ray, out);
  Entrance entrance{};
  if (moving_.empty() || !enter(moving_space_, ray.origin, ray.direction, lane.ray.max_distance, entrance)) return;
  lane.advance = entrance.advance;
  [[clang::uninitialized]] RTCRayHit hit;
  write_ray(hit, entrance.point, ray.direction, lane.ray.max_distance - entrance.advance);
  embree::intersect(moving_scene_.get(), query, hit);
  if (hit.hit.geomID == RTC_INVALID_GEOMETRY_ID) return;
  const double found = lane.advance + static_cast<double>(hit.ray.tfar);
  resolve_entry(lane, hit.hit.geomID, hit.hit.primID, found, out);
}

// Shortens the ray to what it meets.
void Tracer::meet_endless(abut_ray& ray, abut_pick& out) const {
  for (const std::uint32_t index : endless_) {
    const Entry& entry = entries_[index];
    const auto hit = shapes_[entry.shape].access->cast(entry.pose, ray);
    if (!hit || !(hit->distance < out.distance)) continue;
    out = {entry.id, hit->feature, hit->distance, hit->point, hit->normal};
    ray.max_distance = hit->distance;
  }
}

void Tracer::resolve_still(const abut_ray& ray, std::uint32_t geometry, std::uint32_t triangle, double found,
                           abut_pick& out) const {
  const Baked& baked = baked_[geometry];
  const Plane& plane = baked.surface[triangle];
  const double distance = distance_to(plane, subtract(ray.origin, still_space_.origin), ray.direction, found, still_space_.extent);
  if (distance > ray.max_distance) return;
  out = {.geometry = baked.id,
         .feature = {ABUT_FEATURE_FACE, triangle},
         .distance = distance,
         .point = add(ray.origin, scale(ray.direction, distance)),
         .normal = plane.normal};
}

void Tracer::resolve_entry(const Lane& lane, std::uint32_t geometry, std::uint32_t triangle, double found,
                           abut_pick& out) const {
  const Entry& entry = entries_[geometry & ~entry_flag];
  if (entry.role != Role::instance) {
    const abut_ray_hit& hit = lane.exact;
    if (hit.distance <= lane.ray.max_distance) out = {entry.id, hit.feature, hit.distance, hit.point, hit.normal};
    return;
  }
  const Instanced& instanced = *shapes_[entry.shape].instanced;
  const Plane& plane = instanced.surface[triangle];
  const double distance = distance_to(plane, to_local(entry.frame, lane.ray.origin), rotate_back(entry.frame, lane.ray.direction),
                                      found, instanced.space.extent);
  if (distance > lane.ray.max_distance) return;
  out = {.geometry = entry.id,
         .feature = {ABUT_FEATURE_FACE, triangle},
         .distance = distance,
         .point = add(lane.ray.origin, scale(lane.ray.direction, distance)),
         .normal = rotate(entry.frame, plane.normal)};
}

}  // namespace abut::picking
