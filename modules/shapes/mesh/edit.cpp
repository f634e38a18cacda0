// SPDX-License-Identifier: Apache-2.0
module abut.shapes.mesh;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.shapes.mesh.inside;
import abut.shapes.mesh.neighbours;
import abut.trees.boxes.bvh;
import abut.triangles.buffers;

namespace abut {

Fault Mesh::check(const VertexEdit& edit) const {
  const std::size_t all = data_->vertices.size(), count = edit.xyz.size() / 3;
  if (edit.first > all) {
    return error_about(Errc::index_out_of_range, "first", std::uint64_t{edit.first}, "at most " + std::to_string(all));
  }
  if (edit.vertices.empty() && count > all - edit.first) {
    return error_about(Errc::index_out_of_range, "count", std::uint64_t{count},
                       "at most " + std::to_string(all - edit.first) + ", as first is " + std::to_string(edit.first));
  }
  for (std::size_t i = 0; i < edit.vertices.size(); ++i) {
    if (edit.vertices[i] >= all) {
      return error_about(Errc::index_out_of_range, "vertices[" + std::to_string(i) + "]",
                         std::uint64_t{edit.vertices[i]}, "below the vertices, which are " + std::to_string(all));
    }
  }
  if (Fault fault = check_all_finite("xyz", edit.xyz)) {
    return fault;
  }
  return check_stays_in_cells(edit);
}

Fault Mesh::check(const RemovalEdit& edit) const {
  const std::span<const std::uint32_t> indices = data_->indices;
  const std::size_t all = triangle_count();
  for (std::size_t i = 0; i < edit.triangles.size(); ++i) {
    if (edit.triangles[i] >= all) {
      return error_about(Errc::index_out_of_range, "triangles[" + std::to_string(i) + "]",
                         std::uint64_t{edit.triangles[i]}, "below the triangles, which are " + std::to_string(all));
    }
  }
  if (edit.triangles.size() < data_->present) {
    return std::nullopt;
  }
  std::vector<std::uint32_t> going(edit.triangles.begin(), edit.triangles.end());
  std::ranges::sort(going);
  going.erase(std::unique(going.begin(), going.end()), going.end());
  std::erase_if(going, [&](std::uint32_t triangle) { return is_removed(indices, triangle); });
  if (going.size() == data_->present) {
    return error_about(Errc::empty, "count", std::uint64_t{edit.triangles.size()},
                       "less, as that leaves no triangle; a mesh needs at least one");
  }
  return std::nullopt;
}

Fault Mesh::check(const RecreationEdit& edit) const { return check_triangles("a mesh", edit.reals, edit.indices); }

// Where no query has needed the tree so far, no tree follows the change. A grid has it soon, and mostly changes here
// and there: what it costs to follow does not grow with all triangles then. The neighbours tell what a change reaches.
// That must not depend on the queries so far, as it tells who wakes.
void Mesh::make_room_for_change(bool follows_vertices) {
  make_room_in_other();
  if (follows_vertices) {
    static_cast<void>(neighbours());
  }
  if (data_->cells) {
    static_cast<void>(tree());
  }
  if (std::optional<Bvh>& tree = data_.own().tree.made()) {
    tree->make_room();
  }
}

void Mesh::make_room(const RecreationEdit& edit) {
  Data& data = data_.own();
  data.vertices.reserve(edit.reals.size() / 3);
  data.indices.reserve(edit.indices.size());
}

// After triangles have moved or gone: the tree and the box follow. `touched`: the sides of the box at which something
// of them was, low ones before high ones; `moved`: around their new places. Whether the box stays as it was.
bool Mesh::follow(std::uint32_t touched, const Aabb& moved) {
  Data& data = data_.own();
  const Aabb before = data.box;
  if (!data.tree.is_made()) {
    data.box = box_of(data);
    settle_inside();
    return before.low == data.box.low && before.high == data.box.high;
  }
  Bvh& tree = *data.tree.made();
  static_cast<void>(tree.settle());
  for (std::size_t side = 0; side < 6; ++side) {
    const Real sign = side < 3 ? 1 : -1;
    const auto axis = static_cast<int>(side % 3);
    const auto at = [&](const Aabb& box) { return sign * (side < 3 ? box.low : box.high)[axis]; };
    Real value = std::min(at(before), at(moved));
    if ((touched & 1u << side) != 0 && at(moved) > at(before)) {
      value = tree.least(side, at(before), [&](std::uint32_t triangle) { return at(present_box(triangle)); });
    }
    Vec3& bound = side < 3 ? data.box.low : data.box.high;
    (axis == 0 ? bound.x : axis == 1 ? bound.y : bound.z) = sign * value;
  }
  settle_inside();
  return before.low == data.box.low && before.high == data.box.high;
}

namespace {

// What changes with a triangle that has this corner: whether an edge dips depends on all triangles around its ends.
template <class BoxOf>
void include_around(Aabb& box, std::uint32_t corner, const MeshNeighbours& neighbours, const BoxOf& box_of) {
  for (const std::uint32_t triangle : neighbours.around_vertex(corner)) {
    box.include(box_of(triangle));
  }
}

std::uint32_t sides_touched(const Aabb& box, const Vec3& point) {
  return (point.x <= box.low.x ? 1u : 0u) | (point.y <= box.low.y ? 2u : 0u) | (point.z <= box.low.z ? 4u : 0u) |
         (point.x >= box.high.x ? 8u : 0u) | (point.y >= box.high.y ? 16u : 0u) | (point.z >= box.high.z ? 32u : 0u);
}

}  // namespace

Aabb Mesh::apply(const VertexEdit& edit) {
  Data& data = data_.own();
  const std::size_t count = edit.xyz.size() / 3;
  if (count == 0) {
    return {data.box.low, data.box.low};
  }
  if (moves_most(edit)) {
    place(edit);
    follow_all();
    return Aabb::everything();
  }
  std::uint32_t touched = 0;
  // Where triangles were is around the old places of vertices and the new places of the triangles.
  Aabb changed = Aabb::empty();
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3& before = data.vertices[moved_vertex(edit, i)];
    touched |= sides_touched(data.box, before);
    changed.include(before);
  }
  place(edit);
  follow_inside(edit);
  const bool has_same_box = follow(touched, data.tree.is_made() ? move_in_tree(edit) : Aabb::empty());
  // What is inside of a solid may change anywhere.
  if (!has_same_box || is_solid()) {
    return Aabb::everything();
  }
  const auto box_of_present = [this](std::uint32_t triangle) { return present_box(triangle); };
  // Around a vertex in the midst of a range are triangles that move alone.
  const auto is_in_range = [&](std::uint32_t vertex) { return edit.vertices.empty() && vertex - edit.first < count; };
  visit_moved(edit, [&](std::uint32_t triangle) {
    changed.include(box_of_present(triangle));
    for (const std::uint32_t corner : std::span(data.indices).subspan(3 * std::size_t{triangle}, 3)) {
      if (!is_in_range(corner)) {
        include_around(changed, corner, neighbours(), box_of_present);
      }
    }
  });
  return changed;
}

