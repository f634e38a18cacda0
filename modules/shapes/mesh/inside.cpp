// SPDX-License-Identifier: Apache-2.0
module abut.shapes.mesh.inside;
import abut.capability;
import abut.core.joined_sets;
import abut.core.standard;
import abut.math;
import abut.triangles.alike_triangles;
import abut.triangles.buffers;

namespace abut {
namespace {

std::vector<std::uint32_t> vertices_of_pieces(std::size_t vertex_count, std::span<const std::uint32_t> indices) {
  JoinedSets pieces(vertex_count);
  for (std::size_t i = 0; i < indices.size(); i += 3) {
    pieces.join(indices[i], indices[i + 1]);
    pieces.join(indices[i], indices[i + 2]);
  }
  std::vector<bool> is_listed(vertex_count);
  std::vector<std::uint32_t> out;
  for (std::uint32_t triangle = 0; triangle < indices.size() / 3; ++triangle) {
    const std::uint32_t vertex = indices[3 * std::size_t{triangle}], piece = pieces.of(vertex);
    if (!is_listed[piece] && !is_removed(indices, triangle)) {
      is_listed[piece] = true;
      out.push_back(vertex);
    }
  }
  return out;
}

}  // namespace

MeshInside::MeshInside(std::span<const Vec3> vertices, std::span<const std::uint32_t> indices, const Aabb& box)
    : winding_(vertices, indices),
      alike_(vertices, indices),
      looks_(alike_.count()),
      is_turned_(indices.size() / 3),
      vertices_of_pieces_(vertices_of_pieces(vertices.size(), indices)),
      pieces_(vertices_of_pieces_.size()) {
  settle(vertices, indices, box);
}

void MeshInside::move(std::uint32_t triangle, std::span<const Vec3> vertices, std::span<const std::uint32_t> indices) {
  const auto include = [&] {
    for (const Vec3& corner : winding_.corners(triangle)) {
      changed_.include(corner);
    }
  };
  include();
  winding_.move(triangle, vertices);
  include();
  alike_.move(triangle, vertices, indices);
}

void MeshInside::settle(std::span<const Vec3> vertices, std::span<const std::uint32_t> indices, const Aabb& box) {
  winding_.settle();
  look(vertices, indices, box);
  changed_ = Aabb::empty();
  std::transform(vertices_of_pieces_.begin(), vertices_of_pieces_.end(), pieces_.begin(),
                 [&](std::uint32_t of) { return vertices[of]; });
}

// The largest triangle of each set tells for all: whether there is nothing behind it, but something in front. Close to
// a set that is wound the wrong way, it rules the number. So both are asked at a distance of about its size.
void MeshInside::look(std::span<const Vec3> vertices, std::span<const std::uint32_t> indices, const Aabb& box) {
  constexpr Real most_beside = 0.05;  // of the whole
  const Real furthest = most_beside * largest_magnitude(box.high - box.low);
  for (std::uint32_t set = 0; set < alike_.count(); ++set) {
    const AlikeTriangles::Summary its = alike_.summary(set);
    const auto corners = indices.subspan(3 * std::size_t{its.largest}, 3);
    const Triangle largest(vertices[corners[0]], vertices[corners[1]], vertices[corners[2]], its.largest, false);
    const Vec3 step = std::min(std::sqrt(its.area), furthest) * largest.normal();
    Look next{largest.centre() + step, largest.centre() - step, false};
    Look& last = looks_[set];
    const auto is_same = [&](const Vec3& point, const Vec3& before) {
      return point == before && !changed_.overlaps({point, point});
    };
    if (is_same(next.in_front, last.in_front) && is_same(next.behind, last.behind)) {
      continue;
    }
    next.is_turned = winding_.contains(next.in_front) && !winding_.contains(next.behind);
    if (next.is_turned != last.is_turned) {
      turned_sets_ += next.is_turned ? 1 : std::size_t{0} - 1;
      for (const std::uint32_t triangle : alike_.of(set)) {
        is_turned_[triangle] = next.is_turned;
      }
    }
    last = next;
  }
}

}  // namespace abut
