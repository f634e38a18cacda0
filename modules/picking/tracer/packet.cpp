// SPDX-License-Identifier: Apache-2.0
// Rays in packets.
module;

#include <abut/picking.h>

#include "core/check.hpp"
#include "picking/embree.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

module abut.picking;
import :camera;
import :entry;
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

using FourFloats = float __attribute__((ext_vector_type(4)));

// Planes up to this number stay in the processor's own caches: waiting for them takes no time, while a
// second batch would take a part of the first level.
constexpr std::size_t planes_in_cache = 16384;

template <std::size_t Width>
using Doubles = std::array<Four, Width / 4>;

// What a packet needs from one call of Embree to the next; kept, so that constants are written once.
template <std::size_t Width>
struct alignas(64) Batch {
  typename NativePacket<Width>::Type native;
  alignas(64) std::array<int, Width> valid;   // -1 for a ray, 0 for none
  alignas(64) std::array<int, Width> active;  // the rays that reach the space being traced
  Doubles<Width> ox, oy, oz, dx, dy, dz, limit, advance;
  bool advances;   // whether some float ray does not start where its ray does
  bool is_traced;  // in the still scene

  Batch() noexcept;
  // Sets four directions of any length.
  inline void point_along(std::size_t k, Four x, Four y, Four z) noexcept;
  // Sets where the rays start in a space. False when none reaches it.
  [[nodiscard]] bool write(const Space& space) noexcept;
  void write_far(const Space& space) noexcept;
  // What ray i hit in the still scene.
  [[nodiscard]] inline std::uint32_t triangle(const Baked& baked, std::size_t i) const noexcept;
  [[nodiscard]] abut_ray ray(std::size_t i) const noexcept {
    const std::size_t k = i / 4;
    const std::size_t j = i % 4;
    return {{ox[k][j], oy[k][j], oz[k][j]}, {dx[k][j], dy[k][j], dz[k][j]}, limit[k][j]};
  }
};

// SAFETY: every index into the arrays of the packet, here and below, is less than Width, their size.
ABUT_UNSAFE_BEGIN

// Four numbers of a packet.
template <std::size_t Width>
[[gnu::always_inline]] inline void put(float (&out)[Width], std::size_t k, const Four& values) {
  const FourFloats floats = __builtin_convertvector(values, FourFloats);
  for (std::size_t j = 0; j < 4; ++j) out[4 * k + j] = floats[j];
}

template <std::size_t Width>
Batch<Width>::Batch() noexcept : native{}, valid{}, active{}, advances(false), is_traced(false) {
  for (std::size_t i = 0; i < Width; ++i) {
    native.ray.mask[i] = ~0u;
    native.ray.id[i] = static_cast<unsigned>(i);
    native.hit.instID[0][i] = RTC_INVALID_GEOMETRY_ID;
    valid[i] = -1;
  }
  for (std::size_t k = 0; k < Width / 4; ++k) {
    ox[k] = oy[k] = oz[k] = dx[k] = dy[k] = limit[k] = advance[k] = Four(0);
    dz[k] = Four(1);
  }
}

template <std::size_t Width>
[[gnu::always_inline]] inline std::uint32_t Batch<Width>::triangle(const Baked& baked, std::size_t i) const noexcept {
  return triangle_of(baked, native.hit.primID[i], native.hit.u[i], native.hit.v[i]);
}

// As `normalized` does, for four at once.
template <std::size_t Width>
[[gnu::always_inline]] inline void Batch<Width>::point_along(std::size_t k, Four x, Four y, Four z) noexcept {
  Four square = x * x + y * y + z * z;
  Four factor = 1.5 - 0.5 * square;
  if (!(__builtin_reduce_max(__builtin_elementwise_abs(square - 1.0)) < nearly_unit)) {
    for (std::size_t j = 0; j < 4; ++j) {
      if (square[j] > 1e-200 && square[j] < 1e200) [[likely]]
        continue;
      const abut_vec3 unit = normalized({x[j], y[j], z[j]});
      x[j] = unit.x;
      y[j] = unit.y;
      z[j] = unit.z;
      square[j] = 1;
    }
    factor = 1.0 / __builtin_elementwise_sqrt(square);
  }
  dx[k] = x * factor;
  dy[k] = y * factor;
  dz[k] = z * factor;
  put(native.ray.dir_x, k, dx[k]);
  put(native.ray.dir_y, k, dy[k]);
  put(native.ray.dir_z, k, dz[k]);
}

