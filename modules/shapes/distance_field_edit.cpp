// SPDX-License-Identifier: Apache-2.0
module abut.shapes.distance_field;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.shapes.distance_field_ways;
import abut.trees.sparse_blocks;

namespace abut {
namespace {

struct StretchNames {
  std::string_view first, count;
};

Fault check_stretch(const StretchNames& names, std::uint32_t first, std::uint32_t count, std::uint32_t all) {
  if (first > all) {
    return error_about(Errc::index_out_of_range, names.first, std::uint64_t{first}, "at most " + std::to_string(all));
  }
  if (count > all - first) {
    return error_about(
        Errc::index_out_of_range, names.count, std::uint64_t{count},
        "at most " + std::to_string(all - first) + ", as " + std::string(names.first) + " is " + std::to_string(first));
  }
  return std::nullopt;
}

}  // namespace

Fault DistanceField::check(const FieldEdit& edit) const {
  const GridPlace& all = data_->blocks.samples();
  if (Fault fault = check_stretch({"column", "columns"}, edit.column, edit.columns, all.x)) {
    return fault;
  }
  if (Fault fault = check_stretch({"row", "rows"}, edit.row, edit.rows, all.y)) {
    return fault;
  }
  if (Fault fault = check_stretch({"layer", "layers"}, edit.layer, edit.layers, all.z)) {
    return fault;
  }
  constexpr Real largest_value = 3e38;
  for (std::size_t i = 0; i < edit.values.size(); ++i) {
    if (!(std::fabs(edit.values[i]) <= largest_value)) {
      const std::string value = "values[" + std::to_string(i) + "]";
      const Fault fault = check_finite(value, edit.values[i]);
      return fault ? fault : error_about(Errc::out_of_range, value, edit.values[i], "at most 3e38 in magnitude");
    }
  }
  const GridBox box{{edit.column, edit.row, edit.layer}, {edit.columns, edit.rows, edit.layers}};
  if (!edit.values.empty() && !data_->blocks.holds(box)) {
    return Error{Errc::unsupported, "values are set where the distance field holds no samples, far from its surface"};
  }
  return std::nullopt;
}

// Outside of the box of changed values others meet what they met: the values are the same, and the search is while
// slopes are bounded as before. From a point in the solid the surface may be as far as the solid is deep.
Aabb DistanceField::apply(const FieldEdit& edit) {
  if (edit.values.empty()) {
    return Aabb::empty();
  }
  Data& field = data_.own();
  const GridBox box{{edit.column, edit.row, edit.layer}, {edit.columns, edit.rows, edit.layers}};
  const auto deepest = [&] {
    Real most = 0;
    for (const SparseBlocks::Block& block : field.blocks.blocks()) {
      most = std::max(most, -static_cast<Real>(block.low));
    }
    return most;
  };
  const Real before = deepest();
  const Aabb solid = field.solid;
  using Bounds = std::array<Real, sizeof(DistanceFieldWays) / sizeof(Real)>;
  const auto bounds_of_slopes = [&] { return std::pair(field.steepest, std::bit_cast<Bounds>(field.ways)); };
  const auto slopes_before = bounds_of_slopes();
  field.blocks.set(box, [&](const GridPlace& at) {
    const std::size_t from =
        (std::size_t{at.z - edit.layer} * edit.rows + (at.y - edit.row)) * edit.columns + (at.x - edit.column);
    return limited(field, at, edit.values[from]);
  });
  measure(field, box);
  if (field.is_inside_out || solid.low != field.solid.low || solid.high != field.solid.high ||
      bounds_of_slopes() != slopes_before) {
    return Aabb::everything();
  }
  const auto placed = [&](Real x, Real y, Real z) {
    return field.origin + Vec3{x * field.spacing.x, y * field.spacing.y, z * field.spacing.z};
  };
  // A sample counts in the cells on both of its sides.
  const Aabb changed{placed(edit.column - 1.0, edit.row - 1.0, edit.layer - 1.0),
                     placed(static_cast<Real>(edit.column) + edit.columns, static_cast<Real>(edit.row) + edit.rows,
                            static_cast<Real>(edit.layer) + edit.layers)};
  return changed.inflated(std::max(before, deepest()));
}

}  // namespace abut
