// SPDX-License-Identifier: Apache-2.0
// Signed separation of two cores with few faces by trying every axis that can be a face normal of
// their Minkowski difference: face normals of both, and cross products of their edges (Gottschalk,
// Lin, Manocha, "OBBTree", 1996). Exact for overlap; a lower bound of the distance when apart.
export module abut.narrow.fan.sat;
import abut.capability;
import abut.core.standard;
import abut.math;
import abut.narrow.cores.core_separation;

export namespace abut {

struct SatResult {
  Real separation;  // largest over all axes
  Vec3 normal;      // unit, from a to b
  std::uint32_t axes;
  CoreFeatures features;  // that have the normal
};

// The number of the first edge that a core lists: a segment has none along X and Y.
template <Convex S>
inline constexpr std::size_t first_edge = SegmentCored<S> ? 2 : 0;

// The unit normal across two edges, whose cross product has this square. Parallel edges have none: the answer is NaN,
// and no comparison of what lies along it holds.
//
// Of nearly parallel edges the product is off by rounding of their lengths, which are long beside it. What leads along
// the edges would come back multiplied by them: it is taken out. Across them the edges are short, and what is left is
// rounding.
[[nodiscard]] inline Vec3 unit_across_edges(const Vec3& edge_a, const Vec3& edge_b, const Vec3& product, Real square) {
  if (!(square > 0)) {
    constexpr Real none = std::numeric_limits<Real>::quiet_NaN();
    return {none, none, none};
  }
  const Vec3 n = (1 / std::sqrt(square)) * product;
  const Real square_a = squared_norm(edge_a);
  if (square > slender_square * square_a * squared_norm(edge_b)) [[likely]] {
    return n;
  }
  return UnitVec3::make(n - (dot(n, edge_a) / square_a) * edge_a).value_or(UnitVec3::from_unit_unchecked(n));
}

// Nothing when there is no axis at all, as between two points or parallel segments: such cores only
// touch, and any direction across both separates them.
//
// A normal across edges must beat those of faces by more than `noise`: nearly parallel edges repeat the
// normal of a face, and the closest points of their lines say nothing.
template <FewFaced A, FewFaced B>
[[nodiscard]] std::optional<SatResult> sat(const A& a, const B& b, const Pose& ab, Real noise) {
  const auto placement = place(b, ab);
  const Vec3 apart = placed_centre(b, ab) - a.centre();
  SatResult best{-infinity, {0, 0, 0}, 0, {}};

  // Separation along n: from the furthest point of a to the nearest of b.
  const auto separation_along = [&](const Vec3& n) {
    return dot(n, placed_support(b, placement, -n).point) - dot(n, a.support(n).point);
  };
  const auto try_axis = [&](const Vec3& n, Real lead, const CoreFeatures& of_axis, const CoreFeatures& of_opposite) {
    ++best.axes;
    const auto take = [&](Real separation, bool is_opposite) {
      if (separation > best.separation + lead) {
        best.separation = separation;
        best.normal = is_opposite ? -n : n;
        best.features = is_opposite ? of_opposite : of_axis;
      }
    };
    if constexpr (A::is_symmetric && B::is_symmetric) {
      // Of two symmetric bodies the side that faces the other one is the better one.
      const Real offset = dot(n, apart);
      take(std::fabs(offset) - a.reach(n) - placement.reach(n), offset < 0);
    } else {
      take(separation_along(n), false);
      take(separation_along(-n), true);
    }
  };

  std::size_t face = 0;
  for (const Vec3& n : a.face_normals()) {
    if (squared_norm(n) > 0) {
      try_axis(n, 0, {core_face(face + 1), {}}, {core_face(face), {}});
    }
    face += 2;
  }
  face = 0;
  for (const Vec3& local : b.face_normals()) {
    const Vec3 n = ab.rotation * local;
    if (squared_norm(n) > 0) {
      try_axis(n, 0, {{}, core_face(face)}, {{}, core_face(face + 1)});
    }
    face += 2;
  }
  const auto edges_a = a.edge_directions();
  const auto edges_b = b.edge_directions();
  for (std::size_t i = 0; i < edges_a.size(); ++i) {
    for (std::size_t j = 0; j < edges_b.size(); ++j) {
      const Vec3 &edge_a = edges_a[i], edge_b = ab.rotation * edges_b[j];
      const Vec3 n = cross(edge_a, edge_b);
      const Real square = squared_norm(n);
      if (square > parallel_square * squared_norm(edge_a) * squared_norm(edge_b) && square > 0) {
        const CoreFeatures edges{core_edge(first_edge<A> + i), core_edge(first_edge<B> + j)};
        try_axis(unit_across_edges(edge_a, edge_b, n, square), noise, edges, edges);
      }
    }
  }
  return best.axes > 0 ? std::optional(best) : std::nullopt;
}

}  // namespace abut
