// SPDX-License-Identifier: Apache-2.0
module;

#include <abut/picking.h>

#include "picking/embree.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <new>
#include <span>
#include <utility>
#include <vector>

module abut.picking;
import :box_scene;
import :hit;
import :vector;

namespace abut::picking {

namespace {

// Boxes are widened by this part of the extent: rays start within 3 * sqrt(3) extents, and the rounding of their
// points, 2^-24 each, and of the slab test stay below it.
constexpr double widening = 0x1p-20;

[[nodiscard]] float rounded_down(double value) {
  const float nearest = static_cast<float>(value);
  return static_cast<double>(nearest) <= value ? nearest
                                               : std::nextafter(nearest, -std::numeric_limits<float>::infinity());
}

[[nodiscard]] float rounded_up(double value) { return -rounded_down(-value); }

struct BoxQuery : embree::Query {
  std::vector<std::uint32_t> found;
  bool out_of_memory = false;
  BoxQuery() noexcept : embree::Query(false) {}
};

void report_box_bounds(const RTCBoundsFunctionArguments* arguments) {
  const auto& scene = *static_cast<const BoxScene*>(arguments->geometryUserPtr);
  write_bounds(scene.boxes[arguments->primID], *arguments->bounds_o);
}

// Runs inside Embree, through which no exception may pass.
void note_box(const RTCIntersectFunctionNArguments* arguments) {
  auto& query = static_cast<BoxQuery&>(static_cast<embree::Query&>(*arguments->context));
  try {
    query.found.push_back(arguments->primID);
  } catch (const std::bad_alloc&) {
    query.out_of_memory = true;
  }
}

}  // namespace

FloatBox widened_box(const abut_aabb& box, const Space& space) {
  const double margin = widening * space.extent;
  const abut_vec3 low = subtract(box.minimum, space.origin);
  const abut_vec3 high = subtract(box.maximum, space.origin);
  return {.lower = {rounded_down(low.x - margin), rounded_down(low.y - margin), rounded_down(low.z - margin)},
          .upper = {rounded_up(high.x + margin), rounded_up(high.y + margin), rounded_up(high.z + margin)}};
}

std::unique_ptr<BoxScene> make_box_scene(RTCDevice device, const Space& space, std::span<const abut_aabb> boxes) {
  auto made = std::make_unique<BoxScene>();
  made->space = space;
  made->boxes.reserve(boxes.size());
  for (const abut_aabb& box : boxes) made->boxes.push_back(widened_box(box, space));
  made->geometry = embree::Geometry(rtcNewGeometry(device, RTC_GEOMETRY_TYPE_USER));
  made->scene = embree::Scene(rtcNewScene(device));
  if (!made->geometry || !made->scene) return nullptr;
  rtcSetGeometryUserData(made->geometry.get(), made.get());
  rtcSetGeometryUserPrimitiveCount(made->geometry.get(), static_cast<unsigned>(boxes.size()));
  rtcSetGeometryBoundsFunction(made->geometry.get(), report_box_bounds, nullptr);
  rtcSetGeometryIntersectFunction(made->geometry.get(), note_box);
  rtcCommitGeometry(made->geometry.get());
  rtcAttachGeometryByID(made->scene.get(), made->geometry.get(), 0);
  rtcCommitScene(made->scene.get());
  return made;
}

bool boxes_on_ray(const BoxScene& scene, const Entrance& entrance, const abut_vec3& direction, double limit,
                  std::vector<std::uint32_t>& out) {
  BoxQuery query;
  RTCRayHit hit;
  write_ray(hit, entrance.point, direction, limit - entrance.advance);
  embree::intersect(scene.scene.get(), query, hit);
  out = std::move(query.found);
  return !query.out_of_memory;
}

}  // namespace abut::picking
