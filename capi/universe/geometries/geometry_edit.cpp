// SPDX-License-Identifier: Apache-2.0
// Shapes that change while geometries have them.
#include "border.hpp"
#include "universe/geometries/shape_change.hpp"
#include "universe/universe_handle.hpp"

import abut.capability;
import abut.core;
import abut.math;
import abut.pairs.any_shape;
import abut.pairs.any_shape.shape_edit;
import abut.universe;

using namespace abut::capi;

namespace {

abut_status edit_one(abut_universe& its, const abut_geometry_id& geometry, const abut::Edit& edit) {
  if (!exists(its.universe, geometry)) {
    return refuse_stale({"geometry"}, geometry);
  }
  return change_shapes(its, std::array{geometry}, [&] { return its.universe.edit_shape(to_geometry(geometry), edit); });
}

abut_status edit_all(abut_universe& its, std::span<const abut_geometry_id> ids, std::span<const abut::Edit> edits) {
  for (std::size_t i = 0; i < ids.size(); ++i) {
    if (!exists(its.universe, ids[i])) {
      return refuse_stale({"geometries", i}, ids[i]);
    }
  }
  return change_shapes(its, ids, [&] { return its.universe.edit_shapes(to_geometries(ids), edits); });
}

// The first of three numbers for each of these.
template <class Vertex>
auto numbers_of(std::span<Vertex> vertices) {
  static_assert(sizeof(abut::Vec3) == 3 * sizeof(double));
  return vertices.empty() ? nullptr : &vertices.front().x;
}

abut_status advance_all(abut_universe& its, std::span<const abut_geometry_id> ids) {
  for (std::size_t i = 0; i < ids.size(); ++i) {
    if (!exists(its.universe, ids[i])) {
      return refuse_stale({"geometries", i}, ids[i]);
    }
  }
  return change_shapes(its, ids, [&] { return its.universe.advance_vertices(to_geometries(ids)); });
}

abut_status set_parameters(abut_universe& its, std::span<const abut_geometry_id> ids, const double* parameters,
                           std::size_t each) {
  std::span<const double> numbers;
  abut_status status =
      check_size("parameters", "parameter_count", each, std::max<std::size_t>(ids.size(), 1) * sizeof(double));
  status = status != ABUT_OK ? status : read_span("parameters", parameters, "count", each * ids.size(), numbers);
  if (status != ABUT_OK) {
    return status;
  }
  std::vector<abut::Edit> edits;
  edits.reserve(ids.size());
  for (std::size_t i = 0; i < ids.size(); ++i) {
    edits.emplace_back(abut::ParameterEdit{numbers.subspan(i * each, each)});
  }
  return edit_all(its, ids, edits);
}

abut_status set_particles(abut_universe& its, const abut_geometry_id& geometry, std::size_t first, const double* xyz,
                          const double* radii, std::size_t count) {
  std::span<const double> numbers, given_radii;
  abut_status status = read_span<3>("xyz", xyz, "count", count, numbers);
  if (status == ABUT_OK && radii != nullptr) {
    status = read_span("radii", radii, "count", count, given_radii);
  }
  return status != ABUT_OK ? status : edit_one(its, geometry, abut::ParticleEdit{first, numbers, given_radii});
}

abut_status set_vertices(abut_universe& its, const abut_geometry_id& geometry, abut::VertexEdit edit, const double* xyz,
                         std::size_t count) {
  const abut_status status = read_span<3>("xyz", xyz, "count", count, edit.xyz);
  return status != ABUT_OK ? status : edit_one(its, geometry, edit);
}

}  // namespace

abut_status abut_geometry_set_parameters(abut_universe* universe, abut_geometry_id geometry, const double* parameters,
                                         size_t parameter_count) {
  return guard(universe, [&](abut_universe& its) {
    std::span<const double> numbers;
    const abut_status status = read_span("parameters", parameters, "parameter_count", parameter_count, numbers);
    return status != ABUT_OK ? status : edit_one(its, geometry, abut::ParameterEdit{numbers});
  });
}

abut_status abut_geometries_set_parameters(abut_universe* universe, const abut_geometry_id* geometries,
                                           const double* parameters, size_t parameter_count, size_t count) {
  return guard(universe, [&](abut_universe& its) {
    std::span<const abut_geometry_id> ids;
    const abut_status status = read_span("geometries", geometries, "count", count, ids);
    return status != ABUT_OK ? status : set_parameters(its, ids, parameters, parameter_count);
  });
}

abut_status abut_geometry_set_heights(abut_universe* universe, abut_geometry_id geometry, uint32_t column, uint32_t row,
                                      uint32_t columns, uint32_t rows, const double* heights) {
  return guard(universe, [&](abut_universe& its) {
    std::span<const double> numbers;
    const std::string product = "columns * rows = " + std::to_string(columns) + " * " + std::to_string(rows);
    const abut_status status = read_span("heights", heights, product, std::uint64_t{columns} * rows, numbers);
    return status != ABUT_OK ? status : edit_one(its, geometry, abut::HeightEdit{column, row, columns, rows, numbers});
  });
}

abut_status abut_geometry_set_field_values(abut_universe* universe, abut_geometry_id geometry, uint32_t column,
                                           uint32_t row, uint32_t layer, uint32_t columns, uint32_t rows,
                                           uint32_t layers, const double* values) {
  return guard(universe, [&](abut_universe& its) {
    std::span<const double> numbers;
    const std::string product = "columns * rows * layers = " + std::to_string(columns) + " * " + std::to_string(rows) +
                                " * " + std::to_string(layers);
    const abut_status status = read_span("values", values, product, samples_of_grid(columns, rows, layers), numbers);
    return status != ABUT_OK
               ? status
               : edit_one(its, geometry, abut::FieldEdit{column, row, layer, columns, rows, layers, numbers});
  });
}

