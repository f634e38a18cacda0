// SPDX-License-Identifier: Apache-2.0
module abut.elements.keeping;
import abut.core.standard;
import abut.math;

namespace abut {
namespace {

[[nodiscard]] inline bool holds(std::span<const std::uint32_t> corners, std::uint32_t vertex) {
  return corners[0] == vertex || corners[1] == vertex || corners[2] == vertex;
}

[[nodiscard]] inline bool share_vertex(const FaceStencil& a, const FaceStencil& b) {
  for (std::size_t i = 0; i < a.count; ++i) {
    if (holds(b.feature, a.feature[i])) {
      return true;
    }
  }
  return false;
}

// Whether all faces around the feature of a stencil name it.
[[nodiscard]] bool is_named_by_all(const FaceStencil& its, std::span<const FaceStencil> all,
                                   std::span<const std::uint32_t> triangles) {
  if (its.count == 3) {
    return true;
  }
  for (const FaceStencil& other : all) {
    const auto corners = triangles.subspan(3 * std::size_t{other.face}, 3);
    if (other.feature != its.feature && holds(corners, its.feature[0]) &&
        (its.count == 1 || holds(corners, its.feature[1]))) {
      return false;
    }
  }
  return true;
}

}  // namespace

FaceStencil face_stencil(std::uint32_t vertex, std::uint32_t face, std::span<const std::uint32_t> corners,
                         const NearestOnFace& nearest) {
  FaceStencil out{vertex,
                  face,
                  {FaceStencil::none, FaceStencil::none, FaceStencil::none},
                  nearest.count,
                  nearest.weights,
                  nearest.point,
                  nearest.square};
  for (std::size_t i = 0; i < nearest.count; ++i) {
    out.feature.at(i) = corners[nearest.corners.at(i)];
  }
  return out;
}

bool comes_before(const FaceStencil& a, const FaceStencil& b, std::span<const Vec3> vertices) {
  if (a.square != b.square) {
    return a.square < b.square;
  }
  if (a.count != b.count) {
    return a.count < b.count;
  }
  for (std::size_t i = 0; i < a.count; ++i) {
    const Vec3 &of_a = vertices[a.feature[i]], &of_b = vertices[b.feature[i]];
    if (!(of_a == of_b)) {
      return is_placed_before(of_a, of_b);
    }
  }
  return std::tie(a.feature, a.face) < std::tie(b.feature, b.face);
}

std::size_t keep_closest(std::span<FaceStencil> of_vertex, std::span<const std::uint32_t> triangles,
                         std::span<const Vec3> vertices, Real same) {
  if (of_vertex.size() < 2) {
    return of_vertex.size();
  }
  std::size_t complete = 0;
  for (std::size_t i = 0; i < of_vertex.size(); ++i) {
    if (is_named_by_all(of_vertex[i], of_vertex, triangles)) {
      std::swap(of_vertex[complete++], of_vertex[i]);
    }
  }
  std::ranges::sort(of_vertex.first(complete),
                    [&](const FaceStencil& a, const FaceStencil& b) { return comes_before(a, b, vertices); });
  std::size_t kept = 0;
  for (std::size_t i = 0; i < complete; ++i) {
    const FaceStencil its = of_vertex[i];
    const bool is_repeated = std::ranges::any_of(of_vertex.first(kept), [&](const FaceStencil& before) {
      return share_vertex(its, before) && squared_norm(its.point - before.point) <= same * same;
    });
    if (!is_repeated) {
      of_vertex[kept++] = its;
    }
  }
  return kept;
}

}  // namespace abut
