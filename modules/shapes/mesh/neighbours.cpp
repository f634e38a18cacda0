// SPDX-License-Identifier: Apache-2.0
module abut.shapes.mesh.neighbours;
import abut.capability;
import abut.core.standard;

namespace abut {

// Sorted by counting: where the triangles of each vertex begin, then the triangles.
MeshNeighbours::MeshNeighbours(std::size_t vertex_count, std::span<const std::uint32_t> indices, const Workers& workers)
    : first_around_(vertex_count + 1, 0), around_(indices.size()), across_(indices.size()) {
  for (const std::uint32_t vertex : indices) {
    ++first_around_[vertex];
  }
  std::uint32_t before = 0;
  for (std::uint32_t& first : first_around_) {
    before += std::exchange(first, before + first);
  }
  // Each count now is where the triangles of its vertex end; it goes down to where they begin.
  for (std::size_t i = indices.size(); i > 0; --i) {
    around_[--first_around_[indices[i - 1]]] = static_cast<std::uint32_t>((i - 1) / 3);
  }
  constexpr std::size_t least_of_task = 4096;
  const Cuts cuts = workers.cut(indices.size() / 3, least_of_task);
  workers.for_each(cuts.tasks(), [&](std::size_t task) {
    for (std::size_t triangle = cuts.begin(task); triangle < cuts.end(task); ++triangle) {
      for (std::size_t edge = 0; edge < 3; ++edge) {
        across_[3 * triangle + edge] = across_of(indices, static_cast<std::uint32_t>(triangle), edge);
      }
    }
  });
}

std::uint32_t MeshNeighbours::across_of(std::span<const std::uint32_t> indices, std::uint32_t triangle,
                                        std::size_t edge) const {
  const auto own = indices.subspan(3 * std::size_t{triangle}, 3);
  std::uint32_t start = own[edge], end = own[(edge + 1) % 3];
  const std::uint32_t opposite = own[(edge + 2) % 3];
  // A fan may have many triangles at one vertex, but then few at the others.
  if (around_vertex(end).size() < around_vertex(start).size()) {
    std::swap(start, end);
  }
  std::uint32_t across = opposite;
  std::size_t sharing = 0;
  std::uint32_t before = no_index;
  for (const std::uint32_t other : around_vertex(start)) {
    // One that names the vertex twice is there twice.
    if (other == std::exchange(before, other) || is_removed(indices, other)) {
      continue;
    }
    const auto its = indices.subspan(3 * std::size_t{other}, 3);
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const std::uint32_t next = its[(corner + 1) % 3], last = its[(corner + 2) % 3];
      if (its[corner] == start && (next == end || last == end)) {
        const std::uint32_t third = next == end ? last : next;
        across = third == opposite ? across : third;
        ++sharing;
      }
    }
  }
  return sharing <= 2 ? across : no_index;
}

void MeshNeighbours::remove(std::uint32_t triangle, std::span<std::uint32_t> indices) {
  const auto own = indices.subspan(3 * std::size_t{triangle}, 3);
  const std::array corners{own[0], own[1], own[2]};
  own[1] = own[2] = own[0];
  for (std::size_t edge = 0; edge < 3; ++edge) {
    const std::uint32_t start = corners[edge], end = corners[(edge + 1) % 3];
    for (const std::uint32_t other : around_vertex(start)) {
      const auto its = indices.subspan(3 * std::size_t{other}, 3);
      for (std::size_t i = 0; i < 3; ++i) {
        const std::uint32_t from = its[i], to = its[(i + 1) % 3];
        if ((from == start && to == end) || (from == end && to == start)) {
          across_[3 * std::size_t{other} + i] = across_of(indices, other, i);
        }
      }
    }
  }
}

}  // namespace abut
