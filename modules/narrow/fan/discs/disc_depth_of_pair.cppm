// SPDX-License-Identifier: Apache-2.0
// How deep a cylinder or a cone and a polyhedron or another one overlap, of any two shapes that can be asked so.
export module abut.narrow.fan.discs.disc_depth_of_pair;
import abut.capability;
import abut.core.standard;
import abut.math;
import abut.narrow.cores.core_separation;
import abut.narrow.fan.discs.disc_depth;
import abut.narrow.fan.discs.disc_depth_of_polytope;
export import abut.narrow.fan.disc_pairs;
import abut.narrow.fan.facets;
import abut.narrow.fan.features;

export namespace abut {

// Whether a point of its own frame lies in a core, up to some slack.
template <Rimmed S>
  requires Field<S>
[[nodiscard]] inline bool holds(const S& shape, const Vec3& point, Real slack) {
  return shape.nearest(point).distance <= slack;
}

// The normals of triangles that are slender beyond this are not trusted.
inline constexpr Real least_height_of_triangles = 1e-4;  // by the longest edge
[[nodiscard]] inline bool is_slender(const std::array<Vec3, 3>& corners) {
  const Vec3 first = corners[1] - corners[0], second = corners[2] - corners[0], third = corners[2] - corners[1];
  const Real longest = std::fmax(squared_norm(first), std::fmax(squared_norm(second), squared_norm(third)));
  return !(norm(cross(first, second)) > least_height_of_triangles * longest);
}

// Faces that rounding has bent say nothing.
template <class S>
[[nodiscard]] inline bool has_trusted_faces(const S& shape, Real size) {
  if constexpr (Triangular<S>) {
    return !is_slender(shape.corners());
  } else if constexpr (Faceted<S>) {
    return has_facets(shape, noise_of(size));
  } else {
    return true;
  }
}

// Squares of squares of lengths below it vanish.
inline constexpr Real least_size_of_discs = 1e-60;

// Of cores that are not apart by more than the error. Nothing where they hardly overlap, or no least depth is proven.
template <Convex A, Convex B>
  requires has_discs<A, B>
[[nodiscard]] std::optional<ProvenDepth> disc_depth(const A& a, const B& b, const Pose& ab, Real size, Real error) {
  const Real slack = error / 4;
  if (!(size > least_size_of_discs)) {
    return std::nullopt;
  }
  if constexpr (Rimmed<B>) {
    DiscDepth least(mirrored(b.discs(), ab.position, ab.rotation.z), slack, rounding_of(size));
    if constexpr (Rimmed<A>) {
      search_discs(a.discs(), least);
    } else {
      if (!has_trusted_faces(a, size)) {
        return std::nullopt;
      }
      search_polytope(a, least);
    }
    if (!least.is_proven() || !(least.depth() > slack)) {
      return std::nullopt;
    }
    CoreFeatures features = least.features();
    if (SegmentCored<A> && features.a.kind == CoreFeature::Kind::face) {
      features = {};  // that of a box without width
    }
    direct_edges(a, b, ab, least.direction(), features);
    return ProvenDepth{least.depth(), least.depth() - slack, least.direction(), features};
  } else {
    std::optional<ProvenDepth> found = disc_depth(b, a, ab.inverse(), size, error);
    if (found) {
      found->normal = -(ab.rotation * found->normal);
      found->features = {found->features.b, found->features.a};
      direct_edges(a, b, ab, found->normal, found->features);
    }
    return found;
  }
}

}  // namespace abut
