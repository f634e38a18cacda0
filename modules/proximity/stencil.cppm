// SPDX-License-Identifier: Apache-2.0
// What is near in a mesh that deforms, or in two, as a solver takes it: up to four vertices with weights.
export module abut.proximity.stencil;
import abut.core.standard;
import abut.math;

export namespace abut {

enum class StencilKind : std::uint32_t { vertex_face, edge_edge, vertex_edge, vertex_vertex };
[[nodiscard]] constexpr std::uint32_t bit(StencilKind kind) { return 1u << static_cast<std::uint32_t>(kind); }

// The sum of weights times places is the way from the closest point of a to that of b: `distance` times `normal`. So
// the gradient of the distance is weights times normal.
struct Stencil {
  StencilKind kind;
  std::uint32_t of_a;                     // how many vertices are of a: the first ones
  std::uint32_t element_a, element_b;     // numbers of vertices, edges or faces
  std::array<std::uint32_t, 4> vertices;  // those that a kind does not have repeat the last one
  std::array<Real, 4> weights;            // negative of a, positive of b, and 0 for repeated vertices
  Vec3 normal;                            // from a to b
  Real distance;
  Real toi;
};

// An edge of one mesh that passes a face of the same or of another one.
struct Crossing {
  std::uint32_t edge, face;
  bool is_edge_of_b;
  Real share;  // of the way from the first end of the edge
  Vec3 point;
};

}  // namespace abut