template <std::size_t Width>
bool Batch<Width>::write(const Space& space) noexcept {
  Four farthest = 0;
  for (std::size_t k = 0; k < Width / 4; ++k) {
    const Four x = ox[k] - space.origin.x;
    const Four y = oy[k] - space.origin.y;
    const Four z = oz[k] - space.origin.z;
    farthest = __builtin_elementwise_max(farthest, __builtin_elementwise_abs(x));
    farthest = __builtin_elementwise_max(farthest, __builtin_elementwise_abs(y));
    farthest = __builtin_elementwise_max(farthest, __builtin_elementwise_abs(z));
    put(native.ray.org_x, k, x);
    put(native.ray.org_y, k, y);
    put(native.ray.org_z, k, z);
    put(native.ray.tfar, k, limit[k] * (1 + 0x1p-22));
  }
  for (std::size_t i = 0; i < Width; ++i) native.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
  active = valid;
  advances = !(__builtin_reduce_max(farthest) <= 2 * space.extent);
  if (advances) write_far(space);
  return !advances || std::ranges::any_of(active, [](int flag) { return flag != 0; });
}

// Rays that start far outside of the space begin where they enter it.
template <std::size_t Width>
void Batch<Width>::write_far(const Space& space) noexcept {
  for (std::size_t i = 0; i < Width; ++i) {
    const abut_ray from = ray(i);
    Entrance entrance{};
    if (!enter(space, from.origin, from.direction, from.max_distance, entrance)) {
      active[i] = 0;
      entrance.advance = 0;
    }
    advance[i / 4][i % 4] = entrance.advance;
    native.ray.org_x[i] = static_cast<float>(entrance.point.x);
    native.ray.org_y[i] = static_cast<float>(entrance.point.y);
    native.ray.org_z[i] = static_cast<float>(entrance.point.z);
    native.ray.tfar[i] = widened(from.max_distance - entrance.advance);
  }
}

// The hits of four rays of the still scene, computed on their planes. Lanes without a hit hold the
// plane 0, whose distance is not a number.
template <std::size_t Width, class Place>
[[gnu::always_inline]] inline void PacketTracer::resolve_four(const Tracer& tracer, const Batch<Width>& batch,
                                                              std::size_t k, const Place& place) {
  const auto& native = batch.native;
  std::array<abut_geometry_id, 4> geometries{};
  std::array<std::uint32_t, 4> faces{};
  const auto row = [&](std::size_t j) __attribute__((always_inline)) {
    const std::uint32_t geometry = native.hit.geomID[4 * k + j];
    if (geometry == RTC_INVALID_GEOMETRY_ID) return Four(0);
    const Baked& baked = tracer.baked_[geometry];
    geometries[j] = baked.id;
    const std::uint32_t triangle = batch.triangle(baked, 4 * k + j);
    faces[j] = tracer.face_of(baked, triangle);
    return numbers_of(tracer.plane_of(baked, triangle));
  };
  const FourRows rows{row(0), row(1), row(2), row(3)};
  const FourRows planes = transposed(rows);
  const abut_vec3& origin = tracer.still_space_.origin;
  const Four height = planes.d - (planes.a * (batch.ox[k] - origin.x) + planes.b * (batch.oy[k] - origin.y) +
                                  planes.c * (batch.oz[k] - origin.z));
  const Four slope = planes.a * batch.dx[k] + planes.b * batch.dy[k] + planes.c * batch.dz[k];
  const Four exact = height / slope;
  Four found = __builtin_convertvector((FourFloats{native.ray.tfar[4 * k], native.ray.tfar[4 * k + 1],
                                                   native.ray.tfar[4 * k + 2], native.ray.tfar[4 * k + 3]}),
                                       Four);
  if (batch.advances) found += batch.advance[k];
  const Four correction = __builtin_elementwise_abs(exact - found);
  const Four nearest = correction <= largest_correction * tracer.still_space_.extent ? exact : found;
  const Four distance = __builtin_elementwise_max(nearest, Four(0));
  const FourRows ends = transposed({distance, batch.ox[k] + distance * batch.dx[k],
                                    batch.oy[k] + distance * batch.dy[k], batch.oz[k] + distance * batch.dz[k]});
  const auto write = [&](std::size_t j, const Four& end, const Four& plane) __attribute__((always_inline)) {
    const std::size_t i = 4 * k + j;
    if (batch.valid[i] == 0) return;
    abut_pick& out = place(i);
    if (geometries[j].slot == 0 || end[0] > batch.limit[k][j]) {
      out = nothing();
      return;
    }
    out.geometry = geometries[j];
    out.feature = {ABUT_FEATURE_FACE, faces[j]};
    out.child = 0;
    out.reserved = 0;
    out.distance = end[0];
    out.point = {end[1], end[2], end[3]};
    out.normal = {plane[0], plane[1], plane[2]};
  };
  write(0, ends.a, rows.a);
  write(1, ends.b, rows.b);
  write(2, ends.c, rows.c);
  write(3, ends.d, rows.d);
}

