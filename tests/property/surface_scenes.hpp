// SPDX-License-Identifier: Apache-2.0
// Seeded scenes of a surface and a convex shape or another surface, with the same shapes for the oracle.
#pragma once

#include <abut/abut.h>

#include <cstdint>
#include <string>
#include <vector>

#include "oracle/body.hpp"
#include "oracle/meeting.hpp"
#include "scenes.hpp"
#include "subject.hpp"

namespace property {

// A surface, as its triangles, or a convex body.
struct SceneShape {
  std::string kind;
  ShapePtr shape;
  oracle::Soup soup;
  oracle::Body body;
  bool is_surface = false;
  bool is_one_sided = false;
  bool is_solid = false;
  double size = 0;  // farthest extent from the local origin
};

// Triangles that lie in a grid, around a closed body or anywhere. What is dirty has triangles that are turned, missing,
// there twice, or slivers beside an edge. Half of all are rounded to float.
[[nodiscard]] SceneShape random_mesh(Random& random, abut_sides sides, double scale);
[[nodiscard]] SceneShape random_uv_grid(Random& random, abut_sides sides, double scale);
// Some with missing triangles, and with any diagonals.
[[nodiscard]] SceneShape random_height_field(Random& random, double scale);
// Closed, each triangle wound once, and declared solid.
[[nodiscard]] SceneShape random_solid(Random& random, double scale);
// "sphere", "capsule", "segment", "triangle", "box" or "hull".
[[nodiscard]] SceneShape random_body(Random& random, const std::string& kind, double scale);

[[nodiscard]] oracle::Side side_of(const SceneShape& shape, const abut_pose& pose, const oracle::Vec& origin);

struct SurfaceScene {
  std::string name;  // "deep", "sunk in", "touching", "apart"
  abut_pose a, b;
};

// b somewhere on a, both turned and moved; every second scene leaves a where it is.
[[nodiscard]] SurfaceScene place_on(const SceneShape& a, const SceneShape& b, Random& random);

}  // namespace property
