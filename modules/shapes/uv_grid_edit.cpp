// SPDX-License-Identifier: Apache-2.0
module abut.shapes.uv_grid;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.shapes.mesh;
import abut.trees.uv_cells;

namespace abut {

// Vertices move along the axis that is none of the grid. So triangles stay in their cells.
Fault UvGrid::check(const VertexEdit& edit) const {
  if (Fault fault = data_->mesh.check(edit)) {
    return fault;
  }
  constexpr std::array<std::string_view, 3> names{"X", "Y", "Z"};
  const UvCells::Plan& plan = data_->plan;
  const std::string height(names[static_cast<std::size_t>(3 - plan.u - plan.v)]);
  for (std::size_t i = 0; i < edit.xyz.size() / 3; ++i) {
    const std::uint32_t vertex = moved_vertex(edit, i);
    const Vec3& present = data_->mesh.vertex(vertex);
    for (const int axis : {plan.u, plan.v}) {
      const std::size_t at = 3 * i + static_cast<std::size_t>(axis);
      if (edit.xyz[at] != present[axis]) {
        return error_about(Errc::out_of_range, "xyz[" + std::to_string(at) + "]", edit.xyz[at],
                           to_text(present[axis]) + ", as vertex " + std::to_string(vertex) +
                               " of a uv_grid moves along " + height + " only");
      }
    }
  }
  return std::nullopt;
}

// The cells and the neighbours have to be there: changes keep them up to date.
void UvGrid::make_room_for_change() {
  Data& grid = data_.own();
  grid.mesh.find_neighbours();
  grid.mesh.make_room_for_change();
  static_cast<void>(cells());
  grid.cells.made()->make_room();
}

Aabb UvGrid::apply(const VertexEdit& edit) {
  Data& grid = data_.own();
  Mesh& mesh = grid.mesh;
  // Whether an edge dips depends on both of its sides.
  Aabb changed = Aabb::empty();
  const auto include_around = [&] {
    mesh.visit_moved(edit, [&](std::uint32_t triangle) { changed.include(mesh.box_beside(triangle)); });
  };
  include_around();
  mesh.place(edit);
  include_around();
  mesh.visit_moved(edit, [&](std::uint32_t triangle) {
    grid.cells.made()->fit(triangle, [&](std::uint32_t of) { return box_around(mesh.corners(of)); });
    mesh.follow_in_tree(triangle);
  });
  return follow(changed);
}

Aabb UvGrid::apply(const RemovalEdit& edit) {
  Data& grid = data_.own();
  Mesh& mesh = grid.mesh;
  Aabb changed = Aabb::empty();
  for (const std::uint32_t triangle : edit.triangles) {
    if (!mesh.has_gone(triangle)) {
      changed.include(mesh.box_beside(triangle));
      grid.cells.made()->remove(triangle, [&](std::uint32_t of) { return box_around(mesh.corners(of)); });
      mesh.take_out(triangle);
      mesh.follow_in_tree(triangle);
    }
  }
  return follow(changed);
}

Aabb UvGrid::apply(const RecreationEdit& edit) {
  Data& grid = data_.own();
  grid.cells.forget();
  return grid.mesh.apply(edit);
}

// What is inside of a solid may change anywhere.
Aabb UvGrid::follow(const Aabb& changed) {
  Data& grid = data_.own();
  if (!(changed.low.x <= changed.high.x)) {
    const Vec3 corner = grid.mesh.aabb(Pose::identity()).low;
    return {corner, corner};
  }
  const Aabb before = grid.mesh.aabb(Pose::identity()), box = grid.cells.made()->bounds();
  grid.mesh.set_box(box);
  grid.mesh.settle();
  if (grid.cells.made()->is_worn()) {
    grid.cells.forget();
  }
  const bool has_same_box = before.low == box.low && before.high == box.high;
  return has_same_box && !is_solid() ? changed : Aabb::everything();
}

}  // namespace abut
