// What Embree calls back: rays against the boxes of the moving scene, and crossings to collect.
module;

#include <abut/picking.h>

#include "core/check.hpp"
#include "embree.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <new>
#include <optional>
#include <vector>

module abut.picking;
import :hit;
import :source;
import :surface;
import :tracer;
import :vector;

namespace abut::picking {

AllHits::AllHits(const abut_ray& unit_ray) noexcept : Trace(0, false), ray(unit_ray), local_ray(unit_ray) {}

void Tracer::report_hits(const RTCIntersectFunctionNArguments* arguments) {
  const auto& self = *static_cast<const Tracer*>(arguments->geometryUserPtr);
  auto& trace = static_cast<Trace&>(static_cast<embree::Query&>(*arguments->context));
  switch (trace.width) {
    case 0:
      self.meet_all(static_cast<AllHits&>(trace), self.moving_[arguments->primID].entry);
      return;
    case 1:
      self.meet<1>(*arguments);
      return;
    case 4:
      self.meet<4>(*arguments);
      return;
    case 8:
      self.meet<8>(*arguments);
      return;
    default:
      self.meet<16>(*arguments);
      return;
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

template <std::size_t Width> void Tracer::meet(const RTCIntersectFunctionNArguments& arguments) const {
  auto& trace = static_cast<FirstHit<Width>&>(static_cast<Trace&>(static_cast<embree::Query&>(*arguments.context)));
  const std::uint32_t index = moving_[arguments.primID].entry;
  const Entry& entry = entries_[index];
  const ShapeRecord& shape = shapes_[entry.shape];
  const unsigned count = arguments.N;
  RTCRayN* const rays = RTCRayHitN_RayN(arguments.rayhit, count);
  RTCHitN* const hits = RTCRayHitN_HitN(arguments.rayhit, count);
  for (unsigned i = 0; i < count; ++i) {
    // SAFETY: Embree hands over `count` flags.
    ABUT_UNSAFE_BEGIN
    const bool is_active = arguments.valid[i] != 0;
    ABUT_UNSAFE_END
    if (!is_active) continue;
    Lane& lane = trace.lanes[RTCRayN_id(rays, count, i)];
    float& far = RTCRayN_tfar(rays, count, i);
    const double limit = lane.advance + static_cast<double>(far);
    if (entry.role == Role::instance) {
      const auto hit = cast_into(*shape.instanced, entry.frame, lane.ray, limit);
      if (!hit || !(hit->distance < limit)) continue;
      far = static_cast<float>(hit->distance - lane.advance);
      RTCHitN_primID(hits, count, i) = hit->triangle;
    } else {
      // The limit is blurred by single precision: equal distances must stay in the race.
      const abut_ray ray{lane.ray.origin, lane.ray.direction, std::min(lane.ray.max_distance, limit * (1 + 0x1p-20))};
      const auto hit = shape.access->cast(entry.pose, ray);
      if (!hit) continue;
      const std::uint32_t present = RTCHitN_geomID(hits, count, i);
      const bool against_exact =
          present != RTC_INVALID_GEOMETRY_ID && entries_[present & ~entry_flag].role == Role::exact;
      const bool is_nearer = against_exact ? hit->distance < lane.exact.distance ||
                                                 (hit->distance == lane.exact.distance &&
                                                  entry.id.slot < entries_[present & ~entry_flag].id.slot)
                                           : hit->distance < limit;
      if (!is_nearer) continue;
      lane.exact = *hit;
      far = std::min(far, static_cast<float>(hit->distance - lane.advance));
      RTCHitN_primID(hits, count, i) = hit->feature.index;
    }
    RTCHitN_geomID(hits, count, i) = entry_flag | index;
  }
}

// ---- everything along a ray ----------------------------------------------------------------------

bool Tracer::trace_all(const abut_ray& ray, std::vector<abut_pick>& out) const {
  const abut_ray unit{ray.origin, normalized(ray.direction), ray.max_distance};
  AllHits query(unit);
  Entrance entrance{};
  if (!baked_.empty() && enter(still_space_, unit.origin, unit.direction, unit.max_distance, entrance)) {
    query.extent = still_space_.extent;
    collect(still_.get(), query, entrance, unit.direction);
  }
  for (const std::uint32_t index : endless_) meet_all(query, index);
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
  const ShapeRecord& shape = shapes_[entry.shape];
  try {
    if (entry.role == Role::instance) {
      cross_surface(query, index, *shape.instanced);
    } else if (!shape.few.indices.empty()) {
      cross_few(query, entry, shape);
    } else {
      cross_rounded(query, entry, shape);
    }
  } catch (const std::bad_alloc&) {
    query.out_of_memory = true;
  }
}

void Tracer::cross_surface(AllHits& query, std::uint32_t index, const Instanced& instanced) const {
  const Frame& frame = entries_[index].frame;
  AllHits local(query.ray);
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
    (void)self.resolve_still(first_half(query.ray), last_half(query.ray), query.ray.max_distance, hit, found, pick);
  } else {
    const Lane lane{.ray = query.ray, .advance = 0, .exact = {}};
    self.resolve_entry(lane, entry_flag | query.entry, RTCHitN_primID(arguments->hit, 1, 0), found, pick);
  }
  if (pick.geometry.slot == 0) return;
  try {
    query.crossings.push_back({pick, crossing_blur * query.extent});
  } catch (const std::bad_alloc&) {
    query.out_of_memory = true;
  }
}

void Tracer::cross_few(AllHits& query, const Entry& entry, const ShapeRecord& shape) const {
  const abut_vec3 origin = to_local(entry.frame, query.ray.origin);
  const abut_vec3 direction = rotate_back(entry.frame, query.ray.direction);
  const std::vector<std::uint32_t>& indices = shape.few.indices;
  for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
    const auto distance =
        crossing_of_triangle(shape.few, {indices[i], indices[i + 1], indices[i + 2]}, origin, direction);
    if (!distance || *distance < 0 || *distance > query.ray.max_distance) continue;
    const abut_vec3 normal = normal_of_triangle(shape.few, {indices[i], indices[i + 1], indices[i + 2]});
    query.crossings.push_back({.pick = {.geometry = entry.id,
                                        .feature = {ABUT_FEATURE_FACE, static_cast<std::uint32_t>(i / 3)},
                                        .distance = *distance,
                                        .point = add(query.ray.origin, scale(query.ray.direction, *distance)),
                                        .normal = rotate(entry.frame, normal)},
                               .blur = crossing_blur * diagonal_of(entry.box)});
  }
}

// A rounded solid is crossed at most twice: where the ray meets it, and where the same line met from
// the far side does. An endless one is asked for its first crossing only.
void Tracer::cross_rounded(AllHits& query, const Entry& entry, const ShapeRecord& shape) const {
  const auto note = [&](const abut_ray_hit& hit, double distance) {
    query.crossings.push_back({.pick = {entry.id, hit.feature, distance, hit.point, hit.normal}, .blur = 0});
  };
  const abut_ray& ray = query.ray;
  const auto first = shape.access->cast(entry.pose, ray);
  if (first) note(*first, first->distance);
  if (entry.role == Role::endless) return;
  const double diagonal = diagonal_of(entry.box);
  const double beyond = dot(ray.direction, subtract(centre_of(entry.box), ray.origin)) + diagonal;
  if (beyond <= 0) return;
  const abut_ray back{add(ray.origin, scale(ray.direction, beyond)), scale(ray.direction, -1), beyond};
  const auto last = shape.access->cast(entry.pose, back);
  if (!last) return;
  const double distance = beyond - last->distance;
  // The two are one where the ray starts inside, or only touches.
  const bool is_same = first && std::fabs(distance - first->distance) <= 1e-12 * (beyond + diagonal);
  if (!is_same && distance >= 0 && distance <= ray.max_distance) note(*last, distance);
}

}  // namespace abut::picking
