// SPDX-License-Identifier: Apache-2.0
// Shapes that are a few numbers, each by a function of its own.
#include "convert.hpp"
#include "guard.hpp"
#include "shapes/shape_make.hpp"

import abut.core;
import abut.math;

using namespace abut::capi;

namespace {

abut_status create_plane(const abut_vec3& normal, double offset, abut_shape** out) {
  for (const auto& [name, value] : std::array<std::pair<std::string_view, double>, 3>{
           {{"normal.x", normal.x}, {"normal.y", normal.y}, {"normal.z", normal.z}}}) {
    if (!std::isfinite(value)) {
      return refuse(abut::error_about(abut::Errc::not_finite, name, value, "finite"));
    }
  }
  // Normalised here, since lengths may be beyond what coordinates may be.
  const auto unit = abut::UnitVec3::make({normal.x, normal.y, normal.z});
  if (!unit) {
    return refuse(ABUT_ZERO_VECTOR, "normal is (0, 0, 0); it must have a direction");
  }
  const std::array parameters{unit->vec().x, unit->vec().y, unit->vec().z, offset};
  return create_named("plane", {parameters, {}, {}}, out);
}

template <std::size_t Count>
abut_status create_of(std::string_view kind, const std::array<double, Count>& parameters, abut_shape** out) {
  return guard([&] {
    const abut_status status = check_not_null("out", out);
    return status != ABUT_OK ? status : create_named(kind, {parameters, {}, {}}, out);
  });
}

}  // namespace

abut_status abut_sphere_create(double radius, abut_shape** out) { return create_of("sphere", std::array{radius}, out); }

abut_status abut_box_create(double half_x, double half_y, double half_z, abut_shape** out) {
  return create_of("box", std::array{half_x, half_y, half_z}, out);
}

abut_status abut_capsule_create(double radius, double half_height, abut_shape** out) {
  return create_of("capsule", std::array{radius, half_height}, out);
}

abut_status abut_cylinder_create(double radius, double half_height, abut_shape** out) {
  return create_of("cylinder", std::array{radius, half_height}, out);
}

abut_status abut_cone_create(double radius, double half_height, abut_shape** out) {
  return create_of("cone", std::array{radius, half_height}, out);
}

abut_status abut_ellipsoid_create(double radius_x, double radius_y, double radius_z, abut_shape** out) {
  return create_of("ellipsoid", std::array{radius_x, radius_y, radius_z}, out);
}

abut_status abut_point_create(abut_shape** out) { return create_of("point", std::array<double, 0>{}, out); }

abut_status abut_segment_create(double half_length, abut_shape** out) {
  return create_of("segment", std::array{half_length}, out);
}

abut_status abut_sphere_hole_create(double radius, abut_shape** out) {
  return create_of("sphere_hole", std::array{radius}, out);
}

abut_status abut_cylinder_hole_create(double radius, double half_height, abut_open_ends open_ends, abut_shape** out) {
  return create_of("cylinder_hole", std::array{radius, half_height, static_cast<double>(open_ends)}, out);
}

abut_status abut_box_hole_create(double half_x, double half_y, double half_z, abut_open_faces open_faces,
                                 abut_shape** out) {
  return create_of("box_hole", std::array{half_x, half_y, half_z, static_cast<double>(open_faces)}, out);
}

abut_status abut_plane_create(const abut_vec3* normal, double offset, abut_shape** out) {
  return guard([&] {
    const abut_status status = check_none_null<2>({{{"normal", normal}, {"out", out}}});
    return status != ABUT_OK ? status : create_plane(*normal, offset, out);
  });
}

abut_status abut_triangle_create(const abut_vec3* a, const abut_vec3* b, const abut_vec3* c, abut_shape** out) {
  return guard([&] {
    const abut_status status = check_none_null<4>({{{"a", a}, {"b", b}, {"c", c}, {"out", out}}});
    if (status != ABUT_OK) {
      return status;
    }
    const std::array parameters{a->x, a->y, a->z, b->x, b->y, b->z, c->x, c->y, c->z};
    return create_named("triangle", {parameters, {}, {}}, out);
  });
}
