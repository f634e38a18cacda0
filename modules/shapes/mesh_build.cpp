// SPDX-License-Identifier: Apache-2.0
module abut.shapes.mesh;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.trees.bvh;

namespace abut {
Result<Mesh> Mesh::make(std::span<const Real> parameters, std::span<const Real> reals,
                        std::span<const std::uint32_t> indices) {
  if (Fault fault = check_count("parameter_count", parameters.size(), 1)) {
    return *fault;
  }
  if (parameters[0] != 0 && parameters[0] != 1 && parameters[0] != 2) {
    return error_about(Errc::unknown_value, "sides", parameters[0], "0 (both), 1 (front) or 2 (solid)");
  }
  if (reals.empty()) {
    return Error{Errc::empty, "vertex_count is 0; a mesh needs vertices"};
  }
  if (indices.empty()) {
    return Error{Errc::empty, "triangle_count is 0; a mesh needs at least one triangle"};
  }
  if (reals.size() % 3 != 0) {
    return error_about(Errc::invalid_argument, "real_count", static_cast<std::uint64_t>(reals.size()),
                       "a multiple of 3");
  }
  if (indices.size() % 3 != 0) {
    return error_about(Errc::invalid_argument, "index_count", static_cast<std::uint64_t>(indices.size()),
                       "a multiple of 3");
  }
  constexpr std::size_t most_triangles = 0x7fffffff;  // leaves of a tree of boxes
  if (reals.size() / 3 > no_index || indices.size() / 3 > most_triangles) {
    return Error{Errc::size_overflow, "a mesh has at most 2^32 - 1 vertices and 2^31 - 1 triangles"};
  }
  if (Fault fault = check_all_finite("xyz", reals)) {
    return *fault;
  }
  const std::size_t vertex_count = reals.size() / 3;
  for (std::size_t i = 0; i < indices.size(); ++i) {
    if (indices[i] >= vertex_count) {
      return error_about(Errc::index_out_of_range, "triangles[" + std::to_string(i) + "]", std::uint64_t{indices[i]},
                         "below vertex_count, which is " + std::to_string(vertex_count));
    }
  }
  Data data{{}, {indices.begin(), indices.end()}, static_cast<Sides>(parameters[0]), Aabb::empty(), {}, {}};
  data.vertices.resize(vertex_count);
  for (std::size_t i = 0; i < vertex_count; ++i) {
    data.vertices[i] = {reals[3 * i], reals[3 * i + 1], reals[3 * i + 2]};
  }
  for (const std::uint32_t index : indices) {
    data.box.include(data.vertices[index]);
  }
  return Mesh(std::move(data));
}

Mesh::Tree Mesh::make_tree(const Data& data) {
  const std::size_t count = data.indices.size() / 3;
  std::vector<Aabb> boxes(count, Aabb::empty());
  // Sorted by counting: where the triangles of each vertex begin, then the triangles.
  std::vector<std::size_t> first(data.vertices.size() + 1, 0);
  for (std::size_t i = 0; i < data.indices.size(); ++i) {
    boxes[i / 3].include(data.vertices[data.indices[i]]);
    ++first[data.indices[i] + 1];
  }
  for (std::size_t vertex = 0; vertex < data.vertices.size(); ++vertex) {
    first[vertex + 1] += first[vertex];
  }
  std::vector<OtherCorners> around(data.indices.size());
  std::vector<std::size_t> place(first.begin(), first.end() - 1);
  for (std::size_t i = 0; i < data.indices.size(); ++i) {
    const std::size_t triangle = i - i % 3;
    around[place[data.indices[i]]++] = {data.indices[triangle + (i + 1) % 3], data.indices[triangle + (i + 2) % 3]};
  }
  Tree tree{Bvh(boxes), {}, std::move(first), std::move(around)};
  tree.linked = linked_by(tree, data.indices);
  return tree;
}

std::vector<Mesh::Linked> Mesh::linked_by(const Tree& tree, std::span<const std::uint32_t> indices) {
  std::vector<Linked> linked;
  linked.reserve(indices.size() / 3);
  for (std::size_t triangle = 0; triangle < indices.size(); triangle += 3) {
    Linked of{{indices[triangle], indices[triangle + 1], indices[triangle + 2]}, {}};
    for (std::size_t edge = 0; edge < 3; ++edge) {
      std::uint32_t start = of.corners[edge], end = of.corners[(edge + 1) % 3];
      // A fan may have many triangles at one vertex, but then few at the others.
      if (tree.around_vertex(end).size() < tree.around_vertex(start).size()) {
        std::swap(start, end);
      }
      const std::uint32_t opposite = of.corners[(edge + 2) % 3];
      std::size_t sharing = 0;
      of.across[edge] = opposite;
      for (const OtherCorners& others : tree.around_vertex(start)) {
        if (others.next == end || others.last == end) {
          const std::uint32_t corner = others.next == end ? others.last : others.next;
          of.across[edge] = corner == opposite ? of.across[edge] : corner;
          ++sharing;
        }
      }
      of.across[edge] = sharing <= 2 ? of.across[edge] : no_index;
    }
    linked.push_back(of);
  }
  return linked;
}

bool Mesh::is_crest(std::uint32_t index, unsigned corners, const Vec3& direction, Real height) const {
  const Data& mesh = *data_;
  const Tree& tree = this->tree();
  const Linked& own = tree.linked[index];
  const auto corner = static_cast<std::size_t>(std::countr_zero(corners));
  const std::uint32_t vertex = own.corners[corner];
  const Real highest = dot(direction, mesh.vertices[vertex]) + height;
  const auto is_below = [&](std::uint32_t other) { return dot(direction, mesh.vertices[other]) <= highest; };
  const unsigned others = corners & (corners - 1);
  if (others == 0) {
    // The neighbours across edges mostly tell.
    const auto is_above = [&](std::uint32_t across) { return across != no_index && !is_below(across); };
    if (is_above(own.across[corner]) || is_above(own.across[(corner + 2) % 3])) {
      return false;
    }
    return std::ranges::all_of(tree.around_vertex(vertex),
                               [&](const OtherCorners& of) { return is_below(of.next) && is_below(of.last); });
  }
  const auto second = static_cast<std::size_t>(std::countr_zero(others));
  if (const std::uint32_t across = own.across[second == corner + 1 ? corner : second]; across != no_index) {
    return is_below(own.corners[3 - corner - second]) && is_below(across);
  }
  const std::uint32_t end = own.corners[second];
  return std::ranges::all_of(tree.around_vertex(vertex), [&](const OtherCorners& of) {
    return (of.next != end && of.last != end) || (is_below(of.next) && is_below(of.last));
  });
}

std::vector<Mesh> Mesh::samples() {
  const auto xyz = std::to_array<Real>({1, 1, 1, -1, -1, 1, -1, 1, -1, 1, -1, -1});
  const auto tetrahedron = std::to_array<std::uint32_t>({0, 1, 3, 0, 3, 2, 0, 2, 1, 1, 2, 3});
  const auto both = std::to_array<Real>({0}), front = std::to_array<Real>({1});
  std::vector<Real> sheet_xyz;
  std::vector<std::uint32_t> sheet;
  for (std::uint32_t j = 0; j < 5; ++j) {
    for (std::uint32_t i = 0; i < 5; ++i) {
      const Real x = 0.5 * i - 1, y = 0.5 * j - 1;
      sheet_xyz.insert(sheet_xyz.end(), {x, y, 0.3 * x * y});
      if (i < 4 && j < 4) {
        const std::uint32_t k = 5 * j + i;
        sheet.insert(sheet.end(), {k, k + 1, k + 6, k, k + 6, k + 5});
      }
    }
  }
  return {make(both, xyz, tetrahedron).value(), make(front, sheet_xyz, sheet).value()};
}

}  // namespace abut
