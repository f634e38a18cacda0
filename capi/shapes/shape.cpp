// SPDX-License-Identifier: Apache-2.0
// Making shapes from buffers and from other shapes, and owning them.
#include "convert.hpp"
#include "guard.hpp"
#include "options.hpp"
#include "shapes/shape_handle.hpp"
#include "shapes/shape_make.hpp"
#include "shapes/triangle_source.hpp"

import abut.capability;
import abut.core;
import abut.math;
import abut.pairs.any_shape;
import abut.triangles.buffers;
import abut.triangles.report;

using namespace abut::capi;

namespace {

constexpr abut_mesh_options mesh_defaults{sizeof(abut_mesh_options), ABUT_SIDES_BOTH, 3, 0, 0, ABUT_MESH_TREE_AUTO, 0};
constexpr abut_uv_grid_options uv_grid_defaults{
    sizeof(abut_uv_grid_options), ABUT_SIDES_BOTH, ABUT_AXIS_X, ABUT_AXIS_Y, 0, 0, 3, 0, 0};

abut_status check_options(const abut_mesh_options& options) {
  abut_status status = check_struct_size({"options"}, options);
  status = status != ABUT_OK ? status : check_value({"options"}, ".tree", options.tree, ABUT_MESH_TREE_SPHERE);
  return status != ABUT_OK ? status : check_reserved({"options"}, options.reserved);
}

// A struct of options that says how faces are read.
template <class Options>
abut_status read_options(const Options& options, FaceOptions& out) {
  abut_status status = check_struct_size({"options"}, options);
  status = status != ABUT_OK ? status : check_value({"options"}, ".sides", options.sides, ABUT_SIDES_SOLID);
  out = {options.corners, options.merges_vertices, options.merge_distance};
  return status;
}

template <class Options>
abut_status create_from_faces(const Faces& faces, const Options& options, std::string_view kind,
                              std::span<const double> parameters, abut_shape** out) {
  FaceOptions read_as{};
  abut_status status = read_options(options, read_as);
  TriangleSource source;
  status = status != ABUT_OK ? status : TriangleSource::read(faces, read_as, source);
  return status != ABUT_OK ? status : create_named(kind, {parameters, source.xyz(), source.triangles()}, out);
}

abut_status create_mesh(const Faces& faces, const abut_mesh_options& options, abut_shape** out) {
  const abut_status status = check_options(options);
  const std::array parameters{static_cast<double>(options.sides), static_cast<double>(options.tree)};
  return status != ABUT_OK ? status : create_from_faces(faces, options, "mesh", parameters, out);
}

abut_status create_uv_grid(const Faces& faces, const abut_uv_grid_options& options, abut_shape** out) {
  const std::array<double, 5> parameters{static_cast<double>(options.sides), static_cast<double>(options.axis_u),
                                         static_cast<double>(options.axis_v), static_cast<double>(options.cells_u),
                                         static_cast<double>(options.cells_v)};
  return create_from_faces(faces, options, "uv_grid", parameters, out);
}

abut_status describe_mesh(const Faces& faces, const abut_mesh_options& options, abut_mesh_report* out) {
  FaceOptions read_as{};
  abut_status status = check_struct_size({"out"}, *out);
  status = status != ABUT_OK ? status : check_options(options);
  status = status != ABUT_OK ? status : read_options(options, read_as);
  TriangleSource source;
  status = status != ABUT_OK ? status : TriangleSource::read(faces, read_as, source);
  if (status != ABUT_OK) {
    return status;
  }
  if (const abut::Fault fault = abut::check_triangles("a mesh", source.xyz(), source.triangles())) {
    return refuse(*fault);
  }
  const abut::TriangleReport found = abut::report_triangles(source.xyz(), source.triangles());
  write_struct({sizeof(abut_mesh_report), 0, found.triangles, found.vertices, source.merged().vertices,
                source.merged().collapsed, found.duplicate_vertices, found.duplicate_triangles, found.slivers,
                found.open_edges, found.non_manifold_edges, found.reversed_triangles, found.twisted_patches,
                found.components, source.merged().error, found.volume},
               out);
  return ABUT_OK;
}

// `materials` may be null.
abut_status create_composite(const abut_shape* const* children, const abut_pose* poses, const std::uint32_t* materials,
                             std::size_t count, abut_shape** out) {
  std::span<const abut_shape* const> given;
  std::span<const std::uint32_t> given_materials;
  std::span<const abut_pose> given_poses;
  abut_status status = read_span("children", children, "count", count, given);
  status = status != ABUT_OK ? status : read_span("poses", poses, "count", count, given_poses);
  if (materials != nullptr) {
    status = status != ABUT_OK ? status : read_span("materials", materials, "count", count, given_materials);
  }
  if (status != ABUT_OK) {
    return status;
  }
  std::vector<abut::PlacedShape> placed;
  placed.reserve(given.size());
  for (std::size_t i = 0; i < given.size(); ++i) {
    if (given[i] == nullptr) {
      return refuse(ABUT_NULL_ARGUMENT, "children[" + std::to_string(i) + "] is null");
    }
    if (status = check_pose({"poses", i}, given_poses[i]); status != ABUT_OK) {
      return status;
    }
    placed.push_back({given[i]->handle, to_pose(given_poses[i]), given_materials.empty() ? 0 : given_materials[i]});
  }
  abut::Result<abut::ShapeHandle> made = abut::make_composite(placed);
  if (!made) {
    return refuse(made.error());
  }
  *out = std::make_unique<abut_shape>(std::move(made).value()).release();
  return ABUT_OK;
}

abut_status create_height_field(const abut_height_field_desc& desc, abut_shape** out) {
  if (const abut_status status = check_struct_size({"desc"}, desc); status != ABUT_OK) {
    return status;
  }
  if (const abut_status status = check_value({"desc"}, ".below", desc.below, ABUT_BELOW_SOLID); status != ABUT_OK) {
    return status;
  }
  if (const abut_status status = check_reserved({"desc"}, desc.reserved); status != ABUT_OK) {
    return status;
  }
  Numbers numbers;
  const std::string product =
      "desc.columns * desc.rows = " + std::to_string(desc.columns) + " * " + std::to_string(desc.rows);
  const std::uint64_t samples = std::uint64_t{desc.columns} * desc.rows;
  if (const abut_status status = read_span("desc.heights", desc.heights, product, samples, numbers.reals);
      status != ABUT_OK) {
    return status;
  }
  const std::array parameters{
      static_cast<double>(desc.columns),  static_cast<double>(desc.rows), desc.spacing_x, desc.spacing_y,
      static_cast<double>(desc.diagonal), static_cast<double>(desc.below)};
  numbers.parameters = parameters;
  return create_named("height_field", numbers, out);
}

abut_status create_from(const abut_shape_desc& desc, abut_shape** out) {
  if (const abut_status status = check_struct_size({"desc"}, desc); status != ABUT_OK) {
    return status;
  }
  const std::optional<std::size_t> place = abut::find_kind(desc.kind);
  if (!place) {
    return refuse(
        abut::error_about(abut::Errc::unknown_value, "desc.kind", std::uint64_t{desc.kind}, "a kind of this build"));
  }
  Numbers numbers;
  if (const abut_status status = read_span("desc.parameters", desc.parameters, "desc.parameter_count",
                                           desc.parameter_count, numbers.parameters);
      status != ABUT_OK) {
    return status;
  }
  if (const abut_status status = read_span("desc.reals", desc.reals, "desc.real_count", desc.real_count, numbers.reals);
      status != ABUT_OK) {
    return status;
  }
  if (const abut_status status =
          read_span("desc.indices", desc.indices, "desc.index_count", desc.index_count, numbers.indices);
      status != ABUT_OK) {
    return status;
  }
  return create(*place, numbers, out, Door::generic);
}

}  // namespace

