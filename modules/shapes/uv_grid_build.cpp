// SPDX-License-Identifier: Apache-2.0
module abut.shapes.uv_grid;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.shapes.mesh;
import abut.trees.uv_cells;

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

// Such that about four triangles lie in a cell, but cells are wider than most triangles.
std::uint32_t cells_that_suit(Real extent, Real other_extent, Real mean_width, Real triangles) {
  constexpr Real triangles_of_cell = 4, widths_of_cell = 1.4;
  const Real most = std::max(std::floor(triangles / triangles_of_cell), Real{1});
  const Real even = other_extent > 0 ? std::sqrt(most * (extent / other_extent)) : most;
  const Real wide = mean_width > 0 ? extent / (widths_of_cell * mean_width) : most;
  return extent > 0
             ? static_cast<std::uint32_t>(std::clamp(std::min(even, wide), Real{1}, std::min(most, most_along_an_axis)))
             : 1;
}

}  // namespace

Result<UvGrid> UvGrid::make(std::span<const Real> parameters, std::span<const Real> reals,
                            std::span<const std::uint32_t> indices) {
  if (Fault fault = check_count("parameter_count", parameters.size(), parameter_names.size())) {
    return *fault;
  }
  Result<Mesh> mesh = Mesh::make(parameters.first(1), reals, indices);
  if (!mesh) {
    return mesh.error();
  }
  if (Fault fault = check_grid(parameters)) {
    return *fault;
  }
  return UvGrid(Data{std::move(mesh).value(),
                     {static_cast<int>(parameters[1]), static_cast<int>(parameters[2]),
                      static_cast<std::uint32_t>(parameters[3]), static_cast<std::uint32_t>(parameters[4])},
                     {}});
}

std::vector<Real> UvGrid::parameters() const {
  const UvCells::Plan& plan = data_->plan;
  return {data_->mesh.parameters().front(), static_cast<Real>(plan.u), static_cast<Real>(plan.v),
          static_cast<Real>(plan.columns), static_cast<Real>(plan.rows)};
}

UvCells UvGrid::make_cells(const Data& data) {
  const auto count = static_cast<std::uint32_t>(data.mesh.triangle_count());
  std::vector<Aabb> boxes;
  boxes.reserve(count);
  Vec3 widths{0, 0, 0};
  for (std::uint32_t triangle = 0; triangle < count; ++triangle) {
    boxes.push_back(data.mesh.present_box(triangle));
    if (boxes.back().low.x <= boxes.back().high.x) {
      widths += boxes.back().high - boxes.back().low;
    }
  }
  const Aabb around = data.mesh.aabb(Pose::identity());
  const Vec3 extent = around.high - around.low;
  UvCells::Plan plan = data.plan;
  const auto suit = [&](int axis, int other) {
    return cells_that_suit(extent[axis], extent[other], widths[axis] / count, count);
  };
  plan.columns = plan.columns > 0 ? plan.columns : suit(plan.u, plan.v);
  plan.rows = plan.rows > 0 ? plan.rows : suit(plan.v, plan.u);
  return UvCells(plan, around, boxes);
}

std::optional<RayHit> UvGrid::cast_ray(const Vec3& origin, const UnitVec3& direction, Real max_distance) const {
  const Mesh& mesh = data_->mesh;
  const TriangleRay ray(origin, direction);
  Real nearest = max_distance;
  std::uint32_t hit = no_index;
  cells().visit_ray(origin, direction, nearest, [&](std::uint32_t index) {
    const auto distance = ray.distance_to(mesh.corners(index), nearest);
    if (distance && (*distance < nearest || index < hit)) {
      nearest = *distance;
      hit = index;
    }
  });
  return hit == no_index ? std::nullopt : std::optional(RayHit{nearest, part(hit).normal(), {FeatureKind::face, hit}});
}

// A sheet with a bridge over it: two layers, and walls that stand upright.
std::vector<UvGrid> UvGrid::samples() {
  std::vector<Real> xyz;
  std::vector<std::uint32_t> triangles;
  for (std::uint32_t j = 0; j < 5; ++j) {
    for (std::uint32_t i = 0; i < 5; ++i) {
      const Real x = 0.5 * i - 1, y = 0.5 * j - 1;
      xyz.insert(xyz.end(), {x, y, 0.3 * x * y});
      if (i < 4 && j < 4) {
        const std::uint32_t k = 5 * j + i;
        triangles.insert(triangles.end(), {k, k + 1, k + 6, k, k + 6, k + 5});
      }
    }
  }
  const auto bridge = std::to_array<Real>({-0.9, -0.25, 0,   -0.9, 0.25, 0,   -0.9, -0.25, 0.5, -0.9, 0.25, 0.5,
                                           0.9,  -0.25, 0.5, 0.9,  0.25, 0.5, 0.9,  -0.25, 0,   0.9,  0.25, 0});
  xyz.insert(xyz.end(), bridge.begin(), bridge.end());
  for (std::uint32_t k = 25; k < 31; k += 2) {
    triangles.insert(triangles.end(), {k, k + 2, k + 3, k, k + 3, k + 1});
  }
  const auto both = std::to_array<Real>({0, 0, 1, 0, 0}), front = std::to_array<Real>({1, 1, 2, 3, 2});
  return {make(both, xyz, triangles).value(), make(front, xyz, triangles).value()};
}

}  // namespace abut
