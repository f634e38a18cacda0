// SPDX-License-Identifier: Apache-2.0
module abut.shapes.height_field;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.trees.range_pyramid;
import abut.trees.ray_slabs;

namespace abut {
namespace {

Fault check_samples(std::string_view name, Real value) {
  if (Fault fault = check_finite(name, value)) {
    return fault;
  }
  if (value == 0) {
    return error_about(Errc::empty, name, value, "at least 2");
  }
  if (!(value >= 2 && value <= 65535) || value != std::floor(value)) {
    return error_about(Errc::out_of_range, name, value, "a whole number from 2 to 65535");
  }
  return std::nullopt;
}

// A sample, by column and row.
struct Sample {
  std::int64_t i, j;
};

// Samples are joined along the lines of the grid and along the diagonals that split the cells.
constexpr auto neighbours = std::to_array<Sample>({{1, 0}, {1, 1}, {0, 1}, {-1, 0}, {-1, -1}, {0, -1}});

constexpr bool are_joined(const Sample& a, const Sample& b) {
  return std::ranges::any_of(neighbours,
                             [&](const Sample& step) { return a.i + step.i == b.i && a.j + step.j == b.j; });
}

}  // namespace

// The triangles at an edge are those with a third corner that is joined to both ends.
bool HeightField::is_crest(std::uint32_t index, unsigned corners, const Vec3& direction, Real height) const {
  const Data& field = *data_;
  const std::int64_t cell = index / 2, i = cell % (field.columns - 1), j = cell / (field.columns - 1);
  const bool upper = index % 2 != 0;
  const std::array<Sample, 3> own{{{i, j}, {i + 1, j + (upper ? 1 : 0)}, {i + (upper ? 0 : 1), j + 1}}};
  const unsigned others = corners & (corners - 1);
  const Sample& sample = own[static_cast<unsigned>(std::countr_zero(corners))];
  const Sample* second = others != 0 ? &own[static_cast<unsigned>(std::countr_zero(others))] : nullptr;
  const auto height_along = [&](const Sample& at) {
    return dot(direction, point(static_cast<std::uint32_t>(at.i), static_cast<std::uint32_t>(at.j)));
  };
  const Real highest = height_along(sample) + height;
  return std::ranges::all_of(neighbours, [&](const Sample& step) {
    const Sample next{sample.i + step.i, sample.j + step.j};
    const bool is_there = next.i >= 0 && next.j >= 0 && next.i < field.columns && next.j < field.rows;
    return !is_there || (second && !are_joined(next, *second)) || height_along(next) <= highest;
  });
}

Result<HeightField> HeightField::make(std::span<const Real> parameters, std::span<const Real> reals,
                                      std::span<const std::uint32_t> indices) {
  if (Fault fault = check_count("parameter_count", parameters.size(), 4)) {
    return *fault;
  }
  if (Fault fault = check_count("index_count", indices.size(), 0)) {
    return *fault;
  }
  for (std::size_t i = 0; i < 2; ++i) {
    if (Fault fault = check_samples(parameter_names[i], parameters[i])) {
      return *fault;
    }
    if (Fault fault = check_positive(parameter_names[i + 2], parameters[i + 2])) {
      return *fault;
    }
  }
  const auto columns = static_cast<std::uint32_t>(parameters[0]), rows = static_cast<std::uint32_t>(parameters[1]);
  if (reals.empty()) {
    return Error{Errc::empty, "heights is empty; a height field needs columns * rows of them"};
  }
  if (Fault fault = check_count("real_count", reals.size(), std::size_t{columns} * rows)) {
    return *fault;
  }
  if (Fault fault = check_all_finite("heights", reals)) {
    return *fault;
  }
  RangePyramid ranges(reals, columns);
  const auto [low, high] = ranges.whole();
  const Aabb box{{0, 0, low}, {(columns - 1) * parameters[2], (rows - 1) * parameters[3], high}};
  return HeightField(
      Data{columns, rows, parameters[2], parameters[3], {reals.begin(), reals.end()}, std::move(ranges), box});
}

std::optional<RayHit> HeightField::cast_ray(const Vec3& origin, const UnitVec3& direction, Real max_distance) const {
  const Data& field = *data_;
  const RaySlabs slabs(origin, direction, field.box);
  const TriangleRay ray(origin, direction);
  const RaySlabs::Stretch over_box = slabs.within(field.box, {0, max_distance});
  Real nearest = max_distance;
  std::uint32_t hit = no_index;
  const auto meet = [&](const TriangleCorners& corners, std::uint32_t index) {
    const auto distance = ray.distance_to(corners, nearest);
    if (distance && (*distance < nearest || index < hit)) {
      nearest = *distance;
      hit = index;
    }
  };
  const auto meet_cell = [&](std::uint32_t i, std::uint32_t j, const RaySlabs::Stretch& over) {
    const Vec3 a = point(i, j), b = point(i + 1, j), c = point(i, j + 1), d = point(i + 1, j + 1);
    const Real low = std::min(std::min(a.z, b.z), std::min(c.z, d.z)),
               high = std::max(std::max(a.z, b.z), std::max(c.z, d.z));
    if (!slabs.within(2, low, high, over).is_empty()) {
      const std::uint32_t index = 2 * (j * (field.columns - 1) + i);
      meet({a, b, d}, index);
      meet({a, d, c}, index + 1);
    }
  };
  field.ranges.visit_ray(slabs, over_box, {field.spacing_x, field.spacing_y}, nearest, meet_cell);
  return hit == no_index ? std::nullopt : std::optional(RayHit{nearest, part(hit).normal(), {FeatureKind::face, hit}});
}

Triangles HeightField::triangles() const {
  const Data& field = *data_;
  Triangles out;
  for (std::uint32_t j = 0; j < field.rows; ++j) {
    for (std::uint32_t i = 0; i < field.columns; ++i) {
      out.vertices.push_back(point(i, j));
      if (i + 1 < field.columns && j + 1 < field.rows) {
        const std::uint32_t k = j * field.columns + i, above = k + field.columns;
        out.indices.insert(out.indices.end(), {k, k + 1, above + 1, k, above + 1, above});
      }
    }
  }
  return out;
}

std::vector<HeightField> HeightField::samples() {
  std::vector<Real> hills;
  for (int j = 0; j < 6; ++j) {
    for (int i = 0; i < 8; ++i) {
      hills.push_back(0.5 * std::sin(1.3 * i) * std::cos(0.9 * j));
    }
  }
  const auto grid = std::to_array<Real>({8, 6, 0.5, 0.75}), cell = std::to_array<Real>({2, 2, 4, 4});
  const auto flat = std::to_array<Real>({0, 0, 0, 0});
  return {make(grid, hills, {}).value(), make(cell, flat, {}).value()};
}

}  // namespace abut
