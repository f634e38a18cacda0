module abut.shapes.height_field;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.trees.range_pyramid;

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
  const Vec3 d = direction;
  // The part of the ray over the grid, a little widened against rounding.
  Real enter = 0, leave = max_distance;
  for (int axis = 0; axis < 3; ++axis) {
    const Real low = field.box.low[axis], high = field.box.high[axis];
    const Real slack = 8 * epsilon * (std::fabs(low) + std::fabs(high) + std::fabs(origin[axis]));
    if (d[axis] == 0) {
      if (origin[axis] < low - slack || origin[axis] > high + slack) {
        return std::nullopt;
      }
      continue;
    }
    const Real a = (low - slack - origin[axis]) / d[axis], b = (high + slack - origin[axis]) / d[axis];
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  }
  if (!(enter <= leave)) {
    return std::nullopt;
  }
  const Vec3 start = origin + enter * d;
  std::uint32_t i = cell_at(start.x / field.spacing_x, field.columns),
                j = cell_at(start.y / field.spacing_y, field.rows);
  const auto next_crossing = [](Real from, Real along, Real spacing, std::uint32_t cell) {
    return along == 0 ? infinity : ((along > 0 ? cell + 1 : cell) * spacing - from) / along;
  };
  std::optional<RayHit> best;
  while (true) {
    const std::uint32_t cell = j * (field.columns - 1) + i;
    for (const std::uint32_t index : {2 * cell, 2 * cell + 1}) {
      const auto hit = part(index).cast_ray(origin, direction, max_distance);
      if (hit && (!best || hit->distance < best->distance)) {
        best = hit;
      }
    }
    const Real at_x = next_crossing(origin.x, d.x, field.spacing_x, i),
               at_y = next_crossing(origin.y, d.y, field.spacing_y, j);
    // A hit beyond this cell would be one that rounding let in; the cell that it lies in decides.
    const Real end = std::min(at_x, at_y);
    if ((best && best->distance <= end) || !(end <= leave)) {
      return best;
    }
    if (at_x <= at_y) {
      if (d.x > 0 ? i + 2 >= field.columns : i == 0) {
        return best;
      }
      i = d.x > 0 ? i + 1 : i - 1;
    } else {
      if (d.y > 0 ? j + 2 >= field.rows : j == 0) {
        return best;
      }
      j = d.y > 0 ? j + 1 : j - 1;
    }
  }
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