// Rays through the still scene.
template <std::size_t Width>
[[gnu::always_inline]] inline void PacketTracer::shoot(const Tracer& tracer, embree::Query& query,
                                                       Batch<Width>& batch) {
  batch.is_traced = !tracer.baked_.empty() && batch.write(tracer.still_space_);
  if (batch.is_traced) embree::intersect(tracer.still_.get(), query, batch.active.data(), batch.native);
}

// Asks for the memory of the picks, which comes while the packet is under way.
template <std::size_t Width, class Place>
[[gnu::always_inline]] inline void PacketTracer::prefetch_picks(const Batch<Width>& batch, const Place& place) {
  for (std::size_t i = 0; i < Width; ++i) {
    if (batch.valid[i] != 0) __builtin_prefetch(&place(i), 1);
  }
}

// Asks for the planes of the hits, which come while the next packet is under way.
template <std::size_t Width>
[[gnu::always_inline]] inline void PacketTracer::prefetch_planes(const Tracer& tracer, const Batch<Width>& batch) {
  if (!batch.is_traced) return;
  for (std::size_t i = 0; i < Width; ++i) {
    const std::uint32_t geometry = batch.native.hit.geomID[i];
    if (geometry == RTC_INVALID_GEOMETRY_ID) continue;
    const Baked& baked = tracer.baked_[geometry];
    __builtin_prefetch(&tracer.plane_of(baked, batch.triangle(baked, i)));
  }
}

// From what the still scene answered to picks. `place(i)` is where the pick of ray i goes.
template <std::size_t Width, class Place>
void PacketTracer::finish(const Tracer& tracer, const Trace& query, Batch<Width>& batch, const Place& place) {
  if (batch.is_traced) {
    for (std::size_t k = 0; k < Width / 4; ++k) resolve_four(tracer, batch, k, place);
  } else {
    for (std::size_t i = 0; i < Width; ++i) {
      if (batch.valid[i] != 0) place(i) = nothing();
    }
  }
  if (tracer.has_moving()) [[unlikely]]
    trace_moving(tracer, query, batch, place);
}

// Traces packets that `fill(batch, n)` makes from what `expect(n)` asked for; `place(n)` tells where the
// pick of ray i of packet n goes. Memory is read and written while Embree computes.
template <std::size_t Width, class Expect, class Fill, class Place>
void PacketTracer::trace(const Tracer& tracer, Trace& query, std::size_t count, const Expect& expect, const Fill& fill,
                         const Place& place) {
  std::array<Batch<Width>, 2> batches;
  const bool waits = tracer.still_planes_.size() > planes_in_cache;
  for (std::size_t n = 0; n < count; ++n) {
    Batch<Width>& batch = batches[waits ? n % 2 : 0];
    fill(batch, n);
    if (n + 1 < count) expect(n + 1);
    prefetch_picks(batch, place(n));
    shoot(tracer, query, batch);
    if (waits) prefetch_planes(tracer, batch);
    if (waits && n == 0) continue;
    const std::size_t done = waits ? n - 1 : n;
    finish(tracer, query, batches[waits ? done % 2 : 0], place(done));
  }
  if (!waits || count == 0) return;
  finish(tracer, query, batches[(count - 1) % 2], place(count - 1));
}

// Looks for something nearer than what was found in the still scene. One by one: Embree calls back for each box that a
// packet meets, and a packet meets more boxes than each of its rays.
template <std::size_t Width, class Place>
[[gnu::noinline]] void PacketTracer::trace_moving(const Tracer& tracer, const Trace& query, const Batch<Width>& batch,
                                                  const Place& place) {
  for (std::size_t i = 0; i < Width; ++i) {
    if (batch.valid[i] != 0) tracer.trace_moving(batch.ray(i), query.wanted.get(), place(i));
  }
}

ABUT_UNSAFE_END

// Rays to registers, four at a time.
template <std::size_t Width>
[[gnu::always_inline]] inline void PacketTracer::read(Batch<Width>& batch, std::span<const abut_ray, Width> rays) {
  for (std::size_t k = 0; k < Width / 4; ++k) {
    const std::span<const abut_ray, 4> four = rays.subspan(4 * k).template first<4>();
    const FourRows from =
        transposed({first_half(four[0]), first_half(four[1]), first_half(four[2]), first_half(four[3])});
    const FourRows along = transposed({last_half(four[0]), last_half(four[1]), last_half(four[2]), last_half(four[3])});
    batch.ox[k] = from.a;
    batch.oy[k] = from.b;
    batch.oz[k] = from.c;
    batch.limit[k] = along.d;
    batch.point_along(k, along.a, along.b, along.c);
  }
}

