// SPDX-License-Identifier: Apache-2.0
// Surfaces as Bullet wants them: shapes that own the arrays which Bullet only points to.
#pragma once
#include <btBulletCollisionCommon.h>

#include <BulletCollision/CollisionShapes/btHeightfieldTerrainShape.h>
#include <algorithm>
#include <memory>
#include <vector>

#include "scene.hpp"

namespace bench {

struct BulletTriangles {
  btTriangleMesh triangles;

  explicit BulletTriangles(const Solid& solid) {
    const auto corner = [&](int i) {
      const Point& p = solid.points[static_cast<std::size_t>(i)];
      return btVector3(static_cast<btScalar>(p[0]), static_cast<btScalar>(p[1]), static_cast<btScalar>(p[2]));
    };
    for (const auto& triangle : solid.triangles) {
      triangles.addTriangle(corner(triangle[0]), corner(triangle[1]), corner(triangle[2]));
    }
  }
};
class BulletMesh final : private BulletTriangles, public btBvhTriangleMeshShape {
 public:
  explicit BulletMesh(const Solid& solid) : BulletTriangles(solid), btBvhTriangleMeshShape(&triangles, true) {}
};

struct BulletHeights {
  std::vector<float> heights;
  float low, high;

  explicit BulletHeights(const Solid& solid) {
    for (const Point& p : solid.points) {
      heights.push_back(static_cast<float>(p[2]));
    }
    const auto [least, most] = std::ranges::minmax(heights);
    low = least;
    high = most;
  }
};
class BulletField final : private BulletHeights, public btHeightfieldTerrainShape {
 public:
  explicit BulletField(const Solid& solid)
      : BulletHeights(solid),
        btHeightfieldTerrainShape(static_cast<int>(solid.sizes[0]), static_cast<int>(solid.sizes[0]), heights.data(),
                                  low, high, 2, true) {
    const auto spacing = static_cast<btScalar>(solid.sizes[1]);
    setLocalScaling(btVector3(spacing, spacing, 1));
  }
  // Its origin is the middle of its box. This is where that lies from the first sample.
  [[nodiscard]] static Point middle(const Solid& solid) {
    const BulletHeights heights(solid);
    const double half = 0.5 * (solid.sizes[0] - 1) * solid.sizes[1];
    return {half, half, 0.5 * (static_cast<double>(heights.low) + static_cast<double>(heights.high))};
  }
};

}  // namespace bench
