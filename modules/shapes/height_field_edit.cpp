// SPDX-License-Identifier: Apache-2.0
module abut.shapes.height_field;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;

namespace abut {
namespace {

// How many cells further than the changed ones contacts change: whether an edge dips depends on both of its sides.
constexpr Real cells_beyond = 1;

Fault check_stretch(std::string_view first_name, std::string_view count_name, std::uint32_t first, std::uint32_t count,
                    std::uint32_t all) {
  if (first > all) {
    return error_about(Errc::index_out_of_range, first_name, std::uint64_t{first}, "at most " + std::to_string(all));
  }
  if (count > all - first) {
    return error_about(
        Errc::index_out_of_range, count_name, std::uint64_t{count},
        "at most " + std::to_string(all - first) + ", as " + std::string(first_name) + " is " + std::to_string(first));
  }
  return std::nullopt;
}

}  // namespace

Fault HeightField::check(const HeightEdit& edit) const {
  if (Fault fault = check_stretch("column", "columns", edit.column, edit.columns, data_->columns)) {
    return fault;
  }
  if (Fault fault = check_stretch("row", "rows", edit.row, edit.rows, data_->rows)) {
    return fault;
  }
  return check_all_finite("heights", edit.heights);
}

Aabb HeightField::apply(const HeightEdit& edit) {
  Data& field = data_.own();
  for (std::uint32_t j = 0; j < edit.rows; ++j) {
    const std::span<const Real> from = edit.heights.subspan(std::size_t{j} * edit.columns, edit.columns);
    std::ranges::copy(
        from, std::span(field.heights).subspan(std::size_t{edit.row + j} * field.columns + edit.column).begin());
  }
  field.ranges.update(field.heights, {edit.column, edit.row, edit.columns, edit.rows});
  const auto [low, high] = field.ranges.whole();
  if (low != std::exchange(field.box.low.z, low) || high != std::exchange(field.box.high.z, high)) {
    return Aabb::everything();
  }
  const Real before = 1 + cells_beyond, after = cells_beyond;
  return {
      {(edit.column - before) * field.spacing_x, (edit.row - before) * field.spacing_y, low},
      {(edit.column + edit.columns + after) * field.spacing_x, (edit.row + edit.rows + after) * field.spacing_y, high}};
}

}  // namespace abut
