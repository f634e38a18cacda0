// SPDX-License-Identifier: Apache-2.0
// What Embree calls back: rays against the boxes of the moving scenes.
module;

#include <abut/picking.h>

#include "core/check.hpp"
#include "picking/embree.hpp"

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

// Rejects the hits on surfaces of the still scene that the filter leaves out, or that are seen from behind.
void reject_hits(const RTCFilterFunctionNArguments* arguments) {
  const auto& self = *static_cast<const Tracer*>(arguments->geometryUserPtr);
  const auto& trace = static_cast<const Trace&>(static_cast<const embree::Query&>(*arguments->context));
  // SAFETY: Embree hands over N flags, and as many hits.
  ABUT_UNSAFE_BEGIN
  for (unsigned i = 0; i < arguments->N; ++i) {
    if (arguments->valid[i] == 0) continue;
    const Baked& baked = self.baked_[RTCHitN_geomID(arguments->hit, arguments->N, i)];
    if (!admits(trace.wanted.get(), self.entries_[baked.entry]) || self.is_behind(baked, *arguments, i))
      arguments->valid[i] = 0;
  }
  ABUT_UNSAFE_END
}

StillHit::StillHit(bool are_neighbours, bool skips_back_faces, const abut_query_filter* given) noexcept
    : Trace(are_neighbours, false, given) {
  if (given != nullptr || skips_back_faces) filter_hits(reject_hits);
}

void Tracer::report_hits(const RTCIntersectFunctionNArguments* arguments) {
  const auto& moving = *static_cast<const MovingScene*>(arguments->geometryUserPtr);
  auto& trace = static_cast<Trace&>(static_cast<embree::Query&>(*arguments->context));
  const std::uint32_t entry = moving.boxes[arguments->primID].entry;
  if (entry == nowhere) return;
  if (!trace.collects) {
    auto& query = static_cast<FirstHit&>(trace);
    query.tracer->meet(query, moving, *arguments);
    return;
  }
  auto& query = static_cast<AllHits&>(trace);
  // No exception may pass through Embree.
  try {
    query.met.push_back(entry);
  } catch (const std::bad_alloc&) {
    query.out_of_memory = true;
  }
}

namespace {

// Context of a ray that sees the fronts of an instanced surface only.
struct FrontQuery : embree::Query {
  std::unique_ptr<const Instanced, Borrowed> its;
  abut_vec3 direction;
  bool is_steep;
  FrontQuery(const Instanced& instanced, const abut_vec3& along, bool is_twice) noexcept
      : embree::Query(false), its(&instanced), direction(along), is_steep(is_twice) {}
};

void reject_back(const RTCFilterFunctionNArguments* arguments) {
  const auto& query = static_cast<const FrontQuery&>(static_cast<const embree::Query&>(*arguments->context));
  const std::uint32_t triangle = RTCHitN_primID(arguments->hit, 1, 0) >> (query.is_steep ? 1u : 0u);
  if (dot(query.its->surface[triangle].normal, query.direction) > 0) *arguments->valid = 0;
}

// First hit on an instanced surface, nearer than `limit` from the origin of the ray.
struct LocalHit {
  double distance;
  std::uint32_t triangle;
};

[[nodiscard]] std::optional<LocalHit> cast_into(const Instanced& instanced, const Frame& frame, const abut_ray& ray,
                                                double limit, bool is_steep, bool skips_back_faces) {
  const abut_vec3 direction = rotate_back(frame, ray.direction);
  Entrance entrance{};
  if (!enter(instanced.space, to_local(frame, ray.origin), direction, limit, entrance)) return std::nullopt;
  RTCRayHit hit;
  write_ray(hit, entrance.point, direction, limit - entrance.advance);
  FrontQuery query(instanced, direction, is_steep);
  if (skips_back_faces) query.filter_hits(reject_back);
  embree::intersect(instanced.scene.get(), query, hit);
  if (hit.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
  return LocalHit{entrance.advance + static_cast<double>(hit.ray.tfar), hit.hit.primID >> (is_steep ? 1u : 0u)};
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
void Tracer::meet(FirstHit& query, const MovingScene& moving, const RTCIntersectFunctionNArguments& arguments) const {
  const std::uint32_t index = moving.boxes[arguments.primID].entry;
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
    const auto hit = cast_into(*shape.instanced, entry.frame, query.ray, nearest, shape.is_steep, skips_back_faces_);
    if (!hit || !(hit->distance < nearest)) return;
    far = static_cast<float>(hit->distance - query.advance);
    RTCHitN_primID(met, 1, 0) = hit->triangle;
  } else {
    // The limit is blurred by single precision: equal distances must stay in the race.
    const double blurred = limit + 0x1p-20 * (limit + moving.space.extent);
    const abut_ray ray{query.ray.origin, query.ray.direction, std::min(query.ray.max_distance, blurred)};
    const auto hit = cast_seen(entry, ray);
    if (!hit || !is_nearer(*hit, entry, query, present, limit)) return;
    query.exact = *hit;
    // Not below what single precision tells apart here: 0 would hide boxes that begin where the ray does.
    far = std::min(far, static_cast<float>(std::max(hit->distance - query.advance, 0x1p-24 * moving.space.extent)));
    RTCHitN_primID(met, 1, 0) = hit->feature.index;
  }
  RTCHitN_geomID(met, 1, 0) = entry_flag | index;
}

// Whether a ray meets a geometry with a box. What is met within the limit in single precision is looked at in double.
bool Tracer::meets_entry(const Entry& entry, const abut_ray& ray) const {
  if (entry.role != Role::instance) return cast_seen(entry, ray).has_value();
  const ShapeRecord& shape = shapes_[entry.shape];
  const auto hit = cast_into(*shape.instanced, entry.frame, ray, ray.max_distance, shape.is_steep, skips_back_faces_);
  if (!hit) return false;
  abut_pick pick = nothing();
  resolve_instance(ray, entry, hit->triangle, hit->distance, pick);
  return pick.geometry.slot != 0;
}

}  // namespace abut::picking