// The first of some rays.
template <std::size_t Width>
[[gnu::always_inline]] inline void PacketTracer::load(Batch<Width>& batch, std::span<const abut_ray> rays) {
  if (rays.size() >= Width) [[likely]] {
    read(batch, rays.template first<Width>());
    return;
  }
  // Its last ray fills up the last packet, without being traced again.
  std::array<abut_ray, Width> padded;
  padded.fill(rays.back());
  std::ranges::copy(rays, padded.begin());
  read<Width>(batch, padded);
  for (std::size_t i = rays.size(); i < Width; ++i) batch.valid[i] = 0;
}

template <std::size_t Width>
void PacketTracer::trace_batch(const Tracer& tracer, std::span<const abut_ray> rays, Trace& query,
                               std::span<abut_pick> out) {
  const auto fill = [&](Batch<Width>& batch, std::size_t n) { load(batch, rays.subspan(n * Width)); };
  const auto expect = [&](std::size_t n) {
    for (const abut_ray& ray : rays.subspan(n * Width, std::min(Width, rays.size() - n * Width)))
      __builtin_prefetch(&ray);
  };
  trace<Width>(tracer, query, (rays.size() + Width - 1) / Width, expect, fill, [&](std::size_t n) {
    return [out, first = n * Width](std::size_t i) -> abut_pick& { return out[first + i]; };
  });
}

// Tiles of four by Width / 4 pixels: their rays stay together longer than those of a row.
template <std::size_t Width>
void PacketTracer::render(const Tracer& tracer, const abut_camera& camera, Trace& query, std::span<abut_pick> out) {
  constexpr std::size_t across = 4;
  constexpr std::size_t down = Width / across;
  const View view = view_of(camera);
  const std::size_t width = camera.width;
  const std::size_t height = camera.height;
  const std::size_t columns = (width + across - 1) / across;
  const std::size_t rows = (height + down - 1) / down;
  std::vector<Four> rights(columns);
  for (std::size_t i = 0; i < columns; ++i) {
    const Four x = Four{0.5, 1.5, 2.5, 3.5} + static_cast<double>(i * across);
    rights[i] = view.aspect * (x - view.centre_x) / view.focal;
  }
  std::vector<double> ups(rows * down);
  for (std::size_t i = 0; i < ups.size(); ++i) ups[i] = (view.centre_y - (static_cast<double>(i) + 0.5)) / view.focal;
  const auto fill = [&](Batch<Width>& batch, std::size_t n) {
    const std::size_t top = n / columns * down;
    const std::size_t left = n % columns * across;
    for (std::size_t k = 0; k < down; ++k) {
      const Four& right = rights[n % columns];
      const double up = ups[top + k];
      const Four across_x = view.right.x * right + (view.up.x * up);
      const Four across_y = view.right.y * right + (view.up.y * up);
      const Four across_z = view.right.z * right + (view.up.z * up);
      Four start = view.start;
      batch.limit[k] = Four(view.limit);
      if (view.is_parallel) {
        batch.point_along(k, Four(view.forward.x), Four(view.forward.y), Four(view.forward.z));
        batch.ox[k] = view.eye.x + across_x + start * batch.dx[k];
        batch.oy[k] = view.eye.y + across_y + start * batch.dy[k];
        batch.oz[k] = view.eye.z + across_z + start * batch.dz[k];
        continue;
      }
      batch.point_along(k, across_x + view.forward.x, across_y + view.forward.y, across_z + view.forward.z);
      if (view.has_planes) {
        const Four stretch = __builtin_elementwise_sqrt(right * right + (up * up + 1));
        start *= stretch;
        batch.limit[k] *= stretch;
      }
      batch.ox[k] = view.eye.x + start * batch.dx[k];
      batch.oy[k] = view.eye.y + start * batch.dy[k];
      batch.oz[k] = view.eye.z + start * batch.dz[k];
    }
    for (std::size_t i = 0; i < Width; ++i)
      batch.valid[i] = left + i % across < width && top + i / across < height ? -1 : 0;
  };
  const auto expect = [](std::size_t /*n*/) {};
  trace<Width>(tracer, query, columns * rows, expect, fill, [&](std::size_t n) {
    return [out, width, first = n / columns * down * width + n % columns * across](std::size_t i) -> abut_pick& {
      return out[first + i / across * width + i % across];
    };
  });
}

