// SPDX-License-Identifier: Apache-2.0
module;

#include <abut/picking.h>

#include "picking/embree.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <new>
#include <span>
#include <utility>
#include <vector>

module abut.picking;
import :camera;
import :entry;
import :region;
import :source;
import :tracer;
import :vector;

namespace abut::picking {

namespace {

// No exception crosses the module's interface.
template <class Action>
[[nodiscard]] abut_status guarded(const Action& action) noexcept {
  try {
    return action();
  } catch (const std::bad_alloc&) {
    return ABUT_OUT_OF_MEMORY;
  } catch (...) {
    return ABUT_INTERNAL;
  }
}

}  // namespace

void TracerDeleter::operator()(Tracer* tracer) const noexcept { std::default_delete<Tracer>()(tracer); }

Picker::Picker(std::unique_ptr<Source> source, Counters counters)
    : tracer_(std::make_unique<Tracer>(std::move(source), std::move(counters)).release()) {}

abut_status Picker::update() noexcept {
  return guarded([&] { return tracer_->follow(); });
}

bool Picker::cast_usual_ray(const abut_ray& ray, abut_pick& out) const noexcept {
  return tracer_->trace_usual(ray, out);
}

abut_status Picker::cast_ray(const abut_ray& ray, const abut_query_filter* filter, abut_pick& out) noexcept {
  return guarded([&]() -> abut_status {
    if (const abut_status status = tracer_->follow(); status != ABUT_OK) return status;
    tracer_->trace(ray, filter, out);
    return ABUT_OK;
  });
}

abut_status Picker::cast_rays(std::span<const abut_ray> rays, Coherence coherence, const abut_query_filter* filter,
                              std::span<abut_pick> out) noexcept {
  return guarded([&]() -> abut_status {
    if (const abut_status status = tracer_->follow(); status != ABUT_OK) return status;
    if (coherence == Coherence::neighbours) {
      tracer_->trace_neighbours(rays, filter, out);
    } else {
      tracer_->trace_unrelated(rays, filter, out);
    }
    return ABUT_OK;
  });
}

abut_status Picker::cast_ray_all(const abut_ray& ray, const abut_query_filter* filter,
                                 std::vector<abut_pick>& out) noexcept {
  return guarded([&]() -> abut_status {
    if (const abut_status status = tracer_->follow(); status != ABUT_OK) return status;
    return tracer_->trace_all(ray, filter, out);
  });
}

abut_status Picker::pick_pixel(const abut_camera& camera, double x, double y, double radius,
                               const abut_query_filter* filter, abut_pick& out) noexcept {
  return guarded([&]() -> abut_status {
    if (const abut_status status = tracer_->follow(); status != ABUT_OK) return status;
    return tracer_->pick_pixel({view_of(camera), x, y, radius}, filter, out);
  });
}

abut_status Picker::render(const abut_camera& camera, const abut_query_filter* filter,
                           std::span<abut_pick> out) noexcept {
  return guarded([&]() -> abut_status {
    if (const abut_status status = tracer_->follow(); status != ABUT_OK) return status;
    tracer_->render(camera, filter, out);
    return ABUT_OK;
  });
}

abut_status Picker::meets(const abut_ray& ray, const abut_query_filter* filter, std::uint32_t& out) noexcept {
  return guarded([&]() -> abut_status {
    if (const abut_status status = tracer_->follow(); status != ABUT_OK) return status;
    out = tracer_->meets(ray, filter) ? 1 : 0;
    return ABUT_OK;
  });
}

abut_status Picker::meet(std::span<const abut_ray> rays, Coherence coherence, const abut_query_filter* filter,
                         std::span<std::uint32_t> out) noexcept {
  return guarded([&]() -> abut_status {
    if (const abut_status status = tracer_->follow(); status != ABUT_OK) return status;
    if (coherence == Coherence::neighbours) {
      tracer_->meet_neighbours(rays, filter, out);
    } else {
      tracer_->meet_each(rays, filter, out);
    }
    return ABUT_OK;
  });
}

abut_status Picker::select(const abut_camera& camera, const Rectangle& rectangle, bool inside,
                           const abut_query_filter* filter, std::vector<abut_geometry_id>& out) noexcept {
  return guarded([&]() -> abut_status {
    if (const abut_status status = tracer_->follow(); status != ABUT_OK) return status;
    return tracer_->select(view_of(camera), rectangle, inside, filter, out);
  });
}

abut_status Picker::snap(const abut_camera& camera, double x, double y, double radius, abut_snap_kinds kinds,
                         const abut_query_filter* filter, abut_snap& out) noexcept {
  return guarded([&]() -> abut_status {
    if (const abut_status status = tracer_->follow(); status != ABUT_OK) return status;
    return tracer_->snap({view_of(camera), x, y, radius}, kinds, filter, out);
  });
}

abut_status Picker::weigh(abut_geometry_id id, std::uint32_t face, const abut_vec3& point,
                          abut_barycentric& out) noexcept {
  return guarded([&]() -> abut_status {
    if (const abut_status status = tracer_->follow(); status != ABUT_OK) return status;
    return tracer_->weigh(id, face, point, out);
  });
}

void Picker::set_flags(bool sees_sensors, bool skips_back_faces) noexcept {
  tracer_->set_flags(sees_sensors, skips_back_faces);
}

abut_status Picker::set_clip_planes(std::span<const abut_clip_plane> planes) noexcept {
  return guarded([&]() -> abut_status {
    std::vector<HalfSpace> kept;
    kept.reserve(planes.size());
    for (const abut_clip_plane& plane : planes) kept.push_back({normalized(plane.normal), plane.offset});
    tracer_->set_clip_planes(std::move(kept));
    return ABUT_OK;
  });
}

}  // namespace abut::picking
