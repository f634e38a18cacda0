// SPDX-License-Identifier: Apache-2.0
// Solids and placements as ODE wants them.
#pragma once
#include <ode/ode.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <span>
#include <type_traits>
#include <vector>

#include "scene.hpp"

namespace bench {

struct DestroyGeom {
  void operator()(dGeomID geom) const { dGeomDestroy(geom); }
};
using OdeGeom = std::unique_ptr<std::remove_pointer_t<dGeomID>, DestroyGeom>;

struct DestroyTriangles {
  void operator()(dTriMeshDataID data) const { dGeomTriMeshDataDestroy(data); }
};
struct DestroyHeights {
  void operator()(dHeightfieldDataID data) const { dGeomHeightfieldDataDestroy(data); }
};

// A hull or a terrain as ODE reads it, which keeps pointers into these arrays.
struct OdeConvex {
  std::vector<dReal> planes;           // of each triangle: unit normal, offset
  std::vector<dReal> points;           // x, y, z
  std::vector<unsigned int> polygons;  // of each triangle: 3, and its corners
  std::vector<dTriIndex> triangles;    // of a mesh: three corners each
  std::unique_ptr<std::remove_pointer_t<dTriMeshDataID>, DestroyTriangles> mesh;
  std::unique_ptr<std::remove_pointer_t<dHeightfieldDataID>, DestroyHeights> field;
};

// Y leads up in a height field of ODE, whose origin is the middle of the samples. Its rows run against ours.
[[nodiscard]] inline OdeConvex ode_terrain(const Solid& solid) {
  OdeConvex terrain;
  if (solid.kind == Kind::mesh) {
    for (const Point& p : solid.points) {
      terrain.points.insert(terrain.points.end(), p.begin(), p.end());
    }
    for (const auto& triangle : solid.triangles) {
      for (const int corner : triangle) {
        terrain.triangles.push_back(static_cast<dTriIndex>(corner));
      }
    }
    terrain.mesh.reset(dGeomTriMeshDataCreate());
    dGeomTriMeshDataBuildDouble(terrain.mesh.get(), terrain.points.data(), 3 * sizeof(double),
                                static_cast<int>(solid.points.size()), terrain.triangles.data(),
                                static_cast<int>(terrain.triangles.size()), 3 * sizeof(dTriIndex));
    return terrain;
  }
  const auto side = static_cast<std::size_t>(solid.sizes[0]);
  for (std::size_t j = side; j-- > 0;) {
    for (std::size_t i = 0; i < side; ++i) {
      terrain.points.push_back(solid.points[j * side + i][2]);
    }
  }
  const double length = static_cast<double>(side - 1) * solid.sizes[1];
  terrain.field.reset(dGeomHeightfieldDataCreate());
  dGeomHeightfieldDataBuildDouble(terrain.field.get(), terrain.points.data(), 0, length, length, static_cast<int>(side),
                                  static_cast<int>(side), 1, 0, 1, 0);
  const auto [low, high] = std::ranges::minmax(terrain.points);
  dGeomHeightfieldDataSetBounds(terrain.field.get(), low, high);
  return terrain;
}

[[nodiscard]] inline OdeConvex ode_convex(const Solid& solid) {
  OdeConvex convex;
  for (const Point& p : solid.points) {
    convex.points.insert(convex.points.end(), p.begin(), p.end());
  }
  for (const auto& triangle : solid.triangles) {
    std::array<std::size_t, 3> corners{};
    std::ranges::transform(triangle, corners.begin(), [](int corner) { return static_cast<std::size_t>(corner); });
    const Point &a = solid.points[corners[0]], &b = solid.points[corners[1]], &c = solid.points[corners[2]];
    const Point u{b[0] - a[0], b[1] - a[1], b[2] - a[2]}, v{c[0] - a[0], c[1] - a[1], c[2] - a[2]};
    const Point n{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
    const double length = std::hypot(n[0], n[1], n[2]);
    convex.planes.insert(convex.planes.end(), {n[0] / length, n[1] / length, n[2] / length,
                                               (n[0] * a[0] + n[1] * a[1] + n[2] * a[2]) / length});
    convex.polygons.push_back(3);
    for (const int corner : triangle) {
      convex.polygons.push_back(static_cast<unsigned int>(corner));
    }
  }
  return convex;
}

[[nodiscard]] inline std::vector<OdeConvex> ode_convexes(std::span<const Solid> solids) {
  std::vector<OdeConvex> convexes;
  for (const Solid& solid : solids) {
    convexes.push_back(is_surface(solid.kind) ? ode_terrain(solid) : ode_convex(solid));
  }
  return convexes;
}

// A plane of ODE knows no pose: the half-space below z = 0 is moved by hand.
[[nodiscard]] inline dGeomID placed_ode_plane(const Placement& placement) {
  const auto& [w, x, y, z] = placement.orientation;
  const Point &p = placement.position, up{2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)};
  return dCreatePlane(nullptr, up[0], up[1], up[2], up[0] * p[0] + up[1] * p[1] + up[2] * p[2]);
}

[[nodiscard]] inline dGeomID unplaced_ode_geom(const Solid& solid, const OdeConvex& convex) {
  const Point& s = solid.sizes;
  switch (solid.kind) {
    case Kind::sphere: return dCreateSphere(nullptr, s[0]);
    case Kind::box: return dCreateBox(nullptr, 2 * s[0], 2 * s[1], 2 * s[2]);
    case Kind::capsule: return dCreateCapsule(nullptr, s[0], 2 * s[1]);
    case Kind::cylinder: return dCreateCylinder(nullptr, s[0], 2 * s[1]);
    case Kind::hull32:
    case Kind::hull200:
    case Kind::hull:
      return dCreateConvex(nullptr, convex.planes.data(), static_cast<unsigned int>(convex.planes.size() / 4),
                           convex.points.data(), static_cast<unsigned int>(convex.points.size() / 3),
                           convex.polygons.data());
    case Kind::mesh: return dCreateTriMesh(nullptr, convex.mesh.get(), nullptr, nullptr, nullptr);
    case Kind::height_field: return dCreateHeightfield(nullptr, convex.field.get(), 1);
    case Kind::plane:
    case Kind::cone:
    case Kind::ellipsoid:
    case Kind::triangle:
    case Kind::solid_mesh:
    case Kind::distance_field:
    case Kind::particles:
    case Kind::point:
    case Kind::composite: return nullptr;
  }
  return nullptr;
}

// The convex has to outlive the geom.
[[nodiscard]] inline OdeGeom ode_geom(const Solid& solid, const OdeConvex& convex, const Placement& placement) {
  if (solid.kind == Kind::plane) {
    return OdeGeom(placed_ode_plane(placement));
  }
  OdeGeom geom(unplaced_ode_geom(solid, convex));
  if (solid.kind == Kind::height_field) {
    const double half = 0.5 * (solid.sizes[0] - 1) * solid.sizes[1], root = std::sqrt(0.5);
    const std::array<dReal, 4> quarter_turn{root, root, 0, 0};
    dGeomSetPosition(geom.get(), half, half, 0);
    dGeomSetQuaternion(geom.get(), quarter_turn.data());
    return geom;
  }
  const Point& p = placement.position;
  dGeomSetPosition(geom.get(), p[0], p[1], p[2]);
  dGeomSetQuaternion(geom.get(), placement.orientation.data());
  return geom;
}

// Once, and until the program ends. False where ODE does not start.
[[nodiscard]] inline bool start_ode() {
  constexpr auto all_data = static_cast<unsigned int>(dAllocateMaskAll);
  static const bool is_ready = dInitODE2(0) != 0 && dAllocateODEDataForThread(all_data) != 0;
  return is_ready;
}

}  // namespace bench
