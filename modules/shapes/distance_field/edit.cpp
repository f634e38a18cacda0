// SPDX-License-Identifier: Apache-2.0
module abut.shapes.distance_field;
import abut.capability;
import abut.capability.grid_checks;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.trees.samples.sparse_blocks;

namespace abut {

Fault DistanceField::check(const FieldEdit& edit) const {
  const GridPlace& all = data_->blocks.samples();
  if (Fault fault = check_stretch({"column", "columns", edit.column, edit.columns}, all.x)) {
    return fault;
  }
  if (Fault fault = check_stretch({"row", "rows", edit.row, edit.rows}, all.y)) {
    return fault;
  }
  if (Fault fault = check_stretch({"layer", "layers", edit.layer, edit.layers}, all.z)) {
    return fault;
  }
  if (Fault fault = check_field_values(edit.values)) {
    return fault;
  }
  const GridBox box{{edit.column, edit.row, edit.layer}, {edit.columns, edit.rows, edit.layers}};
  if (!edit.values.empty() && !data_->blocks.holds(box)) {
    return Error{Errc::unsupported, "values are set where the distance field holds no samples, far from its surface"};
  }
  return std::nullopt;
}

// A body deep in the solid searches all of it for the surface, so any change may reach it.
Aabb DistanceField::apply(const FieldEdit& edit) {
  if (edit.values.empty()) {
    return Aabb::empty();
  }
  Data& field = data_.own();
  const GridBox box{{edit.column, edit.row, edit.layer}, {edit.columns, edit.rows, edit.layers}};
  field.blocks.set(box, [&](const GridPlace& at) {
    const std::size_t from =
        (std::size_t{at.z - edit.layer} * edit.rows + (at.y - edit.row)) * edit.columns + (at.x - edit.column);
    return limited(field, at, edit.values[from]);
  });
  measure(field, box);
  return Aabb::everything();
}

}  // namespace abut