// Around the new places of the triangles that move.
Aabb Mesh::move_in_tree(const VertexEdit& edit) {
  Data& data = data_.own();
  Bvh& tree = *data.tree.made();
  Aabb moved = Aabb::empty();
  // Vertices that are scattered lie anywhere in the memory. So what a block of triangles needs is asked for at once.
  SmallVector<std::uint32_t, 64> block;
  const auto move_block = [&] {
    for (const std::uint32_t triangle : block.span()) {
      fetch_corners(triangle);
      tree.fetch_node_of(triangle);
    }
    for (const std::uint32_t triangle : block.span()) {
      const Aabb box = box_around(corners(triangle));
      tree.move(triangle, box);
      touch_in_other(triangle);
      moved.include(box);
    }
    block.clear();
  };
  visit_moved(edit, [&](std::uint32_t triangle) {
    tree.fetch_place(triangle);
    block.push_back(triangle);
    if (block.size() == 64) {
      move_block();
    }
  });
  move_block();
  settle_other();
  return moved;
}

Aabb Mesh::apply(const RemovalEdit& edit) {
  Data& data = data_.own();
  if (edit.triangles.empty()) {
    return {data.box.low, data.box.low};
  }
  std::uint32_t touched = 0;
  Aabb changed = Aabb::empty();
  const auto box_of_present = [this](std::uint32_t triangle) { return present_box(triangle); };
  std::optional<Bvh>& tree = data.tree.made();
  for (const std::uint32_t triangle : edit.triangles) {
    if (has_gone(triangle)) {
      continue;
    }
    for (const Vec3& corner : corners(triangle)) {
      touched |= sides_touched(data.box, corner);
    }
    for (const std::uint32_t corner : std::span(data.indices).subspan(3 * std::size_t{triangle}, 3)) {
      include_around(changed, corner, neighbours(), box_of_present);
    }
    take_out(triangle);
    if (tree) {
      tree->move(triangle, Aabb::empty());
    }
    touch_in_other(triangle);
  }
  settle_other();
  return follow(touched, Aabb::empty()) && !is_solid() ? changed : Aabb::everything();
}

