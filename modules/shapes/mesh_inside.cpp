// SPDX-License-Identifier: Apache-2.0
// What is inside of a solid mesh, its connected pieces, and which triangles are wound the wrong way.
module abut.shapes.mesh;
import abut.capability;
import abut.core.joined_sets;
import abut.core.standard;
import abut.math;
import abut.shapes.mesh_neighbours;
import abut.trees.winding_number;
import abut.triangles.edges;

namespace abut {
namespace {

// Triangles that share an edge with one neighbour each look the same way if they run along it in opposite directions.
JoinedSets sets_that_look_alike(std::span<const std::uint32_t> indices) {
  JoinedSets sets(indices.size() / 3);
  visit_edges(indices, [&](std::span<const EdgeOfTriangle> sharing) {
    if (sharing.size() == 2 && sharing[0].is_forward != sharing[1].is_forward) {
      sets.join(sharing[0].triangle, sharing[1].triangle);
    }
  });
  return sets;
}

std::vector<Vec3> vertices_of_pieces(std::span<const Vec3> vertices, std::span<const std::uint32_t> indices) {
  JoinedSets pieces(vertices.size());
  for (std::size_t i = 0; i < indices.size(); i += 3) {
    pieces.join(indices[i], indices[i + 1]);
    pieces.join(indices[i], indices[i + 2]);
  }
  std::vector<bool> is_listed(vertices.size());
  std::vector<Vec3> out;
  for (std::uint32_t triangle = 0; triangle < indices.size() / 3; ++triangle) {
    const std::uint32_t vertex = indices[3 * std::size_t{triangle}], piece = pieces.of(vertex);
    if (!is_listed[piece] && !is_removed(indices, triangle)) {
      is_listed[piece] = true;
      out.push_back(vertices[vertex]);
    }
  }
  return out;
}

}  // namespace

// The largest triangle of each set tells for all: whether there is nothing behind it, but something in front. Close to
// a set that is wound the wrong way, it rules the number. So both are asked at a distance of about its size.
Mesh::Inside Mesh::make_inside(const Data& data) {
  constexpr Real most_beside = 0.05;  // of the whole
  Inside out{WindingNumber(data.vertices, data.indices), vertices_of_pieces(data.vertices, data.indices), {}};
  const auto count = static_cast<std::uint32_t>(data.indices.size() / 3);
  JoinedSets sets = sets_that_look_alike(data.indices);
  const auto triangle = [&](std::uint32_t index) {
    const std::size_t first = 3 * std::size_t{index};
    return Triangle(data.vertices[data.indices[first]], data.vertices[data.indices[first + 1]],
                    data.vertices[data.indices[first + 2]], index, false);
  };
  std::vector<std::uint32_t> largest(count, no_index);
  std::vector<Real> areas(count, 0), areas_of_largest(count, -1);
  for (std::uint32_t index = 0; index < count; ++index) {
    const TriangleCorners corners = triangle(index).corners();
    const Real area = 0.5 * norm(cross(corners[1] - corners[0], corners[2] - corners[0]));
    const std::uint32_t set = sets.of(index);
    areas[set] += area;
    if (area > areas_of_largest[set]) {
      areas_of_largest[set] = area;
      largest[set] = index;
    }
  }
  const Real furthest = most_beside * largest_magnitude(data.box.high - data.box.low);
  const auto looks_inside = [&](std::uint32_t index, Real area) {
    const Triangle its = triangle(index);
    const Vec3 step = std::min(std::sqrt(area), furthest) * its.normal();
    return out.winding.contains(its.centre() + step) && !out.winding.contains(its.centre() - step);
  };
  std::vector<bool> is_set_turned(count);
  bool any = false;
  for (std::uint32_t set = 0; set < count; ++set) {
    is_set_turned[set] = largest[set] != no_index && looks_inside(largest[set], areas[set]);
    any = any || is_set_turned[set];
  }
  if (any) {
    out.turned.resize(count);
    for (std::uint32_t index = 0; index < count; ++index) {
      out.turned[index] = is_set_turned[sets.of(index)];
    }
  }
  return out;
}

}  // namespace abut
