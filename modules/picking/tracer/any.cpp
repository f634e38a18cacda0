// SPDX-License-Identifier: Apache-2.0
// Whether rays meet anything: the first hit that is found ends the search.
module;

#include <abut/picking.h>

#include "core/check.hpp"
#include "picking/embree.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

module abut.picking;
import :entry;
import :hit;
import :source;
import :surface;
import :tracer;
import :vector;

namespace abut::picking {

AnyHit::AnyHit(bool are_neighbours, bool asks, const abut_query_filter* given) noexcept
    : Trace(are_neighbours, false, given), sure_until{} {
  if (asks) filter_hits(reject_any);
}

// As reject_hits. A hit close to the limit may lie beyond it in double, so it does not end the search.
void reject_any(const RTCFilterFunctionNArguments* arguments) {
  auto& query = static_cast<AnyHit&>(static_cast<Trace&>(static_cast<embree::Query&>(*arguments->context)));
  reject_hits(arguments);
  // SAFETY: Embree hands over N flags, and as many rays.
  ABUT_UNSAFE_BEGIN
  for (unsigned i = 0; i < arguments->N; ++i) {
    if (arguments->valid[i] == 0) continue;
    const unsigned ray = RTCRayN_id(arguments->ray, arguments->N, i);
    if (RTCRayN_tfar(arguments->ray, arguments->N, i) <= query.sure_until[ray]) continue;
    arguments->valid[i] = 0;
    query.unsure |= 1u << ray;
  }
  ABUT_UNSAFE_END
}

bool Tracer::meets(const abut_ray& any_ray, const abut_query_filter* filter) const {
  abut_ray ray{any_ray.origin, normalized(any_ray.direction), any_ray.max_distance};
  double skipped = 0;
  if (!trim(ray, skipped)) return false;
  Entrance entrance{};
  if (!baked_.empty() && enter(still_space_, ray.origin, ray.direction, ray.max_distance, entrance)) {
    const double limit = ray.max_distance - entrance.advance;
    [[clang::uninitialized]] RTCRayHit hit;
    write_ray(hit, entrance.point, ray.direction, limit);
    AnyHit query(false, ray.max_distance < infinity || asks_about_hits(filter), filter);
    query.sure_until[0] = static_cast<float>(limit - largest_correction * still_space_.extent);
    embree::occlude(single_still_.get(), query, hit.ray);
    if (hit.ray.tfar < 0) return true;
    if (query.unsure != 0) {
      abut_pick pick;
      trace(any_ray, filter, pick);
      return pick.geometry.slot != 0;
    }
  }
  return has_moving() && meets_moving(ray, filter);
}

void Tracer::meet_each(std::span<const abut_ray> rays, const abut_query_filter* filter,
                       std::span<std::uint32_t> out) const {
  for (std::size_t i = 0; i < rays.size(); ++i) out[i] = meets(rays[i], filter) ? 1 : 0;
}

bool Tracer::meets_moving(const abut_ray& ray, const abut_query_filter* filter) const {
  const auto meets_apart = [&](std::uint32_t index) {
    return admits(filter, entries_[index]) && cast_seen(entries_[index], ray).has_value();
  };
  if (std::ranges::any_of(apart_, meets_apart)) return true;
  MovingAnyHit query(*this, ray, filter);
  for (const MovingScene& moving : moving_) {
    Entrance entrance{};
    if (moving.is_empty() || !enter(moving.space, ray.origin, ray.direction, ray.max_distance, entrance)) continue;
    [[clang::uninitialized]] RTCRayHit hit;
    write_ray(hit, entrance.point, ray.direction, ray.max_distance - entrance.advance);
    embree::occlude(moving.scene.get(), query, hit.ray);
    if (hit.ray.tfar < 0) return true;
  }
  return false;
}

void Tracer::report_any(const RTCOccludedFunctionNArguments* arguments) {
  const auto& moving = *static_cast<const MovingScene*>(arguments->geometryUserPtr);
  const auto& query = static_cast<const MovingAnyHit&>(static_cast<const embree::Query&>(*arguments->context));
  const std::uint32_t index = moving.boxes[arguments->primID].entry;
  if (index == nowhere) return;
  const Tracer& self = *query.tracer;
  const Entry& entry = self.entries_[index];
  if (admits(query.wanted.get(), entry) && self.meets_entry(entry, query.ray))
    RTCRayN_tfar(arguments->ray, 1, 0) = -std::numeric_limits<float>::infinity();
}

}  // namespace abut::picking