void Mesh::place(const VertexEdit& edit) {
  Data& data = data_.own();
  for (std::size_t i = 0; i < edit.xyz.size() / 3; ++i) {
    data.vertices[moved_vertex(edit, i)] = {edit.xyz[3 * i], edit.xyz[3 * i + 1], edit.xyz[3 * i + 2]};
  }
}

// After any number of vertices have moved: all that was made of them is fitted, in one pass each.
void Mesh::follow_all() {
  Data& data = data_.own();
  const auto visit_present = [&](const auto& visit) {
    for (std::uint32_t triangle = 0; triangle < triangle_count(); ++triangle) {
      if (!has_gone(triangle)) {
        visit(triangle);
      }
    }
  };
  if (std::optional<MeshInside>& inside = data.inside.made()) {
    visit_present([&](std::uint32_t triangle) { inside->move(triangle, data.vertices, data.indices); });
    inside->change_everywhere();
  }
  if (std::optional<Bvh>& tree = data.tree.made()) {
    data.box = Aabb::empty();
    tree->move_all([&](std::uint32_t triangle) {
      const Aabb its = box_around(corners(triangle));
      data.box.include(its);
      return its;
    });
    static_cast<void>(tree->settle());
  } else {
    data.box = box_of(data);
  }
  if (data.other.is_made()) {
    visit_present([&](std::uint32_t triangle) { touch_in_other(triangle); });
    settle_other();
  }
  settle_inside();
}

Fault Mesh::check_next(std::span<const Vec3> next) const {
  const auto name_of = [](std::size_t at) { return "next[" + std::to_string(at) + "]"; };
  for (std::size_t i = 0; i < next.size(); ++i) {
    for (const int axis : {0, 1, 2}) {
      // The name is only put together for a fault. The largest of three numbers may hide a NaN among them.
      if (!(std::fabs(next[i][axis]) <= largest_coordinate)) {
        return check_finite(name_of(3 * i + static_cast<std::size_t>(axis)), next[i][axis]);
      }
    }
  }
  return check_next_stays_in_cells(next);
}

Aabb Mesh::exchange(std::vector<Vec3>& next) {
  data_.own().vertices.swap(next);
  follow_all();
  return Aabb::everything();
}

void Mesh::take_out(std::uint32_t triangle) {
  Data& data = data_.own();
  data.inside.forget();
  --data.present;
  data.neighbours.made()->remove(triangle, data.indices);
}

void Mesh::follow_inside(const VertexEdit& edit) {
  Data& data = data_.own();
  std::optional<MeshInside>& inside = data.inside.made();
  if (!inside) {
    return;
  }
  visit_moved(edit, [&](std::uint32_t triangle) { inside->move(triangle, data.vertices, data.indices); });
  bool is_closed = true;
  for (std::size_t i = 0; is_closed && i < edit.xyz.size() / 3; ++i) {
    is_closed = is_closed_around(moved_vertex(edit, i));
  }
  if (!is_closed) {
    inside->change_everywhere();
  }
}

// Whether of each edge at a vertex as many triangles lead out as in. A vertex of very many counts as open.
bool Mesh::is_closed_around(std::uint32_t vertex) const {
  constexpr std::size_t most = 64;
  SmallVector<std::uint32_t, most> next, last;
  for (const std::uint32_t triangle : neighbours().around_vertex(vertex)) {
    const auto its = std::span(data_->indices).subspan(3 * std::size_t{triangle}, 3);
    for (std::size_t corner = 0; corner < 3; ++corner) {
      if (its[corner] == vertex) {
        if (next.size() == most) {
          return false;
        }
        next.push_back(its[(corner + 1) % 3]);
        last.push_back(its[(corner + 2) % 3]);
      }
    }
  }
  return std::ranges::all_of(next.span(), [&](std::uint32_t other) {
    const auto is_other = [other](std::uint32_t its) { return its == other; };
    return std::ranges::count_if(next.span(), is_other) == std::ranges::count_if(last.span(), is_other);
  });
}

void Mesh::settle_inside() {
  Data& data = data_.own();
  std::optional<MeshInside>& inside = data.inside.made();
  if (inside) {
    inside->settle(data.vertices, data.indices, data.box);
  }
  if (inside && inside->is_worn()) {
    data.inside.forget();
  }
}

Aabb Mesh::apply(const RecreationEdit& edit) {
  Data& data = data_.own();
  fill(data, edit.reals, edit.indices);
  data.tree.forget();
  data.other.forget();
  data.neighbours.forget();
  data.inside.forget();
  return Aabb::everything();
}

}  // namespace abut
