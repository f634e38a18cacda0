// SPDX-License-Identifier: Apache-2.0
module abut.shapes.height_field;
import abut.capability;
import abut.capability.grid_checks;
import abut.core.standard;
import abut.core;
import abut.core.joined_sets;
import abut.math;
import abut.trees.grids.range_pyramid;

namespace abut {
namespace {

Fault check_heights(std::span<const Real> heights) {
  for (std::size_t i = 0; i < heights.size(); ++i) {
    if (!(std::fabs(heights[i]) <= largest_coordinate) && !std::isnan(heights[i])) {
      return check_finite("heights[" + std::to_string(i) + "]", heights[i]);
    }
  }
  return std::nullopt;
}

bool has_holes(std::span<const Real> heights) {
  return std::ranges::any_of(heights, [](Real height) { return std::isnan(height); });
}

Error no_triangle() {
  return {Errc::empty, "heights is NaN in every triangle; a height field needs at least one triangle"};
}

// How many cells further than the changed ones contacts change: whether an edge dips depends on both of its sides.
constexpr Real cells_beyond = 1;

}  // namespace

template <class HeightAt>
std::uint64_t HeightField::count_triangles(const RangePyramid::Rectangle& cells, Diagonal diagonal,
                                           const HeightAt& height_at) {
  std::uint64_t count = 0;
  for (std::uint32_t j = cells.row; j < cells.row + cells.rows; ++j) {
    for (std::uint32_t i = cells.column; i < cells.column + cells.columns; ++i) {
      const Cell cell{{0, 0, height_at(i, j)},
                      {0, 0, height_at(i + 1, j)},
                      {0, 0, height_at(i, j + 1)},
                      {0, 0, height_at(i + 1, j + 1)},
                      is_falling(diagonal, i, j)};
      count += (is_there(cell.triangle(false)) ? 1u : 0u) + (is_there(cell.triangle(true)) ? 1u : 0u);
    }
  }
  return count;
}

Result<HeightField> HeightField::make(std::span<const Real> parameters, std::span<const Real> reals,
                                      std::span<const std::uint32_t> indices) {
  // The last two may be left out.
  if (parameters.size() != 4 && parameters.size() != 5) {
    if (Fault fault = check_count("parameter_count", parameters.size(), parameter_names.size())) {
      return *fault;
    }
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
  const Real split = parameters.size() > 4 ? parameters[4] : 0, below = parameters.size() > 5 ? parameters[5] : 0;
  if (split != 0 && split != 1 && split != 2) {
    return error_about(Errc::unknown_value, "diagonal", split, "0 (rising), 1 (falling) or 2 (alternating)");
  }
  if (below != 0 && below != 1) {
    return error_about(Errc::unknown_value, "solid_below", below, "0 (open) or 1 (solid)");
  }
  const auto columns = static_cast<std::uint32_t>(parameters[0]), rows = static_cast<std::uint32_t>(parameters[1]);
  // Two triangles of each cell have a number, and so have as many of the base.
  const std::uint64_t most_samples = std::uint64_t{1} << (below == 1 ? 29 : 30);
  if (const std::uint64_t samples = std::uint64_t{columns} * rows; samples > most_samples) {
    return error_about(Errc::size_overflow, "columns * rows", samples, "at most " + std::to_string(most_samples));
  }
  if (reals.empty()) {
    return Error{Errc::empty, "heights is empty; a height field needs columns * rows of them"};
  }
  if (Fault fault = check_count("real_count", reals.size(), std::size_t{columns} * rows)) {
    return *fault;
  }
  if (Fault fault = check_heights(reals)) {
    return *fault;
  }
  const auto diagonal = static_cast<Diagonal>(split);
  const RangePyramid::Rectangle cells{0, 0, columns - 1, rows - 1};
  const std::uint64_t triangle_count =
      has_holes(reals)
          ? count_triangles(cells, diagonal,
                            [&](std::uint32_t i, std::uint32_t j) { return reals[std::size_t{j} * columns + i]; })
          : std::uint64_t{2} * cells.columns * cells.rows;
  if (triangle_count == 0) {
    return no_triangle();
  }
  RangePyramid ranges(reals, columns);
  const auto [low, high] = ranges.whole();
  const Aabb box{{0, 0, low}, {(columns - 1) * parameters[2], (rows - 1) * parameters[3], high}};
  Data data{columns,           rows, parameters[2], parameters[3], diagonal, below == 1, {reals.begin(), reals.end()},
            std::move(ranges), box,  triangle_count};
  data.box.low.z = data.floor_below(low);
  return HeightField(std::move(data));
}

// The triangles around the samples of an edit that come less those that go.
std::int64_t HeightField::change_of_count(const HeightEdit& edit) const {
  const Data& field = *data_;
  const std::uint64_t all = std::uint64_t{2} * (field.columns - 1) * (field.rows - 1);
  if (edit.heights.empty() || (field.triangle_count == all && !has_holes(edit.heights))) {
    return 0;
  }
  const std::uint32_t i = edit.column > 0 ? edit.column - 1 : 0, j = edit.row > 0 ? edit.row - 1 : 0;
  const RangePyramid::Rectangle cells{i, j, std::min(edit.column + edit.columns, field.columns - 1) - i,
                                      std::min(edit.row + edit.rows, field.rows - 1) - j};
  const auto before = [&](std::uint32_t column, std::uint32_t row) { return height(column, row); };
  const auto after = [&](std::uint32_t column, std::uint32_t row) {
    const bool is_new =
        column >= edit.column && column - edit.column < edit.columns && row >= edit.row && row - edit.row < edit.rows;
    return is_new ? edit.heights[std::size_t{row - edit.row} * edit.columns + (column - edit.column)]
                  : height(column, row);
  };
  return static_cast<std::int64_t>(count_triangles(cells, field.diagonal, after)) -
         static_cast<std::int64_t>(count_triangles(cells, field.diagonal, before));
}

// A field without holes is one piece. What holes leave is joined by the samples that triangles share.
std::vector<Vec3> HeightField::find_pieces() const {
  if (!lacks_triangles()) {
    return {point(0, 0)};
  }
  JoinedSets joined(data_->heights.size());
  std::vector<std::uint32_t> samples;  // one of each triangle
  for (std::uint32_t index = 0; index < triangle_count(); ++index) {
    if (is_there(corners_in_grid(index))) {
      const std::uint32_t cell = index / 2, columns = data_->columns;
      const auto at = samples_of(cell % (columns - 1), cell / (columns - 1), index % 2 != 0);
      const auto number = [columns](const Sample& sample) { return sample.j * columns + sample.i; };
      joined.join(number(at[0]), number(at[1]));
      joined.join(number(at[0]), number(at[2]));
      samples.push_back(number(at[0]));
    }
  }
  for (std::uint32_t& sample : samples) {
    sample = joined.of(sample);
  }
  std::ranges::sort(samples);
  samples.erase(std::unique(samples.begin(), samples.end()), samples.end());
  std::vector<Vec3> pieces;
  for (const std::uint32_t sample : samples) {
    pieces.push_back(point(sample % data_->columns, sample / data_->columns));
  }
  return pieces;
}

Fault HeightField::check(const HeightEdit& edit) const {
  if (Fault fault = check_stretch({"column", "columns", edit.column, edit.columns}, data_->columns)) {
    return fault;
  }
  if (Fault fault = check_stretch({"row", "rows", edit.row, edit.rows}, data_->rows)) {
    return fault;
  }
  if (Fault fault = check_heights(edit.heights)) {
    return fault;
  }
  const auto count = static_cast<std::int64_t>(data_->triangle_count);
  return count + change_of_count(edit) == 0 ? Fault(no_triangle()) : std::nullopt;
}

Aabb HeightField::apply(const HeightEdit& edit) {
  Data& field = data_.own();
  field.pieces.forget();
  field.triangle_count += static_cast<std::uint64_t>(change_of_count(edit));
  for (std::uint32_t j = 0; j < edit.rows; ++j) {
    const std::span<const Real> from = edit.heights.subspan(std::size_t{j} * edit.columns, edit.columns);
    std::ranges::copy(
        from, std::span(field.heights).subspan(std::size_t{edit.row + j} * field.columns + edit.column).begin());
  }
  field.ranges.update(field.heights, {edit.column, edit.row, edit.columns, edit.rows});
  const auto [lowest, high] = field.ranges.whole();
  const Real low = field.floor_below(lowest);
  const bool has_same_box = low == field.box.low.z && high == field.box.high.z;
  field.box.low.z = low;
  field.box.high.z = high;
  if (!has_same_box) {
    return Aabb::everything();
  }
  const Real before = 1 + cells_beyond, after = cells_beyond;
  return {
      {(edit.column - before) * field.spacing_x, (edit.row - before) * field.spacing_y, low},
      {(edit.column + edit.columns + after) * field.spacing_x, (edit.row + edit.rows + after) * field.spacing_y, high}};
}

std::vector<HeightField> HeightField::samples() {
  std::vector<Real> hills;
  for (int j = 0; j < 6; ++j) {
    for (int i = 0; i < 8; ++i) {
      hills.push_back(0.5 * std::sin(1.3 * i) * std::cos(0.9 * j));
    }
  }
  const auto grid = std::to_array<Real>({8, 6, 0.5, 0.75, 0, 0}), cell = std::to_array<Real>({2, 2, 4, 4, 0, 0});
  const auto flat = std::to_array<Real>({0, 0, 0, 0});
  return {make(grid, hills, {}).value(), make(cell, flat, {}).value()};
}

}  // namespace abut