abut_status abut_geometry_set_field_lattice(abut_universe* universe, abut_geometry_id geometry, uint32_t columns,
                                            uint32_t rows, uint32_t layers, const double* xyz) {
  return guard(universe, [&](abut_universe& its) {
    std::span<const double> numbers;
    const std::string product = "columns * rows * layers = " + std::to_string(columns) + " * " + std::to_string(rows) +
                                " * " + std::to_string(layers);
    const abut_status status = read_span<3>("xyz", xyz, product, samples_of_grid(columns, rows, layers), numbers);
    return status != ABUT_OK ? status : edit_one(its, geometry, abut::LatticeEdit{columns, rows, layers, numbers});
  });
}

abut_status abut_geometry_set_particles(abut_universe* universe, abut_geometry_id geometry, size_t first,
                                        const double* xyz, const double* radii, size_t count) {
  return guard(universe, [&](abut_universe& its) { return set_particles(its, geometry, first, xyz, radii, count); });
}

abut_status abut_geometry_set_vertices(abut_universe* universe, abut_geometry_id geometry, size_t first,
                                       const double* xyz, size_t count) {
  return guard(universe, [&](abut_universe& its) { return set_vertices(its, geometry, {first, {}, {}}, xyz, count); });
}

abut_status abut_geometry_set_vertices_at(abut_universe* universe, abut_geometry_id geometry, const uint32_t* vertices,
                                          const double* xyz, size_t count) {
  return guard(universe, [&](abut_universe& its) {
    std::span<const std::uint32_t> given;
    const abut_status status = read_span("vertices", vertices, "count", count, given);
    return status != ABUT_OK ? status : set_vertices(its, geometry, {0, given, {}}, xyz, count);
  });
}

abut_status abut_geometry_vertices(const abut_universe* universe, abut_geometry_id geometry, const double** xyz,
                                   size_t* count) {
  return guard(universe, [&](const abut_universe& its) {
    const abut_status status = check_none_null<2>({{{"xyz", xyz}, {"count", count}}});
    if (status == ABUT_OK && !exists(its.universe, geometry)) {
      return refuse_stale({"geometry"}, geometry);
    }
    if (status == ABUT_OK) {
      const abut::AnyShape& shape = its.universe.shape_at(geometry.slot - 1);
      if (const abut::Fault fault = abut::check_next_vertices(shape, {})) {
        return refuse(*fault);
      }
      const std::span<const abut::Vec3> lent = abut::held_triangles(shape).vertices;
      *xyz = numbers_of(lent);
      *count = lent.size();
    }
    return status;
  });
}

abut_status abut_geometry_next_vertices(abut_universe* universe, abut_geometry_id geometry, double** xyz,
                                        size_t* count) {
  return guard(universe, [&](abut_universe& its) {
    const abut_status status = check_none_null<2>({{{"xyz", xyz}, {"count", count}}});
    if (status == ABUT_OK && !exists(its.universe, geometry)) {
      return refuse_stale({"geometry"}, geometry);
    }
    if (status == ABUT_OK) {
      const auto lent = its.universe.lend_next_vertices(to_geometry(geometry));
      if (!lent) {
        return refuse(lent.error());
      }
      *xyz = numbers_of(lent.value());
      *count = lent.value().size();
    }
    return status;
  });
}

abut_status abut_geometry_advance(abut_universe* universe, abut_geometry_id geometry) {
  return guard(universe, [&](abut_universe& its) {
    return !exists(its.universe, geometry) ? refuse_stale({"geometry"}, geometry)
                                           : change_shapes(its, std::array{geometry}, [&] {
                                               return its.universe.advance_vertices(to_geometry(geometry));
                                             });
  });
}

abut_status abut_geometries_advance(abut_universe* universe, const abut_geometry_id* geometries, size_t count) {
  return guard(universe, [&](abut_universe& its) {
    std::span<const abut_geometry_id> ids;
    const abut_status status = read_span("geometries", geometries, "count", count, ids);
    return status != ABUT_OK ? status : advance_all(its, ids);
  });
}

abut_status abut_geometry_remove_triangles(abut_universe* universe, abut_geometry_id geometry,
                                           const uint32_t* triangles, size_t count) {
  return guard(universe, [&](abut_universe& its) {
    std::span<const std::uint32_t> given;
    const abut_status status = read_span("triangles", triangles, "count", count, given);
    return status != ABUT_OK ? status : edit_one(its, geometry, abut::RemovalEdit{given});
  });
}

abut_status abut_geometry_set_mesh(abut_universe* universe, abut_geometry_id geometry, const double* xyz,
                                   size_t vertex_count, const uint32_t* triangles, size_t triangle_count) {
  return guard(universe, [&](abut_universe& its) {
    std::span<const double> reals;
    std::span<const std::uint32_t> indices;
    abut_status status = read_span<3>("xyz", xyz, "vertex_count", vertex_count, reals);
    status =
        status != ABUT_OK ? status : read_span<3>("triangles", triangles, "triangle_count", triangle_count, indices);
    return status != ABUT_OK ? status : edit_one(its, geometry, abut::RecreationEdit{reals, indices});
  });
}

abut_status abut_geometry_shape(const abut_universe* universe, abut_geometry_id geometry, abut_shape** out) {
  return guard(universe, [&](const abut_universe& its) {
    const abut_status status = check_not_null("out", out);
    if (status == ABUT_OK && !exists(its.universe, geometry)) {
      return refuse_stale({"geometry"}, geometry);
    }
    if (status == ABUT_OK) {
      *out = share(its.shapes[geometry.slot - 1].get()).release();
    }
    return status;
  });
}
