// SPDX-License-Identifier: Apache-2.0
// Making distance fields, from samples and from meshes.
#include "convert.hpp"
#include "guard.hpp"
#include "options.hpp"
#include "shapes/shape_handle.hpp"
#include "shapes/shape_make.hpp"

import abut.core;
import abut.math;
import abut.pairs.any_shape;
import abut.pairs.any_shape.field_of_mesh;

using namespace abut::capi;

namespace {

abut_status create_distance_field(const abut_distance_field_desc& desc, abut_shape** out) {
  abut_status status = check_struct_size({"desc"}, desc);
  status = status != ABUT_OK ? status : check_value({"desc"}, ".is_inside_out", desc.is_inside_out, 1u);
  status = status != ABUT_OK
               ? status
               : check_value({"desc"}, ".interpolation", desc.interpolation, ABUT_INTERPOLATION_QUADRATIC);
  if (status != ABUT_OK) {
    return status;
  }
  Numbers numbers;
  const std::string product = "desc.columns * desc.rows * desc.layers = " + std::to_string(desc.columns) + " * " +
                              std::to_string(desc.rows) + " * " + std::to_string(desc.layers);
  status = read_span("desc.values", desc.values, product, samples_of_grid(desc.columns, desc.rows, desc.layers),
                     numbers.reals);
  if (status != ABUT_OK) {
    return status;
  }
  const std::array parameters{static_cast<double>(desc.columns),
                              static_cast<double>(desc.rows),
                              static_cast<double>(desc.layers),
                              desc.spacing.x,
                              desc.spacing.y,
                              desc.spacing.z,
                              desc.origin.x,
                              desc.origin.y,
                              desc.origin.z,
                              static_cast<double>(desc.is_inside_out),
                              static_cast<double>(desc.interpolation)};
  numbers.parameters = parameters;
  return create_named("distance_field", numbers, out);
}

abut_status read_options(const abut_distance_field_options& given, abut::FieldOptions& out) {
  abut_status status = check_struct_size({"options"}, given);
  status = status != ABUT_OK ? status : check_value({"options"}, ".is_inside_out", given.is_inside_out, 1u);
  status = status != ABUT_OK ? status : check_reserved({"options"}, given.reserved);
  status = status != ABUT_OK
               ? status
               : check_value({"options"}, ".interpolation", given.interpolation, ABUT_INTERPOLATION_QUADRATIC);
  out = {given.spacing, given.band, given.is_inside_out == 1, given.interpolation == ABUT_INTERPOLATION_QUADRATIC};
  return status;
}

abut_status create_from_mesh(const double* xyz, std::size_t vertex_count, const std::uint32_t* triangles,
                             std::size_t triangle_count, const abut_distance_field_options* options, abut_shape** out) {
  abut::FieldOptions its{0, 3, false, false};
  if (const abut_status status = options != nullptr ? read_options(*options, its) : ABUT_OK; status != ABUT_OK) {
    return status;
  }
  Numbers numbers;
  abut_status status = read_span<3>("xyz", xyz, "vertex_count", vertex_count, numbers.reals);
  status = status != ABUT_OK ? status
                             : read_span<3>("triangles", triangles, "triangle_count", triangle_count, numbers.indices);
  if (status != ABUT_OK) {
    return status;
  }
  abut::Result<abut::ShapeHandle> made = abut::make_field_of_mesh(numbers.reals, numbers.indices, its);
  if (!made) {
    return refuse(made.error());
  }
  *out = std::make_unique<abut_shape>(std::move(made).value()).release();
  return ABUT_OK;
}

abut_status describe_field(const abut_shape* shape, abut_distance_field_report* out) {
  if (const abut_status status = check_struct_size({"out"}, *out); status != ABUT_OK) {
    return status;
  }
  const std::optional<abut::FieldReport> report = abut::field_report_of(shape_of(shape));
  if (!report) {
    return refuse(ABUT_UNSUPPORTED, "shape is a " + std::string(abut::kind_name(abut::kind_of(shape_of(shape)))) +
                                        ", and no distance field");
  }
  write_struct(
      {sizeof(abut_distance_field_report),
       static_cast<abut_interpolation>(report->is_smooth ? ABUT_INTERPOLATION_QUADRATIC : ABUT_INTERPOLATION_LINEAR),
       report->blocks, report->held_blocks, report->near_error, report->far_error, report->least_stretch,
       report->most_stretch},
      out);
  return ABUT_OK;
}

}  // namespace

void abut_distance_field_desc_init(abut_distance_field_desc* desc, uint32_t struct_size) {
  fill_defaults<abut_distance_field_desc>(
      {sizeof(abut_distance_field_desc), 0, 0, 0, 0, 0, {1, 1, 1}, {0, 0, 0}, nullptr}, struct_size, desc);
}

abut_status abut_distance_field_create(const abut_distance_field_desc* desc, abut_shape** out) {
  return guard([&] {
    const abut_status status = check_none_null<2>({{{"desc", desc}, {"out", out}}});
    return status != ABUT_OK ? status : create_distance_field(*desc, out);
  });
}

void abut_distance_field_options_init(abut_distance_field_options* options, uint32_t struct_size) {
  fill_defaults<abut_distance_field_options>({sizeof(abut_distance_field_options), 0, 0, 3, 0, 0}, struct_size,
                                             options);
}

abut_status abut_distance_field_from_mesh(const double* xyz, size_t vertex_count, const uint32_t* triangles,
                                          size_t triangle_count, const abut_distance_field_options* options,
                                          abut_shape** out) {
  return guard([&] {
    const abut_status status = check_not_null("out", out);
    return status != ABUT_OK ? status : create_from_mesh(xyz, vertex_count, triangles, triangle_count, options, out);
  });
}

void abut_distance_field_report_init(abut_distance_field_report* report, uint32_t struct_size) {
  fill_defaults(abut_distance_field_report{}, struct_size, report);
}

abut_status abut_distance_field_describe(const abut_shape* shape, abut_distance_field_report* out) {
  return guard([&] {
    const abut_status status = check_none_null<2>({{{"shape", shape}, {"out", out}}});
    return status != ABUT_OK ? status : describe_field(shape, out);
  });
}
