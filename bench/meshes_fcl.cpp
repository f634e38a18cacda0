// SPDX-License-Identifier: Apache-2.0
#include "meshes_fcl.hpp"

#include <fcl/fcl.h>

#include <cstddef>
#include <limits>
#include <memory>
#include <vector>

#include "fcl_shapes.hpp"

namespace bench {
namespace {

[[nodiscard]] fcl::CollisionRequestd all_contacts() { return {std::numeric_limits<std::size_t>::max(), true}; }

}  // namespace

struct FclMesh::Model {
  fcl::BVHModel<fcl::OBBRSSd> model;
};

FclMesh::FclMesh(const TriangleMesh& mesh) : model_(std::make_unique<Model>()) {
  std::vector<Eigen::Vector3d> vertices;
  for (std::size_t i = 0; i < mesh.xyz.size(); i += 3) {
    vertices.emplace_back(mesh.xyz[i], mesh.xyz[i + 1], mesh.xyz[i + 2]);
  }
  std::vector<fcl::Triangle> triangles;
  for (std::size_t i = 0; i < mesh.triangles.size(); i += 3) {
    triangles.emplace_back(mesh.triangles[i], mesh.triangles[i + 1], mesh.triangles[i + 2]);
  }
  model_->model.beginModel();
  model_->model.addSubModel(vertices, triangles);
  model_->model.endModel();
}
FclMesh::~FclMesh() = default;

std::size_t FclMesh::contacts(const Placement& here, const FclMesh& other, const Placement& there) const {
  fcl::CollisionResultd result;
  return fcl::collide(&model_->model, fcl_transform(here), &other.model_->model, fcl_transform(there), all_contacts(),
                      result);
}

std::size_t FclMesh::contacts_below(double height) const {
  const fcl::Halfspaced below(0, 0, 1, height);
  fcl::CollisionResultd result;
  return fcl::collide(&model_->model, FclTransform(FclTransform::Identity()), &below,
                      FclTransform(FclTransform::Identity()), all_contacts(), result);
}

}  // namespace bench
