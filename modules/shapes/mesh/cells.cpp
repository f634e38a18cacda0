// SPDX-License-Identifier: Apache-2.0
// Meshes whose trees are made by cells. Their vertices move only along the third axis, perpendicular to the grid, so
// that triangles stay in their cells.
module abut.shapes.mesh;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.trees.grids.cell_order;
import abut.triangles.buffers;

namespace abut {
namespace {

constexpr Real most_along_an_axis = 65535, most_cells = 1 << 24;

Fault check_axis(std::string_view name, Real value) {
  if (value != 0 && value != 1 && value != 2) {
    return error_about(Errc::unknown_value, name, value, "0 (X), 1 (Y) or 2 (Z)");
  }
  return std::nullopt;
}

Fault check_cells(std::string_view name, Real value) {
  if (!(value >= 0 && value <= most_along_an_axis) || value != std::floor(value)) {
    return error_about(Errc::out_of_range, name, value, "a whole number from 0 to 65535");
  }
  return std::nullopt;
}

Fault check_grid(std::span<const Real> parameters) {
  for (std::size_t i = 1; i <= 2; ++i) {
    if (Fault fault = check_axis(UvGrid::parameter_names[i], parameters[i])) {
      return fault;
    }
    if (Fault fault = check_cells(UvGrid::parameter_names[i + 2], parameters[i + 2])) {
      return fault;
    }
  }
  if (parameters[1] == parameters[2]) {
    return error_about(Errc::out_of_range, "axis_v", parameters[2], "another axis than axis_u");
  }
  if (parameters[3] * parameters[4] > most_cells) {
    return error_about(Errc::out_of_range, "cells_u * cells_v", parameters[3] * parameters[4], "at most 16777216");
  }
  return std::nullopt;
}

}  // namespace

Result<Mesh> UvGrid::make(std::span<const Real> parameters, std::span<const Real> reals,
                          std::span<const std::uint32_t> indices) {
  if (Fault fault = check_count("parameter_count", parameters.size(), parameter_names.size())) {
    return *fault;
  }
  if (Fault fault = Mesh::check_sides(parameters[0])) {
    return *fault;
  }
  if (Fault fault = check_triangles("a mesh", reals, indices)) {
    return *fault;
  }
  if (Fault fault = check_grid(parameters)) {
    return *fault;
  }
  const CellPlan plan{static_cast<int>(parameters[1]), static_cast<int>(parameters[2]),
                      static_cast<std::uint32_t>(parameters[3]), static_cast<std::uint32_t>(parameters[4])};
  return Mesh::made(static_cast<Mesh::Sides>(parameters[0]), Mesh::ChosenTree::automatic, plan, reals, indices);
}

// Vertices move along the axis that is none of the grid. So triangles stay in their cells. `array`: the name of what
// holds the place of the vertex, from number `first` on.
Fault Mesh::check_stays_in_cell(std::uint32_t vertex, const Vec3& next, std::string_view array,
                                std::size_t first) const {
  const CellPlan& plan = *data_->cells;
  constexpr std::array<std::string_view, 3> names{"X", "Y", "Z"};
  const Vec3& present = data_->vertices[vertex];
  for (const int axis : {plan.u, plan.v}) {
    if (next[axis] != present[axis]) {
      const std::size_t at = first + static_cast<std::size_t>(axis);
      const std::string height(names[static_cast<std::size_t>(3 - plan.u - plan.v)]);
      return error_about(Errc::out_of_range, std::string(array) + "[" + std::to_string(at) + "]", next[axis],
                         to_text(present[axis]) + ", as vertex " + std::to_string(vertex) +
                             " of a uv_grid moves along " + height + " only");
    }
  }
  return std::nullopt;
}

Fault Mesh::check_stays_in_cells(const VertexEdit& edit) const {
  for (std::size_t i = 0; data_->cells && i < edit.xyz.size() / 3; ++i) {
    const Vec3 next{edit.xyz[3 * i], edit.xyz[3 * i + 1], edit.xyz[3 * i + 2]};
    if (Fault fault = check_stays_in_cell(moved_vertex(edit, i), next, "xyz", 3 * i)) {
      return fault;
    }
  }
  return std::nullopt;
}

Fault Mesh::check_next_stays_in_cells(std::span<const Vec3> next) const {
  for (std::uint32_t vertex = 0; data_->cells && vertex < next.size(); ++vertex) {
    if (Fault fault = check_stays_in_cell(vertex, next[vertex], "next", 3 * std::size_t{vertex})) {
      return fault;
    }
  }
  return std::nullopt;
}

}  // namespace abut
