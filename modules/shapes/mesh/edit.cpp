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

// Where no query has needed the tree so far, there is nothing to follow the change. A grid has it soon, and mostly
// changes here and there: what it costs to follow does not grow with all triangles then.
void Mesh::make_room_for_change(bool follows_vertices) {
  make_room_in_other();
  if (follows_vertices && data_.own().inside.is_made()) {
    static_cast<void>(neighbours());
  }
  if (data_->cells) {
    static_cast<void>(tree());
  }
  if (std::optional<Bvh>& tree = data_.own().tree.made()) {
    if (follows_vertices) {
      static_cast<void>(neighbours());
    }
    tree->make_room();
  }
}

void Mesh::make_room(const RecreationEdit& edit) {
  Data& data = data_.own();
  data.vertices.reserve(edit.reals.size() / 3);
  data.indices.reserve(edit.indices.size());
}

// After triangles have moved or gone: the tree and the box follow. `touched`: the sides of the box at which something
// of them was, low ones before high ones; `moved`: around their new places.
Aabb Mesh::follow(std::uint32_t touched, const Aabb& moved) {
  Data& data = data_.own();
  Bvh& tree = *data.tree.made();
  const Aabb changed = tree.settle(), before = data.box;
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
  // What is inside of a solid may change anywhere. Whether an edge dips depends on the triangles that share a corner
  // with it, which reach so much further.
  const Vec3 reach = data.widest;
  const bool has_same_box = before.low == data.box.low && before.high == data.box.high;
  settle_inside();
  return has_same_box && !is_solid() ? Aabb{changed.low - reach, changed.high + reach} : Aabb::everything();
}

namespace {

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
    return follow_all();
  }
  std::uint32_t touched = 0;
  for (std::size_t i = 0; i < count; ++i) {
    touched |= sides_touched(data.box, data.vertices[moved_vertex(edit, i)]);
  }
  place(edit);
  follow_inside(edit);
  if (!data.tree.is_made()) {
    data.box = box_of(data);
    settle_inside();
    return Aabb::everything();
  }
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
      data.widest = maximum(data.widest, box.high - box.low);
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
  return follow(touched, moved);
}

Aabb Mesh::apply(const RemovalEdit& edit) {
  Data& data = data_.own();
  if (edit.triangles.empty()) {
    return {data.box.low, data.box.low};
  }
  std::uint32_t touched = 0;
  std::optional<Bvh>& tree = data.tree.made();
  for (const std::uint32_t triangle : edit.triangles) {
    if (has_gone(triangle)) {
      continue;
    }
    for (const Vec3& corner : corners(triangle)) {
      touched |= sides_touched(data.box, corner);
    }
    take_out(triangle);
    if (tree) {
      tree->move(triangle, Aabb::empty());
    }
    touch_in_other(triangle);
  }
  settle_other();
  if (!tree) {
    data.box = box_of(data);
    return Aabb::everything();
  }
  return follow(touched, Aabb::empty());
}

void Mesh::place(const VertexEdit& edit) {
  Data& data = data_.own();
  for (std::size_t i = 0; i < edit.xyz.size() / 3; ++i) {
    data.vertices[moved_vertex(edit, i)] = {edit.xyz[3 * i], edit.xyz[3 * i + 1], edit.xyz[3 * i + 2]};
  }
}

// After any number of vertices have moved: all that was made of them is fitted, in one pass each.
Aabb Mesh::follow_all() {
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
  if (!data.tree.is_made()) {
    data.box = box_of(data);
    settle_inside();
    return Aabb::everything();
  }
  Aabb box = Aabb::empty();
  Vec3 widest{0, 0, 0};
  Bvh& tree = *data.tree.made();
  tree.move_all([&](std::uint32_t triangle) {
    const Aabb its = box_around(corners(triangle));
    box.include(its);
    widest = maximum(widest, its.high - its.low);
    return its;
  });
  if (data.other.is_made()) {
    visit_present([&](std::uint32_t triangle) { touch_in_other(triangle); });
    settle_other();
  }
  const Aabb changed = tree.settle(), before = std::exchange(data.box, box);
  // As far as triangles beside those that moved reach, before and after.
  const Vec3 reach = maximum(widest, std::exchange(data.widest, widest));
  settle_inside();
  const bool has_same_box = before.low == box.low && before.high == box.high;
  return has_same_box && !is_solid() ? Aabb{changed.low - reach, changed.high + reach} : Aabb::everything();
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
  return follow_all();
}

void Mesh::take_out(std::uint32_t triangle) {
  Data& data = data_.own();
  data.inside.forget();
  --data.present;
  if (std::optional<MeshNeighbours>& neighbours = data.neighbours.made()) {
    neighbours->remove(triangle, data.indices);
  } else {
    const std::size_t first = 3 * std::size_t{triangle};
    data.indices[first + 1] = data.indices[first + 2] = data.indices[first];
  }
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
