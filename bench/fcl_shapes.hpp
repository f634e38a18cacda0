// SPDX-License-Identifier: Apache-2.0
// Solids and placements as FCL wants them.
#pragma once
#include <fcl/fcl.h>

#include <memory>
#include <vector>

#include "scene.hpp"

namespace bench {

using FclTransform = fcl::Transform3<double>;
using FclGeometry = fcl::CollisionGeometry<double>;

[[nodiscard]] inline FclTransform fcl_transform(const Placement& placement) {
  const auto& [w, x, y, z] = placement.orientation;
  FclTransform out = FclTransform::Identity();
  out.linear() = Eigen::Quaterniond(w, x, y, z).toRotationMatrix();
  out.translation() = Eigen::Vector3d(placement.position[0], placement.position[1], placement.position[2]);
  return out;
}

[[nodiscard]] inline std::unique_ptr<FclGeometry> fcl_geometry(const Solid& solid) {
  const Point& s = solid.sizes;
  switch (solid.kind) {
    case Kind::sphere: return std::make_unique<fcl::Sphere<double>>(s[0]);
    case Kind::box: return std::make_unique<fcl::Box<double>>(2 * s[0], 2 * s[1], 2 * s[2]);
    case Kind::capsule: return std::make_unique<fcl::Capsule<double>>(s[0], 2 * s[1]);
    case Kind::cylinder: return std::make_unique<fcl::Cylinder<double>>(s[0], 2 * s[1]);
    case Kind::cone: return std::make_unique<fcl::Cone<double>>(s[0], 2 * s[1]);
    case Kind::ellipsoid: return std::make_unique<fcl::Ellipsoid<double>>(s[0], s[1], s[2]);
    case Kind::plane: return std::make_unique<fcl::Halfspace<double>>(0, 0, 1, 0);
    case Kind::mesh:
    case Kind::solid_mesh: {
      auto mesh = std::make_unique<fcl::BVHModel<fcl::OBBRSSd>>();
      std::vector<Eigen::Vector3d> vertices;
      for (const Point& p : solid.points) {
        vertices.emplace_back(p[0], p[1], p[2]);
      }
      std::vector<fcl::Triangle> triangles;
      for (const auto& [a, b, c] : solid.triangles) {
        triangles.emplace_back(static_cast<std::size_t>(a), static_cast<std::size_t>(b), static_cast<std::size_t>(c));
      }
      mesh->beginModel();
      mesh->addSubModel(vertices, triangles);
      mesh->endModel();
      return mesh;
    }
    case Kind::height_field:
    case Kind::distance_field:
    case Kind::particles:
    case Kind::point:
    case Kind::composite: return nullptr;
    case Kind::hull32:
    case Kind::hull200:
    case Kind::hull:
    case Kind::triangle: {
      auto vertices = std::make_shared<std::vector<Eigen::Vector3d>>();
      for (const Point& p : solid.points) {
        vertices->emplace_back(p[0], p[1], p[2]);
      }
      auto faces = std::make_shared<std::vector<int>>();
      for (const auto& triangle : solid.triangles) {
        faces->insert(faces->end(), {3, triangle[0], triangle[1], triangle[2]});
      }
      // Its triangle has no distances; a hull of two faces, back to back, has.
      if (solid.kind == Kind::triangle) {
        *faces = {3, 0, 1, 2, 3, 0, 2, 1};
      }
      return std::make_unique<fcl::Convex<double>>(vertices, static_cast<int>(faces->size() / 4), faces);
    }
  }
  return nullptr;
}

}  // namespace bench
