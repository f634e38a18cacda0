// SPDX-License-Identifier: Apache-2.0
module;

#include <abut/picking.h>

#include "picking/embree.hpp"

#include <cstddef>
#include <memory>
#include <new>
#include <span>
#include <utility>
#include <vector>

module abut.picking;
import :camera;
import :entry;
import :source;
import :tracer;

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

}  // namespace abut::picking