// Any hits. Only what Embree is not sure about is traced again.
template <std::size_t Width>
void PacketTracer::meet_batch(const Tracer& tracer, std::span<const abut_ray> rays, AnyHit& query,
                              std::span<std::uint32_t> out) {
  Batch<Width> batch;
  const bool has_moving = tracer.has_moving();
  for (std::size_t first = 0; first < rays.size(); first += Width) {
    load(batch, rays.subspan(first));
    query.unsure = 0;
    const bool is_traced = batch.write(tracer.still_space_);
    if (is_traced) {
      for (std::size_t i = 0; i < Width; ++i) {
        const double limit = batch.limit[i / 4][i % 4] - batch.advance[i / 4][i % 4];
        query.sure_until[i] = static_cast<float>(limit - largest_correction * tracer.still_space_.extent);
      }
      embree::occlude(tracer.still_.get(), query, batch.active.data(), batch.native.ray);
    }
    for (std::size_t i = 0; i < std::min(Width, rays.size() - first); ++i) {
      // SAFETY: i is less than Width, the size of the packet.
      ABUT_UNSAFE_BEGIN
      bool is_met = is_traced && batch.active[i] != 0 && batch.native.ray.tfar[i] < 0;
      ABUT_UNSAFE_END
      if (!is_met && ((query.unsure >> i & 1u) != 0 || has_moving))
        is_met = tracer.meets(rays[first + i], query.wanted.get());
      out[first + i] = is_met ? 1 : 0;
    }
  }
}

void Tracer::trace_each(std::span<const abut_ray> rays, const abut_query_filter* filter,
                        std::span<abut_pick> out) const {
  for (std::size_t i = 0; i < rays.size(); ++i) trace(rays[i], filter, out[i]);
}

// Where triangles are small in the picture, sixteen rays in a row share less than eight do.
void Tracer::trace_neighbours(std::span<const abut_ray> rays, const abut_query_filter* filter,
                              std::span<abut_pick> out) const {
  if (baked_.empty() || !clip_planes_.empty()) {
    trace_each(rays, filter, out);
    return;
  }
  StillHit query(true, skips_back_faces_, filter);
  switch (still_planes_.size() > planes_in_cache ? std::min<std::size_t>(widest_, 8) : widest_) {
    case 16: PacketTracer::trace_batch<16>(*this, rays, query, out); return;
    case 8: PacketTracer::trace_batch<8>(*this, rays, query, out); return;
    default: PacketTracer::trace_batch<4>(*this, rays, query, out); return;
  }
}

// Unrelated rays part at the first boxes: wide packets do not pay for them.
void Tracer::trace_unrelated(std::span<const abut_ray> rays, const abut_query_filter* filter,
                             std::span<abut_pick> out) const {
  if (baked_.empty() || !clip_planes_.empty()) {
    trace_each(rays, filter, out);
    return;
  }
  StillHit query(false, skips_back_faces_, filter);
  if (widest_ >= 8) {
    PacketTracer::trace_batch<8>(*this, rays, query, out);
  } else {
    PacketTracer::trace_batch<4>(*this, rays, query, out);
  }
}

void Tracer::meet_neighbours(std::span<const abut_ray> rays, const abut_query_filter* filter,
                             std::span<std::uint32_t> out) const {
  if (baked_.empty() || !clip_planes_.empty()) {
    meet_each(rays, filter, out);
    return;
  }
  const bool has_limits = std::ranges::any_of(rays, [](const abut_ray& ray) { return ray.max_distance < infinity; });
  AnyHit query(true, has_limits || asks_about_hits(filter), filter);
  if (widest_ >= 8) {
    PacketTracer::meet_batch<8>(*this, rays, query, out);
  } else {
    PacketTracer::meet_batch<4>(*this, rays, query, out);
  }
}

void Tracer::render(const abut_camera& camera, const abut_query_filter* filter, std::span<abut_pick> out) const {
  if (!clip_planes_.empty()) {
    const View view = view_of(camera);
    for (std::size_t i = 0; i < out.size(); ++i) {
      const std::size_t x = i % camera.width;
      const std::size_t y = i / camera.width;
      trace(ray_through(view, static_cast<double>(x) + 0.5, static_cast<double>(y) + 0.5), filter, out[i]);
    }
    return;
  }
  StillHit query(true, skips_back_faces_, filter);
  switch (widest_) {
    case 16: PacketTracer::render<16>(*this, camera, query, out); return;
    case 8: PacketTracer::render<8>(*this, camera, query, out); return;
    default: PacketTracer::render<4>(*this, camera, query, out); return;
  }
}

}  // namespace abut::picking
