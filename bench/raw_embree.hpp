// SPDX-License-Identifier: Apache-2.0
// Embree as its manual uses it, to compare with.
#ifndef ABUT_BENCH_RAW_EMBREE_HPP
#define ABUT_BENCH_RAW_EMBREE_HPP

#include <abut/abut.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "mesh_files.hpp"

namespace abut_bench {

using Mesh = bench::TriangleMesh;

[[nodiscard]] std::pair<abut_vec3, abut_vec3> bounds_of(const Mesh& mesh);

/// Rays in Embree's layout, one by one or in packets of 8 or 16.
class Packing {
 public:
  Packing(std::span<const abut_ray> rays, std::size_t width);
  ~Packing();
  Packing(const Packing&) = delete;
  Packing& operator=(const Packing&) = delete;

 private:
  friend class RawScene;
  struct Rays;
  std::unique_ptr<Rays> rays_;
};

/// One mesh in one Embree scene.
class RawScene {
 public:
  RawScene(const Mesh& mesh, bool robust);
  ~RawScene();
  RawScene(const RawScene&) = delete;
  RawScene& operator=(const RawScene&) = delete;

  /// Resets and traces all rays once.
  void trace(Packing& packing, bool coherent) const;

 private:
  struct Scene;
  std::unique_ptr<Scene> scene_;
};

}  // namespace abut_bench

#endif
