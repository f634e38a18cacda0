// Rays in packets.
module;

#include <abut/picking.h>

#include "core/check.hpp"
#include "embree.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>

module abut.picking;
import :camera;
import :hit;
import :source;
import :surface;
import :tracer;
import :vector;

namespace abut::picking {

template <std::size_t Width>
struct NativePacket;
template <>
struct NativePacket<4> {
  using Type = RTCRayHit4;
};
template <>
struct NativePacket<8> {
  using Type = RTCRayHit8;
};
template <>
struct NativePacket<16> {
  using Type = RTCRayHit16;
};

template <std::size_t Width>
using Doubles = std::array<double, Width>;

// What a packet needs from one call of Embree to the next; kept, so that constants are written once.
template <std::size_t Width>
struct alignas(64) Batch {
  typename NativePacket<Width>::Type native;
  std::array<int, Width> valid;   // -1 for a ray, 0 for none
  std::array<int, Width> active;  // the rays that reach the space being traced
  Doubles<Width> ox, oy, oz, dx, dy, dz, limit, advance;
  bool coherent;

  explicit Batch(bool are_neighbours) noexcept;
  void normalize() noexcept;
  // False when no ray reaches the space.
  [[nodiscard]] bool write(const Space& space) noexcept;
  [[nodiscard]] abut_ray ray(std::size_t i) const noexcept {
    return {{ox[i], oy[i], oz[i]}, {dx[i], dy[i], dz[i]}, limit[i]};
  }
};

// SAFETY: every index into the arrays of the packet, here and below, is less than Width, their size.
ABUT_UNSAFE_BEGIN

template <std::size_t Width>
Batch<Width>::Batch(bool are_neighbours) noexcept : native{}, valid{}, active{}, coherent(are_neighbours) {
  for (std::size_t i = 0; i < Width; ++i) {
    native.ray.mask[i] = ~0U;
    native.ray.id[i] = static_cast<unsigned>(i);
    native.hit.instID[0][i] = RTC_INVALID_GEOMETRY_ID;
    valid[i] = -1;
    ox[i] = oy[i] = oz[i] = limit[i] = advance[i] = 0;
    dx[i] = dy[i] = 0;
    dz[i] = 1;
  }
}

template <std::size_t Width>
void Batch<Width>::normalize() noexcept {
  [[clang::uninitialized]] Doubles<Width> square;
  double worst = 0;
  double least = infinity;
  double most = 0;
  for (std::size_t i = 0; i < Width; ++i) {
    square[i] = dx[i] * dx[i] + dy[i] * dy[i] + dz[i] * dz[i];
    worst = std::max(worst, std::fabs(square[i] - 1));
    least = std::min(least, square[i]);
    most = std::max(most, square[i]);
  }
  // As `normalized` does, for all at once.
  if (worst < 1e-8) {
    for (std::size_t i = 0; i < Width; ++i) square[i] = 1.5 - 0.5 * square[i];
  } else if (least > 1e-200 && most < 1e200) {
    for (std::size_t i = 0; i < Width; ++i) square[i] = 1 / std::sqrt(square[i]);
  } else {
    for (std::size_t i = 0; i < Width; ++i) {
      const abut_vec3 unit = normalized({dx[i], dy[i], dz[i]});
      dx[i] = unit.x;
      dy[i] = unit.y;
      dz[i] = unit.z;
    }
    return;
  }
  for (std::size_t i = 0; i < Width; ++i) {
    dx[i] *= square[i];
    dy[i] *= square[i];
    dz[i] *= square[i];
  }
}

template <std::size_t Width>
bool Batch<Width>::write(const Space& space) noexcept {
  double farthest = 0;
  for (std::size_t i = 0; i < Width; ++i) {
    const double x = ox[i] - space.origin.x;
    const double y = oy[i] - space.origin.y;
    const double z = oz[i] - space.origin.z;
    farthest = std::max({farthest, std::fabs(x), std::fabs(y), std::fabs(z)});
    native.ray.org_x[i] = static_cast<float>(x);
    native.ray.org_y[i] = static_cast<float>(y);
    native.ray.org_z[i] = static_cast<float>(z);
    native.ray.dir_x[i] = static_cast<float>(dx[i]);
    native.ray.dir_y[i] = static_cast<float>(dy[i]);
    native.ray.dir_z[i] = static_cast<float>(dz[i]);
    native.ray.tfar[i] = widened(limit[i]);
    native.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
    advance[i] = 0;
  }
  active = valid;
  if (farthest <= 2 * space.extent) return true;
  bool any = false;
  for (std::size_t i = 0; i < Width; ++i) {
    Entrance entrance{};
    if (!enter(space, {ox[i], oy[i], oz[i]}, {dx[i], dy[i], dz[i]}, limit[i], entrance)) {
      active[i] = 0;
      continue;
    }
    any = any || active[i] != 0;
    advance[i] = entrance.advance;
    native.ray.org_x[i] = static_cast<float>(entrance.point.x);
    native.ray.org_y[i] = static_cast<float>(entrance.point.y);
    native.ray.org_z[i] = static_cast<float>(entrance.point.z);
    native.ray.tfar[i] = widened(limit[i] - entrance.advance);
  }
  return any;
}

// Traces the rays of the batch. `place(i)` is where the pick of ray i goes.
template <std::size_t Width, class Place>
void PacketTracer::trace(const Tracer& tracer, Batch<Width>& batch, const Place& place) {
  auto& native = batch.native;
  const bool still = !tracer.baked_.empty() && batch.write(tracer.still_space_);
  if (still) {
    embree::Query query(batch.coherent);
    embree::intersect(tracer.still_.get(), query, batch.active.data(), native);
  }
  for (std::size_t i = 0; i < Width; ++i) {
    if (batch.valid[i] == 0) continue;
    abut_pick& out = place(i);
    out = nothing();
    if (!still || native.hit.geomID[i] == RTC_INVALID_GEOMETRY_ID) continue;
    const double found = batch.advance[i] + static_cast<double>(native.ray.tfar[i]);
    tracer.resolve_still(batch.ray(i), native.hit.geomID[i], native.hit.primID[i], found, out);
  }
  if (tracer.has_moving()) trace_moving(tracer, batch, place);
}

// Looks for something nearer than what was found in the still scene.
template <std::size_t Width, class Place>
void PacketTracer::trace_moving(const Tracer& tracer, Batch<Width>& batch, const Place& place) {
  FirstHit<Width> query(batch.coherent);
  for (std::size_t i = 0; i < Width; ++i) {
    if (batch.valid[i] == 0) continue;
    abut_pick& out = place(i);
    Lane& lane = query.lanes[i];
    lane.ray = batch.ray(i);
    if (out.geometry.slot != 0) lane.ray.max_distance = out.distance;
    tracer.meet_endless(lane.ray, out);
    batch.limit[i] = lane.ray.max_distance;
  }
  if (tracer.moving_.empty() || !batch.write(tracer.moving_space_)) return;
  for (std::size_t i = 0; i < Width; ++i) query.lanes[i].advance = batch.advance[i];
  auto& native = batch.native;
  embree::intersect(tracer.moving_scene_.get(), query, batch.active.data(), native);
  for (std::size_t i = 0; i < Width; ++i) {
    if (batch.valid[i] == 0 || native.hit.geomID[i] == RTC_INVALID_GEOMETRY_ID) continue;
    const double found = batch.advance[i] + static_cast<double>(native.ray.tfar[i]);
    tracer.resolve_entry(query.lanes[i], native.hit.geomID[i], native.hit.primID[i], found, place(i));
  }
}

ABUT_UNSAFE_END

template <std::size_t Width>
void PacketTracer::trace_batch(const Tracer& tracer, std::span<const abut_ray> rays, bool coherent, std::span<abut_pick> out) {
  Batch<Width> batch(coherent);
  for (std::size_t first = 0; first < rays.size(); first += Width) {
    const std::size_t count = std::min(Width, rays.size() - first);
    const std::span<const abut_ray> some = rays.subspan(first, count);
    const std::span<abut_pick> picks = out.subspan(first, count);
    for (std::size_t i = 0; i < count; ++i) {
      const abut_ray& ray = some[i];
      batch.ox[i] = ray.origin.x;
      batch.oy[i] = ray.origin.y;
      batch.oz[i] = ray.origin.z;
      batch.dx[i] = ray.direction.x;
      batch.dy[i] = ray.direction.y;
      batch.dz[i] = ray.direction.z;
      batch.limit[i] = ray.max_distance;
    }
    for (std::size_t i = count; i < Width; ++i) batch.valid[i] = 0;
    batch.normalize();
    trace(tracer, batch, [&](std::size_t i) -> abut_pick& { return picks[i]; });
  }
}

// Tiles of four by Width / 4 pixels: their rays stay together longer than those of a row.
template <std::size_t Width>
void PacketTracer::render(const Tracer& tracer, const abut_camera& camera, std::span<abut_pick> out) {
  constexpr std::size_t across = 4;
  constexpr std::size_t down = Width / across;
  const View view = view_of(camera);
  const std::size_t width = camera.width;
  const std::size_t height = camera.height;
  Batch<Width> batch(true);
  for (std::size_t top = 0; top < height; top += down) {
    for (std::size_t left = 0; left < width; left += across) {
      for (std::size_t i = 0; i < Width; ++i) {
        const std::size_t x = left + i % across;
        const std::size_t y = top + i / across;
        const abut_vec3 direction = direction_through(view, static_cast<double>(x) + 0.5, static_cast<double>(y) + 0.5);
        batch.dx[i] = direction.x;
        batch.dy[i] = direction.y;
        batch.dz[i] = direction.z;
        batch.valid[i] = x < width && y < height ? -1 : 0;
      }
      batch.normalize();
      for (std::size_t i = 0; i < Width; ++i) {
        batch.ox[i] = view.eye.x + view.start * batch.dx[i];
        batch.oy[i] = view.eye.y + view.start * batch.dy[i];
        batch.oz[i] = view.eye.z + view.start * batch.dz[i];
        batch.limit[i] = view.limit;
      }
      trace(tracer, batch,
            [&](std::size_t i) -> abut_pick& { return out[(top + i / across) * width + left + i % across]; });
    }
  }
}

void Tracer::trace_neighbours(std::span<const abut_ray> rays, std::span<abut_pick> out) const {
  switch (widest_) {
    case 16: PacketTracer::trace_batch<16>(*this, rays, true, out); return;
    case 8: PacketTracer::trace_batch<8>(*this, rays, true, out); return;
    default: PacketTracer::trace_batch<4>(*this, rays, true, out); return;
  }
}

// Unrelated rays part at the first boxes: wide packets do not pay for them.
void Tracer::trace_unrelated(std::span<const abut_ray> rays, std::span<abut_pick> out) const {
  if (widest_ >= 8) {
    PacketTracer::trace_batch<8>(*this, rays, false, out);
  } else {
    PacketTracer::trace_batch<4>(*this, rays, false, out);
  }
}

void Tracer::render(const abut_camera& camera, std::span<abut_pick> out) const {
  switch (widest_) {
    case 16: PacketTracer::render<16>(*this, camera, out); return;
    case 8: PacketTracer::render<8>(*this, camera, out); return;
    default: PacketTracer::render<4>(*this, camera, out); return;
  }
}

}  // namespace abut::picking
