// SPDX-License-Identifier: Apache-2.0
// Selects the closest features of a vertex that become contacts. All faces around an edge or a vertex have that feature
// as the closest one. A face further away has a closest feature on its border, although a nearer face covers that
// border.
export module abut.elements.keeping;
import abut.core.standard;
export import abut.elements.nearest;
import abut.math;

export namespace abut {

// A vertex, a face and the closest feature of that face.
struct FaceStencil {
  static constexpr std::uint32_t none = 0xffffffff;

  std::uint32_t vertex, face;
  std::array<std::uint32_t, 3> feature;  // vertices of the feature in the order of their places, then none
  std::uint32_t count;                   // of them
  std::array<Real, 3> weights;           // of them
  Vec3 point;                            // the closest one
  Real square;                           // of the distance
};

// `corners`: vertices of the face.
[[nodiscard]] FaceStencil face_stencil(std::uint32_t vertex, std::uint32_t face, std::span<const std::uint32_t> corners,
                                       const NearestOnFace& nearest);

// The order of stencils of one vertex: by distance, then by the number of corners, then by the places of these. It
// depends on numbers only where different vertices lie at one place.
[[nodiscard]] bool comes_before(const FaceStencil& a, const FaceStencil& b, std::span<const Vec3> vertices);

// Puts first the stencils of one vertex that count, in their order, and returns their number. Each feature occurs once.
// A feature counts where all given faces around it name it: the vertex is in its Voronoi region. Of two features that
// share a vertex and whose closest points lie within `same` of each other, the first one counts.
//
// Rounding loses nothing. The feature that a face names comes before all other edges and corners of this face in the
// order, bit for bit. So each feature that does not count leads to a nearer one that does, and the nearest one counts.
//
// `triangles`: the corners of faces. For n faces n * n comparisons.
[[nodiscard]] std::size_t keep_closest(std::span<FaceStencil> of_vertex, std::span<const std::uint32_t> triangles,
                                       std::span<const Vec3> vertices, Real same);

}  // namespace abut
