// SPDX-License-Identifier: Apache-2.0
// What Embree calls back: rays against the boxes of the moving scene, and crossings to collect.
module;

#include <abut/picking.h>

#include "core/check.hpp"
#include "embree.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <new>
#include <optional>
#include <vector>

module abut.picking;
import :entry;
import :hit;
import :source;
import :surface;
import :tracer;
import :vector;

namespace abut::picking {

AllHits::AllHits(const abut_ray& unit_ray, const abut_query_filter* given) noexcept
    : Trace(false, true, given), ray(unit_ray), local_ray(unit_ray) {}

// Rejects the hits on surfaces of the still scene that the filter leaves out.
void reject_hits(const RTCFilterFunctionNArguments* arguments) {
  const auto& self = *static_cast<const Tracer*>(arguments->geometryUserPtr);
  const auto& trace = static_cast<const Trace&>(static_cast<const embree::Query&>(*arguments->context));
  // SAFETY: Embree hands over N flags, and as many hits.
  ABUT_UNSAFE_BEGIN
  for (unsigned i = 0; i < arguments->N; ++i) {
    if (arguments->valid[i] == 0) continue;
    const Baked& baked = self.baked_[RTCHitN_geomID(arguments->hit, arguments->N, i)];
    if (!admits(trace.wanted.get(), self.entries_[baked.entry])) arguments->valid[i] = 0;
  }
  ABUT_UNSAFE_END
}

StillHit::StillHit(bool are_neighbours, const abut_query_filter* given) noexcept : Trace(are_neighbours, false, given) {
  if (given != nullptr) filter_hits(reject_hits);
}

void Tracer::report_hits(const RTCIntersectFunctionNArguments* arguments) {
  const auto& self = *static_cast<const Tracer*>(arguments->geometryUserPtr);
  auto& trace = static_cast<Trace&>(static_cast<embree::Query&>(*arguments->context));
  if (trace.collects) {
    self.meet_all(static_cast<AllHits&>(trace), self.moving_[arguments->primID].entry);
  } else {
    self.meet(static_cast<FirstHit&>(trace), *arguments);
  }
}

namespace {

// First hit on an instanced surface, nearer than `limit` from the origin of the ray.
struct LocalHit {
  double distance;
  std::uint32_t triangle;
};

[[nodiscard]] std::optional<LocalHit> cast_into(const Instanced& instanced, const Frame& frame, const abut_ray& ray,
                                                double limit) {
  const abut_vec3 direction = rotate_back(frame, ray.direction);
  Entrance entrance{};
  if (!enter(instanced.space, to_local(frame, ray.origin), direction, limit, entrance)) return std::nullopt;
  RTCRayHit hit;
  write_ray(hit, entrance.point, direction, limit - entrance.advance);
  embree::Query query(false);
  embree::intersect(instanced.scene.get(), query, hit);
  if (hit.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
  return LocalHit{entrance.advance + static_cast<double>(hit.ray.tfar), hit.hit.primID};
}

}  // namespace

// Whether a hit in double is nearer than the present one: exactly where that is in double, too, and ties go to the
// lower slot; in single precision where that is on a surface.
bool Tracer::is_nearer(const abut_ray_hit& hit, const Entry& entry, const FirstHit& query, std::uint32_t present,
                       double limit) const {
  if (present == RTC_INVALID_GEOMETRY_ID) return true;
  const Entry& other = entries_[present & ~entry_flag];
  if (other.role != Role::exact) return hit.distance < limit;
  if (hit.distance != query.exact.distance) return hit.distance < query.exact.distance;
  return entry.id.slot < other.id.slot;
}

// One ray against one geometry whose box it meets.
void Tracer::meet(FirstHit& query, const RTCIntersectFunctionNArguments& arguments) const {
  const std::uint32_t index = moving_[arguments.primID].entry;
  const Entry& entry = entries_[index];
  if (!admits(query.wanted.get(), entry)) return;
  const ShapeRecord& shape = shapes_[entry.shape];
  float& far = RTCRayN_tfar(RTCRayHitN_RayN(arguments.rayhit, 1), 1, 0);
  RTCHitN* const met = RTCRayHitN_HitN(arguments.rayhit, 1);
  const std::uint32_t present = RTCHitN_geomID(met, 1, 0);
  const double limit = query.advance + static_cast<double>(far);
  if (entry.role == Role::instance) {
    // What was hit in double may be nearer than single precision tells.
    const bool is_exact = present != RTC_INVALID_GEOMETRY_ID && entries_[present & ~entry_flag].role == Role::exact;
    const double nearest = is_exact ? std::min(limit, query.exact.distance) : limit;
    const auto hit = cast_into(*shape.instanced, entry.frame, query.ray, nearest);
    if (!hit || !(hit->distance < nearest)) return;
    far = static_cast<float>(hit->distance - query.advance);
    RTCHitN_primID(met, 1, 0) = hit->triangle;
  } else {
    // The limit is blurred by single precision: equal distances must stay in the race.
    const double blurred = limit + 0x1p-20 * (limit + moving_space_.extent);
    const abut_ray ray{query.ray.origin, query.ray.direction, std::min(query.ray.max_distance, blurred)};
    const auto hit = shape.access->cast(entry.pose, ray);
    if (!hit || !is_nearer(*hit, entry, query, present, limit)) return;
    query.exact = *hit;
    // Not below what single precision tells apart here: 0 would hide boxes that begin where the ray does.
    far = std::min(far, static_cast<float>(std::max(hit->distance - query.advance, 0x1p-24 * moving_space_.extent)));
    RTCHitN_primID(met, 1, 0) = hit->feature.index;
  }
  RTCHitN_geomID(met, 1, 0) = entry_flag | index;
}

// ---- everything along a ray ----------------------------------------------------------------------

bool Tracer::trace_all(const abut_ray& ray, const abut_query_filter* filter, std::vector<abut_pick>& out) const {
  const abut_ray unit{ray.origin, normalized(ray.direction), ray.max_distance};
  AllHits query(unit, filter);
  Entrance entrance{};
  if (!baked_.empty() && enter(still_space_, unit.origin, unit.direction, unit.max_distance, entrance)) {
    query.extent = still_space_.extent;
    collect(still_.get(), query, entrance, unit.direction);
  }
  for (const std::uint32_t index : apart_) meet_all(query, index);
  if (!moving_.empty() && enter(moving_space_, unit.origin, unit.direction, unit.max_distance, entrance)) {
    RTCRayHit hit;
    write_ray(hit, entrance.point, unit.direction, unit.max_distance - entrance.advance);
    embree::intersect(moving_scene_.get(), query, hit);
  }
  if (query.out_of_memory) return false;
  merge_crossings(query.crossings, unit.direction, out);
  return true;
}

// Runs inside Embree, through which no exception may pass.
void Tracer::meet_all(AllHits& query, std::uint32_t index) const {
  const Entry& entry = entries_[index];
  if (!admits(query.wanted.get(), entry)) return;
  const ShapeRecord& shape = shapes_[entry.shape];
  try {
    if (entry.role == Role::instance) {
      cross_surface(query, index, *shape.instanced);
    } else {
      cross_exact(query, entry, shape);
    }
  } catch (const std::bad_alloc&) {
    query.out_of_memory = true;
  }
}

void Tracer::cross_surface(AllHits& query, std::uint32_t index, const Instanced& instanced) const {
  const Frame& frame = entries_[index].frame;
  AllHits local(query.ray, nullptr);
  local.local_ray = {to_local(frame, query.ray.origin), rotate_back(frame, query.ray.direction),
                     query.ray.max_distance};
  local.entry = index;
  local.extent = instanced.space.extent;
  Entrance entrance{};
  if (!enter(instanced.space, local.local_ray.origin, local.local_ray.direction, query.ray.max_distance, entrance))
    return;
  collect(instanced.scene.get(), local, entrance, local.local_ray.direction);
  query.out_of_memory = query.out_of_memory || local.out_of_memory;
  query.crossings.insert(query.crossings.end(), local.crossings.begin(), local.crossings.end());
}

void Tracer::collect(RTCScene scene, AllHits& query, const Entrance& entrance, const abut_vec3& direction) {
  RTCRayHit hit;
  write_ray(hit, entrance.point, direction, query.ray.max_distance - entrance.advance);
  query.advance = entrance.advance;
  query.filter_hits(collect_hit);
  embree::intersect(scene, query, hit);
  query.filter_hits(nullptr);
}

// Notes a hit and rejects it, so that Embree goes on behind it.
void Tracer::collect_hit(const RTCFilterFunctionNArguments* arguments) {
  const auto& self = *static_cast<const Tracer*>(arguments->geometryUserPtr);
  auto& query = static_cast<AllHits&>(static_cast<Trace&>(static_cast<embree::Query&>(*arguments->context)));
  *arguments->valid = 0;
  const double found = query.advance + static_cast<double>(RTCRayN_tfar(arguments->ray, 1, 0));
  abut_pick pick = nothing();
  if (query.entry == nowhere) {
    const RTCHit hit = rtcGetHitFromHitN(arguments->hit, 1, 0);
    if (!admits(query.wanted.get(), self.entries_[self.baked_[hit.geomID].entry])) return;
    (void)self.resolve_still(first_half(query.ray), last_half(query.ray), query.ray.max_distance, hit, found, pick);
  } else {
    self.resolve_instance(query.ray, self.entries_[query.entry], RTCHitN_primID(arguments->hit, 1, 0), found, pick);
  }
  if (pick.geometry.slot == 0) return;
  try {
    query.crossings.push_back({pick, crossing_blur * query.extent});
  } catch (const std::bad_alloc&) {
    query.out_of_memory = true;
  }
}

// Crossing after crossing: each ray starts behind the crossing before, by more than that may be off. A crossing of the
// same side within the blur is the same one; there the next ray starts further behind, so that this ends also for a ray
// that runs along a surface.
void Tracer::cross_exact(AllHits& query, const Entry& entry, const ShapeRecord& shape) const {
  constexpr double least_step = 0x1p-44;
  constexpr double blur = 0x1p-38;
  const abut_ray& ray = query.ray;
  const double coordinates = largest_component(ray.origin) + largest_component(entry.pose.position);
  double start = 0;
  double step = least_step;
  double last = -infinity;
  bool entered = false;
  while (start <= ray.max_distance) {
    const abut_ray rest{add(ray.origin, scale(ray.direction, start)), ray.direction, ray.max_distance - start};
    auto hit = shape.access->cast(entry.pose, rest);
    if (!hit) return;
    hit->distance += start;
    const double size = coordinates + hit->distance;
    const bool enters = dot(hit->normal, ray.direction) < 0;
    const bool repeats = enters == entered && hit->distance - last <= blur * size;
    if (!repeats) query.crossings.push_back({.pick = pick_of(entry.id, *hit), .blur = 0});
    step = repeats ? 2 * step : least_step;
    last = hit->distance;
    entered = enters;
    start = hit->distance + step * size;
  }
}

}  // namespace abut::picking
