// SPDX-License-Identifier: Apache-2.0
// Solids and placements as Bullet wants them.
#pragma once
#include <btBulletCollisionCommon.h>

#include <BulletCollision/CollisionShapes/btTriangleShape.h>
#include <memory>

#include "bullet_surfaces.hpp"
#include "scene.hpp"

namespace bench {

[[nodiscard]] inline btScalar to_bullet(double value) { return static_cast<btScalar>(value); }
[[nodiscard]] inline btVector3 to_bullet(const Point& p) { return {to_bullet(p[0]), to_bullet(p[1]), to_bullet(p[2])}; }

[[nodiscard]] inline btTransform bullet_transform(const Placement& placement) {
  const auto& q = placement.orientation;
  return btTransform(btQuaternion(to_bullet(q[1]), to_bullet(q[2]), to_bullet(q[3]), to_bullet(q[0])),
                     to_bullet(placement.position));
}

// A negative margin keeps Bullet's own. Null for what Bullet has not.
[[nodiscard]] inline std::unique_ptr<btCollisionShape> bullet_shape(const Solid& solid, double margin) {
  const auto with_margin = [&](auto shape) {
    if (margin >= 0) {
      shape->setMargin(to_bullet(margin));
    }
    return shape;
  };
  switch (solid.kind) {
    case Kind::sphere: return std::make_unique<btSphereShape>(to_bullet(solid.sizes[0]));
    case Kind::box: return with_margin(std::make_unique<btBoxShape>(to_bullet(solid.sizes)));
    case Kind::capsule:
      return std::make_unique<btCapsuleShapeZ>(to_bullet(solid.sizes[0]), to_bullet(2 * solid.sizes[1]));
    case Kind::cylinder: {
      const auto radius = to_bullet(solid.sizes[0]);
      return with_margin(std::make_unique<btCylinderShapeZ>(btVector3(radius, radius, to_bullet(solid.sizes[1]))));
    }
    case Kind::cone:
      return with_margin(std::make_unique<btConeShapeZ>(to_bullet(solid.sizes[0]), to_bullet(2 * solid.sizes[1])));
    case Kind::ellipsoid:
    case Kind::solid_mesh:
    case Kind::distance_field:
    case Kind::particles:
    case Kind::point:
    case Kind::composite: return nullptr;
    case Kind::mesh: return with_margin(std::make_unique<BulletMesh>(solid));
    case Kind::height_field: return with_margin(std::make_unique<BulletField>(solid));
    case Kind::triangle:
      return with_margin(std::make_unique<btTriangleShape>(to_bullet(solid.points[0]), to_bullet(solid.points[1]),
                                                           to_bullet(solid.points[2])));
    case Kind::plane: return with_margin(std::make_unique<btStaticPlaneShape>(btVector3(0, 0, 1), to_bullet(0)));
    case Kind::hull32:
    case Kind::hull200:
    case Kind::hull: {
      auto hull = with_margin(std::make_unique<btConvexHullShape>());
      for (const Point& p : solid.points) {
        hull->addPoint(to_bullet(p), false);
      }
      hull->recalcLocalAabb();
      return hull;
    }
  }
  return nullptr;
}

}  // namespace bench
