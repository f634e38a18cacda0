// SPDX-License-Identifier: Apache-2.0
#include "raw_embree.hpp"

#include "picking/embree.hpp"

#include <abut/abut.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace abut_bench {

namespace embree = abut::picking::embree;

namespace {

constexpr float endless = std::numeric_limits<float>::infinity();

template <class Native, std::size_t Width>
std::vector<Native> packed(std::span<const abut_ray> rays) {
  std::vector<Native> out(rays.size() / Width);
  for (std::size_t i = 0; i < out.size() * Width; ++i) {
    auto& ray = out[i / Width].ray;
    const std::size_t k = i % Width;
    std::span(ray.org_x)[k] = static_cast<float>(rays[i].origin.x);
    std::span(ray.org_y)[k] = static_cast<float>(rays[i].origin.y);
    std::span(ray.org_z)[k] = static_cast<float>(rays[i].origin.z);
    std::span(ray.dir_x)[k] = static_cast<float>(rays[i].direction.x);
    std::span(ray.dir_y)[k] = static_cast<float>(rays[i].direction.y);
    std::span(ray.dir_z)[k] = static_cast<float>(rays[i].direction.z);
    std::span(ray.tnear)[k] = 0;
    std::span(ray.time)[k] = 0;
    std::span(ray.mask)[k] = ~0U;
    std::span(ray.id)[k] = 0;
    std::span(ray.flags)[k] = 0;
  }
  return out;
}

std::vector<RTCRayHit> singles(std::span<const abut_ray> rays) {
  std::vector<RTCRayHit> out(rays.size());
  for (std::size_t i = 0; i < out.size(); ++i) {
    RTCRay& ray = out[i].ray;
    ray = {};
    ray.org_x = static_cast<float>(rays[i].origin.x);
    ray.org_y = static_cast<float>(rays[i].origin.y);
    ray.org_z = static_cast<float>(rays[i].origin.z);
    ray.dir_x = static_cast<float>(rays[i].direction.x);
    ray.dir_y = static_cast<float>(rays[i].direction.y);
    ray.dir_z = static_cast<float>(rays[i].direction.z);
    ray.mask = ~0U;
  }
  return out;
}

template <std::size_t Width, class Native>
void trace_packets(RTCScene scene, std::vector<Native>& packets, bool coherent) {
  alignas(64) std::array<int, Width> valid;
  valid.fill(-1);
  embree::Query query(coherent);
  for (Native& packet : packets) {
    for (std::size_t k = 0; k < Width; ++k) {
      std::span(packet.ray.tfar)[k] = endless;
      std::span(packet.hit.geomID)[k] = RTC_INVALID_GEOMETRY_ID;
      std::span(packet.hit.instID[0])[k] = RTC_INVALID_GEOMETRY_ID;
    }
    embree::intersect(scene, query, valid.data(), packet);
  }
}

}  // namespace

struct Packing::Rays {
  std::vector<RTCRayHit> one;
  std::vector<RTCRayHit8> eight;
  std::vector<RTCRayHit16> sixteen;
};

Packing::Packing(std::span<const abut_ray> rays, std::size_t width) : rays_(std::make_unique<Rays>()) {
  if (width == 1) rays_->one = singles(rays);
  if (width == 8) rays_->eight = packed<RTCRayHit8, 8>(rays);
  if (width == 16) rays_->sixteen = packed<RTCRayHit16, 16>(rays);
}
Packing::~Packing() = default;

struct RawScene::Scene {
  std::vector<float> vertices;
  std::vector<std::uint32_t> triangles;
  embree::Device device;
  embree::Scene scene;
};

RawScene::RawScene(const Mesh& mesh, bool robust) : scene_(std::make_unique<Scene>()) {
  scene_->device = embree::Device(rtcNewDevice(nullptr));
  scene_->scene = embree::Scene(rtcNewScene(scene_->device.get()));
  rtcSetSceneFlags(scene_->scene.get(), robust ? RTC_SCENE_FLAG_ROBUST : RTC_SCENE_FLAG_NONE);
  const embree::Geometry geometry(rtcNewGeometry(scene_->device.get(), RTC_GEOMETRY_TYPE_TRIANGLE));
  // Embree reads the last element of a buffer as 16 bytes.
  scene_->vertices.resize(mesh.xyz.size() + 1);
  scene_->triangles.resize(mesh.triangles.size() + 1);
  std::ranges::transform(mesh.xyz, scene_->vertices.begin(), [](double x) { return static_cast<float>(x); });
  std::ranges::copy(mesh.triangles, scene_->triangles.begin());
  rtcSetSharedGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, scene_->vertices.data(), 0,
                             12, mesh.xyz.size() / 3);
  rtcSetSharedGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, scene_->triangles.data(), 0,
                             12, mesh.triangles.size() / 3);
  rtcCommitGeometry(geometry.get());
  rtcAttachGeometry(scene_->scene.get(), geometry.get());
  rtcCommitScene(scene_->scene.get());
}
RawScene::~RawScene() = default;

void RawScene::trace(Packing& packing, bool coherent) const {
  const RTCScene scene = scene_->scene.get();
  embree::Query query(coherent);
  for (RTCRayHit& ray : packing.rays_->one) {
    ray.ray.tfar = endless;
    ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    ray.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    embree::intersect(scene, query, ray);
  }
  trace_packets<8>(scene, packing.rays_->eight, coherent);
  trace_packets<16>(scene, packing.rays_->sixteen, coherent);
}

std::pair<abut_vec3, abut_vec3> bounds_of(const Mesh& mesh) {
  abut_vec3 low{mesh.xyz.at(0), mesh.xyz.at(1), mesh.xyz.at(2)};
  abut_vec3 high = low;
  for (std::size_t i = 0; i + 2 < mesh.xyz.size(); i += 3) {
    low = {std::min(low.x, mesh.xyz[i]), std::min(low.y, mesh.xyz[i + 1]), std::min(low.z, mesh.xyz[i + 2])};
    high = {std::max(high.x, mesh.xyz[i]), std::max(high.y, mesh.xyz[i + 1]), std::max(high.z, mesh.xyz[i + 2])};
  }
  return {low, high};
}

}  // namespace abut_bench
