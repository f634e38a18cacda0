// SPDX-License-Identifier: Apache-2.0
// Meshes in FCL, to compare with.
#pragma once
#include <cstddef>
#include <memory>

#include "mesh_files.hpp"
#include "scene.hpp"

namespace bench {

class [[gnu::visibility("default")]] FclMesh {
 public:
  // Makes its tree.
  explicit FclMesh(const TriangleMesh& mesh);
  ~FclMesh();
  FclMesh(const FclMesh&) = delete;
  FclMesh& operator=(const FclMesh&) = delete;

  // How many contacts two placed meshes have: of each two triangles that cross one or two.
  [[nodiscard]] std::size_t contacts(const Placement& here, const FclMesh& other, const Placement& there) const;
  // The same with what lies below the plane z = height.
  [[nodiscard]] std::size_t contacts_below(double height) const;

 private:
  struct Model;
  std::unique_ptr<Model> model_;
};

}  // namespace bench
