// SPDX-License-Identifier: Apache-2.0
#include "surface_residual.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

namespace property {

namespace {

// Of a half-plane with a corner at both ends: the larger of the distances to the lines inside, that to the polygon
// outside.
struct Outline {
  double beside;  // out of the side
  double beyond;  // out of the ends
};

double inside_or_out(const Outline& at) {
  const double out = std::hypot(std::max(at.beside, 0.0), std::max(at.beyond, 0.0));
  return out > 0 ? out : std::max(at.beside, at.beyond);
}

double of_cylinder(const oracle::Cylinder& cylinder, double around, double z) {
  return inside_or_out({around - cylinder.radius, std::abs(z) - cylinder.half_height});
}

// Corners are not rounded off, so that outside of them it is a lower bound: within rounding that is enough.
double of_cone(const oracle::Cone& cone, double around, double z) {
  const double slant = std::hypot(2 * cone.half_height, cone.radius);
  const double beside = ((around - cone.radius) * 2 * cone.half_height + (z + cone.half_height) * cone.radius) / slant;
  return std::max({beside, -cone.half_height - z, z - cone.half_height, around - cone.radius});
}

double of_ellipsoid(const oracle::Ellipsoid& ellipsoid, const oracle::Vec& p) {
  const double x = static_cast<double>(p.x) / ellipsoid.radii[0];
  const double y = static_cast<double>(p.y) / ellipsoid.radii[1];
  const double z = static_cast<double>(p.z) / ellipsoid.radii[2];
  const double square = x * x + y * y + z * z;
  const double slope = 2 * std::hypot(x / ellipsoid.radii[0], y / ellipsoid.radii[1], z / ellipsoid.radii[2]);
  return slope > 0 ? (square - 1) / slope : -ellipsoid.radii[0];
}

}  // namespace

double surface_residual(const SolidSubject& solid, const abut_pose& pose, const abut_vec3& point) {
  const oracle::Pose placed = pose_of(pose);
  const oracle::Vec local = placed.rotate_back(vec_of(point) - placed.position);
  const double around = std::hypot(static_cast<double>(local.x), static_cast<double>(local.y));
  const double z = static_cast<double>(local.z);
  if (const auto* cylinder = std::get_if<oracle::Cylinder>(&solid.solid.form)) return of_cylinder(*cylinder, around, z);
  if (const auto* cone = std::get_if<oracle::Cone>(&solid.solid.form)) return of_cone(*cone, around, z);
  if (const auto* ellipsoid = std::get_if<oracle::Ellipsoid>(&solid.solid.form)) return of_ellipsoid(*ellipsoid, local);
  return static_cast<double>(oracle::distance_to_point(solid.subject.measured, placed, vec_of(point)));
}

}  // namespace property