abut_status abut_hull_create(const double* xyz, size_t point_count, abut_shape** out) {
  return guard([&] {
    Numbers numbers;
    abut_status status = check_not_null("out", out);
    status = status != ABUT_OK ? status : read_span<3>("xyz", xyz, "point_count", point_count, numbers.reals);
    return status != ABUT_OK ? status : create_named("hull", numbers, out);
  });
}

void abut_mesh_options_init(abut_mesh_options* options, uint32_t struct_size) {
  fill_defaults(mesh_defaults, struct_size, options);
}

abut_status abut_mesh_create(const double* xyz, size_t vertex_count, const uint32_t* triangles, size_t triangle_count,
                             const abut_mesh_options* options, abut_shape** out) {
  return guard([&] {
    const abut_status status = check_not_null("out", out);
    return status != ABUT_OK ? status
                             : create_mesh({xyz, vertex_count, triangles, triangle_count},
                                           options != nullptr ? *options : mesh_defaults, out);
  });
}

void abut_mesh_report_init(abut_mesh_report* report, uint32_t struct_size) {
  fill_defaults(abut_mesh_report{}, struct_size, report);
}

abut_status abut_mesh_describe(const double* xyz, size_t vertex_count, const uint32_t* triangles, size_t triangle_count,
                               const abut_mesh_options* options, abut_mesh_report* out) {
  return guard([&] {
    const abut_status status = check_not_null("out", out);
    return status != ABUT_OK ? status
                             : describe_mesh({xyz, vertex_count, triangles, triangle_count},
                                             options != nullptr ? *options : mesh_defaults, out);
  });
}

