// SPDX-License-Identifier: Apache-2.0
module abut.shapes.mesh;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.shapes.mesh.neighbours;
import abut.trees.boxes.bvh;
import abut.trees.grids.cell_order;
import abut.triangles.buffers;

namespace abut {

void Mesh::fill(Data& data, std::span<const Real> reals, std::span<const std::uint32_t> indices) {
  data.indices.assign(indices.begin(), indices.end());
  data.vertices.resize(reals.size() / 3);
  for (std::size_t i = 0; i < data.vertices.size(); ++i) {
    data.vertices[i] = {reals[3 * i], reals[3 * i + 1], reals[3 * i + 2]};
  }
  data.box = box_of(data);
  data.present = 0;
  for (std::uint32_t triangle = 0; triangle < indices.size() / 3; ++triangle) {
    data.present += is_removed(indices, triangle) ? 0 : 1;
  }
}

Aabb Mesh::box_of(const Data& data) {
  Aabb box = Aabb::empty();
  for (std::uint32_t triangle = 0; triangle < data.indices.size() / 3; ++triangle) {
    if (!is_removed(data.indices, triangle)) {
      for (std::size_t corner = 0; corner < 3; ++corner) {
        box.include(data.vertices[data.indices[3 * std::size_t{triangle} + corner]]);
      }
    }
  }
  return box;
}

Result<Mesh> Mesh::make(std::span<const Real> parameters, std::span<const Real> reals,
                        std::span<const std::uint32_t> indices) {
  if (Fault fault = check_count("parameter_count", parameters.size(), parameters.size() == 2 ? 2 : 1)) {
    return *fault;
  }
  if (Fault fault = check_sides(parameters[0])) {
    return *fault;
  }
  const Real tree = parameters.size() == 2 ? parameters[1] : 0;
  if (tree != 0 && tree != 1 && tree != 2 && tree != 3) {
    return error_about(Errc::unknown_value, "tree", tree,
                       "0 (automatic), 1 (boxes), 2 (oriented boxes) or 3 (spheres)");
  }
  if (Fault fault = check_triangles("a mesh", reals, indices)) {
    return *fault;
  }
  return made(static_cast<Sides>(parameters[0]), static_cast<ChosenTree>(tree), std::nullopt, reals, indices);
}

Fault Mesh::check_sides(Real sides) {
  if (sides != 0 && sides != 1 && sides != 2) {
    return error_about(Errc::unknown_value, "sides", sides, "0 (both), 1 (front) or 2 (solid)");
  }
  return std::nullopt;
}

Mesh Mesh::made(Sides sides, ChosenTree chosen, const std::optional<CellPlan>& cells, std::span<const Real> reals,
                std::span<const std::uint32_t> indices) {
  Data data{.sides = sides, .chosen = chosen, .cells = cells};
  fill(data, reals, indices);
  return Mesh(std::move(data));
}

std::vector<Real> Mesh::parameters() const {
  std::vector<Real> numbers{static_cast<Real>(data_->sides)};
  if (const std::optional<CellPlan>& cells = data_->cells) {
    numbers.insert(numbers.end(), {static_cast<Real>(cells->u), static_cast<Real>(cells->v),
                                   static_cast<Real>(cells->columns), static_cast<Real>(cells->rows)});
  } else if (data_->chosen != ChosenTree::automatic) {
    numbers.push_back(static_cast<Real>(data_->chosen));
  }
  return numbers;
}

Bvh Mesh::make_tree(const Workers& workers) const {
  if (data_->cells) {
    std::vector<Aabb> boxes(triangle_count());
    for (std::uint32_t triangle = 0; triangle < boxes.size(); ++triangle) {
      boxes[triangle] = present_box(triangle);
    }
    return Bvh(data_->box, boxes, ordered_by_cells(*data_->cells, data_->box, boxes));
  }
  return Bvh(data_->box, triangle_count(), [this](std::uint32_t triangle) { return present_box(triangle); }, workers);
}

MeshNeighbours Mesh::make_neighbours(const Workers& workers) const {
  return {data_->vertices.size(), data_->indices, workers};
}

void Mesh::prepare(const Workers& workers) const {
  static_cast<void>(data_->tree.get([&] { return make_tree(workers); }));
  if (has_other_tree()) {
    static_cast<void>(other());
  }
  static_cast<void>(data_->neighbours.get([&] { return make_neighbours(workers); }));
  if (is_solid()) {
    static_cast<void>(inside());
  }
}

bool Mesh::is_crest(std::uint32_t index, unsigned corners, const Vec3& direction, Real height) const {
  const Data& mesh = *data_;
  const MeshNeighbours& neighbours = this->neighbours();
  const auto own = std::span(mesh.indices).subspan(3 * std::size_t{index}, 3);
  const auto corner = static_cast<std::size_t>(std::countr_zero(corners));
  const std::uint32_t vertex = own[corner];
  const Real highest = dot(direction, mesh.vertices[vertex]) + height;
  const auto is_below = [&](std::uint32_t other) { return dot(direction, mesh.vertices[other]) <= highest; };
  // All triangles around the vertex that have another one as well, if one is asked for.
  const auto are_below = [&](std::optional<std::uint32_t> other) {
    return std::ranges::all_of(neighbours.around_vertex(vertex), [&](std::uint32_t triangle) {
      const auto its = std::span(mesh.indices).subspan(3 * std::size_t{triangle}, 3);
      return (other && its[0] != *other && its[1] != *other && its[2] != *other) || has_gone(triangle) ||
             (is_below(its[0]) && is_below(its[1]) && is_below(its[2]));
    });
  };
  const unsigned others = corners & (corners - 1);
  if (others == 0) {
    // The neighbours across edges mostly tell. Both are asked, as neither answer can be guessed.
    const auto is_above = [&](std::uint32_t across) { return !is_below(across == no_index ? vertex : across); };
    const bool is_one_above = is_above(neighbours.across(index, corner)),
               is_other_above = is_above(neighbours.across(index, (corner + 2) % 3));
    return (is_one_above | is_other_above) == 0 && are_below(std::nullopt);
  }
  const auto second = static_cast<std::size_t>(std::countr_zero(others));
  const std::uint32_t across = neighbours.across(index, second == corner + 1 ? corner : second);
  return across == no_index ? are_below(own[second]) : is_below(own[3 - corner - second]) && is_below(across);
}

std::vector<Mesh> Mesh::samples() {
  const auto tetrahedron_xyz = std::to_array<Real>({1, 1, 1, -1, -1, 1, -1, 1, -1, 1, -1, -1});
  const auto tetrahedron = std::to_array<std::uint32_t>({0, 1, 3, 0, 3, 2, 0, 2, 1, 1, 2, 3});
  const auto both = std::to_array<Real>({0}), front = std::to_array<Real>({1});
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
  std::vector<Mesh> out{make(both, tetrahedron_xyz, tetrahedron).value(), make(front, xyz, triangles).value()};
  // A bridge over the sheet: two layers, and walls that stand upright.
  const auto bridge = std::to_array<Real>({-0.9, -0.25, 0,   -0.9, 0.25, 0,   -0.9, -0.25, 0.5, -0.9, 0.25, 0.5,
                                           0.9,  -0.25, 0.5, 0.9,  0.25, 0.5, 0.9,  -0.25, 0,   0.9,  0.25, 0});
  xyz.insert(xyz.end(), bridge.begin(), bridge.end());
  for (std::uint32_t k = 25; k < 31; k += 2) {
    triangles.insert(triangles.end(), {k, k + 2, k + 3, k, k + 3, k + 1});
  }
  const auto both_by_cells = std::to_array<Real>({0, 0, 1, 0, 0}),
             front_by_cells = std::to_array<Real>({1, 1, 2, 3, 2});
  out.push_back(UvGrid::make(both_by_cells, xyz, triangles).value());
  out.push_back(UvGrid::make(front_by_cells, xyz, triangles).value());
  return out;
}

}  // namespace abut
