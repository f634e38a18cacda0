// SPDX-License-Identifier: Apache-2.0
// Closest points of a vertex and a face, and of two edges. Corners are put in the order of their places first, so the
// answer has the same bits under any numbering, winding or first corner. The point on a vertex or an edge is computed
// from that feature alone, so all faces around it give the same bits.
export module abut.elements.nearest;
import abut.core.standard;
import abut.math;

export namespace abut {

// By x, then by y, then by z.
[[nodiscard]] inline bool is_placed_before(const Vec3& a, const Vec3& b) {
  return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
}

// The closest feature of a face: one corner, an edge or all three, in the order of their places.
struct NearestOnFace {
  std::uint32_t count;                   // of corners of the feature
  std::array<std::uint32_t, 3> corners;  // as the caller orders them; the first `count` are of the feature
  std::array<Real, 3> weights;           // of these corners; the closest point is their sum
  Vec3 point;
  Real square;  // of the distance
};
// Of features at the same distance, one with fewer corners counts, then the one whose corners have the first places. No
// corner or edge of the face is nearer, as its distance is computed for any other face around it. Corners may coincide
// or lie on one line.
[[nodiscard]] NearestOnFace nearest_on_face(const Vec3& vertex, const std::array<Vec3, 3>& face);

// Closest points that both lie strictly inside their edges.
struct NearestOfEdges {
  std::array<Real, 2> shares;  // from the first end of each edge, as the caller orders them
  std::array<Vec3, 2> points;
  Real square;  // of the distance
};
// Nothing where a closest point is an end, or where the squared sine of the angle between the edges is below 1e-12.
[[nodiscard]] std::optional<NearestOfEdges> nearest_of_edges(const std::array<Vec3, 2>& a,
                                                             const std::array<Vec3, 2>& b);

}  // namespace abut
