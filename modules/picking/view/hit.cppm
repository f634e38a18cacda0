// SPDX-License-Identifier: Apache-2.0
// From what Embree found in single precision to hits in double.
module;

#include <abut/picking.h>

#include "picking/embree.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

module abut.picking:hit;
import :source;
import :surface;
import :tracer;
import :vector;

namespace abut::picking {

// Two crossings of neighbouring triangles, in parts of the extent: outlines overlap by twice their
// growth, which a slope stretches.
inline constexpr double crossing_blur = 0x1p-17;

// A limit that no rounding makes smaller.
[[nodiscard]] inline float widened(double limit) { return static_cast<float>(limit * (1 + 0x1p-22)); }

// The three lines of a ray, each written at once: Embree reads them so, and a line that was written
// in pieces would have to reach the cache first.
struct RayLines {
  using Floats = float __attribute__((ext_vector_type(4)));
  using Numbers = std::uint32_t __attribute__((ext_vector_type(4)));
  Floats origin_and_near;
  Floats direction_and_time;
  Numbers far_mask_id_flags;
};
static_assert(sizeof(RayLines) == sizeof(RTCRay));

// A ray in two registers: where it starts, and its direction followed by its limit.
inline void write_ray(RTCRayHit& hit, const Four& point, const Four& direction_and_limit) {
  using Floats = RayLines::Floats;
  const Floats from = __builtin_convertvector(point, Floats);
  const Floats along = __builtin_convertvector((direction_and_limit * Four{1, 1, 1, 1 + 0x1p-22}), Floats);
  constexpr Floats none = {0, 0, 0, 0};
  hit.ray = std::bit_cast<RTCRay>(RayLines{__builtin_shufflevector(from, none, 0, 1, 2, 4),
                                           __builtin_shufflevector(along, none, 0, 1, 2, 4),
                                           {std::bit_cast<std::uint32_t>(static_cast<float>(along[3])), ~0u, 0, 0}});
  hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  hit.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
}

inline void write_ray(RTCRayHit& hit, const abut_vec3& point, const abut_vec3& direction, double limit) {
  write_ray(hit, Four{point.x, point.y, point.z, 0}, Four{direction.x, direction.y, direction.z, limit});
}

// Sorts crossings by distance and reports those of neighbouring triangles at their edge once.
void merge_crossings(std::vector<AllHits::Crossing>& crossings, const abut_vec3& direction,
                     std::vector<abut_pick>& out);

}  // namespace abut::picking