abut_status abut_composite_create(const abut_shape* const* children, const abut_pose* poses, size_t count,
                                  abut_shape** out) {
  return guard([&] {
    const abut_status status = check_not_null("out", out);
    return status != ABUT_OK ? status : create_composite(children, poses, nullptr, count, out);
  });
}

abut_status abut_composite_create_with_materials(const abut_shape* const* children, const abut_pose* poses,
                                                 const uint32_t* materials, size_t count, abut_shape** out) {
  return guard([&] {
    const abut_status status = check_none_null<2>({{{"materials", materials}, {"out", out}}});
    return status != ABUT_OK ? status : create_composite(children, poses, materials, count, out);
  });
}

void abut_uv_grid_options_init(abut_uv_grid_options* options, uint32_t struct_size) {
  fill_defaults(uv_grid_defaults, struct_size, options);
}

abut_status abut_uv_grid_create(const double* xyz, size_t vertex_count, const uint32_t* triangles,
                                size_t triangle_count, const abut_uv_grid_options* options, abut_shape** out) {
  return guard([&] {
    const abut_status status = check_not_null("out", out);
    return status != ABUT_OK ? status
                             : create_uv_grid({xyz, vertex_count, triangles, triangle_count},
                                              options != nullptr ? *options : uv_grid_defaults, out);
  });
}

void abut_height_field_desc_init(abut_height_field_desc* desc, uint32_t struct_size) {
  fill_defaults<abut_height_field_desc>({sizeof(abut_height_field_desc), 0, 0, 0, 1, 1, nullptr, ABUT_BELOW_OPEN, 0},
                                        struct_size, desc);
}

abut_status abut_height_field_create(const abut_height_field_desc* desc, abut_shape** out) {
  return guard([&] {
    const abut_status status = check_none_null<2>({{{"desc", desc}, {"out", out}}});
    return status != ABUT_OK ? status : create_height_field(*desc, out);
  });
}

void abut_shape_desc_init(abut_shape_desc* desc, uint32_t struct_size) {
  fill_defaults<abut_shape_desc>({sizeof(abut_shape_desc), 0, nullptr, 0, nullptr, 0, nullptr, 0}, struct_size, desc);
}

abut_status abut_shape_create(const abut_shape_desc* desc, abut_shape** out) {
  return guard([&] {
    const abut_status status = check_none_null<2>({{{"desc", desc}, {"out", out}}});
    return status != ABUT_OK ? status : create_from(*desc, out);
  });
}

void abut_shape_retain(abut_shape* shape) {
  if (shape != nullptr) {
    shape->references.fetch_add(1, std::memory_order_relaxed);
  }
}

void abut_shape_release(abut_shape* shape) {
  // The last owner must see everything that the others did with the shape.
  if (shape != nullptr && shape->references.fetch_sub(1, std::memory_order_acq_rel) == 1) {
    const std::unique_ptr<abut_shape> last(shape);
  }
}
